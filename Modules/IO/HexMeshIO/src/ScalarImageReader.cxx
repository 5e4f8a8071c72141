#include "moserhex/HexMeshIO/ScalarImageReader.h"

#include "ImageFile.h"
#include "ImageGrid.h"

#include <algorithm>

namespace moserhex
{

ScalarImage
readScalarImage(const std::string & fileName)
{
  return withImageErrors(fileName, [&fileName] {
    const ImageFile file = openImageFile(fileName);
    ScalarImage     result{ fileName, imageOnGrid<ScalarImageType>(file.grid), file.warnings };
    withVoxels(file, [&](const auto & voxels) {
      std::transform(voxels.begin(), voxels.end(), result.image->GetBufferPointer(), [](auto voxel) {
        return static_cast<double>(voxel);
      });
    });
    return result;
  });
}

} // namespace moserhex
