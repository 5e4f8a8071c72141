#include "moserhex/HexMeshIO/FieldImageReader.h"

#include "ImageValues.h"

namespace moserhex
{

FieldImage
readFieldImage(const std::string & fileName, const ReadOptions & options)
{
  FieldImage result;
  result.fileName = fileName;
  readImageValues(fileName, VoxelContent::ManyValues, options, [&result](const ImageValuesHeader & header) {
    result.volume = FieldVolume{ header.grid, header.components, {} };
    result.volume.values.resize(header.grid.gridVoxels() * static_cast<std::size_t>(header.components));
    result.valuesInLps = header.valuesInLps;
    result.warnings = header.warnings;
    return result.volume.values.data();
  });
  return result;
}

} // namespace moserhex
