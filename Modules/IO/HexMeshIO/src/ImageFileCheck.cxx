#include "ImageFileCheck.h"

#include "ByteSource.h"
#include "FileNames.h"
#include "ImageHeader.h"
#include "moserhex/HexMeshIO/FileErrors.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>

namespace moserhex
{
namespace
{

namespace fs = std::filesystem;

std::optional<ImageFormat>
formatByName(const std::string & fileName)
{
  if (endsWithAny(fileName, { ".nrrd", ".nhdr" }))
  {
    return ImageFormat::Nrrd;
  }
  if (endsWithAny(fileName, { ".nii", ".nii.gz" }))
  {
    return ImageFormat::Nifti;
  }
  if (endsWithAny(fileName, { ".mha", ".mhd" }))
  {
    return ImageFormat::Meta;
  }
  return std::nullopt;
}

bool
holdsNifti(const std::string & fileName)
{
  try
  {
    ByteSource  source(fileName, ByteSource::Coding::GzipOrPlain);
    std::string header(348, '\0');
    return source.read(header.data(), header.size()) == header.size() &&
           (header.compare(344, 3, "n+1") == 0 || header.compare(344, 3, "ni1") == 0);
  }
  catch (const FileError &)
  {
    return false; // other compressed content
  }
}

std::optional<ImageFormat>
formatByContent(const std::string & fileName)
{
  const std::string begin = beginningOf(fileName, 16);
  if (begin.compare(0, 7, "NRRD000") == 0)
  {
    return ImageFormat::Nrrd;
  }
  if (begin.compare(0, 10, "ObjectType") == 0 || begin.compare(0, 5, "NDims") == 0)
  {
    return ImageFormat::Meta;
  }
  return holdsNifti(fileName) ? std::optional(ImageFormat::Nifti) : std::nullopt;
}

/** Whether the content, and not the name, says what a file is. */
bool
isLeftToContent(const std::string & fileName)
{
  std::error_code error;
  return fs::path(fileName).extension().empty() && fs::is_regular_file(fileName, error);
}

/** Refuses files of other well-known kinds under an image's name, by their kind. */
void
requireNoOtherKind(const std::string & fileName)
{
  struct Kind
  {
    std::size_t  at;
    const char * bytes;
    const char * name;
  };
  static constexpr std::array<Kind, 9> kinds{ { { 0, "PK\x03\x04", "a ZIP archive" },
                                                { 0, "\x89PNG", "a PNG picture" },
                                                { 0, "\xFF\xD8\xFF", "a JPEG picture" },
                                                { 0, "%PDF", "a PDF document" },
                                                { 0, "\x89HDF", "an HDF5 file" },
                                                { 0, "BZh", "a bzip2 archive" },
                                                { 0, "<", "HTML or XML text" },
                                                { 0, "# vtk", "a VTK file" },
                                                { 128, "DICM", "DICOM (3D Slicer or dcmqi convert a DICOM SEG)" } } };
  const std::string                    begin = beginningOf(fileName, 132);
  for (const Kind & kind : kinds)
  {
    if (begin.size() > kind.at && begin.compare(kind.at, std::strlen(kind.bytes), kind.bytes) == 0)
    {
      throw BadInput(ErrorCode::Format,
                     fileName,
                     std::string("the content is ") + kind.name + ", not an image of this name's kind",
                     "give a NRRD, NIfTI-1 or MetaImage file");
    }
  }
}

} // namespace

void
requireRegularFile(const std::string & fileName)
{
  std::error_code error;
  const auto      status = fs::status(fileName, error);
  if (error == std::errc::permission_denied) // a folder on the way may not be entered
  {
    throwUnopened(fileName, EACCES);
  }
  if (!fs::exists(status))
  {
    throw BadInput(ErrorCode::NoInput, fileName, "there is no such file", "check the name");
  }
  if (!fs::is_regular_file(status))
  {
    throw BadInput(ErrorCode::NoInput, fileName, "is not a regular file", "give a file");
  }
}

void
requireReadableFile(const std::string & fileName)
{
  requireRegularFile(fileName);
  if (!std::ifstream(fileName, std::ios::binary))
  {
    throwUnopened(fileName, errno);
  }
  if (fs::file_size(fileName) == 0)
  {
    throw BadInput(ErrorCode::Empty, fileName, "the file is empty (0 bytes)", copyAgain);
  }
}

bool
isImageFileName(const std::string & fileName)
{
  if (formatByName(fileName))
  {
    return true;
  }
  try
  {
    return isLeftToContent(fileName) && formatByContent(fileName);
  }
  catch (const FileError &)
  {
    return false; // cannot be opened
  }
}

ImageFormat
imageFormatOf(const std::string & fileName)
{
  std::optional<ImageFormat> format = formatByName(fileName);
  if (!format && isLeftToContent(fileName))
  {
    format = formatByContent(fileName);
  }
  if (!format)
  {
    throw BadInput(
      ErrorCode::Format, fileName, "not the name of an image", "give a .nrrd, .nhdr, .nii, .nii.gz, .mha or .mhd file");
  }
  return *format;
}

ImageDescription
checkImageHeader(const std::string & fileName, ImageFormat format, VoxelContent content)
{
  requireReadableFile(fileName);
  requireNoOtherKind(fileName);
  switch (format)
  {
    case ImageFormat::Nifti:
      return checkNiftiHeader(fileName, content);
    case ImageFormat::Meta:
      return checkMetaHeader(fileName, content);
    case ImageFormat::Nrrd:
      break;
  }
  return checkNrrdHeader(fileName, content);
}

ImageDescription
checkImageFile(const std::string & fileName, ImageFormat format, VoxelContent content)
{
  ImageDescription image = checkImageHeader(fileName, format, content);
  checkVoxelBytes(image);
  return image;
}

} // namespace moserhex
