#include "ImageFile.h"
#include "ImageFileCheck.h"

#include <cstring>

namespace moserhex
{
namespace
{

/** Where each value of the file stands among a voxel's: of symmetric matrices of any size the upper triangle's place of
 * an entry of the lower one. */
std::vector<std::size_t>
placesOfValues(const ImageDescription & image)
{
  const auto               count = static_cast<std::size_t>(image.layers);
  std::vector<std::size_t> places;
  if (!image.layout.lowerTriangle)
  {
    for (std::size_t value = 0; value < count; ++value)
    {
      places.push_back(value);
    }
    return places;
  }
  std::size_t rows = 1;
  while (rows * (rows + 1) / 2 < count)
  {
    ++rows;
  }
  for (std::size_t row = 0; row < rows; ++row)
  {
    for (std::size_t column = 0; column <= row; ++column)
    {
      places.push_back(column * rows - column * (column + 1) / 2 + row);
    }
  }
  return places;
}

} // namespace

std::vector<double>
rearrangedValues(const ImageDescription & image)
{
  std::vector<char> stored(static_cast<std::size_t>(image.promisedBytes));
  ImageDescription  decoded = image;
  checkVoxelBytes(decoded, stored.data());
  if (decoded.checksum != image.checksum)
  {
    throw BadInput(
      ErrorCode::ReaderFailed, image.fileName, "the voxels change while they are read", "read the file again");
  }
  const std::vector<std::size_t> places = placesOfValues(image);
  const std::size_t              count = places.size();
  const std::size_t              voxels = image.grid.gridVoxels();
  std::vector<double>            values(voxels * count);
  withComponent(image.component, [&](auto number) {
    for (std::size_t voxel = 0; voxel < voxels; ++voxel)
    {
      for (std::size_t value = 0; value < count; ++value)
      {
        const std::size_t from = image.layout.lastAxis ? value * voxels + voxel : voxel * count + value;
        std::memcpy(&number, stored.data() + from * sizeof number, sizeof number);
        values[voxel * count + places[value]] = image.slope * static_cast<double>(number) + image.intercept;
      }
    }
  });
  return values;
}

} // namespace moserhex
