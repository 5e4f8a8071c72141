#include "ImageHeader.h"

#include "ByteSource.h"
#include "moserhex/HexMeshIO/FileErrors.h"

#include <filesystem>
#include <fstream>
#include <map>

namespace moserhex
{
namespace
{

namespace fs = std::filesystem;

// Below the 1000 characters of NrrdIO's message buffer.
constexpr std::size_t longestNrrdField = 500;
constexpr std::size_t longestHeader = 1 << 20;

std::uint64_t
nrrdBytesPerVoxel(const std::string & file, const std::string & type)
{
  static const std::map<std::string, std::uint64_t> sizes{ { "char", 1 },
                                                           { "signed char", 1 },
                                                           { "int8", 1 },
                                                           { "int8_t", 1 },
                                                           { "uchar", 1 },
                                                           { "unsigned char", 1 },
                                                           { "uint8", 1 },
                                                           { "uint8_t", 1 },
                                                           { "short", 2 },
                                                           { "short int", 2 },
                                                           { "signed short", 2 },
                                                           { "signed short int", 2 },
                                                           { "int16", 2 },
                                                           { "int16_t", 2 },
                                                           { "ushort", 2 },
                                                           { "unsigned short", 2 },
                                                           { "unsigned short int", 2 },
                                                           { "uint16", 2 },
                                                           { "uint16_t", 2 },
                                                           { "int", 4 },
                                                           { "signed int", 4 },
                                                           { "int32", 4 },
                                                           { "int32_t", 4 },
                                                           { "uint", 4 },
                                                           { "unsigned int", 4 },
                                                           { "uint32", 4 },
                                                           { "uint32_t", 4 },
                                                           { "longlong", 8 },
                                                           { "long long", 8 },
                                                           { "long long int", 8 },
                                                           { "signed long long", 8 },
                                                           { "signed long long int", 8 },
                                                           { "int64", 8 },
                                                           { "int64_t", 8 },
                                                           { "ulonglong", 8 },
                                                           { "unsigned long long", 8 },
                                                           { "unsigned long long int", 8 },
                                                           { "uint64", 8 },
                                                           { "uint64_t", 8 },
                                                           { "float", 4 },
                                                           { "double", 8 } };
  const auto                                        entry = sizes.find(lowerCase(type));
  if (entry == sizes.end())
  {
    throw BadInput(
      ErrorCode::PixelType, file, "voxel type '" + type.substr(0, 30) + "'", "export integer labels, one per voxel");
  }
  return entry->second;
}

struct NrrdHeader
{
  std::map<std::string, std::string> fields;
  std::uint64_t                      bytes{ 0 }; ///< length of the header with the empty line that ends it
};

/** Fields "key: value" of the header; comments and Slicer's "key:=value" lines are passed over. */
NrrdHeader
readNrrdHeader(const std::string & file)
{
  std::ifstream stream(file, std::ios::binary);
  std::string   line;
  NrrdHeader    header;
  const auto    nextLine = [&]() {
    line.clear();
    for (int c = stream.get(); c != std::char_traits<char>::eof() && c != '\n'; c = stream.get())
    {
      line += static_cast<char>(c);
      if (line.size() > longestHeader)
      {
        throw BadInput(
          ErrorCode::NotHexahedra, file, "a header line of more than 1 MB", "check that this is a NRRD file");
      }
    }
    header.bytes = stream ? static_cast<std::uint64_t>(stream.tellg()) : header.bytes;
    if (!line.empty() && line.back() == '\r')
    {
      line.pop_back();
    }
    return static_cast<bool>(stream);
  };
  if (!nextLine() || line.compare(0, 7, "NRRD000") != 0 || line.size() != 8)
  {
    throw BadInput(ErrorCode::Format, file, "the content is not NRRD", "check that the name's ending fits the format");
  }
  while (nextLine() && !line.empty())
  {
    const auto colon = line.find(':');
    if (line[0] == '#' || (colon != std::string::npos && colon + 1 < line.size() && line[colon + 1] == '='))
    {
      continue;
    }
    if (colon == std::string::npos || line.size() > longestNrrdField)
    {
      throw BadInput(ErrorCode::NotHexahedra,
                     file,
                     "header line '" + line.substr(0, 30) + "' is not a NRRD field",
                     "correct the header");
    }
    header.fields[lowerCase(trimmed(line.substr(0, colon)))] = trimmed(line.substr(colon + 1));
  }
  return header;
}

} // namespace

std::vector<std::string>
checkNrrdFile(const std::string & file)
{
  NrrdHeader                           header = readNrrdHeader(file);
  std::map<std::string, std::string> & fields = header.fields;
  if (fields["dimension"] != "3")
  {
    throw BadInput(ErrorCode::Dimension,
                   file,
                   "dimension " + fields["dimension"].substr(0, 20) + ", need a 3-D image",
                   "export one segment, or segments that do not overlap");
  }
  if (fields.count("data file") + fields.count("datafile") > 0)
  {
    throw BadInput(
      ErrorCode::Reference, file, "the voxels are in another file", "convert to a .nrrd that holds its own data");
  }
  for (const char * key : { "space directions", "space origin", "spacings" })
  {
    requireNumbers(file, key, fields[key]);
  }
  for (const std::string & unit : wordsOf(fields["space units"]))
  {
    if (unit != "\"mm\"" && unit != "\"\"")
    {
      throw BadInput(
        ErrorCode::Geometry, file, "space units " + unit.substr(0, 20), "convert the image to millimetres");
    }
  }
  const std::uint64_t promised = promisedBytes(file, wordsOf(fields["sizes"]), nrrdBytesPerVoxel(file, fields["type"]));
  for (const char * key : { "line skip", "lineskip", "byte skip", "byteskip" })
  {
    if (!fields[key].empty() && fields[key] != "0")
    {
      throw BadInput(ErrorCode::Unsupported,
                     file,
                     std::string(key) + " " + fields[key].substr(0, 20),
                     "save the image as plain .nrrd");
    }
  }
  const std::string   encoding = lowerCase(fields["encoding"]);
  const std::uint64_t present = fs::file_size(file) - header.bytes;
  if (encoding == "raw")
  {
    requireData(file, promised, present);
  }
  else if (encoding == "gzip" || encoding == "gz")
  {
    if (promised / deflateLimit > present)
    {
      throw BadInput(ErrorCode::Truncated, file, "the header promises more voxels than the file can hold", copyAgain);
    }
    requireData(file, promised, inflatedSize(file, header.bytes));
  }
  else
  {
    throw BadInput(
      ErrorCode::Unsupported, file, "encoding '" + encoding.substr(0, 20) + "'", "save the image as raw or gzip NRRD");
  }
  return {};
}

} // namespace moserhex
