#pragma once

#include "itkMassPreservingHexahedralMeshFilter.h"

#include "moserhex/Analytic/SolidShapes.h"
#include "moserhex/HexMeshIO/LabelImageReader.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace moserhex::results
{

using Pipeline = itk::MassPreservingHexahedralMeshFilter<LabelImageType>;

/** One whole run: the filter after Update(), and its wall time. */
struct Run
{
  Pipeline::Pointer pipeline;
  double            seconds{ 0.0 };
};

struct RunOptions
{
  int                                  shells{ 10 };
  MeshingStage                         lastStage{ MeshingStage::Moser };
  MeshingWay                           way{ MeshingWay::Faithful }; ///< matters for MeshingStage::Exact only
  int                                  paddingLayers{ 0 };
  bool                                 smoothing{ true };
  std::optional<Pipeline::ShellMethod> method; ///< empty: what the command does by default
};

/** A mesh that is not exact is accepted: the tables say so. */
[[nodiscard]] Run
runPipeline(const LabelImage & image, const RunOptions & runOptions);

/** The same with all options of the meshing, but that a mesh that is not exact is accepted. */
[[nodiscard]] Run
runMeshing(const LabelImage &                           image,
           SolidMeshingOptions                          options,
           const std::optional<Pipeline::ShellMethod> & method = std::nullopt);

/** A label as stage A leaves it. */
struct LabelSolid
{
  LevelSet phi;           ///< negative inside [mm]
  double   volume{ 0.0 }; ///< of the label [mm^3]
};

[[nodiscard]] LabelSolid
conditionedSolid(const LabelImage & image, int shells);

/** A solid's voxels of 1 mm. */
[[nodiscard]] LabelImage
labelImageOf(const analytic::Solid & solid);

/** \throws std::runtime_error  the stage was not run */
[[nodiscard]] const MeshingStageReport &
stageOf(const Run & run, const std::string & stage);

[[nodiscard]] const HexQualitySummary &
qualityAfter(const Run & run, const std::string & stage);

[[nodiscard]] std::string
fixed(double value, int digits);

/** Two significant digits, also for small numbers. */
[[nodiscard]] std::string
significant(double value);

/** 0 for no values. */
[[nodiscard]] double
medianOf(std::vector<double> values);

/** 0 for no values. */
[[nodiscard]] double
largestOf(const std::vector<double> & values);

/** Labelmaps in a folder, sorted by name, at most `atMost` of them. */
[[nodiscard]] std::vector<std::filesystem::path>
imagesIn(const std::filesystem::path & folder, std::size_t atMost);

[[nodiscard]] std::string
caseName(const std::filesystem::path & file);

} // namespace moserhex::results
