#include "CorrespondenceParts.h"

#include "moserhex/Common/Errors.h"

namespace moserhex::correspondence
{

std::vector<Way>
waysToCorrespond()
{
  std::vector<Way> ways{ { "own", false, false, {} },
                         { "tied", true, true, {} },
                         { "tied, rigid", true, false, {} },
                         { "tied, affine", true, false, {} } };
  ways[1].options.templateAlignment = TemplateAlignment::None;
  ways[2].options.templateAlignment = TemplateAlignment::Rigid;
  ways[3].options.templateAlignment = TemplateAlignment::Affine;
  return ways;
}

results::Run
meshBy(const Way & way, const LabelImage & label, const HexMesh & other)
{
  SolidMeshingOptions options = way.options;
  options.shells = other.nodesPerSide / 2;
  if (way.tied)
  {
    options.templateMesh = other;
  }
  return results::runMeshing(label, options);
}

results::Run
meshAlone(const LabelImage & label, int shells)
{
  SolidMeshingOptions options;
  options.shells = shells;
  return results::runMeshing(label, options);
}

std::string
remarkOn(const results::Run & run)
{
  const SolidMeshingResult & result = run.pipeline->GetResult();
  std::string                remark = result.equalisation->exact ? "" : "not exact";
  if (!result.turnWarning.empty())
  {
    remark += remark.empty() ? "turned" : ", turned";
  }
  return remark;
}

std::string
refusalOf(const std::function<void()> & action)
{
  try
  {
    action();
  }
  catch (const itk::ExceptionObject & error)
  {
    return std::string("refused: ") + error.GetDescription();
  }
  catch (const Error & error)
  {
    return std::string("refused: ") + error.what();
  }
  return {};
}

} // namespace moserhex::correspondence
