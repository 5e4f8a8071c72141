#include "moserhex/HexMeshIO/ScalarImageReader.h"

#include "ImageFile.h"
#include "ImageGrid.h"
#include "NiftiLink.h"
#include "Parcel.h"
#include "ReaderSandbox.h"

#include <cstring>
#include <stdexcept>

namespace moserhex
{
namespace
{

/** Voxels as they are, then grid, type and warnings. */
std::string
packedValues(const std::string & fileName, const std::string & itkName, bool sandboxed)
{
  std::string parcel;
  withCheckedVoxels(fileName, itkName, sandboxed, [&](const ImageDescription & image, const auto & values) {
    if (image.layers != 1)
    {
      throw BadInput(
        ErrorCode::Dimension, fileName, "segments in layers, need one number per voxel", "export one 3-D volume");
    }
    const std::uint64_t begin = values.size() * sizeof(values[0]);
    ParcelWriter        writer(std::string(reinterpret_cast<const char *>(values.data()), begin));
    writer.put(image.grid);
    writer.put(static_cast<int>(deliveredComponent(image)));
    writer.put(image.warnings);
    writer.put(begin);
    parcel = writer.take();
  });
  return parcel;
}

ScalarImage
unpack(const std::string & fileName, const std::string & bytes)
{
  const auto      begin = ParcelReader(bytes, bytes.size() - sizeof(std::uint64_t)).number<std::uint64_t>();
  ParcelReader    parcel(bytes, static_cast<std::size_t>(begin));
  const VoxelGrid grid = parcel.grid();
  const auto      type = static_cast<ComponentType>(parcel.number<int>());
  ScalarImage     result{ fileName, imageOnGrid<ScalarImageType>(grid), parcel.texts() };
  double * const  values = result.image->GetBufferPointer();
  withComponent(type, [&](auto value) {
    if (begin != grid.gridVoxels() * sizeof value)
    {
      throw std::out_of_range("the reader's answer does not fit its sizes");
    }
    for (std::size_t n = 0; n < grid.gridVoxels(); ++n)
    {
      std::memcpy(&value, bytes.data() + n * sizeof value, sizeof value);
      values[n] = static_cast<double>(value);
    }
  });
  return result;
}

} // namespace

ScalarImage
readScalarImage(const std::string & fileName, const ReadOptions & options)
{
  return withImageErrors(fileName, [&] {
    const NiftiLink link(fileName);
    const auto      work = [&] { return packedValues(fileName, link.name(), options.sandbox); };
    return unpack(fileName, options.sandbox ? runInSandbox(fileName, {}, work) : work());
  });
}

} // namespace moserhex
