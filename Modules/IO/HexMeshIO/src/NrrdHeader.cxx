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
