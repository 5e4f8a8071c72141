#include "OffReader.h"

#include "moserhex/HexMeshIO/FileErrors.h"

#include <charconv>
#include <fstream>
#include <iterator>

namespace moserhex
{
namespace
{

/** Hands out the numbers of the file, line by line; '#' starts a comment. */
class OffText
{
public:
  explicit OffText(const std::string & fileName) : m_FileName(fileName)
  {
    std::ifstream file(fileName, std::ios::binary);
    m_Text.assign(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }

  [[nodiscard]] std::string
  nextWord()
  {
    skipSpace();
    const std::size_t begin = m_Position;
    while (m_Position < m_Text.size() && !isSpace(m_Text[m_Position]))
    {
      ++m_Position;
    }
    return m_Text.substr(begin, m_Position - begin);
  }

  template <typename T>
  [[nodiscard]] T
  nextNumber(const char * what)
  {
    const std::string word = nextWord();
    const char *      begin = word.data() + (!word.empty() && word[0] == '+' ? 1 : 0);
    T                 value{};
    const auto [end, error] = std::from_chars(begin, word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size())
    {
      throw BadInput(m_FileName,
                     word.empty() ? std::string("the file ends before ") + what
                                  : "'" + word.substr(0, 20) + "' where " + what + " is expected",
                     "export the surface again");
    }
    return value;
  }

  void
  skipLine()
  {
    while (m_Position < m_Text.size() && m_Text[m_Position] != '\n')
    {
      ++m_Position;
    }
  }

  [[nodiscard]] std::size_t
  size() const
  {
    return m_Text.size();
  }

private:
  static bool
  isSpace(char c)
  {
    return c == ' ' || c == '\t' || c == '\r' || c == '\n';
  }

  void
  skipSpace()
  {
    while (m_Position < m_Text.size() && (isSpace(m_Text[m_Position]) || m_Text[m_Position] == '#'))
    {
      if (m_Text[m_Position] == '#')
      {
        skipLine();
      }
      else
      {
        ++m_Position;
      }
    }
  }

  std::string m_FileName;
  std::string m_Text;
  std::size_t m_Position{ 0 };
};

} // namespace

TriangleMesh
readOff(const std::string & fileName)
{
  OffText           text(fileName);
  const std::string magic = text.nextWord();
  if (magic != "OFF" && magic != "COFF")
  {
    throw BadInput(fileName, "the content is not OFF", "check that the name's ending fits the format");
  }
  const auto vertices = text.nextNumber<std::size_t>("the number of vertices");
  const auto triangles = text.nextNumber<std::size_t>("the number of triangles");
  text.skipLine(); // the number of edges, which nobody keeps up to date
  // Two characters per number at least: a count beyond that is a lie, found before memory is asked for.
  if (vertices > text.size() || triangles > text.size())
  {
    throw BadInput(fileName, "the header promises more than the file holds", "export the surface again");
  }
  TriangleMesh mesh;
  mesh.vertices.resize(vertices);
  for (Vector3 & vertex : mesh.vertices)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      vertex[axis] = text.nextNumber<double>("a coordinate");
    }
    text.skipLine();
  }
  mesh.triangles.resize(triangles);
  for (Triangle & triangle : mesh.triangles)
  {
    const int corners = text.nextNumber<int>("the number of corners");
    if (corners != 3)
    {
      throw BadInput(
        fileName, "a polygon with " + std::to_string(corners) + " corners, need triangles", "triangulate the surface");
    }
    for (VertexIndex & vertex : triangle)
    {
      vertex = text.nextNumber<VertexIndex>("a vertex number");
    }
    text.skipLine();
  }
  return mesh;
}

} // namespace moserhex
