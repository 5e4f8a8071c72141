#include "ImageHeader.h"

#include "ByteSource.h"
#include "ImageFileCheck.h"
#include "moserhex/HexMeshIO/FileErrors.h"

#include <filesystem>
#include <fstream>
#include <map>

namespace moserhex
{
namespace
{

namespace fs = std::filesystem;

// Below the 255 characters of MetaIO's buffers.
constexpr std::size_t longestMetaLine = 250;

struct MetaHeader
{
  std::map<std::string, std::string> fields;
  std::uint64_t                      bytes{ 0 }; ///< length of the header

  [[nodiscard]] std::string
  get(const std::string & key) const
  {
    const auto entry = fields.find(key);
    return entry == fields.end() ? std::string() : entry->second;
  }
};

MetaHeader
readMetaHeader(const std::string & file)
{
  std::ifstream stream(file, std::ios::binary);
  MetaHeader    header;
  std::string   line;
  for (int c = stream.get(); c != std::char_traits<char>::eof(); c = stream.get())
  {
    ++header.bytes;
    if (c != '\n')
    {
      line += static_cast<char>(c);
      if (line.size() > longestMetaLine || c == 0)
      {
        throw BadInput(
          ErrorCode::Format, file, "the content is not a MetaImage header", "check that this is a .mha or .mhd file");
      }
      continue;
    }
    const auto equals = line.find('=');
    if (equals == std::string::npos)
    {
      throw BadInput(
        ErrorCode::NotHexahedra, file, "header line '" + line.substr(0, 30) + "' has no '='", "correct the header");
    }
    const std::string key = trimmed(line.substr(0, equals));
    if (!header.fields.emplace(key, trimmed(line.substr(equals + 1))).second)
    {
      throw BadInput(
        ErrorCode::Truncated, file, "the header gives " + key.substr(0, 30) + " twice", "correct the header");
    }
    if (key == "ElementDataFile")
    {
      return header;
    }
    line.clear();
  }
  throw BadInput(ErrorCode::Truncated, file, "the header ends early (no ElementDataFile)", copyAgain);
}

std::uint64_t
metaBytesPerVoxel(const std::string & file, const std::string & type)
{
  static const std::map<std::string, std::uint64_t> sizes{
    { "MET_CHAR", 1 },  { "MET_UCHAR", 1 },  { "MET_SHORT", 2 },     { "MET_USHORT", 2 },
    { "MET_INT", 4 },   { "MET_UINT", 4 },   { "MET_LONG", 4 },      { "MET_ULONG", 4 },
    { "MET_FLOAT", 4 }, { "MET_DOUBLE", 8 }, { "MET_LONG_LONG", 8 }, { "MET_ULONG_LONG", 8 }
  };
  const auto entry = sizes.find(type);
  if (entry == sizes.end())
  {
    throw BadInput(ErrorCode::Unsupported,
                   file,
                   "ElementType is '" + type.substr(0, 30) + "'",
                   "export integer labels, one per voxel");
  }
  return entry->second;
}

/** The file that holds the voxels: the header itself, or a plain file beside it. */
std::string
metaDataFile(const std::string & file, const std::string & name)
{
  if (name == "LOCAL" || name == "Local" || name == "local")
  {
    return file;
  }
  const bool plain = !name.empty() && name != "LIST" && name.find_first_of("/\\%") == std::string::npos &&
                     wordsOf(name).size() == 1 && name[0] != '.';
  if (!plain)
  {
    throw BadInput(ErrorCode::Reference,
                   file,
                   "ElementDataFile is '" + name.substr(0, 40) + "', need LOCAL or one plain file name beside it",
                   "convert the image to .mha");
  }
  const std::string path = (fs::path(file).parent_path() / name).string();
  requireReadableFile(path);
  return path;
}

} // namespace

std::vector<std::string>
checkMetaFile(const std::string & file)
{
  const MetaHeader  header = readMetaHeader(file);
  const std::string objectType = header.get("ObjectType");
  if (!objectType.empty() && objectType != "Image")
  {
    throw BadInput(
      ErrorCode::Unsupported, file, "ObjectType is '" + objectType.substr(0, 20) + "', need Image", exportScalarVolume);
  }
  const std::string headerSize = header.get("HeaderSize");
  if (!headerSize.empty() && headerSize != "0")
  {
    throw BadInput(ErrorCode::Dimension,
                   file,
                   "HeaderSize is " + headerSize.substr(0, 20) + ", need none",
                   "convert the image to .mha");
  }
  if (header.get("NDims") != "3")
  {
    throw BadInput(ErrorCode::Dimension,
                   file,
                   "NDims is '" + header.get("NDims").substr(0, 20) + "', need a 3-D image",
                   exportScalarVolume);
  }
  const std::string channels = header.get("ElementNumberOfChannels");
  if (!channels.empty() && channels != "1")
  {
    throw BadInput(ErrorCode::PixelType,
                   file,
                   channels.substr(0, 10) + " values per voxel, need a scalar image",
                   exportScalarVolume);
  }
  for (const char * key : { "ElementSpacing",
                            "ElementSize",
                            "Offset",
                            "Position",
                            "Origin",
                            "TransformMatrix",
                            "Rotation",
                            "Orientation",
                            "CenterOfRotation" })
  {
    requireNumbers(file, key, header.get(key));
  }
  const std::uint64_t promised =
    promisedBytes(file, wordsOf(header.get("DimSize")), metaBytesPerVoxel(file, header.get("ElementType")));
  const std::string   dataFile = metaDataFile(file, header.get("ElementDataFile"));
  const std::uint64_t begin = dataFile == file ? header.bytes : 0;
  const std::uint64_t present = fs::file_size(dataFile) - begin;
  if (lowerCase(header.get("BinaryData")) == "false")
  {
    throw BadInput(
      ErrorCode::Unsupported, file, "the voxels are written as text", "save the image as binary .mha or .nrrd");
  }
  if (lowerCase(header.get("CompressedData")) == "true")
  {
    if (header.get("CompressedDataSize").empty())
    {
      throw BadInput(ErrorCode::Truncated, file, "CompressedDataSize is missing", copyAgain);
    }
    if (promised / deflateLimit > present)
    {
      throw BadInput(ErrorCode::Truncated, file, "the header promises more voxels than the file can hold", copyAgain);
    }
    requireData(file, promised, inflatedSize(dataFile, begin));
  }
  else
  {
    requireData(file, promised, present);
  }
  return {};
}

} // namespace moserhex
