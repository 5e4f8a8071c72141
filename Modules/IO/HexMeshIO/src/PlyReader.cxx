#include "PlyHeader.h"
#include "PolygonCollector.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace moserhex
{
namespace
{

[[nodiscard]] bool
isCorners(const PlyProperty & property)
{
  return property.isList && (property.name == "vertex_indices" || property.name == "vertex_index");
}

class PlyData
{
public:
  explicit PlyData(const std::string & fileName)
    : m_File(fileName, exportSurfaceAgain, '\0', ErrorCode::Format), m_Surface(fileName)
  {}

  RawSurface
  read()
  {
    const PlyHeader header = readPlyHeader(m_File);
    m_Encoding = header.encoding;
    requireSurface(header);
    for (const PlyElement & element : header.elements)
    {
      for (std::size_t item = 0; item < element.count; ++item)
      {
        readItem(element);
      }
    }
    if (!m_File.nextWord().empty())
    {
      m_File.refuse(ErrorCode::Header, "more data than the header promises");
    }
    return m_Surface.finish();
  }

private:
  void
  requireSurface(const PlyHeader & header) const
  {
    bool hasPolygons = false;
    for (const PlyElement & element : header.elements)
    {
      const auto has = [&element](const auto & wanted) {
        return std::any_of(element.properties.begin(), element.properties.end(), wanted);
      };
      hasPolygons = hasPolygons || (element.name == "face" && element.count > 0);
      if (element.name == "tristrips")
      {
        m_File.refuse(ErrorCode::Unsupported, "triangle strips, need polygons");
      }
      if (element.name == "face" && element.count > 0 && !has(isCorners))
      {
        m_File.refuse(ErrorCode::Header, "faces without a list vertex_indices");
      }
      for (const char * axis : { "x", "y", "z" })
      {
        if (element.name == "vertex" &&
            !has([axis](const PlyProperty & property) { return property.name == axis && !property.isList; }))
        {
          m_File.refuse(ErrorCode::Header, std::string("vertices without a property ") + axis);
        }
      }
    }
    if (!hasPolygons)
    {
      m_File.refuse(ErrorCode::Empty, "a point cloud: there are no faces");
    }
  }

  void
  readItem(const PlyElement & element)
  {
    if (m_Encoding == PlyEncoding::Ascii && !element.properties.empty())
    {
      if (!m_File.nextWords(m_Words))
      {
        m_File.refuseEnd("the last item promised");
      }
      m_NextWord = 0;
    }
    Vector3 position = Vector3::Zero();
    for (const PlyProperty & property : element.properties)
    {
      readProperty(property);
      if (element.name == "vertex" && property.name.size() == 1 && property.name[0] >= 'x' && property.name[0] <= 'z')
      {
        position[property.name[0] - 'x'] = m_Values[0];
      }
      else if (element.name == "face" && isCorners(property))
      {
        addPolygon();
      }
    }
    if (element.name == "vertex")
    {
      m_Surface.addVertex(position);
    }
    if (m_Encoding == PlyEncoding::Ascii && !element.properties.empty() && m_NextWord != m_Words.size())
    {
      m_File.refuse("line " + std::to_string(m_File.lineNumber()) + ": " + std::to_string(m_Words.size()) +
                    " numbers, the header promises " + std::to_string(m_NextWord));
    }
  }

  /** The numbers of one property of one item: one, or those of a list. */
  void
  readProperty(const PlyProperty & property)
  {
    std::size_t count = 1;
    if (property.isList)
    {
      const double declared = nextNumber(property.countType);
      if (!(declared >= 0.0) || declared != std::floor(declared))
      {
        m_File.refuse("a list of " + std::to_string(declared) + " numbers");
      }
      if (declared > static_cast<double>(m_Encoding == PlyEncoding::Ascii ? m_Words.size() : m_File.remaining()))
      {
        m_File.refuseEnd("the end of a list");
      }
      count = static_cast<std::size_t>(declared);
    }
    m_Values.resize(count);
    for (double & value : m_Values)
    {
      value = nextNumber(property.type);
    }
  }

  void
  addPolygon()
  {
    m_Corners.clear();
    for (const double value : m_Values)
    {
      if (!(std::abs(value) < 1e15) || value != std::floor(value))
      {
        m_File.refuse(ErrorCode::SurfaceIndex, "a vertex number that is not a whole number of reasonable size");
      }
      m_Corners.push_back(static_cast<std::int64_t>(value));
    }
    m_Surface.addPolygon(m_Corners);
  }

  [[nodiscard]] double
  nextNumber(PlyScalar type)
  {
    if (m_Encoding == PlyEncoding::Ascii)
    {
      if (m_NextWord == m_Words.size())
      {
        m_File.refuse(m_File.atEnd() ? ErrorCode::Truncated : ErrorCode::Format,
                      "line " + std::to_string(m_File.lineNumber()) + ": only " + std::to_string(m_Words.size()) +
                        " numbers, the header promises more");
      }
      return m_File.numberOf<double>(m_Words[m_NextWord++], "a number");
    }
    switch (type)
    {
      case PlyScalar::Int8:
        return nextBinary<std::int8_t>();
      case PlyScalar::UInt8:
        return nextBinary<std::uint8_t>();
      case PlyScalar::Int16:
        return nextBinary<std::int16_t>();
      case PlyScalar::UInt16:
        return nextBinary<std::uint16_t>();
      case PlyScalar::Int32:
        return nextBinary<std::int32_t>();
      case PlyScalar::UInt32:
        return nextBinary<std::uint32_t>();
      case PlyScalar::Float32:
        return nextBinary<float>();
      case PlyScalar::Float64:
        return nextBinary<double>();
    }
    return 0.0;
  }

  template <typename T>
  [[nodiscard]] double
  nextBinary()
  {
    return static_cast<double>(m_Encoding == PlyEncoding::BigEndian ? m_File.nextBigEndian<T>("a number")
                                                                    : m_File.nextBinary<T>("a number"));
  }

  FileText                      m_File;
  PolygonCollector              m_Surface;
  PlyEncoding                   m_Encoding{ PlyEncoding::Ascii };
  std::vector<std::string_view> m_Words; ///< of the item's line, in text
  std::size_t                   m_NextWord{ 0 };
  std::vector<double>           m_Values;
  std::vector<std::int64_t>     m_Corners;
};

} // namespace

RawSurface
readPly(const std::string & fileName)
{
  return PlyData(fileName).read();
}

} // namespace moserhex
