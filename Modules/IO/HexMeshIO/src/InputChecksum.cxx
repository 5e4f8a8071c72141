#include "moserhex/HexMeshIO/InputChecksum.h"

#include "ImageFileCheck.h"
#include "moserhex/HexMeshIO/FileErrors.h"
#include "moserhex/HexMeshIO/Sha256.h"

namespace moserhex
{
namespace
{

/** The file of an image's voxels; the file itself where it is no image, or a header that will be refused. */
std::string
voxelFileOf(const std::string & fileName)
{
  try
  {
    return isImageFileName(fileName) ? checkImageHeader(fileName, imageFormatOf(fileName)).dataFile : fileName;
  }
  catch (const FileError &)
  {
    return fileName;
  }
}

} // namespace

std::string
sha256OfInput(const std::string & fileName)
{
  const std::string ofFile = sha256OfFile(fileName);
  const std::string voxelFile = voxelFileOf(fileName);
  if (voxelFile == fileName)
  {
    return ofFile;
  }
  const std::string both = ofFile + sha256OfFile(voxelFile);
  Sha256            sha256;
  sha256.update(both.data(), both.size());
  return sha256.hexDigest();
}

} // namespace moserhex
