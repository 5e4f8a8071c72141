#pragma once

#include "FileText.h"

#include <string>
#include <vector>

namespace moserhex
{

enum class PlyEncoding
{
  Ascii,
  LittleEndian,
  BigEndian
};

enum class PlyScalar
{
  Int8,
  UInt8,
  Int16,
  UInt16,
  Int32,
  UInt32,
  Float32,
  Float64
};

struct PlyProperty
{
  std::string name;
  PlyScalar   type{ PlyScalar::Float32 };
  bool        isList{ false };
  PlyScalar   countType{ PlyScalar::UInt8 }; ///< of a list
};

struct PlyElement
{
  std::string              name;
  std::size_t              count{ 0 };
  std::vector<PlyProperty> properties;
};

struct PlyHeader
{
  PlyEncoding             encoding{ PlyEncoding::Ascii };
  std::vector<PlyElement> elements;
};

/** Reads up to and with end_header.
 * \throws BadInput  not PLY; a count that is none or larger than the file; an element or a property twice; a type or a
 *                   line that PLY does not have; no format */
[[nodiscard]] PlyHeader
readPlyHeader(FileText & file);

} // namespace moserhex
