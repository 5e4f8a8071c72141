#include "moserhex/HexMeshIO/ScalarImageReader.h"

#include "ImageGrid.h"
#include "ImageValues.h"

namespace moserhex
{

ScalarImage
readScalarImage(const std::string & fileName, const ReadOptions & options)
{
  ScalarImage result{ fileName, {}, {} };
  readImageValues(fileName, VoxelContent::OneValue, options, [&result](const ImageValuesHeader & header) {
    result.image = imageOnGrid<ScalarImageType>(header.grid);
    result.warnings = header.warnings;
    return result.image->GetBufferPointer();
  });
  return result;
}

} // namespace moserhex
