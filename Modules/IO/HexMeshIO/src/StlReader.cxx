#include "FileText.h"
#include "ImageHeader.h"
#include "PolygonCollector.h"

#include <algorithm>
#include <cctype>

namespace moserhex
{
namespace
{

constexpr std::size_t headerBytes = 80;
constexpr std::size_t bytesBeforeTriangles = headerBytes + 4;
constexpr std::size_t bytesPerTriangle = 50;

[[nodiscard]] bool
isTextByte(char c)
{
  return c == '\t' || c == '\n' || c == '\r' || static_cast<unsigned char>(c) >= 0x20;
}

/** Headers of binary files often begin with "solid", too; their count and numbers hold bytes that no text has. */
[[nodiscard]] bool
looksLikeText(const FileText & file)
{
  const std::string begin = trimmed(lowerCase(std::string(file.peekBytes(512))));
  return begin.compare(0, 5, "solid") == 0 && std::all_of(begin.begin(), begin.end(), isTextByte);
}

class StlText
{
public:
  StlText(FileText & text, PolygonCollector & surface) : m_Text(text), m_Surface(surface)
  {}

  void
  read()
  {
    while (!m_Text.peekWord().empty())
    {
      readSolid();
    }
  }

private:
  /** The name behind "solid" and "endsolid" is free; facets of the solid begin on lines of their own. */
  void
  readSolid()
  {
    expect("solid");
    (void)m_Text.nextLine();
    std::string word = nextWord("'facet' or 'endsolid'");
    for (; word == "facet"; word = nextWord("'facet' or 'endsolid'"))
    {
      readFacet();
    }
    if (word != "endsolid")
    {
      m_Text.refuseWord(word, "'facet' or 'endsolid'");
    }
    (void)m_Text.nextLine();
  }

  /** Normals are not looked at: many programs write NaN for those of thin triangles. */
  void
  readFacet()
  {
    expect("normal");
    for (int component = 0; component < 3; ++component)
    {
      (void)nextWord("a normal");
    }
    expect("outer");
    expect("loop");
    for (int corner = 0; corner < 3; ++corner)
    {
      expect("vertex");
      Vector3 position;
      for (int axis = 0; axis < 3; ++axis)
      {
        position[axis] = m_Text.nextNumber<double>("a coordinate");
      }
      m_Surface.addVertex(position);
    }
    expect("endloop");
    expect("endfacet");
    const auto end = static_cast<std::int64_t>(m_Surface.vertexCount());
    m_Surface.addPolygon({ end - 3, end - 2, end - 1 });
  }

  [[nodiscard]] std::string
  nextWord(const char * what)
  {
    const std::string_view word = m_Text.nextWord();
    if (word.empty())
    {
      m_Text.refuseEnd(what);
    }
    return lowerCase(std::string(word.substr(0, 30)));
  }

  void
  expect(const char * keyword)
  {
    const std::string word = nextWord(keyword);
    if (word != keyword)
    {
      m_Text.refuseWord(word, keyword);
    }
  }

  FileText &         m_Text;
  PolygonCollector & m_Surface;
};

void
readBinary(FileText & bytes, PolygonCollector & surface)
{
  const std::size_t size = bytes.remaining();
  bytes.skipBytes(headerBytes, "the number of triangles");
  const std::size_t triangles = bytes.nextBinary<std::uint32_t>("the number of triangles");
  const std::size_t promised = bytesBeforeTriangles + bytesPerTriangle * triangles;
  if (size != promised)
  {
    bytes.refuse(size < promised ? ErrorCode::Truncated : ErrorCode::Header,
                 std::to_string(size) + " bytes do not fit the " + std::to_string(triangles) +
                   " triangles promised: these take " + std::to_string(promised));
  }
  for (std::size_t triangle = 0; triangle < triangles; ++triangle)
  {
    bytes.skipBytes(3 * sizeof(float), "a normal");
    for (int corner = 0; corner < 3; ++corner)
    {
      Vector3 position;
      for (int axis = 0; axis < 3; ++axis)
      {
        position[axis] = static_cast<double>(bytes.nextBinary<float>("a coordinate"));
      }
      surface.addVertex(position);
    }
    bytes.skipBytes(2, "an attribute");
    const auto end = static_cast<std::int64_t>(surface.vertexCount());
    surface.addPolygon({ end - 3, end - 2, end - 1 });
  }
}

} // namespace

RawSurface
readStl(const std::string & fileName)
{
  FileText         file(fileName, copyAgain, '\0', ErrorCode::Format);
  PolygonCollector surface(fileName);
  if (looksLikeText(file))
  {
    StlText(file, surface).read();
  }
  else
  {
    if (std::all_of(file.peekBytes(512).begin(), file.peekBytes(512).end(), isTextByte))
    {
      file.refuse("the content is text, but not STL");
    }
    readBinary(file, surface);
  }
  return surface.finish();
}

} // namespace moserhex
