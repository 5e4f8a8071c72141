#include "NrrdAxes.h"

#include "ImageHeader.h"
#include "moserhex/HexMeshIO/FileErrors.h"

#include <algorithm>
#include <map>

namespace moserhex
{
namespace
{

bool
isSpatialKind(const std::string & kind)
{
  return kind.empty() || kind == "domain" || kind == "space" || kind == "???" || kind == "none";
}

[[noreturn]] void
throwExtraAxis(const ImageDescription & image, const NrrdAxes & axes, std::size_t axis)
{
  const std::string & kind = axes.kinds[axis];
  const std::string   count = std::to_string(axes.sizes[axis]);
  if (kind.empty() || isSpatialKind(kind) || kind == "list" || kind == "time")
  {
    throw BadInput(ErrorCode::Dimension,
                   image.fileName,
                   "a " + std::to_string(axes.sizes.size()) + "-D image of " + count + " volumes, need a 3-D image",
                   "export one 3-D volume");
  }
  throw BadInput(ErrorCode::PixelType,
                 image.fileName,
                 count + " values per voxel (" + quoted(kind) + "), need one",
                 exportScalarVolume);
}

/** The fields of the axes, as many entries as there are axes. */
NrrdAxes
axesOfHeader(const NrrdHeader & header, const ImageDescription & image)
{
  constexpr std::uint64_t mostDimensions = 16;
  const auto              dimension = countsOf(image.fileName, "dimension", header.get("dimension"));
  if (dimension.size() != 1 || dimension[0] == 0 || dimension[0] > mostDimensions)
  {
    throwHeader(image.fileName, "dimension " + quoted(header.get("dimension")) + ", need 3");
  }
  const std::size_t axisCount = dimension[0];
  const auto        requireCount = [&](const char * field, std::size_t count) {
    if (count != axisCount)
    {
      throwHeader(image.fileName,
                  std::string(field) + " are " + std::to_string(count) + " for dimension " + std::to_string(axisCount));
    }
  };
  NrrdAxes axes;
  axes.sizes = countsOf(image.fileName, "sizes", header.get("sizes"));
  requireCount("sizes", axes.sizes.size());
  axes.kinds.resize(axisCount);
  if (header.has("kinds"))
  {
    axes.kinds = wordsOf(lowerCase(header.get("kinds")));
    requireCount("kinds", axes.kinds.size());
  }
  if (header.has("space directions"))
  {
    axes.directions = spaceVectorsOf(image.fileName, "space directions", header.get("space directions"));
    requireCount("space directions", axes.directions.size());
  }
  return axes;
}

bool
isMaskedKind(const std::string & kind)
{
  return kind.find("-masked-") != std::string::npos;
}

/** Whether the first or the last axis of a file may be one of values. */
bool
mayHoldValues(const std::string & kind, std::uint64_t size)
{
  return !isSpatialKind(kind) && kind != "time" && size <= mostValuesPerVoxel;
}

/** \throws BadInput (Header)  a kind of another number of values; of other kinds any number is right */
void
requireSizeOfKind(const std::string & file, const std::string & kind, std::uint64_t size)
{
  static const std::map<std::string, std::uint64_t> sizes{
    { "2d-symmetric-matrix", 3 }, { "2d-masked-symmetric-matrix", 4 }, { "2d-matrix", 4 }, { "2d-masked-matrix", 5 },
    { "3d-symmetric-matrix", 6 }, { "3d-masked-symmetric-matrix", 7 }, { "3d-matrix", 9 }, { "3d-masked-matrix", 10 }
  };
  const auto entry = sizes.find(kind);
  if ((entry != sizes.end() && entry->second != size) || (entry == sizes.end() && isMaskedKind(kind)))
  {
    throwHeader(file, std::to_string(size) + " values per voxel of kind " + quoted(kind));
  }
}

/** Sorts the axes into three of space and others. \throws BadInput (Dimension, PixelType, Geometry) */
void
findSpatialAxes(const ImageDescription & image, bool segmentation, VoxelContent content, NrrdAxes & axes)
{
  const std::size_t axisCount = axes.sizes.size();
  if (axisCount < 3)
  {
    throw BadInput(ErrorCode::Dimension,
                   image.fileName,
                   "a " + std::to_string(axisCount) + "-D image, need a 3-D image",
                   exportScalarVolume);
  }
  const auto & directions = axes.directions;
  if (!directions.empty() && std::none_of(directions.begin(), directions.end(), [](const auto & v) { return v; }))
  {
    throw BadInput(ErrorCode::Geometry, image.fileName, "no axis has a direction in space", correctHeader);
  }
  for (std::size_t axis = 0; axis < axisCount; ++axis)
  {
    const bool directed = directions.empty() || directions[axis];
    if (directed && isSpatialKind(axes.kinds[axis]) && axes.spatial.size() < 3)
    {
      axes.spatial.push_back(axis);
    }
    else if (axis == 0 && segmentation && axes.kinds[0] != "rgb-color")
    {
      axes.layers = axes.sizes[0];
    }
    else if (content == VoxelContent::ManyValues && axes.layers == 1 && (axis == 0 || axis + 1 == axisCount) &&
             mayHoldValues(axes.kinds[axis], axes.sizes[axis]))
    {
      requireSizeOfKind(image.fileName, axes.kinds[axis], axes.sizes[axis]);
      axes.layers = axes.sizes[axis];
      axes.layout.lastAxis = axis > 0 && axes.layers > 1;
      axes.layout.masked = isMaskedKind(axes.kinds[axis]);
      axes.symmetricTensors =
        axes.kinds[axis] == "3d-symmetric-matrix" || axes.kinds[axis] == "3d-masked-symmetric-matrix";
    }
    else if (axes.sizes[axis] != 1)
    {
      throwExtraAxis(image, axes, axis);
    }
  }
  if (axes.spatial.size() != 3)
  {
    throw BadInput(ErrorCode::Dimension,
                   image.fileName,
                   std::to_string(axes.spatial.size()) + " axes of space, need a 3-D image",
                   exportScalarVolume);
  }
}

} // namespace

std::vector<SpaceVector>
spaceVectorsOf(const std::string & file, const std::string & field, const std::string & text)
{
  std::vector<SpaceVector> vectors;
  std::size_t              at = 0;
  while ((at = text.find_first_not_of(" \t", at)) != std::string::npos)
  {
    if (text.compare(at, 4, "none") == 0)
    {
      vectors.emplace_back(std::nullopt);
      at += 4;
      continue;
    }
    const auto end = text.find(')', at);
    if (text[at] != '(' || end == std::string::npos)
    {
      throwHeader(file, field + " is " + quoted(text.substr(at)) + ", need (x,y,z) or none");
    }
    std::string inside = text.substr(at + 1, end - at - 1);
    const auto  commas = static_cast<std::size_t>(std::count(inside.begin(), inside.end(), ','));
    std::replace(inside.begin(), inside.end(), ',', ' ');
    vectors.emplace_back(numbersOf(file, field, inside, commas + 1));
    if (commas != 2)
    {
      throwHeader(file, field + " holds a vector of " + std::to_string(commas + 1) + " components, need 3");
    }
    at = end + 1;
  }
  return vectors;
}

NrrdAxes
nrrdAxes(const NrrdHeader & header, const ImageDescription & image, VoxelContent content)
{
  NrrdAxes   axes = axesOfHeader(header, image);
  const bool isSegmentation = header.keyValues.count("Segment0_ID") + header.keyValues.count("Segment0_Name") > 0;
  findSpatialAxes(image, isSegmentation, content, axes);
  return axes;
}

} // namespace moserhex
