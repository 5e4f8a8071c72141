#include "FileText.h"
#include "ImageHeader.h"
#include "PolygonCollector.h"
#include "VtkSpace.h"

#include <algorithm>
#include <cstdio>
#include <map>

namespace moserhex
{
namespace
{

/** Bytes of a value of VTK's types in a binary file; 0: not a type of fixed size. */
std::size_t
bytesOf(const std::string & type)
{
  static const std::map<std::string, std::size_t> sizes{
    { "char", 1 },      { "unsigned_char", 1 }, { "short", 2 },         { "unsigned_short", 2 }, { "int", 4 },
    { "float", 4 },     { "unsigned_int", 4 },  { "long", 8 },          { "unsigned_long", 8 },  { "double", 8 },
    { "vtkidtype", 4 }, { "vtktypeint64", 8 },  { "vtktypeuint64", 8 }, { "vtktypeint32", 4 },   { "vtktypeuint32", 4 }
  };
  const auto entry = sizes.find(type);
  return entry == sizes.end() ? 0 : entry->second;
}

/** A legacy file of DATASET POLYDATA up to its attributes, which begin with POINT_DATA or CELL_DATA. */
class LegacySurface
{
public:
  explicit LegacySurface(const std::string & fileName)
    : m_File(fileName, exportSurfaceAgain, '\0', ErrorCode::Format), m_Surface(fileName)
  {}

  RawSurface
  read()
  {
    readHeader();
    for (std::string keyword = nextKeyword(); !keyword.empty() && keyword != "point_data" && keyword != "cell_data";
         keyword = nextKeyword())
    {
      readSection(keyword);
    }
    if (!m_HasPoints)
    {
      m_File.refuseEnd("POINTS");
    }
    RawSurface surface = m_Surface.finish();
    surface.isRas = m_IsRas;
    return surface;
  }

private:
  /** Version, title, ASCII or BINARY, DATASET. */
  void
  readHeader()
  {
    const std::string version(m_File.nextLine().substr(0, 60));
    int               minor = 0;
    if (std::sscanf(version.c_str(), "# vtk DataFile Version %d.%d", &m_Major, &minor) != 2)
    {
      m_File.refuse("not a legacy VTK file (no version in the first line)");
    }
    if (m_Major < 1 || m_Major > 5)
    {
      m_File.refuse(ErrorCode::Unsupported, "version " + std::to_string(m_Major) + " of the format, need 1 to 5");
    }
    m_IsRas = saysRas(std::string(m_File.nextLine()).c_str());
    const std::string encoding = lowerCase(std::string(m_File.nextWord().substr(0, 20)));
    if (encoding != "ascii" && encoding != "binary")
    {
      m_File.refuseWord(encoding, "ASCII or BINARY");
    }
    m_IsBinary = encoding == "binary";
    if (lowerCase(std::string(m_File.nextWord().substr(0, 20))) != "dataset")
    {
      m_File.refuse("no DATASET in the fourth line");
    }
    const std::string kind(m_File.nextWord().substr(0, 30));
    if (lowerCase(kind) != "polydata")
    {
      m_File.refuse(kind.empty() ? ErrorCode::Truncated : ErrorCode::Unsupported,
                    "dataset is " + kind + ", need a surface (POLYDATA)");
    }
    (void)m_File.nextLine();
  }

  [[nodiscard]] std::string
  nextKeyword()
  {
    return lowerCase(std::string(m_File.nextWord().substr(0, 20)));
  }

  void
  readSection(const std::string & keyword)
  {
    if (keyword == "points" && !m_HasPoints)
    {
      readPoints();
    }
    else if (keyword == "polygons" && !m_HasPolygons)
    {
      m_HasPolygons = true;
      readCells(keyword);
    }
    else if (keyword == "vertices" || keyword == "lines" || keyword == "triangle_strips")
    {
      readCells(keyword);
    }
    else if (keyword == "metadata")
    {
      (void)m_File.nextLine();
      while (!m_File.atEnd() && !trimmed(std::string(m_File.nextLine())).empty())
      {}
    }
    else if (keyword == "field")
    {
      readField();
    }
    else
    {
      m_File.refuse("'" + keyword + "' where a section of a surface is expected" +
                    (m_IsBinary ? " (the file says BINARY)" : ""));
    }
  }

  void
  readPoints()
  {
    m_HasPoints = true;
    const std::size_t points = nextCount("the number of points");
    const std::string type = nextType();
    (void)m_File.nextLine();
    requireNoText();
    requireValues(3, points, type);
    for (std::size_t point = 0; point < points; ++point)
    {
      Vector3 position;
      for (int axis = 0; axis < 3; ++axis)
      {
        position[axis] = nextValue(type);
      }
      m_Surface.addVertex(position);
    }
  }

  /** "POLYGONS cells size": since version 5 two lists with names, else every cell with its number of points before it.
   */
  void
  readCells(const std::string & keyword)
  {
    const std::size_t cells = nextCount("a number of cells");
    const std::size_t size = nextCount("the size of a list of cells");
    (void)m_File.nextLine();
    if (keyword == "triangle_strips" && cells > 0 && size > 0)
    {
      m_File.refuse(ErrorCode::Unsupported, "triangle strips, need polygons");
    }
    const bool isPolygons = keyword == "polygons";
    if (m_Major >= 5)
    {
      const std::vector<std::int64_t> offsets = nextList("offsets", cells);
      const std::vector<std::int64_t> corners = nextList("connectivity", size);
      addByOffsets(offsets, corners, isPolygons);
      return;
    }
    requireValues(1, size, "int");
    std::size_t left = size;
    for (std::size_t cell = 0; cell < cells; ++cell)
    {
      const std::int64_t corners = left > 0 ? nextIndex("int") : 0;
      if (left == 0 || corners < 0 || corners > static_cast<std::int64_t>(left - 1))
      {
        m_File.refuse(ErrorCode::SurfaceIndex, "cell " + std::to_string(cell) + " goes beyond the list of cells");
      }
      m_Corners.resize(static_cast<std::size_t>(corners));
      for (std::int64_t & corner : m_Corners)
      {
        corner = nextIndex("int");
      }
      left -= m_Corners.size() + 1;
      if (isPolygons)
      {
        m_Surface.addPolygon(m_Corners);
      }
    }
    if (left > 0)
    {
      m_File.refuse(ErrorCode::Header, std::to_string(left) + " numbers too many in the list of " + keyword);
    }
  }

  [[nodiscard]] std::vector<std::int64_t>
  nextList(const char * name, std::size_t size)
  {
    const std::string keyword = nextKeyword();
    if (keyword != name)
    {
      m_File.refuseWord(keyword, name);
    }
    const std::string type = nextType();
    (void)m_File.nextLine();
    requireValues(1, size, type);
    std::vector<std::int64_t> list(size);
    for (std::int64_t & number : list)
    {
      number = nextIndex(type);
    }
    return list;
  }

  void
  addByOffsets(const std::vector<std::int64_t> & offsets, const std::vector<std::int64_t> & corners, bool isPolygons)
  {
    const bool fit = offsets.empty() ? corners.empty()
                                     : offsets.front() == 0 && std::is_sorted(offsets.begin(), offsets.end()) &&
                                         offsets.back() == static_cast<std::int64_t>(corners.size());
    if (!fit)
    {
      m_File.refuse(ErrorCode::SurfaceIndex, "OFFSETS do not fit the " + std::to_string(corners.size()) + " corners");
    }
    for (std::size_t cell = 0; isPolygons && cell + 1 < offsets.size(); ++cell)
    {
      m_Corners.assign(corners.begin() + offsets[cell], corners.begin() + offsets[cell + 1]);
      m_Surface.addPolygon(m_Corners);
    }
  }

  /** "FIELD name arrays", then "name components tuples type" and the values of each. */
  void
  readField()
  {
    (void)m_File.nextWord();
    const std::size_t arrays = nextCount("the number of arrays");
    for (std::size_t array = 0; array < arrays; ++array)
    {
      std::string name(m_File.nextWord());
      if (lowerCase(name) == "metadata")
      {
        readSection("metadata");
        name = m_File.nextWord();
      }
      const std::size_t components = nextCount("a number of components");
      const std::size_t tuples = nextCount("a number of tuples");
      const bool        isText = m_File.peekWord() == "string";
      const std::string type = isText ? "char" : nextType(); // a text takes a byte at least, as a char does
      (void)m_File.nextLine();
      requireValues(components, tuples, type);
      for (std::size_t value = 0; value < components * tuples; ++value)
      {
        if (isText)
        {
          const std::string text = nextText();
          m_IsRas = m_IsRas || (name == "SPACE" && text == "RAS");
        }
        else
        {
          (void)nextValue(type);
        }
      }
    }
  }

  /** A line, or in a binary file a text behind its length: of 6, 14, 30 or 62 bits, which the two highest bits tell. */
  [[nodiscard]] std::string
  nextText()
  {
    if (!m_IsBinary)
    {
      return trimmed(std::string(m_File.nextLine()));
    }
    const auto    first = m_File.nextBinary<std::uint8_t>("a text");
    const int     moreBytes = (1 << (3 - (first >> 6))) - 1;
    std::uint64_t length = first & 0x3F;
    for (int byte = 0; byte < moreBytes; ++byte)
    {
      length = 256 * length + m_File.nextBinary<std::uint8_t>("a text");
    }
    std::string text(m_File.peekBytes(length));
    m_File.skipBytes(length, "the end of a text");
    return text;
  }

  [[nodiscard]] std::size_t
  nextCount(const char * what)
  {
    const std::string_view word = m_File.nextWord();
    std::size_t            count = 0;
    if (word.empty())
    {
      m_File.refuseEnd(what);
    }
    if (!parseNumber(word, count))
    {
      m_File.refuse(ErrorCode::Header, "'" + std::string(word.substr(0, 20)) + "' where " + what + " is expected");
    }
    return count;
  }

  [[nodiscard]] std::string
  nextType()
  {
    const std::string type = lowerCase(std::string(m_File.nextWord().substr(0, 20)));
    if (bytesOf(type) == 0)
    {
      m_File.refuse(ErrorCode::Unsupported, "values of type '" + type + "'");
    }
    return type;
  }

  /** A value of text takes two bytes, but for the last. */
  void
  requireValues(std::size_t components, std::size_t tuples, const std::string & type) const
  {
    const std::size_t each = m_IsBinary ? bytesOf(type) : 2;
    const std::size_t most = m_File.remaining() / each + 1;
    if (components > most || tuples > most || components * tuples > most)
    {
      m_File.refuse(ErrorCode::Truncated,
                    std::to_string(tuples) + " x " + std::to_string(components) +
                      " values are promised, the file is too short for them");
    }
  }

  /** Digits and blanks alone in the place of binary numbers are text. */
  void
  requireNoText() const
  {
    const std::string_view begin = m_File.peekBytes(20);
    if (m_IsBinary && begin.size() >= 8 && begin.find_first_not_of("0123456789 +-.eE\r\n") == std::string_view::npos)
    {
      m_File.refuse("the file says BINARY and holds text");
    }
  }

  [[nodiscard]] double
  nextValue(const std::string & type)
  {
    if (!m_IsBinary)
    {
      return m_File.nextNumber<double>("a number");
    }
    if (type == "float")
    {
      return static_cast<double>(m_File.nextBigEndian<float>("a number"));
    }
    return type == "double" ? m_File.nextBigEndian<double>("a number") : static_cast<double>(nextIndex(type));
  }

  [[nodiscard]] std::int64_t
  nextIndex(const std::string & type)
  {
    if (!m_IsBinary)
    {
      const std::string_view word = m_File.nextWord();
      if (word.empty())
      {
        m_File.refuseEnd("a number of the cells");
      }
      return vertexNumberOf(m_File, word);
    }
    const bool isSigned = type[0] != 'u' && type.find("uint") == std::string::npos;
    switch (bytesOf(type))
    {
      case 8:
        return m_File.nextBigEndian<std::int64_t>("a number");
      case 4:
        return isSigned ? m_File.nextBigEndian<std::int32_t>("a number")
                        : static_cast<std::int64_t>(m_File.nextBigEndian<std::uint32_t>("a number"));
      case 2:
        return isSigned ? m_File.nextBigEndian<std::int16_t>("a number")
                        : static_cast<std::int64_t>(m_File.nextBigEndian<std::uint16_t>("a number"));
      default:
        return isSigned ? m_File.nextBigEndian<std::int8_t>("a number")
                        : static_cast<std::int64_t>(m_File.nextBigEndian<std::uint8_t>("a number"));
    }
  }

  FileText                  m_File;
  PolygonCollector          m_Surface;
  int                       m_Major{ 0 };
  bool                      m_IsBinary{ false };
  bool                      m_IsRas{ false };
  bool                      m_HasPoints{ false };
  bool                      m_HasPolygons{ false };
  std::vector<std::int64_t> m_Corners;
};

} // namespace

RawSurface
readVtk(const std::string & fileName)
{
  return LegacySurface(fileName).read();
}

} // namespace moserhex
