#include "XmlVtkCheck.h"

#include "FileText.h"
#include "ImageHeader.h"

#include <algorithm>
#include <array>

namespace moserhex
{
namespace
{

constexpr std::array<std::string_view, 11> knownTypes{ "Int8",  "UInt8",  "Int16",   "UInt16",  "Int32", "UInt32",
                                                       "Int64", "UInt64", "Float32", "Float64", "String" };

/** The text between the quotes of ="..." here; nothing when there is no such thing. */
std::string_view
quotedHere(std::string_view text)
{
  const std::size_t equals = text.find_first_not_of(" \t\r\n");
  if (equals == std::string_view::npos || text[equals] != '=')
  {
    return {};
  }
  const std::size_t quote = text.find_first_not_of(" \t\r\n", equals + 1);
  if (quote == std::string_view::npos || (text[quote] != '"' && text[quote] != '\''))
  {
    return {};
  }
  const std::size_t end = text.find(text[quote], quote + 1);
  return end == std::string_view::npos ? std::string_view() : text.substr(quote + 1, end - quote - 1);
}

/** Attributes NumberOfPoints="..." and so on. */
void
requireCounts(FileText & text)
{
  text.rewind();
  const std::uint64_t most = deflateLimit * text.remaining();
  while (text.contains("NumberOf"))
  {
    text.skipBehind("NumberOf");
    const std::string_view rest = text.peekBytes(120);
    const auto             isLetter = [](char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); };
    const auto             nameEnd = std::find_if_not(rest.begin(), rest.end(), isLetter);
    const std::string_view value = quotedHere(rest.substr(static_cast<std::size_t>(nameEnd - rest.begin())));
    std::uint64_t          count = 0;
    if (!value.empty() && !parseNumber(value, count))
    {
      text.refuse(ErrorCode::Header, "'" + std::string(value.substr(0, 20)) + "' where a count is expected");
    }
    if (count > most)
    {
      text.refuse(ErrorCode::Truncated, "the file is too short for a count of " + std::to_string(count));
    }
  }
}

/** Elements <DataArray type="..."> and <Array type="...">. */
void
requireTypes(FileText & text, const std::string & element)
{
  text.rewind();
  while (text.contains(element))
  {
    text.skipBehind(element);
    const std::string_view attributes = text.peekBytes(text.peekBytes(2000).find('>'));
    const std::size_t      found = attributes.find("type");
    const std::string_view type =
      found == std::string_view::npos ? std::string_view() : quotedHere(attributes.substr(found + 4));
    if (std::find(knownTypes.begin(), knownTypes.end(), type) == knownTypes.end())
    {
      text.refuse(ErrorCode::Header, "an array of the unknown type '" + std::string(type.substr(0, 20)) + "'");
    }
  }
}

} // namespace

void
requireHonestXml(const std::string & fileName, const std::string & kind, const std::string & remedy)
{
  FileText text(fileName, remedy, '\0', ErrorCode::Format);
  if (text.contains("<!DOCTYPE") || text.contains("<!ENTITY"))
  {
    text.refuse("DOCTYPE and entities are not allowed");
  }
  if (!text.contains("<VTKFile"))
  {
    text.refuse("the content is not an XML file of VTK");
  }
  if (!text.contains("<" + kind))
  {
    text.refuse(ErrorCode::Unsupported, "not of the kind " + kind);
  }
  requireCounts(text);
  requireTypes(text, "<DataArray");
  requireTypes(text, "<Array");
}

} // namespace moserhex
