#include "PlyReader.h"

#include "ImageHeader.h"
#include "moserhex/HexMeshIO/FileErrors.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>

namespace moserhex
{
namespace
{

enum class Encoding
{
  Ascii,
  LittleEndian,
  BigEndian
};

enum class Scalar
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

struct Property
{
  std::string name;
  Scalar      type{ Scalar::Float32 };
  bool        isList{ false };
  Scalar      countType{ Scalar::UInt8 }; ///< of a list
};

struct Element
{
  std::string           name;
  std::size_t           count{ 0 };
  std::vector<Property> properties;
};

struct Header
{
  Encoding             encoding{ Encoding::Ascii };
  std::vector<Element> elements;
};

/** The bytes of the file, read front to back. */
class PlyBytes
{
public:
  explicit PlyBytes(const std::string & fileName) : m_FileName(fileName)
  {
    std::ifstream file(fileName, std::ios::binary);
    m_Bytes.assign(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }

  [[noreturn]] void
  fail(const std::string & cause) const
  {
    throw BadInput(ErrorCode::NotHexahedra, m_FileName, cause, "export the surface again");
  }

  [[nodiscard]] std::size_t
  remaining() const
  {
    return m_Bytes.size() - m_Position;
  }

  [[nodiscard]] std::string
  nextLine()
  {
    const std::size_t end = m_Bytes.find('\n', m_Position);
    if (end == std::string::npos)
    {
      fail("the header ends early");
    }
    const std::string line = m_Bytes.substr(m_Position, end - m_Position);
    m_Position = end + 1;
    return trimmed(line);
  }

  [[nodiscard]] double
  nextNumber(Encoding encoding, Scalar type)
  {
    return encoding == Encoding::Ascii ? nextTextNumber() : nextBinaryNumber(encoding, type);
  }

private:
  [[nodiscard]] double
  nextTextNumber()
  {
    const auto isSpace = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; };
    while (m_Position < m_Bytes.size() && isSpace(m_Bytes[m_Position]))
    {
      ++m_Position;
    }
    const char * const begin = m_Bytes.data() + m_Position;
    const char * const end = m_Bytes.data() + m_Bytes.size();
    if (begin == end)
    {
      fail("the file ends early");
    }
    double value = 0.0;
    const auto [stop, error] = std::from_chars(*begin == '+' ? begin + 1 : begin, end, value);
    if (error != std::errc() || (stop != end && !isSpace(*stop)))
    {
      fail("something else where a number is expected");
    }
    m_Position = static_cast<std::size_t>(stop - m_Bytes.data());
    return value;
  }

  template <typename T>
  [[nodiscard]] double
  nextBinary(Encoding encoding)
  {
    if (remaining() < sizeof(T))
    {
      fail("the file ends early");
    }
    std::array<char, sizeof(T)> bytes;
    std::copy_n(m_Bytes.data() + m_Position, sizeof(T), bytes.begin());
    m_Position += sizeof(T);
    const std::uint16_t probe = 1;
    const bool          hostIsLittle = *reinterpret_cast<const unsigned char *>(&probe) == 1;
    if (hostIsLittle != (encoding == Encoding::LittleEndian))
    {
      std::reverse(bytes.begin(), bytes.end());
    }
    T value;
    std::memcpy(&value, bytes.data(), sizeof(T));
    return static_cast<double>(value);
  }

  [[nodiscard]] double
  nextBinaryNumber(Encoding encoding, Scalar type)
  {
    switch (type)
    {
      case Scalar::Int8:
        return nextBinary<std::int8_t>(encoding);
      case Scalar::UInt8:
        return nextBinary<std::uint8_t>(encoding);
      case Scalar::Int16:
        return nextBinary<std::int16_t>(encoding);
      case Scalar::UInt16:
        return nextBinary<std::uint16_t>(encoding);
      case Scalar::Int32:
        return nextBinary<std::int32_t>(encoding);
      case Scalar::UInt32:
        return nextBinary<std::uint32_t>(encoding);
      case Scalar::Float32:
        return nextBinary<float>(encoding);
      case Scalar::Float64:
        return nextBinary<double>(encoding);
    }
    return 0.0;
  }

  std::string m_FileName;
  std::string m_Bytes;
  std::size_t m_Position{ 0 };
};

Scalar
scalarOf(const PlyBytes & bytes, const std::string & name)
{
  static const std::map<std::string, Scalar> types{ { "char", Scalar::Int8 },      { "int8", Scalar::Int8 },
                                                    { "uchar", Scalar::UInt8 },    { "uint8", Scalar::UInt8 },
                                                    { "short", Scalar::Int16 },    { "int16", Scalar::Int16 },
                                                    { "ushort", Scalar::UInt16 },  { "uint16", Scalar::UInt16 },
                                                    { "int", Scalar::Int32 },      { "int32", Scalar::Int32 },
                                                    { "uint", Scalar::UInt32 },    { "uint32", Scalar::UInt32 },
                                                    { "float", Scalar::Float32 },  { "float32", Scalar::Float32 },
                                                    { "double", Scalar::Float64 }, { "float64", Scalar::Float64 } };
  const auto                                 entry = types.find(name);
  if (entry == types.end())
  {
    bytes.fail("unknown type '" + name.substr(0, 20) + "' in the header");
  }
  return entry->second;
}

Encoding
encodingOf(const PlyBytes & bytes, const std::vector<std::string> & words)
{
  const std::string name = words.size() > 1 ? words[1] : "";
  if (name == "ascii")
  {
    return Encoding::Ascii;
  }
  if (name == "binary_little_endian" || name == "binary_big_endian")
  {
    return name == "binary_big_endian" ? Encoding::BigEndian : Encoding::LittleEndian;
  }
  bytes.fail("unknown format '" + name.substr(0, 20) + "'");
}

std::size_t
countOf(const PlyBytes & bytes, const std::string & text)
{
  std::size_t count = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  if (error != std::errc() || end != text.data() + text.size() || count > bytes.remaining())
  {
    bytes.fail("impossible count '" + text.substr(0, 20) + "' in the header");
  }
  return count;
}

Header
readHeader(PlyBytes & bytes)
{
  if (bytes.nextLine() != "ply")
  {
    bytes.fail("the content is not PLY");
  }
  Header header;
  for (;;)
  {
    const std::vector<std::string> words = wordsOf(bytes.nextLine());
    if (words.empty() || words[0] == "comment" || words[0] == "obj_info")
    {
      continue;
    }
    if (words[0] == "end_header")
    {
      return header;
    }
    if (words[0] == "format")
    {
      header.encoding = encodingOf(bytes, words);
    }
    else if (words[0] == "element" && words.size() == 3)
    {
      header.elements.push_back({ words[1], countOf(bytes, words[2]), {} });
    }
    else if (words[0] == "property" && words.size() == 3 && !header.elements.empty())
    {
      header.elements.back().properties.push_back({ words[2], scalarOf(bytes, words[1]), false, Scalar::UInt8 });
    }
    else if (words[0] == "property" && words.size() == 5 && words[1] == "list" && !header.elements.empty())
    {
      header.elements.back().properties.push_back(
        { words[4], scalarOf(bytes, words[3]), true, scalarOf(bytes, words[2]) });
    }
    else
    {
      bytes.fail("header line '" + words[0].substr(0, 20) + "' is not PLY");
    }
  }
}

/** The numbers of one property of one item: one, or those of a list. */
std::vector<double>
readProperty(PlyBytes & bytes, Encoding encoding, const Property & property)
{
  std::size_t count = 1;
  if (property.isList)
  {
    const double declared = bytes.nextNumber(encoding, property.countType);
    if (!(declared >= 0.0 && declared <= static_cast<double>(bytes.remaining())))
    {
      bytes.fail("the file ends early");
    }
    count = static_cast<std::size_t>(declared);
  }
  std::vector<double> values(count);
  for (double & value : values)
  {
    value = bytes.nextNumber(encoding, property.type);
  }
  return values;
}

VertexIndex
indexOf(const PlyBytes & bytes, double value)
{
  if (!(value >= -2e9 && value <= 2e9) || value != static_cast<double>(static_cast<VertexIndex>(value)))
  {
    bytes.fail("a vertex number that is not a whole number");
  }
  return static_cast<VertexIndex>(value);
}

void
addItem(const PlyBytes &            bytes,
        const Element &             element,
        const Property &            property,
        const std::vector<double> & values,
        TriangleMesh &              mesh)
{
  if (element.name == "vertex" && !property.isList && property.name.size() == 1)
  {
    const int axis = property.name[0] - 'x';
    if (axis >= 0 && axis < 3)
    {
      mesh.vertices.back()[axis] = values[0];
    }
  }
  else if (element.name == "face" && (property.name == "vertex_indices" || property.name == "vertex_index"))
  {
    if (values.size() != 3)
    {
      bytes.fail("a polygon with " + std::to_string(values.size()) + " corners, need triangles");
    }
    mesh.triangles.push_back({ indexOf(bytes, values[0]), indexOf(bytes, values[1]), indexOf(bytes, values[2]) });
  }
}

} // namespace

TriangleMesh
readPly(const std::string & fileName)
{
  PlyBytes     bytes(fileName);
  const Header header = readHeader(bytes);
  TriangleMesh mesh;
  for (const Element & element : header.elements)
  {
    for (std::size_t item = 0; item < element.count; ++item)
    {
      if (element.name == "vertex")
      {
        mesh.vertices.push_back(Vector3::Zero());
      }
      for (const Property & property : element.properties)
      {
        addItem(bytes, element, property, readProperty(bytes, header.encoding, property), mesh);
      }
    }
  }
  return mesh;
}

} // namespace moserhex
