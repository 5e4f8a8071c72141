#include "PipelineRun.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace moserhex::integration
{

ShortImage::Pointer
labelImage(const LabelVolume & label, short value)
{
  auto                      image = ShortImage::New();
  ShortImage::SizeType      size;
  ShortImage::SpacingType   spacing;
  ShortImage::PointType     origin;
  ShortImage::DirectionType direction;
  for (unsigned int a = 0; a < 3; ++a)
  {
    size[a] = static_cast<itk::SizeValueType>(label.size[a]);
    spacing[a] = label.spacing[a];
    origin[a] = label.origin[a];
    for (unsigned int b = 0; b < 3; ++b)
    {
      direction[a][b] = label.direction(a, b);
    }
  }
  image->SetRegions(size);
  image->SetSpacing(spacing);
  image->SetOrigin(origin);
  image->SetDirection(direction);
  image->Allocate();
  std::transform(label.inside.begin(), label.inside.end(), image->GetBufferPointer(), [value](std::uint8_t inside) {
    return inside != 0 ? value : short{ 0 };
  });
  return image;
}

Pipeline::Pointer
runPipeline(const ShortImage * image, const PipelineOptions & options)
{
  auto pipeline = Pipeline::New();
  pipeline->SetInput(image);
  pipeline->SetLabel(options.label);
  pipeline->SetNumberOfShells(options.shells);
  if (options.method)
  {
    pipeline->SetShellMethod(*options.method);
  }
  pipeline->SetLastStage(options.lastStage);
  pipeline->SetNumberOfWorkUnits(options.threads);
  pipeline->Update();
  return pipeline;
}

const HexQualitySummary &
qualityAfter(const Pipeline & pipeline, const std::string & stage)
{
  for (const MeshingStageReport & report : pipeline.GetStages())
  {
    if (report.name == stage && report.quality)
    {
      return *report.quality;
    }
  }
  throw std::out_of_range("stage \"" + stage + "\" was not run");
}

WorstSphereMap
worstSphereMap(const Pipeline & pipeline)
{
  constexpr double fullSphere = 12.566370614359172;
  WorstSphereMap   worst;
  for (const AreaPreservingMapResult & map : pipeline.GetResult().sphereMaps)
  {
    worst.flippedTriangles = std::max(worst.flippedTriangles, map.quality.flippedTriangles);
    worst.solidAngleError = std::max(worst.solidAngleError, std::abs(map.quality.solidAngleSum - fullSphere));
    worst.areaRatioRms = std::max(worst.areaRatioRms, map.quality.areaRatioRms);
  }
  return worst;
}

} // namespace moserhex::integration
