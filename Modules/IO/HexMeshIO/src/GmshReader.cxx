#include "FileText.h"
#include "HexCellCollector.h"
#include "HexCellFormats.h"

#include <algorithm>
#include <map>

namespace moserhex
{
namespace
{

struct ElementKind
{
  const char * name;
  int          dimension;
  int          nodes;
};

/** The element types of the Gmsh manual, "MSH file format". */
const ElementKind *
elementKind(int type)
{
  static const std::map<int, ElementKind> kinds{
    { 1, { "line", 1, 2 } },
    { 2, { "triangle", 2, 3 } },
    { 3, { "quadrilateral", 2, 4 } },
    { 4, { "tetrahedron", 3, 4 } },
    { 5, { "hexahedron", 3, 8 } },
    { 6, { "prism", 3, 6 } },
    { 7, { "pyramid", 3, 5 } },
    { 8, { "3-node line", 1, 3 } },
    { 9, { "6-node triangle", 2, 6 } },
    { 10, { "9-node quadrilateral", 2, 9 } },
    { 11, { "10-node tetrahedron", 3, 10 } },
    { 12, { "27-node hexahedron", 3, 27 } },
    { 13, { "18-node prism", 3, 18 } },
    { 14, { "14-node pyramid", 3, 14 } },
    { 15, { "point", 0, 1 } },
    { 16, { "8-node quadrilateral", 2, 8 } },
    { 17, { "20-node hexahedron", 3, 20 } },
    { 18, { "15-node prism", 3, 15 } },
    { 19, { "13-node pyramid", 3, 13 } },
    { 20, { "9-node triangle", 2, 9 } },
    { 21, { "10-node triangle", 2, 10 } },
    { 26, { "4-node line", 1, 4 } },
    { 27, { "5-node line", 1, 5 } },
    { 29, { "20-node tetrahedron", 3, 20 } },
    { 36, { "16-node quadrilateral", 2, 16 } },
    { 92, { "64-node hexahedron", 3, 64 } },
    { 93, { "125-node hexahedron", 3, 125 } },
  };
  const auto found = kinds.find(type);
  return found == kinds.end() ? nullptr : &found->second;
}

constexpr int hexahedronType = 5;

class GmshReader
{
public:
  explicit GmshReader(const std::string & fileName)
    : m_Text(fileName, "save the mesh again as MSH 4.1 or 2.2"), m_Cells(fileName)
  {}

  HexCellFile
  read()
  {
    if (m_Text.nextWord() != "$MeshFormat")
    {
      m_Text.refuse("the content is not Gmsh's MSH");
    }
    readFormat();
    for (std::string word(m_Text.nextWord()); !word.empty(); word = m_Text.nextWord())
    {
      if (word[0] != '$')
      {
        m_Text.refuse("'" + word.substr(0, 20) + "' where a section is expected");
      }
      const std::string end = "$End" + word.substr(1);
      if (word == "$Nodes")
      {
        m_Version4 ? readNodes4() : readNodes2();
        requireEnd(end);
      }
      else if (word == "$Elements")
      {
        m_Version4 ? readElements4() : readElements2();
        requireEnd(end);
      }
      else
      {
        m_Text.skipBehind(end);
      }
    }
    addHexahedraInOrder();
    return m_Cells.finish();
  }

private:
  /** A number, text or binary as the header says. */
  template <typename T>
  T
  next(const char * what)
  {
    return m_Binary ? m_Text.nextBinary<T>(what) : m_Text.nextNumber<T>(what);
  }

  /** A count of things of `numbersEach` numbers, two characters or four bytes each at least. */
  std::size_t
  nextCount(const char * what, std::size_t numbersEach)
  {
    const auto count = next<std::uint64_t>(what);
    m_Text.requireRoom(count, numbersEach * (m_Binary ? 4 : 2), what);
    return count;
  }

  void
  requireEnd(const std::string & end)
  {
    const std::string word(m_Text.nextWord());
    if (word != end)
    {
      m_Text.refuse("'" + word.substr(0, 20) + "' where " + end + " is expected");
    }
  }

  void
  readFormat()
  {
    const std::string version(m_Text.nextWord());
    m_Version4 = version == "4.1";
    if (!m_Version4 && version != "2" && version != "2.0" && version != "2.1" && version != "2.2")
    {
      m_Text.refuse("is MSH version " + version.substr(0, 20) + ", need 4.1 or 2.2");
    }
    m_Binary = m_Text.nextNumber<int>("the file type") != 0;
    const int realSize = m_Text.nextNumber<int>("the data size");
    (void)m_Text.nextLine();
    if (m_Binary && realSize != 8)
    {
      m_Text.refuse("has numbers of " + std::to_string(realSize) + " bytes, need 8");
    }
    if (m_Binary && m_Text.nextBinary<std::int32_t>("the byte order") != 1)
    {
      m_Text.refuse("is big-endian, need little-endian");
    }
    requireEnd("$EndMeshFormat");
  }

  Vector3
  nextPosition()
  {
    Vector3 position;
    for (int axis = 0; axis < 3; ++axis)
    {
      position[axis] = next<double>("a coordinate");
    }
    return position;
  }

  void
  beginSection()
  {
    if (m_Binary)
    {
      (void)m_Text.nextLine();
    }
  }

  void
  readNodes4()
  {
    beginSection();
    const std::size_t blocks = nextCount("entity blocks", 4);
    for (int i = 0; i < 3; ++i)
    {
      (void)next<std::uint64_t>("a number of nodes");
    }
    for (std::size_t block = 0; block < blocks; ++block)
    {
      const auto dimension = next<std::int32_t>("a dimension");
      (void)next<std::int32_t>("an entity's number");
      const auto        parametric = next<std::int32_t>("the parametric flag");
      const std::size_t count = nextCount("nodes", 4);
      const int         parameters = parametric != 0 ? dimension : 0;
      if (parameters < 0 || parameters > 3)
      {
        m_Text.refuse("an entity of dimension " + std::to_string(dimension));
      }
      std::vector<std::uint64_t> tags(count);
      for (std::uint64_t & tag : tags)
      {
        tag = next<std::uint64_t>("a node number");
      }
      for (const std::uint64_t tag : tags)
      {
        m_Cells.addNode(static_cast<HexCellCollector::NodeTag>(tag), nextPosition());
        for (int i = 0; i < parameters; ++i)
        {
          (void)next<double>("a parameter");
        }
      }
    }
  }

  void
  readElements4()
  {
    beginSection();
    const std::size_t blocks = nextCount("entity blocks", 4);
    for (int i = 0; i < 3; ++i)
    {
      (void)next<std::uint64_t>("a number of elements");
    }
    for (std::size_t block = 0; block < blocks; ++block)
    {
      (void)next<std::int32_t>("a dimension");
      (void)next<std::int32_t>("an entity's number");
      const auto          type = next<std::int32_t>("an element type");
      const ElementKind & kind = kindOf(type);
      const std::size_t   count = nextCount("elements", static_cast<std::size_t>(kind.nodes + 1));
      for (std::size_t element = 0; element < count; ++element)
      {
        const auto number = next<std::uint64_t>("an element number");
        readElement<std::uint64_t>(number, type, kind);
      }
    }
  }

  void
  readNodes2()
  {
    const auto count = m_Text.nextNumber<std::uint64_t>("the number of nodes");
    beginSection();
    m_Text.requireRoom(count, 8, "nodes");
    for (std::uint64_t node = 0; node < count; ++node)
    {
      const auto tag = next<std::int32_t>("a node number");
      m_Cells.addNode(tag, nextPosition());
    }
  }

  void
  readElements2()
  {
    const auto count = m_Text.nextNumber<std::uint64_t>("the number of elements");
    beginSection();
    m_Text.requireRoom(count, 6, "elements");
    for (std::uint64_t done = 0; done < count;)
    {
      done += m_Binary ? readElementBlock2(count - done) : readElementLine2();
    }
  }

  std::uint64_t
  readElementLine2()
  {
    const auto number = static_cast<std::uint64_t>(next<std::int32_t>("an element number"));
    const auto type = next<std::int32_t>("an element type");
    skipTags(next<std::int32_t>("the number of tags"));
    readElement<std::int32_t>(number, type, kindOf(type));
    return 1;
  }

  /** Binary: elements of one type behind a header of their own. */
  std::uint64_t
  readElementBlock2(std::uint64_t left)
  {
    const auto type = next<std::int32_t>("an element type");
    const auto count = next<std::int32_t>("the number of elements");
    const auto tags = next<std::int32_t>("the number of tags");
    if (count < 1 || static_cast<std::uint64_t>(count) > left)
    {
      m_Text.refuse("a block of " + std::to_string(count) + " elements, " + std::to_string(left) + " left");
    }
    for (std::int32_t element = 0; element < count; ++element)
    {
      const auto number = static_cast<std::uint64_t>(next<std::int32_t>("an element number"));
      skipTags(tags);
      readElement<std::int32_t>(number, type, kindOf(type));
    }
    return static_cast<std::uint64_t>(count);
  }

  void
  skipTags(std::int32_t count)
  {
    for (std::int32_t i = 0; i < count; ++i)
    {
      (void)next<std::int32_t>("a tag");
    }
  }

  const ElementKind &
  kindOf(std::int32_t type)
  {
    const ElementKind * kind = elementKind(type);
    if (!kind)
    {
      m_Text.refuse("has elements of the unknown type " + std::to_string(type));
    }
    return *kind;
  }

  template <typename TTag>
  void
  readElement(std::uint64_t number, std::int32_t type, const ElementKind & kind)
  {
    std::array<HexCellCollector::NodeTag, 8> tags{};
    for (int node = 0; node < kind.nodes; ++node)
    {
      const auto tag = static_cast<HexCellCollector::NodeTag>(next<TTag>("a node number"));
      if (node < 8)
      {
        tags[static_cast<std::size_t>(node)] = tag;
      }
    }
    if (type == hexahedronType)
    {
      m_Hexahedra.push_back({ number, tags });
    }
    else
    {
      m_Cells.addOther(kind.name, kind.dimension, 1);
    }
  }

  /** By their numbers: MSH 4.1 lists elements by entity, which tears a lattice's cells apart. */
  void
  addHexahedraInOrder()
  {
    std::stable_sort(m_Hexahedra.begin(), m_Hexahedra.end(), [](const Hexahedron & a, const Hexahedron & b) {
      return a.number < b.number;
    });
    for (const Hexahedron & hexahedron : m_Hexahedra)
    {
      m_Cells.addHexahedron(hexahedron.nodes);
    }
  }

  struct Hexahedron
  {
    std::uint64_t                            number;
    std::array<HexCellCollector::NodeTag, 8> nodes;
  };

  FileText                m_Text;
  HexCellCollector        m_Cells;
  std::vector<Hexahedron> m_Hexahedra;
  bool                    m_Version4{ true };
  bool                    m_Binary{ false };
};

} // namespace

HexCellFile
readGmshCells(const std::string & fileName)
{
  return GmshReader(fileName).read();
}

} // namespace moserhex
