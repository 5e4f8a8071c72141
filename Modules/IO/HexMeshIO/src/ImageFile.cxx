#include "ImageFile.h"

#include "ImageFileCheck.h"
#include "ReaderSandbox.h"

#include <itkMetaImageIO.h>
#include <itkNiftiImageIO.h>
#include <itkNrrdImageIO.h>
#include <itk_zlib.h>

#include <algorithm>
#include <cstring>

namespace moserhex
{
namespace
{

itk::ImageIOBase::Pointer
makeReader(ImageFormat format)
{
  switch (format)
  {
    case ImageFormat::Nifti:
      return itk::NiftiImageIO::New().GetPointer();
    case ImageFormat::Meta:
      return itk::MetaImageIO::New().GetPointer();
    case ImageFormat::Nrrd:
      break;
  }
  return itk::NrrdImageIO::New().GetPointer();
}

bool
isComponent(itk::ImageIOBase::IOComponentEnum seen, ComponentType expected)
{
  using Component = itk::ImageIOBase::IOComponentEnum;
  switch (seen)
  {
    case Component::UCHAR:
      return expected == ComponentType::UInt8;
    case Component::CHAR:
      return expected == ComponentType::Int8;
    case Component::USHORT:
      return expected == ComponentType::UInt16;
    case Component::SHORT:
      return expected == ComponentType::Int16;
    case Component::UINT:
      return expected == ComponentType::UInt32;
    case Component::INT:
      return expected == ComponentType::Int32;
    case Component::ULONG:
      return expected == (sizeof(unsigned long) == 8 ? ComponentType::UInt64 : ComponentType::UInt32);
    case Component::LONG:
      return expected == (sizeof(long) == 8 ? ComponentType::Int64 : ComponentType::Int32);
    case Component::ULONGLONG:
      return expected == ComponentType::UInt64;
    case Component::LONGLONG:
      return expected == ComponentType::Int64;
    case Component::FLOAT:
      return expected == ComponentType::Float32;
    case Component::DOUBLE:
      return expected == ComponentType::Float64;
    default:
      return false;
  }
}

/** Two parsers must agree before a buffer is filled. */
void
requireSameImage(const ImageDescription & image, const itk::ImageIOBase & reader)
{
  bool          same = isComponent(reader.GetComponentType(), deliveredComponent(image));
  std::uint64_t values = reader.GetNumberOfComponents();
  for (unsigned int axis = 0; axis < reader.GetNumberOfDimensions(); ++axis)
  {
    const auto size = reader.GetDimensions(axis);
    same = same && (axis >= 3 || size == static_cast<itk::SizeValueType>(image.grid.size[axis]));
    values *= size;
  }
  same = same && values == image.grid.gridVoxels() * static_cast<std::size_t>(image.layers);
  if (!same)
  {
    throw BadInput(ErrorCode::ReaderFailed,
                   image.fileName,
                   "ITK reads another size or voxel type from the header than the check of it",
                   "export the image again, for example as .nrrd");
  }
}

} // namespace

bool
isReadWithoutItk(const ImageDescription & image)
{
  return !image.layout.isPlain() ||
         (image.keepsNonFinite && image.format == ImageFormat::Nifti && isFloatingPoint(image.component));
}

ComponentType
deliveredComponent(const ImageDescription & image)
{
  if (isReadWithoutItk(image))
  {
    return ComponentType::Float64;
  }
  return image.scaled() && image.component != ComponentType::Float64 ? ComponentType::Float32 : image.component;
}

void
readByItk(const ImageDescription & image, const std::string & itkName, void * buffer)
{
  const auto reader = makeReader(image.format);
  reader->SetFileName(itkName);
  reader->ReadImageInformation();
  requireSameImage(image, *reader);
  itk::ImageIORegion region(reader->GetNumberOfDimensions());
  for (unsigned int axis = 0; axis < reader->GetNumberOfDimensions(); ++axis)
  {
    region.SetSize(axis, reader->GetDimensions(axis));
  }
  reader->SetIORegion(region);
  reader->Read(buffer);
}

void
requireDelivered(const ImageDescription & image, const void * buffer)
{
  if (image.scaled())
  {
    return;
  }
  constexpr std::uint64_t longestPart = 1 << 30; // zlib counts in 32 bits
  const auto *            bytes = static_cast<const unsigned char *>(buffer);
  unsigned long           checksum = 0;
  for (std::uint64_t at = 0; at < image.promisedBytes; at += longestPart)
  {
    checksum = crc32(checksum, bytes + at, static_cast<unsigned int>(std::min(longestPart, image.promisedBytes - at)));
  }
  if (checksum != image.checksum)
  {
    throw BadInput(ErrorCode::ReaderFailed,
                   image.fileName,
                   "ITK delivered other voxels than the file holds",
                   "read it again; if it is not being written, export it in another format");
  }
}

ImageDescription
checkedDescription(const std::string & fileName, bool sandboxed, VoxelContent content)
{
  ImageDescription image = checkImageHeader(fileName, imageFormatOf(fileName), content);
  image.keepsNonFinite = content == VoxelContent::ManyValues;
  if (sandboxed)
  {
    // The buffer here, one inside the library, one of compressed bytes, and the answer.
    constexpr std::uint64_t overhead = std::uint64_t{ 256 } << 20;
    const std::uint64_t     bytes = withComponent(deliveredComponent(image), [](auto zero) { return sizeof(zero); });
    const std::uint64_t     widest =
      std::max(image.promisedBytes, image.promisedBytes / image.bytesPerComponent * std::max<std::uint64_t>(bytes, 4));
    allowSandboxMemory(overhead + 4 * widest);
  }
  checkVoxelBytes(image);
  return image;
}

std::string
withoutPlace(std::string text)
{
  // ITK puts its file, line and class before the message.
  for (const char * before : { "ERROR: ", "): " })
  {
    const auto at = text.find(before);
    text = at == std::string::npos ? text : text.substr(at + std::strlen(before));
  }
  std::replace(text.begin(), text.end(), '\n', ' ');
  return "the reader says: " + text;
}

void
throwTooBig(const std::string & fileName)
{
  throw BadInput(ErrorCode::TooBig, fileName, "not enough memory for the image", "crop the image around the label");
}

} // namespace moserhex
