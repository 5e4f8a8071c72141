#include "TransferFiles.h"

#include "CommandErrors.h"
#include "moserhex/CubeTransfer/CubeAxes.h"
#include "moserhex/HexMeshIO/HexMeshReader.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

namespace moserhex::app
{
namespace
{

constexpr int    mostVoxelsPerAxis = 4096;
constexpr double mostVoxels = 5e8; ///< numbers that image files may hold

void
tell(const TransferLog & log, const std::vector<std::string> & warnings)
{
  for (const std::string & warning : warnings)
  {
    log.warn(warning);
  }
}

TransferImage
readLabels(const TransferOptions & options, const TransferLog & log)
{
  LabelReadOptions reading;
  reading.sandbox = options.sandbox;
  reading.allowEmpty = true;
  reading.remedyForFractions = "leave --labels out for a probability map";
  if (!options.segment.empty())
  {
    reading.segment = options.segment;
  }
  const LabelImage image = readLabelImage(options.input, reading);
  tell(log, image.warnings);
  if (!image.labels.empty() && image.labels.back().value > mostLabelValue)
  {
    throw BadInput(ErrorCode::Labels,
                   options.input,
                   "label " + std::to_string(image.labels.back().value) + ", at most " + std::to_string(mostLabelValue),
                   "number the labels from 1");
  }
  const LabelValues values = labelValuesOf(*image.image);
  return {
    FieldVolume{ values, 1, { values.values.begin(), values.values.end() } }, {}, image.labels, FieldValues::Labels
  };
}

/** What takes vectors to LPS. \param space  LPS or RAS */
Matrix3
matrixToLps(const std::string & space)
{
  return space == "RAS" ? Matrix3(Vector3(-1.0, -1.0, 1.0).asDiagonal()) : Matrix3(Matrix3::Identity());
}

/** \throws BadInput  numbers that are to be turned cannot be */
void
requireTurnable(const TransferOptions & options, const FieldImage & image)
{
  const FieldVolume & volume = image.volume;
  if (!canBeTurned(volume.components))
  {
    throw BadInput(ErrorCode::PixelType,
                   options.input,
                   std::to_string(volume.components) + " numbers per voxel, --rotate needs vectors (3) or symmetric "
                                                       "tensors (6)",
                   "leave --rotate out");
  }
  const bool isFromCube = options.toCube.empty() && options.toMesh.empty();
  if (!isFromCube && !image.valuesToLps && !image.inCubeAxes && options.valuesIn.empty())
  {
    throw BadInput(ErrorCode::Geometry,
                   options.input,
                   "the vectors or tensors are not known to be in LPS",
                   "say --values-in LPS or RAS, or leave --rotate out");
  }
}

/** Puts what is to be turned into LPS where its axes are known. \return the axes then */
ValueAxes
putIntoLps(const TransferOptions & options, FieldImage & image)
{
  if (image.inCubeAxes)
  {
    return ValueAxes::Cube;
  }
  const std::optional<Matrix3> toLps = options.valuesIn.empty() ? image.valuesToLps : matrixToLps(options.valuesIn);
  FieldVolume &                volume = image.volume;
  if (!toLps)
  {
    return ValueAxes::Unknown;
  }
  if (*toLps == Matrix3::Identity())
  {
    return ValueAxes::Lps;
  }
  if (!options.rotate) // every number by itself: a list, a colour
  {
    return ValueAxes::Unknown;
  }
  for (std::size_t voxel = 0; voxel < volume.gridVoxels(); ++voxel)
  {
    turn(*toLps, volume.components, volume.at(voxel));
  }
  return ValueAxes::Lps;
}

/** Vectors leave the cube as they have come: turned, or not. */
void
requireCubeAxes(const TransferOptions & options, const TransferLog & log, ValueAxes axes)
{
  const bool isFromCube = options.toCube.empty() && options.toMesh.empty();
  if (axes == ValueAxes::Cube && !(isFromCube && options.rotate))
  {
    throw BadInput(ErrorCode::Geometry,
                   options.input,
                   "its vectors or tensors are in the cube's axes",
                   "turn them back by --rotate, from the cube to a subject");
  }
  if (isFromCube && options.rotate && axes != ValueAxes::Cube)
  {
    log.warn(fileMessage(options.input,
                         "does not say that its vectors or tensors are in the cube's axes",
                         "if it was made without --rotate, leave --rotate out"));
  }
}

/** Around the mesh, with centres half a voxel within its box's ends. */
VoxelGrid
gridAround(const HexMesh & mesh, const Vector3 & spacing)
{
  Vector3 lower = mesh.nodes.front();
  Vector3 upper = lower;
  for (const Vector3 & node : mesh.nodes)
  {
    lower = lower.cwiseMin(node);
    upper = upper.cwiseMax(node);
  }
  VoxelGrid grid;
  grid.spacing = spacing;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double count = std::ceil((upper - lower)[axis] / spacing[axis]);
    if (!(count <= mostVoxelsPerAxis))
    {
      throw UsageError("--spacing is too small: more than " + std::to_string(mostVoxelsPerAxis) +
                       " voxels along an axis");
    }
    grid.size[static_cast<std::size_t>(axis)] = std::max(static_cast<int>(count), 1);
    grid.origin[axis] =
      0.5 * (lower + upper)[axis] - 0.5 * spacing[axis] * (grid.size[static_cast<std::size_t>(axis)] - 1);
  }
  if (static_cast<double>(grid.gridVoxels()) > mostVoxels)
  {
    throw UsageError("--spacing is too small: " + std::to_string(grid.gridVoxels()) + " voxels");
  }
  return grid;
}

} // namespace

HexMesh
readTransferMesh(const std::string & fileName, const TransferOptions & options)
{
  HexMesh mesh = readHexMesh(fileName, { options.sandbox });
  if (mesh.paddingLayers > 0)
  {
    throw BadInput(ErrorCode::NotHexahedra,
                   fileName,
                   "a mesh with padding, whose lattice ends inside the organ",
                   "give the mesh made without --padding");
  }
  const std::vector<double> volumes = cellVolumes(mesh);
  const auto bad = std::find_if(volumes.begin(), volumes.end(), [](double volume) { return !(volume > 0.0); });
  if (bad != volumes.end())
  {
    throw BadInput(ErrorCode::Precondition,
                   fileName,
                   "cell " + std::to_string(bad - volumes.begin()) + " has no positive volume",
                   "give a mesh that moserhex quality certifies");
  }
  return mesh;
}

TransferImage
readTransferImage(const TransferOptions & options, const TransferLog & log)
{
  if (options.labels)
  {
    return readLabels(options, log);
  }
  FieldImage image = readFieldImage(options.input, { options.sandbox });
  tell(log, image.warnings);
  if (options.rotate)
  {
    requireTurnable(options, image);
  }
  const ValueAxes axes = image.volume.components == 1 ? ValueAxes::Lps : putIntoLps(options, image);
  requireCubeAxes(options, log, axes);
  return { std::move(image.volume), std::move(image.hasValue), {}, image.kind, axes };
}

VoxelGrid
readTargetGrid(const TransferOptions & options, const HexMesh & mesh, int components, const TransferLog & log)
{
  VoxelGrid grid;
  if (!options.like.empty())
  {
    const FieldImage image = readFieldImage(options.like, { options.sandbox });
    tell(log, image.gridWarnings);
    grid = image.volume;
  }
  else
  {
    const std::vector<double> & spacing = options.spacing;
    const double                last = spacing.back();
    grid = gridAround(mesh, spacing.size() == 1 ? Vector3(last, last, last) : Vector3(spacing[0], spacing[1], last));
  }
  requireWritableSize(static_cast<double>(grid.gridVoxels()) * components,
                      options.like.empty() ? "--spacing" : "--like");
  return grid;
}

void
requireWritableSize(double numbers, const std::string & option)
{
  if (numbers > mostVoxels)
  {
    char text[80];
    std::snprintf(text, sizeof text, ": %.3g numbers, more than an image file may hold (%.0e)", numbers, mostVoxels);
    throw UsageError(option + text);
  }
}

FieldValues
valuesOf(const TransferOptions & options, const TransferImage & image)
{
  constexpr int tensorComponents = 6;
  if (options.labels)
  {
    return options.fractions ? FieldValues::Numbers : FieldValues::Labels;
  }
  return options.rotate && image.volume.components == tensorComponents ? FieldValues::SymmetricTensors : image.kind;
}

} // namespace moserhex::app
