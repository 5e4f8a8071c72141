#pragma once

#include "ImageFile.h"
#include "NiftiLink.h"
#include "Parcel.h"
#include "ReaderSandbox.h"
#include "moserhex/HexMeshIO/ReadOptions.h"

#include <cstring>
#include <optional>
#include <stdexcept>

namespace moserhex
{

/** What an image's header says of its values. */
struct ImageValuesHeader
{
  VoxelGrid                grid;
  int                      components{ 1 }; ///< values per voxel, a mask among them
  bool                     masked{ false }; ///< the first is the mask
  bool                     symmetricTensors{ false };
  std::optional<Matrix3>   valuesToLps{ Matrix3::Identity() }; ///< nothing: the file leaves their space open
  bool                     inCubeAxes{ false };
  std::vector<std::string> warnings;
};

/** Checks and reads a file, values first as they are, then the header and their type. */
[[nodiscard]] std::string
packedValues(const std::string & fileName, const std::string & itkName, bool sandboxed, VoxelContent content);

/** \param bufferFor  given the header, makes room for its values: double * */
template <typename TBufferFor>
void
unpackValues(const std::string & bytes, const TBufferFor & bufferFor)
{
  const auto        begin = ParcelReader(bytes, bytes.size() - sizeof(std::uint64_t)).number<std::uint64_t>();
  ParcelReader      parcel(bytes, static_cast<std::size_t>(begin));
  const auto        type = static_cast<ComponentType>(parcel.number<int>());
  ImageValuesHeader header;
  header.grid = parcel.grid();
  header.components = parcel.number<int>();
  header.masked = parcel.number<int>() != 0;
  header.symmetricTensors = parcel.number<int>() != 0;
  header.valuesToLps = parcel.matrix();
  header.inCubeAxes = parcel.number<int>() != 0;
  header.warnings = parcel.texts();
  const std::size_t count = header.grid.gridVoxels() * static_cast<std::size_t>(header.components);
  withComponent(type, [&](auto value) {
    if (begin != count * sizeof value)
    {
      throw std::out_of_range("the reader's answer does not fit its sizes");
    }
    double * const values = bufferFor(header);
    for (std::size_t n = 0; n < count; ++n)
    {
      std::memcpy(&value, bytes.data() + n * sizeof value, sizeof value);
      values[n] = static_cast<double>(value);
    }
  });
}

/** Reads an image's values as double. \param bufferFor  see unpackValues \throws BadInput, IOError */
template <typename TBufferFor>
void
readImageValues(const std::string & fileName,
                VoxelContent        content,
                const ReadOptions & options,
                const TBufferFor &  bufferFor)
{
  withImageErrors(fileName, [&] {
    const NiftiLink link(fileName);
    const auto      work = [&] { return packedValues(fileName, link.name(), options.sandbox, content); };
    unpackValues(options.sandbox ? runInSandbox(fileName, {}, work) : work(), bufferFor);
  });
}

} // namespace moserhex
