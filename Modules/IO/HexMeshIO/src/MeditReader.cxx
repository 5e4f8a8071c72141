#include "FileText.h"
#include "HexCellCollector.h"
#include "HexCellFormats.h"

#include <map>

namespace moserhex
{
namespace
{

struct CellKind
{
  const char * name;
  int          dimension;
};

/** Lists of cells other than Hexahedra: keyword, name, dimension. */
const CellKind *
cellKind(std::string_view keyword)
{
  static const std::map<std::string, CellKind, std::less<>> kinds{
    { "Edges", { "edge", 1 } },
    { "EdgesP2", { "3-node edge", 1 } },
    { "Triangles", { "triangle", 2 } },
    { "TrianglesP2", { "6-node triangle", 2 } },
    { "Quadrilaterals", { "quadrilateral", 2 } },
    { "QuadrilateralsQ2", { "9-node quadrilateral", 2 } },
    { "Tetrahedra", { "tetrahedron", 3 } },
    { "TetrahedraP2", { "10-node tetrahedron", 3 } },
    { "Prisms", { "prism", 3 } },
    { "Pentahedra", { "prism", 3 } },
    { "PrismsP2", { "18-node prism", 3 } },
    { "Pyramids", { "pyramid", 3 } },
    { "PyramidsP2", { "14-node pyramid", 3 } },
    { "HexahedraQ2", { "27-node hexahedron", 3 } },
  };
  const auto found = kinds.find(keyword);
  return found == kinds.end() ? nullptr : &found->second;
}

bool
isKeyword(std::string_view word)
{
  return !word.empty() && ((word[0] >= 'A' && word[0] <= 'Z') || (word[0] >= 'a' && word[0] <= 'z'));
}

class MeditReader
{
public:
  explicit MeditReader(const std::string & fileName)
    : m_Text(fileName, "save the mesh again as ASCII MEDIT", '#'), m_Cells(fileName)
  {}

  HexCellFile
  read()
  {
    if (m_Text.nextWord() != "MeshVersionFormatted")
    {
      m_Text.refuse("the content is not ASCII MEDIT");
    }
    (void)m_Text.nextNumber<int>("the version");
    for (std::string word(m_Text.nextWord()); !word.empty() && word != "End"; word = m_Text.nextWord())
    {
      if (!isKeyword(word))
      {
        m_Text.refuse("'" + word.substr(0, 20) + "' where a keyword is expected");
      }
      readBlock(word);
    }
    return m_Cells.finish();
  }

private:
  void
  readBlock(const std::string & keyword)
  {
    if (keyword == "Dimension")
    {
      const int dimension = m_Text.nextNumber<int>("the dimension");
      if (dimension != 3)
      {
        m_Text.refuse("has dimension " + std::to_string(dimension) + ", need 3");
      }
    }
    else if (keyword == "Vertices")
    {
      readVertices();
    }
    else if (keyword == "Hexahedra")
    {
      readHexahedra();
    }
    else
    {
      if (const CellKind * kind = cellKind(keyword))
      {
        const auto count = m_Text.nextNumber<std::size_t>("a number of cells");
        m_Text.requireRoom(count, 4, "cells");
        m_Cells.addOther(kind->name, kind->dimension, count);
      }
      skipNumbers();
    }
  }

  void
  readVertices()
  {
    const auto count = m_Text.nextNumber<std::size_t>("the number of vertices");
    m_Text.requireRoom(count, 8, "vertices");
    for (std::size_t vertex = 0; vertex < count; ++vertex)
    {
      Vector3 position;
      for (int axis = 0; axis < 3; ++axis)
      {
        position[axis] = m_Text.nextNumber<double>("a coordinate");
      }
      (void)m_Text.nextNumber<double>("a vertex's reference");
      m_Cells.addNode(m_NextTag++, position);
    }
  }

  void
  readHexahedra()
  {
    const auto count = m_Text.nextNumber<std::size_t>("the number of hexahedra");
    m_Text.requireRoom(count, 18, "hexahedra");
    for (std::size_t cell = 0; cell < count; ++cell)
    {
      std::array<HexCellCollector::NodeTag, 8> tags{};
      for (auto & tag : tags)
      {
        tag = m_Text.nextNumber<HexCellCollector::NodeTag>("a vertex number");
      }
      (void)m_Text.nextNumber<double>("a hexahedron's reference");
      m_Cells.addHexahedron(tags);
    }
  }

  void
  skipNumbers()
  {
    for (std::string_view word = m_Text.peekWord(); !word.empty() && !isKeyword(word); word = m_Text.peekWord())
    {
      (void)m_Text.nextWord();
    }
  }

  FileText                  m_Text;
  HexCellCollector          m_Cells;
  HexCellCollector::NodeTag m_NextTag{ 1 }; ///< vertices are numbered from 1 in their order
};

} // namespace

HexCellFile
readMeditCells(const std::string & fileName)
{
  return MeditReader(fileName).read();
}

} // namespace moserhex
