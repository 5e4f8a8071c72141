#pragma once

#include "itkMassPreservingHexahedralMeshFilter.h"

#include "moserhex/LevelSet/LabelVolume.h"

#include <itkImage.h>

#include <optional>

namespace moserhex::integration
{

using ShortImage = itk::Image<short, 3>;
using Pipeline = itk::MassPreservingHexahedralMeshFilter<ShortImage>;

/** The voxels of a label as an ITK image: `value` inside, 0 outside. */
[[nodiscard]] ShortImage::Pointer
labelImage(const LabelVolume & label, short value = 1);

struct PipelineOptions
{
  int                                  shells{ 10 };
  short                                label{ 1 };
  unsigned int                         threads{ 2 };
  std::optional<Pipeline::ShellMethod> method; ///< empty: the filter's own choice
  MeshingStage                         lastStage{ MeshingStage::Moser };
};

/** Runs the whole chain and returns the updated filter. Throws what the filter throws. */
[[nodiscard]] Pipeline::Pointer
runPipeline(const ShortImage * image, const PipelineOptions & options = {});

/** Quality of the mesh after the named stage ("initial map", "smoothing", "moser flow").
 * \throws std::out_of_range  when the stage was not run */
[[nodiscard]] const HexQualitySummary &
qualityAfter(const Pipeline & pipeline, const std::string & stage);

/** Largest number of flipped triangles, |sum of solid angles - 4 pi| and area ratio rms over all shells. */
struct WorstSphereMap
{
  int    flippedTriangles{ 0 };
  double solidAngleError{ 0.0 };
  double areaRatioRms{ 0.0 };
};
[[nodiscard]] WorstSphereMap
worstSphereMap(const Pipeline & pipeline);

} // namespace moserhex::integration
