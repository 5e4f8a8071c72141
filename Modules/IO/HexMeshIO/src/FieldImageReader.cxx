#include "moserhex/HexMeshIO/FieldImageReader.h"

#include "ImageValues.h"

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
    result.valuesInLps = header.valuesInLps;
    result.warnings = header.warnings;
    return result.volume.values.data();
  });
  if (isMasked)
  {
    takeMaskOut(result);
  }
  return result;
}

} // namespace moserhex
