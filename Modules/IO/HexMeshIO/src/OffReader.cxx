#include "FileText.h"
#include "PolygonCollector.h"

#include <array>

namespace moserhex
{
namespace
{

class OffText
{
public:
  explicit OffText(const std::string & fileName)
    : m_Text(fileName, exportSurfaceAgain, '#', ErrorCode::Format), m_Surface(fileName)
  {}

  RawSurface
  read()
  {
    readMagic();
    const std::size_t vertices = countAt(0, "the number of vertices");
    const std::size_t faces = countAt(1, "the number of faces");
    m_Text.requireRoom(vertices, 5, "vertices");
    m_Text.requireRoom(faces, 5, "faces");
    for (std::size_t vertex = 0; vertex < vertices; ++vertex)
    {
      readVertex();
    }
    for (std::size_t face = 0; face < faces; ++face)
    {
      readFace();
    }
    if (m_Text.nextWords(m_Words))
    {
      m_Text.refuse(ErrorCode::Header, "more lines than the counts at the beginning promise");
    }
    return m_Surface.finish();
  }

private:
  /** The counts follow on the same line or the next. */
  void
  readMagic()
  {
    const bool             any = m_Text.nextWords(m_Words);
    const std::string_view magic = any ? m_Words[0] : std::string_view();
    if (magic == "4OFF" || magic == "nOFF" || magic == "4nOFF" || (m_Words.size() > 1 && m_Words[1] == "BINARY"))
    {
      m_Text.refuse(ErrorCode::Unsupported, "binary OFF or OFF of another dimension, need text in three dimensions");
    }
    if (magic != "OFF" && magic != "COFF" && magic != "NOFF" && magic != "CNOFF")
    {
      m_Text.refuse("the content is not OFF");
    }
    m_Words.erase(m_Words.begin());
    if (m_Words.empty())
    {
      nextLine("the number of vertices");
    }
  }

  void
  nextLine(const char * what)
  {
    if (!m_Text.nextWords(m_Words))
    {
      m_Text.refuseEnd(what);
    }
  }

  [[nodiscard]] std::size_t
  countAt(std::size_t word, const char * what) const
  {
    std::size_t count = 0;
    if (word >= m_Words.size() || !parseNumber(m_Words[word], count))
    {
      m_Text.refuse(ErrorCode::Header,
                    word < m_Words.size()
                      ? "'" + std::string(m_Words[word].substr(0, 20)) + "' where " + what + " is expected"
                      : std::string(what) + " is missing");
    }
    return count;
  }

  void
  readVertex()
  {
    nextLine("the last vertex");
    if (m_Words.size() < 3)
    {
      m_Text.refuse("line " + std::to_string(m_Text.lineNumber()) + ": a vertex of " + std::to_string(m_Words.size()) +
                    " numbers, need 3");
    }
    Vector3 position;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      position[static_cast<int>(axis)] = m_Text.numberOf<double>(m_Words[axis], "a coordinate");
    }
    m_Surface.addVertex(position);
  }

  /** The number of corners, the corners, and a colour that is passed over. */
  void
  readFace()
  {
    nextLine("the last face");
    const auto corners = m_Text.numberOf<std::size_t>(m_Words[0], "the number of corners");
    if (corners > m_Words.size() - 1)
    {
      m_Text.refuse("line " + std::to_string(m_Text.lineNumber()) + ": " + std::to_string(m_Words.size() - 1) +
                    " numbers for " + std::to_string(corners) + " corners");
    }
    m_Corners.clear();
    for (std::size_t corner = 0; corner < corners; ++corner)
    {
      m_Corners.push_back(vertexNumberOf(m_Text, m_Words[corner + 1]));
    }
    m_Surface.addPolygon(m_Corners);
  }

  FileText                      m_Text;
  PolygonCollector              m_Surface;
  std::vector<std::string_view> m_Words;
  std::vector<std::int64_t>     m_Corners;
};

} // namespace

RawSurface
readOff(const std::string & fileName)
{
  return OffText(fileName).read();
}

} // namespace moserhex
