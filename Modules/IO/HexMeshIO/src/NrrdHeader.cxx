#include "NrrdHeader.h"

#include "ImageHeader.h"
#include "moserhex/HexMeshIO/FileErrors.h"

namespace moserhex
{
namespace
{

constexpr std::size_t longestNrrdField = 500;

/** NrrdIO's fields in all their spellings. */
const std::map<std::string, std::string> &
nrrdFields()
{
  static const std::map<std::string, std::string> fields{ { "content", "content" },
                                                          { "number", "number" },
                                                          { "type", "type" },
                                                          { "block size", "block size" },
                                                          { "blocksize", "block size" },
                                                          { "dimension", "dimension" },
                                                          { "space", "space" },
                                                          { "space dimension", "space dimension" },
                                                          { "sizes", "sizes" },
                                                          { "spacings", "spacings" },
                                                          { "thicknesses", "thicknesses" },
                                                          { "axis mins", "axis mins" },
                                                          { "axismins", "axis mins" },
                                                          { "axis maxs", "axis maxs" },
                                                          { "axismaxs", "axis maxs" },
                                                          { "space directions", "space directions" },
                                                          { "centers", "centers" },
                                                          { "centerings", "centers" },
                                                          { "kinds", "kinds" },
                                                          { "labels", "labels" },
                                                          { "units", "units" },
                                                          { "min", "min" },
                                                          { "max", "max" },
                                                          { "old min", "old min" },
                                                          { "oldmin", "old min" },
                                                          { "old max", "old max" },
                                                          { "oldmax", "old max" },
                                                          { "endian", "endian" },
                                                          { "encoding", "encoding" },
                                                          { "line skip", "line skip" },
                                                          { "lineskip", "line skip" },
                                                          { "byte skip", "byte skip" },
                                                          { "byteskip", "byte skip" },
                                                          { "sample units", "sample units" },
                                                          { "sampleunits", "sample units" },
                                                          { "space units", "space units" },
                                                          { "space origin", "space origin" },
                                                          { "measurement frame", "measurement frame" },
                                                          { "data file", "data file" },
                                                          { "datafile", "data file" } };
  return fields;
}

void
requireMagic(const std::string & file, const std::string & line)
{
  if (line.compare(0, 7, "NRRD000") == 0 && line.size() > 8)
  {
    throwHeader(file, "the first line has " + std::to_string(line.size()) + " characters, need NRRD0004 or the like");
  }
  if (line.compare(0, 7, "NRRD000") != 0 || line.size() != 8)
  {
    throw BadInput(ErrorCode::Format, file, "the content is not NRRD", "check that the name's ending fits the format");
  }
  if (line[7] < '1' || line[7] > '5')
  {
    throw BadInput(ErrorCode::Unsupported, file, "NRRD version " + quoted(line), "save it as NRRD0004 or NRRD0005");
  }
}

/** Fields that another one must stand before. */
void
requireOrder(const std::string & file, const NrrdHeader & header, const std::string & field)
{
  const auto needs = [&](const char * first) {
    if (!header.has(first))
    {
      throwHeader(file, "the field " + quoted(field) + " stands before '" + first + "'");
    }
  };
  for (const char * perAxis :
       { "sizes", "spacings", "space directions", "kinds", "centers", "labels", "units", "thicknesses" })
  {
    if (field == perAxis)
    {
      needs("dimension");
    }
  }
  for (const char * spatial : { "space directions", "space origin", "space units", "measurement frame" })
  {
    if (field == spatial && !header.has("space dimension"))
    {
      needs("space");
    }
  }
}

void
addLine(const std::string & file, const std::string & line, std::size_t number, NrrdHeader & header)
{
  const auto colon = line.find(": ");
  const auto known =
    colon == std::string::npos ? nrrdFields().end() : nrrdFields().find(lowerCase(line.substr(0, colon)));
  if (known == nrrdFields().end())
  {
    const auto separator = line.find(":=");
    if (separator == std::string::npos || separator == 0)
    {
      throwHeader(file, "header line " + std::to_string(number) + " (" + quoted(line) + ") is not a field");
    }
    header.keyValues.emplace(line.substr(0, separator), line.substr(separator + 2));
    return;
  }
  if (line.size() > longestNrrdField)
  {
    throwHeader(file, "the field " + quoted(known->second) + " has " + std::to_string(line.size()) + " characters");
  }
  requireOrder(file, header, known->second);
  if (!header.fields.emplace(known->second, trimmed(line.substr(colon + 2))).second)
  {
    throwHeader(file, "the field " + quoted(known->second) + " is given twice");
  }
}

} // namespace

std::string
NrrdHeader::get(const std::string & field) const
{
  const auto entry = fields.find(field);
  return entry == fields.end() ? std::string() : entry->second;
}

ComponentType
nrrdComponentType(const std::string & file, const std::string & type)
{
  static const std::map<std::string, ComponentType> types{ { "signed char", ComponentType::Int8 },
                                                           { "int8", ComponentType::Int8 },
                                                           { "int8_t", ComponentType::Int8 },
                                                           { "uchar", ComponentType::UInt8 },
                                                           { "unsigned char", ComponentType::UInt8 },
                                                           { "uint8", ComponentType::UInt8 },
                                                           { "uint8_t", ComponentType::UInt8 },
                                                           { "short", ComponentType::Int16 },
                                                           { "short int", ComponentType::Int16 },
                                                           { "signed short", ComponentType::Int16 },
                                                           { "signed short int", ComponentType::Int16 },
                                                           { "int16", ComponentType::Int16 },
                                                           { "int16_t", ComponentType::Int16 },
                                                           { "ushort", ComponentType::UInt16 },
                                                           { "unsigned short", ComponentType::UInt16 },
                                                           { "unsigned short int", ComponentType::UInt16 },
                                                           { "uint16", ComponentType::UInt16 },
                                                           { "uint16_t", ComponentType::UInt16 },
                                                           { "int", ComponentType::Int32 },
                                                           { "signed int", ComponentType::Int32 },
                                                           { "int32", ComponentType::Int32 },
                                                           { "int32_t", ComponentType::Int32 },
                                                           { "uint", ComponentType::UInt32 },
                                                           { "unsigned int", ComponentType::UInt32 },
                                                           { "uint32", ComponentType::UInt32 },
                                                           { "uint32_t", ComponentType::UInt32 },
                                                           { "longlong", ComponentType::Int64 },
                                                           { "long long", ComponentType::Int64 },
                                                           { "long long int", ComponentType::Int64 },
                                                           { "signed long long", ComponentType::Int64 },
                                                           { "signed long long int", ComponentType::Int64 },
                                                           { "int64", ComponentType::Int64 },
                                                           { "int64_t", ComponentType::Int64 },
                                                           { "ulonglong", ComponentType::UInt64 },
                                                           { "unsigned long long", ComponentType::UInt64 },
                                                           { "unsigned long long int", ComponentType::UInt64 },
                                                           { "uint64", ComponentType::UInt64 },
                                                           { "uint64_t", ComponentType::UInt64 },
                                                           { "float", ComponentType::Float32 },
                                                           { "double", ComponentType::Float64 } };
  const auto                                        entry = types.find(lowerCase(type));
  if (entry != types.end())
  {
    return entry->second;
  }
  if (lowerCase(type) == "block")
  {
    throw BadInput(ErrorCode::PixelType, file, "voxel type 'block'", "export integer labels, one per voxel");
  }
  throwHeader(file, "voxel type " + quoted(type) + " is unknown");
}

NrrdHeader
parseNrrdHeader(const std::string & file, const std::string & text)
{
  NrrdHeader  header;
  std::size_t number = 0;
  while (header.bytes < text.size())
  {
    const auto  end = text.find('\n', header.bytes);
    std::string line = text.substr(header.bytes, end - header.bytes);
    if (!line.empty() && line.back() == '\r')
    {
      line.pop_back();
    }
    if (++number == 1)
    {
      requireMagic(file, line);
    }
    if (line.find('\r') != std::string::npos)
    {
      // The end of a line to NrrdIO, which does not survive the error message about a long rest.
      throwHeader(file, "header line " + std::to_string(number) + " holds a carriage return");
    }
    if (line.find('\0') != std::string::npos)
    {
      throwHeader(file, "header line " + std::to_string(number) + " is not text: no empty line ends the header");
    }
    if (end == std::string::npos && !header.has("data file"))
    {
      throwHeader(file, "the header does not end (no empty line)");
    }
    header.bytes = end == std::string::npos ? text.size() : end + 1;
    if (line.empty())
    {
      break;
    }
    if (number > 1 && line[0] != '#')
    {
      addLine(file, line, number, header);
    }
    if (header.get("data file").compare(0, 4, "LIST") == 0)
    {
      break; // names of files follow; setDataFile refuses them
    }
  }
  return header;
}

} // namespace moserhex
