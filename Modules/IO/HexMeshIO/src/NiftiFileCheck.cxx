#include "ImageHeader.h"

#include "ByteSource.h"
#include "moserhex/HexMeshIO/FileErrors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <map>

namespace moserhex
{
namespace
{

namespace fs = std::filesystem;

/** The 348 bytes of a NIfTI-1 header in either byte order. */
class NiftiHeader
{
public:
  static constexpr std::size_t size = 348;

  NiftiHeader(const std::string & file, const std::array<char, size> & bytes) : m_Bytes(bytes)
  {
    m_Swap = integer<std::int32_t>(0) != 348;
    if (integer<std::int32_t>(0) != 348 || std::memcmp(m_Bytes.data() + 344, "n+1", 4) != 0)
    {
      throw BadInput(
        ErrorCode::Format, file, "the content is not NIfTI-1 in one file", "export the image as .nii.gz or .nrrd");
    }
  }

  template <typename T>
  [[nodiscard]] T
  integer(std::size_t offset) const
  {
    return read<T>(offset);
  }

  [[nodiscard]] double
  real(std::size_t offset) const
  {
    return static_cast<double>(read<float>(offset));
  }

private:
  template <typename T>
  [[nodiscard]] T
  read(std::size_t offset) const
  {
    std::array<char, sizeof(T)> bytes;
    std::copy_n(m_Bytes.begin() + static_cast<std::ptrdiff_t>(offset), sizeof(T), bytes.begin());
    if (m_Swap)
    {
      std::reverse(bytes.begin(), bytes.end());
    }
    T value;
    std::memcpy(&value, bytes.data(), sizeof(T));
    return value;
  }

  std::array<char, size> m_Bytes;
  bool                   m_Swap{ false };
};

std::uint64_t
niftiPromisedBytes(const std::string & file, const NiftiHeader & header)
{
  // Offsets of the NIfTI-1 header: dim 40, datatype 70, bitpix 72, pixdim 76.
  const int dimensions = header.integer<std::int16_t>(40);
  if (dimensions < 1 || dimensions > 7)
  {
    throw BadInput(ErrorCode::NotHexahedra,
                   file,
                   "the header gives " + std::to_string(dimensions) + " dimensions",
                   exportScalarVolume);
  }
  std::vector<std::string> sizes;
  for (int axis = 1; axis <= dimensions; ++axis)
  {
    const int count = header.integer<std::int16_t>(40 + 2 * static_cast<std::size_t>(axis));
    if (axis <= 3)
    {
      sizes.push_back(std::to_string(count));
    }
    else if (count != 1)
    {
      throw BadInput(ErrorCode::Dimension,
                     file,
                     "a " + std::to_string(dimensions) + "-D image (axis " + std::to_string(axis) + " has size " +
                       std::to_string(count) + "), need a 3-D image",
                     exportScalarVolume);
    }
  }
  // Bytes of the scalar types: integers of 1 to 8 bytes, float, double.
  static const std::map<int, int> bytesOfType{ { 2, 1 },   { 4, 2 },   { 8, 4 },   { 16, 4 },   { 64, 8 },
                                               { 256, 1 }, { 512, 2 }, { 768, 4 }, { 1024, 8 }, { 1280, 8 } };
  const int                       type = header.integer<std::int16_t>(70);
  const int                       bits = header.integer<std::int16_t>(72);
  const auto                      entry = bytesOfType.find(type);
  if (entry == bytesOfType.end() || bits != 8 * entry->second)
  {
    throw BadInput(ErrorCode::PixelType,
                   file,
                   "data type " + std::to_string(type) + " with " + std::to_string(bits) +
                     " bits per voxel is not a scalar image",
                   exportScalarVolume);
  }
  return promisedBytes(file, sizes, static_cast<std::uint64_t>(bits) / 8);
}

void
requireNiftiGeometry(const std::string & file, const NiftiHeader & header)
{
  // pixdim[0..7] at 76, vox_offset 108, quaternion and offset 256..280, rows of the sform 280..328.
  std::vector<std::size_t> offsets{ 108 };
  for (std::size_t offset = 76; offset < 108; offset += 4)
  {
    offsets.push_back(offset);
  }
  for (std::size_t offset = 256; offset < 328; offset += 4)
  {
    offsets.push_back(offset);
  }
  for (const std::size_t offset : offsets)
  {
    if (!(std::abs(header.real(offset)) < 1e9))
    {
      throw BadInput(ErrorCode::Geometry,
                     file,
                     "the header's geometry holds a number that is not finite or above 1e9",
                     "correct the header");
    }
  }
  for (std::size_t axis = 1; axis <= 3; ++axis)
  {
    const double spacing = header.real(76 + 4 * axis);
    if (!(spacing > 0.0))
    {
      throw BadInput(ErrorCode::Geometry,
                     file,
                     "voxel size " + std::to_string(spacing) + " along axis " + std::to_string(axis),
                     "set pixdim to the voxel size in mm");
    }
  }
}

NiftiHeader
readHeader(const std::string & file, GzipFile & source)
{
  std::array<char, NiftiHeader::size> bytes{};
  if (source.read(bytes.data(), bytes.size()) != bytes.size())
  {
    throw BadInput(ErrorCode::Truncated, file, "the file ends within its header", copyAgain);
  }
  return NiftiHeader(file, bytes);
}

} // namespace

std::optional<std::array<double, 3>>
niftiColumnLengths(const std::string & file)
{
  GzipFile          source(file);
  const NiftiHeader header = readHeader(file, source);
  if (header.integer<std::int16_t>(254) <= 0) // sform_code
  {
    return std::nullopt;
  }
  std::array<double, 3> lengths{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::size_t place = 280 + 4 * axis; // of the first of three rows of 16 bytes
    lengths[axis] = std::hypot(header.real(place), header.real(place + 16), header.real(place + 32));
  }
  return lengths;
}

std::vector<std::string>
checkNiftiFile(const std::string & file)
{
  GzipFile          source(file);
  const NiftiHeader header = readHeader(file, source);
  requireNiftiGeometry(file, header);
  const std::uint64_t voxelBytes = niftiPromisedBytes(file, header);
  const double        offset = header.real(108);
  if (!(offset >= 352.0 && offset <= 1e7))
  {
    throw BadInput(
      ErrorCode::Truncated, file, "data offset " + std::to_string(offset) + ", need 352 or more", "correct the header");
  }
  if (voxelBytes / deflateLimit > fs::file_size(file))
  {
    throw BadInput(ErrorCode::Truncated, file, "the header promises more voxels than the file can hold", copyAgain);
  }
  const auto          begin = static_cast<std::uint64_t>(offset);
  const std::uint64_t total = NiftiHeader::size + source.skipToEnd();
  requireData(file, voxelBytes, total > begin ? total - begin : 0);
  if (total > begin + voxelBytes)
  {
    return { file + ": " + std::to_string(total - begin - voxelBytes) + " bytes after the voxels were ignored" };
  }
  return {};
}

} // namespace moserhex
