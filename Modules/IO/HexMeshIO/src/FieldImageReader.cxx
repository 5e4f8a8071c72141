#include "moserhex/HexMeshIO/FieldImageReader.h"

#include "ImageValues.h"

#include <algorithm>
#include <cmath>

namespace moserhex
{

namespace
{

/** Takes the first of each voxel's values, a mask from 0 to 1, apart. */
void
takeMaskOut(FieldImage & image)
{
  constexpr double  least = 0.5;
  FieldVolume &     volume = image.volume;
  const std::size_t voxels = volume.gridVoxels();
  const FieldVolume masked = volume;
  --volume.components;
  volume.values.clear();
  for (std::size_t voxel = 0; voxel < voxels; ++voxel)
  {
    const double * const first = masked.at(voxel);
    image.hasValue.push_back(*first >= least ? 1 : 0);
    volume.values.insert(volume.values.end(), first + 1, first + masked.components);
  }
}

/** Takes data from voxels with a number that is not finite. */
void
leaveNonFiniteOut(FieldImage & image)
{
  const FieldVolume & volume = image.volume;
  const auto          isWhole = [&volume](std::size_t voxel) {
    const double * const first = volume.at(voxel);
    return std::all_of(first, first + volume.components, [](double value) { return std::isfinite(value); });
  };
  std::size_t count = 0;
  for (std::size_t voxel = 0; voxel < volume.gridVoxels(); ++voxel)
  {
    if ((!image.hasValue.empty() && image.hasValue[voxel] == 0) || isWhole(voxel))
    {
      continue;
    }
    image.hasValue.resize(volume.gridVoxels(), 1);
    image.hasValue[voxel] = 0;
    ++count;
  }
  if (count > 0)
  {
    image.warnings.push_back(image.fileName + ": " + std::to_string(count) +
                             " voxels are not finite numbers and count as without data");
  }
}

} // namespace

FieldImage
readFieldImage(const std::string & fileName, const ReadOptions & options)
{
  FieldImage result;
  result.fileName = fileName;
  bool isMasked = false;
  readImageValues(fileName, VoxelContent::ManyValues, options, [&](const ImageValuesHeader & header) {
    result.volume = FieldVolume{ header.grid, header.components, {} };
    result.volume.values.resize(header.grid.gridVoxels() * static_cast<std::size_t>(header.components));
    isMasked = header.masked;
    result.kind = header.symmetricTensors ? FieldValues::SymmetricTensors : FieldValues::Numbers;
    result.valuesToLps = header.valuesToLps;
    result.inCubeAxes = header.inCubeAxes;
    result.warnings = header.warnings;
    result.gridWarnings = header.warnings;
    return result.volume.values.data();
  });
  if (isMasked)
  {
    takeMaskOut(result);
  }
  leaveNonFiniteOut(result);
  return result;
}

} // namespace moserhex
