#include "ByteSource.h"
#include "FileText.h"
#include "ImageFileCheck.h"
#include "ImageHeader.h"
#include "moserhex/HexMeshIO/FileErrors.h"

#include <itk_zlib.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace moserhex
{
namespace
{

constexpr std::size_t   chunkSize = 1 << 18; // a multiple of every component's size
constexpr std::uint64_t searchBehind = 16 << 20;

ByteSource::Coding
codingOf(VoxelEncoding encoding)
{
  switch (encoding)
  {
    case VoxelEncoding::Gzip:
      return ByteSource::Coding::Gzip;
    case VoxelEncoding::GzipOrRaw:
      return ByteSource::Coding::GzipOrPlain;
    case VoxelEncoding::Zlib:
      return ByteSource::Coding::Zlib;
    case VoxelEncoding::Raw:
    case VoxelEncoding::Text:
      break;
  }
  return ByteSource::Coding::Plain;
}

/** Where decoded bytes go: into the image's checksum, and to where they are kept. */
class DecodedVoxels
{
public:
  DecodedVoxels(ImageDescription & image, char * kept) : m_Image(image), m_Kept(kept)
  {
    m_Image.checksum = 0;
  }

  void
  add(const void * bytes, std::size_t count)
  {
    m_Image.checksum = static_cast<std::uint32_t>(
      crc32(m_Image.checksum, static_cast<const unsigned char *>(bytes), static_cast<unsigned int>(count)));
    if (m_Kept != nullptr)
    {
      std::memcpy(m_Kept, bytes, count);
      m_Kept += count;
    }
  }

private:
  ImageDescription & m_Image;
  char *             m_Kept;
};

void
swapComponents(char * bytes, std::size_t count, std::size_t componentSize)
{
  for (char * component = bytes; component + componentSize <= bytes + count; component += componentSize)
  {
    std::reverse(component, component + componentSize);
  }
}

/** ITK's NIfTI reader makes 0 of numbers that are not finite; so that what it delivers can be compared, they are 0 here
 * too, and counted. */
template <typename TComponent>
std::size_t
clearNonFinite(char * bytes, std::size_t count, TComponent)
{
  std::size_t cleared = 0;
  for (std::size_t begin = 0; begin + sizeof(TComponent) <= count; begin += sizeof(TComponent))
  {
    TComponent number{};
    std::memcpy(&number, bytes + begin, sizeof number);
    if (!std::isfinite(static_cast<double>(number)))
    {
      std::memset(bytes + begin, 0, sizeof number);
      ++cleared;
    }
  }
  return cleared;
}

void
warnOfTrailingBytes(ImageDescription & image, std::uint64_t count, bool more)
{
  if (count > 0)
  {
    image.warnings.push_back(image.dataFile + (more ? ": more than " : ": ") + std::to_string(count) +
                             " bytes after the voxels were ignored");
  }
}

void
checkBinary(ImageDescription & image, ByteSource & source, DecodedVoxels & voxels)
{
  const bool mayBeCleared =
    image.format == ImageFormat::Nifti && isFloatingPoint(image.component) && !image.keepsNonFinite;
  std::vector<char> chunk(chunkSize);
  std::uint64_t     present = 0;
  std::uint64_t     cleared = 0;
  while (present < image.promisedBytes)
  {
    const auto part = static_cast<std::size_t>(std::min<std::uint64_t>(chunk.size(), image.promisedBytes - present));
    const auto count = source.read(chunk.data(), part);
    if (image.swapped)
    {
      swapComponents(chunk.data(), count, static_cast<std::size_t>(image.bytesPerComponent));
    }
    if (mayBeCleared)
    {
      cleared += withComponent(image.component, [&](auto zero) { return clearNonFinite(chunk.data(), count, zero); });
    }
    voxels.add(chunk.data(), count);
    present += count;
    if (count < part)
    {
      throw BadInput(ErrorCode::Truncated,
                     image.dataFile,
                     "the file ends early: " + std::to_string(image.promisedBytes) + " bytes of voxels promised, " +
                       std::to_string(present) + " found",
                     copyAgain);
    }
  }
  if (cleared > 0)
  {
    image.warnings.push_back(image.dataFile + ": " + std::to_string(cleared) +
                             " values that are not finite were read as 0");
  }
  if (image.encoding == VoxelEncoding::Raw)
  {
    warnOfTrailingBytes(image, source.unusedBytes(), false);
    return;
  }
  const std::uint64_t behind = source.skip(searchBehind);
  const bool          more = behind == searchBehind;
  warnOfTrailingBytes(image, behind + (more ? 0 : source.unusedBytes()), more);
}

/** \throws BadInput (Header)  no number of the voxel type */
template <typename TComponent>
void
addNumber(const ImageDescription & image, const std::string & word, TComponent, DecodedVoxels & voxels)
{
  TComponent number{};
  if (!parseNumber(word, number))
  {
    throwHeader(image.fileName, "a voxel is " + quoted(word) + ", which the voxel type does not hold");
  }
  voxels.add(&number, sizeof number);
}

void
checkText(ImageDescription & image, ByteSource & source, DecodedVoxels & voxels)
{
  constexpr std::size_t longestWord = 64;
  const std::uint64_t   promised = image.promisedBytes / image.bytesPerComponent;
  std::uint64_t         present = 0;
  std::vector<char>     chunk(chunkSize);
  std::string           word;
  const auto            endWord = [&] {
    if (word.empty())
    {
      return;
    }
    withComponent(image.component, [&](auto zero) { addNumber(image, word, zero, voxels); });
    word.clear();
    ++present;
  };
  std::size_t count = 0;
  std::size_t at = 0;
  for (; present < promised; ++at)
  {
    if (at == count)
    {
      at = 0;
      count = source.read(chunk.data(), chunk.size());
      if (count == 0)
      {
        endWord();
        break;
      }
    }
    if (std::strchr(" \t\r\n", chunk[at]) && chunk[at] != '\0')
    {
      endWord();
    }
    else if ((word += chunk[at]).size() > longestWord)
    {
      throwHeader(image.fileName, "a voxel is " + quoted(word) + ", which is not a number");
    }
  }
  if (present < promised)
  {
    throw BadInput(ErrorCode::Truncated,
                   image.dataFile,
                   "the file ends early: " + std::to_string(promised) + " numbers promised, " +
                     std::to_string(present) + " found",
                   copyAgain);
  }
  std::uint64_t behind = source.unusedBytes();
  for (; at < count; ++at)
  {
    behind += std::strchr(" \t\r\n", chunk[at]) && chunk[at] != '\0' ? 0 : 1;
  }
  warnOfTrailingBytes(image, behind, false);
}

} // namespace

void
checkVoxelBytes(ImageDescription & image, char * kept)
{
  const bool withHeader = image.encoding == VoxelEncoding::GzipOrRaw;
  ByteSource source(image.dataFile, codingOf(image.encoding), withHeader ? 0 : image.dataBegin, image.storedBytes);
  if (withHeader)
  {
    (void)source.skip(image.dataBegin);
  }
  DecodedVoxels voxels(image, kept);
  if (image.encoding == VoxelEncoding::Text)
  {
    checkText(image, source, voxels);
  }
  else
  {
    checkBinary(image, source, voxels);
  }
}

} // namespace moserhex
