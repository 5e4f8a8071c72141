#include "PlyHeader.h"

#include "ImageHeader.h"

#include <algorithm>
#include <map>
#include <optional>

namespace moserhex
{
namespace
{

using Words = std::vector<std::string>;

[[noreturn]] void
refuseHeader(const FileText & file, const std::string & cause)
{
  file.refuse(ErrorCode::Header, cause);
}

PlyScalar
scalarOf(const FileText & file, const std::string & name)
{
  static const std::map<std::string, PlyScalar> types{
    { "char", PlyScalar::Int8 },      { "int8", PlyScalar::Int8 },       { "uchar", PlyScalar::UInt8 },
    { "uint8", PlyScalar::UInt8 },    { "short", PlyScalar::Int16 },     { "int16", PlyScalar::Int16 },
    { "ushort", PlyScalar::UInt16 },  { "uint16", PlyScalar::UInt16 },   { "int", PlyScalar::Int32 },
    { "int32", PlyScalar::Int32 },    { "uint", PlyScalar::UInt32 },     { "uint32", PlyScalar::UInt32 },
    { "float", PlyScalar::Float32 },  { "float32", PlyScalar::Float32 }, { "double", PlyScalar::Float64 },
    { "float64", PlyScalar::Float64 }
  };
  const auto entry = types.find(name);
  if (entry == types.end())
  {
    refuseHeader(file, "unknown type '" + name.substr(0, 20) + "' in the header");
  }
  return entry->second;
}

PlyEncoding
encodingOf(const FileText & file, const std::string & name)
{
  if (name == "ascii")
  {
    return PlyEncoding::Ascii;
  }
  if (name != "binary_little_endian" && name != "binary_big_endian")
  {
    refuseHeader(file, "unknown format '" + name.substr(0, 20) + "'");
  }
  return name == "binary_big_endian" ? PlyEncoding::BigEndian : PlyEncoding::LittleEndian;
}

/** Everything that is counted takes a byte at least. */
std::size_t
countOf(const FileText & file, const std::string & text)
{
  const bool  isWhole = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
  std::size_t count = 0;
  if (!isWhole)
  {
    refuseHeader(file, "impossible count '" + text.substr(0, 20) + "' in the header");
  }
  if (!parseNumber(text, count) || count > file.remaining())
  {
    file.refuse(ErrorCode::Truncated, "the file is too short for a count of " + text.substr(0, 20));
  }
  return count;
}

void
addElement(const FileText & file, const Words & words, PlyHeader & header)
{
  for (const PlyElement & element : header.elements)
  {
    if (element.name == words[1])
    {
      refuseHeader(file, "element '" + words[1].substr(0, 20) + "' is there twice");
    }
  }
  header.elements.push_back({ words[1], countOf(file, words[2]), {} });
}

void
addProperty(const FileText & file, const PlyProperty & property, PlyHeader & header)
{
  std::vector<PlyProperty> & properties = header.elements.back().properties;
  for (const PlyProperty & other : properties)
  {
    if (other.name == property.name)
    {
      refuseHeader(file, "property '" + property.name.substr(0, 20) + "' is there twice");
    }
  }
  properties.push_back(property);
}

} // namespace

PlyHeader
readPlyHeader(FileText & file)
{
  if (trimmed(std::string(file.nextLine().substr(0, 10))) != "ply")
  {
    file.refuse("the content is not PLY");
  }
  PlyHeader                  header;
  std::optional<PlyEncoding> encoding;
  while (!file.atEnd())
  {
    const Words words = wordsOf(std::string(file.nextLine()));
    if (words.empty() || words[0] == "comment" || words[0] == "obj_info")
    {
      continue;
    }
    if (words[0] == "end_header")
    {
      if (!encoding)
      {
        refuseHeader(file, "the header has no line 'format'");
      }
      header.encoding = *encoding;
      return header;
    }
    if (words[0] == "format" && words.size() == 3 && !encoding)
    {
      encoding = encodingOf(file, words[1]);
    }
    else if (words[0] == "element" && words.size() == 3)
    {
      addElement(file, words, header);
    }
    else if (words[0] == "property" && words.size() == 3 && !header.elements.empty())
    {
      addProperty(file, { words[2], scalarOf(file, words[1]), false, PlyScalar::UInt8 }, header);
    }
    else if (words[0] == "property" && words.size() == 5 && words[1] == "list" && !header.elements.empty())
    {
      addProperty(file, { words[4], scalarOf(file, words[3]), true, scalarOf(file, words[2]) }, header);
    }
    else
    {
      refuseHeader(file, "header line '" + words[0].substr(0, 20) + "' is not PLY");
    }
  }
  file.refuseEnd("end_header");
}

} // namespace moserhex
