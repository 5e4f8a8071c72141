#include "FileText.h"
#include "ImageHeader.h"
#include "PolygonCollector.h"

#include <algorithm>
#include <array>

namespace moserhex
{
namespace
{

/** What says nothing about the surface itself. */
constexpr std::array<std::string_view, 24> ignoredKeywords{ "vt",       "vn",         "vp",        "g",     "o",
                                                            "s",        "mg",         "l",         "p",     "usemtl",
                                                            "mtllib",   "usemap",     "maplib",    "bevel", "c_interp",
                                                            "d_interp", "shadow_obj", "trace_obj", "lod",   "ctech",
                                                            "stech",    "hole",       "sp",        "deg" };

class ObjText
{
public:
  explicit ObjText(const std::string & fileName)
    : m_Text(fileName, exportSurfaceAgain, '#', ErrorCode::Format), m_Surface(fileName, 1)
  {}

  RawSurface
  read()
  {
    while (m_Text.nextWords(m_Words))
    {
      readLine();
    }
    return m_Surface.finish();
  }

private:
  using Words = std::vector<std::string_view>;

  void
  readLine()
  {
    joinContinuedLines();
    const std::string_view keyword = m_Words[0];
    if (keyword == "v")
    {
      readVertex();
    }
    else if (keyword == "f" || keyword == "fo")
    {
      readFace();
    }
    else if (keyword == "curv" || keyword == "surf" || keyword == "cstype")
    {
      m_Text.refuse(ErrorCode::Unsupported, place() + "free-form curves and surfaces, need polygons");
    }
    else if (std::find(ignoredKeywords.begin(), ignoredKeywords.end(), keyword) == ignoredKeywords.end())
    {
      m_Text.refuse(place() + "'" + std::string(keyword.substr(0, 20)) + "' is not OBJ");
    }
  }

  /** A line that ends with a backslash goes on in the next. */
  void
  joinContinuedLines()
  {
    while (m_Words.back().back() == '\\')
    {
      m_Words.back().remove_suffix(1);
      if (m_Words.back().empty())
      {
        m_Words.pop_back();
      }
      Words more;
      if (!m_Text.nextWords(more) || m_Words.empty())
      {
        m_Text.refuse(ErrorCode::Truncated, "the file ends within a line that goes on");
      }
      m_Words.insert(m_Words.end(), more.begin(), more.end());
    }
  }

  /** x y z, and then a weight or a colour. */
  void
  readVertex()
  {
    if (m_Words.size() < 4 || m_Words.size() > 8)
    {
      m_Text.refuse(place() + "a vertex of " + std::to_string(m_Words.size() - 1) + " numbers, need 3");
    }
    Vector3 position;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      position[static_cast<int>(axis)] = m_Text.numberOf<double>(m_Words[axis + 1], "a coordinate");
    }
    for (std::size_t word = 4; word < m_Words.size(); ++word)
    {
      (void)m_Text.numberOf<double>(m_Words[word], "a weight or a colour");
    }
    m_Surface.addVertex(position);
  }

  /** v, v/vt, v//vn or v/vt/vn. */
  void
  readFace()
  {
    m_Corners.clear();
    for (std::size_t word = 1; word < m_Words.size(); ++word)
    {
      const std::string_view corner = m_Words[word];
      const std::size_t      slash = corner.find('/');
      m_Corners.push_back(vertexOf(corner.substr(0, slash)));
      if (slash != std::string_view::npos && corner.find_first_not_of("0123456789-/", slash) != std::string_view::npos)
      {
        m_Text.refuseWord(corner, "a corner");
      }
    }
    m_Surface.addPolygon(m_Corners);
  }

  /** Negative numbers count back from the last vertex so far. */
  [[nodiscard]] std::int64_t
  vertexOf(std::string_view word)
  {
    const std::int64_t number = vertexNumberOf(m_Text, word);
    const auto         count = static_cast<std::int64_t>(m_Surface.vertexCount());
    if (number == 0 || number < -count)
    {
      m_Text.refuse(ErrorCode::SurfaceIndex,
                    place() + "vertex number " + std::to_string(number) + " of a face, " + std::to_string(count) +
                      " vertices so far");
    }
    return number > 0 ? number - 1 : count + number;
  }

  [[nodiscard]] std::string
  place() const
  {
    return "line " + std::to_string(m_Text.lineNumber()) + ": ";
  }

  FileText                  m_Text;
  PolygonCollector          m_Surface;
  Words                     m_Words;
  std::vector<std::int64_t> m_Corners;
};

} // namespace

RawSurface
readObj(const std::string & fileName)
{
  return ObjText(fileName).read();
}

} // namespace moserhex
