#include "TemplateInputs.h"

#include "CommandErrors.h"
#include "CorrespondingLandmarks.h"
#include "itkDensityConversion.h"
#include "moserhex/HexMeshIO/HexMeshReader.h"
#include "moserhex/HexMeshIO/TransformFile.h"
#include "moserhex/Quality/HexQuality.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace moserhex::app
{
namespace
{

ReadOptions
readOptionsOf(const MeshCommandOptions & options)
{
  return { options.input.sandbox };
}

/** A transform that mirrors is one that goes the wrong way or is of another convention. */
Positions
movedByFile(const HexMesh & mesh, const MeshCommandOptions & options)
{
  HexMesh moved = mesh;
  moved.nodes = transformedByFile(options.align, mesh.nodes, readOptionsOf(options));
  const std::vector<double> before = cellVolumes(mesh);
  const std::vector<double> after = cellVolumes(moved);
  std::size_t               turned = 0;
  for (std::size_t cell = 0; cell < before.size(); ++cell)
  {
    turned += before[cell] > 0.0 && after[cell] <= 0.0 ? 1 : 0;
  }
  if (turned > 0)
  {
    throw BadInput(ErrorCode::Geometry,
                   options.align,
                   "it turns " + std::to_string(turned) + " of " + std::to_string(after.size()) +
                     " cells of the template inside out",
                   "give a transform that keeps left and right");
  }
  return moved.nodes;
}

ScalarVolume
readImage(const std::string & fileName, const MeshCommandOptions & options, std::vector<std::string> & warnings)
{
  const ScalarImage image = readScalarImage(fileName, readOptionsOf(options));
  warnings.insert(warnings.end(), image.warnings.begin(), image.warnings.end());
  return comparableVolume(image);
}

void
requireTemplate(const HexMesh & mesh, const MeshCommandOptions & options)
{
  if (mesh.nodesPerSide != 2 * options.shells || mesh.paddingLayers > 0)
  {
    throw BadInput(ErrorCode::NotHexahedra,
                   options.templateMesh,
                   "a template of " + std::to_string(mesh.nodesPerSide) + " nodes a side and " +
                     std::to_string(mesh.paddingLayers) + " layers of padding",
                   "give one of --shells " + std::to_string(options.shells) + " without padding");
  }
}

/** \throws BadInput  growth against uneven cells cannot be told */
void
requireEqualCells(const HexMesh & mesh, const MeshCommandOptions & options)
{
  constexpr double equal = 1e-6; // variance of the volumes [1]
  if (!(volumeQuality(mesh).volumeVariance <= equal))
  {
    throw BadInput(ErrorCode::Template,
                   options.templateMesh,
                   "the volumes of its cells differ, so growth against it cannot be told",
                   "tie to a mesh of equal cells");
  }
}

} // namespace

ScalarVolume
comparableVolume(const ScalarImage & image)
{
  ScalarVolume volume = itk::ScalarVolumeFromImage(image.image.GetPointer());
  if (!std::all_of(volume.values.begin(), volume.values.end(), [](double value) { return std::isfinite(value); }))
  {
    throw BadInput(
      ErrorCode::PixelType, image.fileName, "it holds values that are not finite", "fill them, with 0 for example");
  }
  return volume;
}

bool
isAlignedByFile(const MeshCommandOptions & options)
{
  return std::find(alignNames.begin(), alignNames.end(), options.align) == alignNames.end();
}

TemplateInputs
readTemplate(const MeshCommandOptions & options)
{
  HexMeshFile    file = readHexMeshFile(options.templateMesh, readOptionsOf(options));
  TemplateInputs inputs = tiedTo(std::move(file.mesh), options);
  if (const auto turn = turnOfLattice(options.templateMesh, file.meshArrays))
  {
    inputs.latticeTurn = turn->rotation;
    inputs.warnings.push_back(fileMessage(options.templateMesh, turn->description, "this mesh is turned alike"));
  }
  for (const std::string & warning : templateCellWarnings(cellRecordOf(options.templateMesh, file.meshArrays), options))
  {
    inputs.warnings.push_back(warning);
  }
  return inputs;
}

std::vector<std::string>
templateCellWarnings(const CellRecord & cells, const MeshCommandOptions & options)
{
  std::vector<std::string> warnings;
  const auto               warn = [&](const char * what, const char * consequence) {
    warnings.push_back(fileMessage(options.templateMesh, what, consequence));
  };
  if (cells.hasDensity && options.density.empty())
  {
    warn("its cells hold equal masses of a density, those of this mesh equal volumes",
         "nodes differ by that, too: give the same --density to both");
  }
  if (cells.hasLocalGrowth)
  {
    warn("its cells were free to grow, those of this mesh are not against it",
         "nodes differ by that, too: tie all visits to the baseline");
  }
  if (cells.isInexact)
  {
    warn("it was not made exact, or fell short of it", "nodes differ by what its cells are uneven");
  }
  return warnings;
}

TemplateInputs
tiedTo(HexMesh mesh, const MeshCommandOptions & options)
{
  requireTemplate(mesh, options);
  if (options.localGrowth)
  {
    requireEqualCells(mesh, options);
  }
  TemplateInputs inputs;
  inputs.mesh = std::move(mesh);
  if (isAlignedByFile(options))
  {
    inputs.nodesAtSolid = movedByFile(inputs.mesh, options);
  }
  if (!options.landmarks.empty())
  {
    CorrespondingLandmarks landmarks = readLandmarks(options.templateLandmarks, options.landmarks);
    inputs.refinement.landmarks = std::move(landmarks.points);
    inputs.warnings = std::move(landmarks.warnings);
  }
  inputs.refinement.localGrowth = options.localGrowth;
  if (!options.image.empty())
  {
    inputs.refinement.images = CorrespondingImages{ readImage(options.templateImage, options, inputs.warnings),
                                                    readImage(options.image, options, inputs.warnings) };
  }
  return inputs;
}

std::vector<RunReport::File>
templateFiles(const MeshCommandOptions & options)
{
  if (options.templateMesh.empty())
  {
    return {};
  }
  std::vector<RunReport::File> files{ { "mesh", options.templateMesh, {} },
                                      { "transform", isAlignedByFile(options) ? options.align : "", {} },
                                      { "template_landmarks", options.templateLandmarks, {} },
                                      { "landmarks", options.landmarks, {} },
                                      { "template_image", options.templateImage, {} },
                                      { "image", options.image, {} } };
  files.erase(
    std::remove_if(files.begin(), files.end(), [](const RunReport::File & file) { return file.name.empty(); }),
    files.end());
  return files;
}

std::vector<std::string>
inputFiles(const MeshCommandOptions & options)
{
  std::vector<std::string> names{ options.input.file };
  if (!options.density.empty())
  {
    names.push_back(options.density);
  }
  for (const RunReport::File & file : templateFiles(options))
  {
    names.push_back(file.name);
  }
  return names;
}

} // namespace moserhex::app
