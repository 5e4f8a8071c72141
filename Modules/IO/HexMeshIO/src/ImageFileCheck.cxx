#include "ImageFileCheck.h"

#include "ImageHeader.h"
#include "moserhex/HexMeshIO/FileErrors.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace moserhex
{

namespace fs = std::filesystem;

void
requireReadableFile(const std::string & fileName)
{
  std::error_code error;
  const auto      status = fs::status(fileName, error);
  if (!fs::exists(status))
  {
    throw BadInput(ErrorCode::NoInput, fileName, "there is no such file", "check the name");
  }
  if (!fs::is_regular_file(status))
  {
    throw BadInput(ErrorCode::NoInput, fileName, "is not a regular file", "give a file");
  }
  if (!std::ifstream(fileName, std::ios::binary))
  {
    throw IOError(ErrorCode::InputOutput,
                  fileName,
                  std::string("cannot open (") + std::strerror(errno) + ")",
                  "check the file's permissions");
  }
  if (fs::file_size(fileName) == 0)
  {
    throw BadInput(ErrorCode::Empty, fileName, "the file is empty (0 bytes)", copyAgain);
  }
}

std::vector<std::string>
checkImageFile(const std::string & fileName, ImageFormat format)
{
  requireReadableFile(fileName);
  switch (format)
  {
    case ImageFormat::Nifti:
      return checkNiftiFile(fileName);
    case ImageFormat::Meta:
      return checkMetaFile(fileName);
    case ImageFormat::Nrrd:
      return checkNrrdFile(fileName);
  }
  return {};
}

} // namespace moserhex
