#include "CorrespondenceParts.h"

#include "moserhex/Common/Errors.h"
#include "moserhex/LevelSet/AgreementDensity.h"
#include "moserhex/LevelSet/LabelDensity.h"

namespace moserhex::correspondence
{
namespace
{

LabelVolume
volumeOf(const LabelImage & image)
{
  return labelVolumeOf(*image.image, chooseLabel(image, std::nullopt).value);
}

} // namespace

std::vector<Way>
waysToCorrespond()
{
  std::vector<Way> ways{
    { "own", false, {} }, { "tied", true, {} }, { "tied, rigid", true, {} }, { "tied, affine", true, {} }
  };
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

MeshedPair
meshByAgreement(const LabelImage & first, const LabelImage & second, int shells)
{
  const ScalarVolume  density = agreementDensity({ volumeOf(first), volumeOf(second) }).density;
  const LabelDensity  ofFirst = densityOnLabel(density, volumeOf(first));
  const LabelDensity  ofSecond = densityOnLabel(density, volumeOf(second));
  SolidMeshingOptions options;
  options.shells = shells;
  options.density = &ofFirst.density;
  MeshedPair pair;
  pair.first = results::runMeshing(first, options);
  options.density = &ofSecond.density;
  options.templateMesh = pair.first.pipeline->GetHexMesh();
  options.templateAlignment = TemplateAlignment::None;
  pair.second = results::runMeshing(second, options);
  return pair;
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
