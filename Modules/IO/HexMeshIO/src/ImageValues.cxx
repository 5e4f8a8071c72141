#include "ImageValues.h"

namespace moserhex
{

std::string
packedValues(const std::string & fileName, const std::string & itkName, bool sandboxed, VoxelContent content)
{
  std::string parcel;
  const auto  pack = [&](const ImageDescription & image, const auto & values) {
    if (image.layers != 1 && content == VoxelContent::OneValue)
    {
      throw BadInput(
        ErrorCode::Dimension, fileName, "segments in layers, need one number per voxel", "export one 3-D volume");
    }
    const std::uint64_t begin = values.size() * sizeof(values[0]);
    ParcelWriter        writer(std::string(reinterpret_cast<const char *>(values.data()), begin));
    writer.put(static_cast<int>(deliveredComponent(image)));
    writer.put(image.grid);
    writer.put(image.layers);
    writer.put(image.layout.masked ? 1 : 0);
    writer.put(image.symmetricTensors ? 1 : 0);
    writer.put(image.valuesToLps);
    writer.put(image.valuesInCubeAxes ? 1 : 0);
    writer.put(image.warnings);
    writer.put(begin);
    parcel = writer.take();
  };
  withCheckedVoxels(fileName, itkName, sandboxed, content, pack);
  return parcel;
}

} // namespace moserhex
