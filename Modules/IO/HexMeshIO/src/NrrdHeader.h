#pragma once

#include "ImageDescription.h"

#include <cstdint>
#include <map>
#include <string>

namespace moserhex
{

/** The lines of a NRRD header. */
struct NrrdHeader
{
  std::map<std::string, std::string> fields;     ///< by canonical name, in lower case
  std::map<std::string, std::string> keyValues;  ///< "key:=value" lines
  std::uint64_t                      bytes{ 0 }; ///< length with the empty line that ends it

  /** The value of a field, "" when it is absent. */
  [[nodiscard]] std::string
  get(const std::string & field) const;

  [[nodiscard]] bool
  has(const std::string & field) const
  {
    return fields.count(field) > 0;
  }
};

/** \param text  the beginning of the file, the whole header if that has at most longestNrrdHeader bytes
 * \throws BadInput (Format)  not NRRD; (Unsupported)  a version above 5; (Header)  a line that is neither a known field
 * nor a comment nor key and value; a field longer than 500 characters (NrrdIO's messages have 1000), given twice, or
 *         before one that it depends on; no end */
[[nodiscard]] NrrdHeader
parseNrrdHeader(const std::string & file, const std::string & text);

/** The value of the field "type", in any of its spellings. \throws BadInput (Header, PixelType) */
[[nodiscard]] ComponentType
nrrdComponentType(const std::string & file, const std::string & type);

constexpr std::size_t longestNrrdHeader = 4 << 20;

} // namespace moserhex
