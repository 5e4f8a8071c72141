#include "ResultsRun.h"

#include "itkLevelSetConversion.h"

#include "moserhex/Common/Stopwatch.h"

#include <algorithm>
#include <iomanip>
#include <sstream>
#include <stdexcept>

namespace moserhex::results
{

Run
runPipeline(const LabelImage & image, const RunOptions & runOptions)
{
  SolidMeshingOptions options;
  options.shells = runOptions.shells;
  options.lastStage = runOptions.lastStage;
  options.paddingLayers = runOptions.paddingLayers;
  options.way = runOptions.way;
  if (!runOptions.smoothing)
  {
    options.smoothing.edges.slides = 0;
    options.smoothing.guarded.sweeps = 0;
    options.flow.smoothedPasses = 0;
  }
  return runMeshing(image, options, runOptions.method);
}

Run
runMeshing(const LabelImage & image, SolidMeshingOptions options, const std::optional<Pipeline::ShellMethod> & method)
{
  Run run{ Pipeline::New(), 0.0 };
  options.allowPartial = true;
  run.pipeline->SetMeshingOptions(options);
  if (method)
  {
    run.pipeline->SetShellMethod(*method);
  }
  run.pipeline->SetInput(image.image);
  run.pipeline->SetLabel(chooseLabel(image, std::nullopt).value);
  const Stopwatch stopwatch;
  run.pipeline->Update();
  run.seconds = stopwatch.seconds();
  return run;
}

LabelSolid
conditionedSolid(const LabelImage & image, int shells)
{
  const auto conditioning = Pipeline::ConditioningFilterType::New();
  conditioning->SetInput(image.image);
  conditioning->SetLabel(chooseLabel(image, std::nullopt).value);
  conditioning->SetNodesPerSide(2 * shells);
  conditioning->Update();
  return { itk::LevelSetFromImage(conditioning->GetOutput()), conditioning->GetLabelVolume() };
}

LabelImage
labelImageOf(const analytic::Solid & solid)
{
  LabelImage image;
  image.image = moserhex::labelImageOf(analytic::labelVolume(solid));
  image.labels = { { 1, 0, {} } };
  return image;
}

const MeshingStageReport &
stageOf(const Run & run, const std::string & stage)
{
  const auto & stages = run.pipeline->GetStages();
  const auto   found = std::find_if(
    stages.begin(), stages.end(), [&](const MeshingStageReport & s) { return s.name == stage && s.quality; });
  if (found == stages.end())
  {
    throw std::runtime_error("stage " + stage + " was not run");
  }
  return *found;
}

const HexQualitySummary &
qualityAfter(const Run & run, const std::string & stage)
{
  return *stageOf(run, stage).quality;
}

std::string
fixed(double value, int digits)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << value;
  return text.str();
}

std::string
significant(double value)
{
  std::ostringstream text;
  text << std::setprecision(2) << value;
  return text.str();
}

double
medianOf(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  if (values.empty())
  {
    return 0.0;
  }
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

double
largestOf(const std::vector<double> & values)
{
  return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

std::vector<std::filesystem::path>
imagesIn(const std::filesystem::path & folder, std::size_t atMost)
{
  std::vector<std::filesystem::path> files;
  for (const auto & entry : std::filesystem::directory_iterator(folder))
  {
    if (isLabelImageName(entry.path().string()))
    {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  files.resize(std::min(files.size(), atMost));
  return files;
}

std::string
caseName(const std::filesystem::path & file)
{
  const std::string name = file.filename().string();
  return name.substr(0, name.find('.'));
}

} // namespace moserhex::results
