// What FEBio's reader of files of version 4.0 asks for (FEBioXML: sections, attributes, names, order of numbers).
// Exact.
#include "moserhex/HexMeshIO/HexMeshWriter.h"

#include "TestFolder.h"
#include "TestLattice.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

using namespace moserhex;

namespace
{

constexpr int side = 6; // nodes

struct Element
{
  std::string                        name;
  std::map<std::string, std::string> attributes;
  std::string                        text; ///< in front of the first child
  std::vector<Element>               children;

  [[nodiscard]] std::vector<const Element *>
  all(const std::string & wanted) const
  {
    std::vector<const Element *> found;
    for (const Element & child : children)
    {
      if (child.name == wanted)
      {
        found.push_back(&child);
      }
    }
    return found;
  }

  [[nodiscard]] std::string
  attribute(const std::string & key) const
  {
    const auto found = attributes.find(key);
    return found == attributes.end() ? "" : found->second;
  }

  [[nodiscard]] std::size_t
  id() const
  {
    return std::stoul(attribute("id"));
  }
};

/** Well-formed XML as the writer makes it: no references, no CDATA. Throws std::runtime_error at anything else. */
class XmlReader
{
public:
  explicit XmlReader(std::string text) : m_Text(std::move(text))
  {}

  [[nodiscard]] Element
  document()
  {
    require(m_Text.compare(0, 6, "<?xml ") == 0, "FEBio wants <?xml first");
    m_At = m_Text.find("?>") + 2;
    Element root = element();
    skip();
    require(m_At == m_Text.size(), "something behind the end");
    return root;
  }

private:
  static void
  require(bool holds, const std::string & what)
  {
    if (!holds)
    {
      throw std::runtime_error(what);
    }
  }

  /** Over white space and comments. */
  void
  skip()
  {
    while (true)
    {
      m_At = std::min(m_Text.find_first_not_of(" \n", m_At), m_Text.size());
      if (m_Text.compare(m_At, 4, "<!--") != 0)
      {
        return;
      }
      m_At = m_Text.find("-->", m_At) + 3;
    }
  }

  [[nodiscard]] std::string
  upTo(const std::string & ends)
  {
    const std::size_t begin = m_At;
    m_At = m_Text.find_first_of(ends, begin);
    require(m_At != std::string::npos, "cut off");
    return m_Text.substr(begin, m_At - begin);
  }

  [[nodiscard]] Element
  element()
  {
    skip();
    require(m_Text[m_At++] == '<', "no element");
    Element result;
    result.name = upTo(" />");
    while (m_Text[m_At] == ' ')
    {
      ++m_At;
      const std::string key = upTo("=");
      require(m_Text.compare(m_At, 2, "=\"") == 0, "no quotation mark behind " + key);
      m_At += 2;
      require(result.attributes.emplace(key, upTo("\"")).second, key + " twice");
      ++m_At;
    }
    if (m_Text.compare(m_At, 2, "/>") == 0)
    {
      m_At += 2;
      return result;
    }
    require(m_Text[m_At++] == '>', "no end of the tag " + result.name);
    result.text = upTo("<");
    const std::string end = "</" + result.name + ">";
    for (skip(); m_Text.compare(m_At, 2, "</") != 0; skip())
    {
      result.children.push_back(element());
    }
    require(m_Text.compare(m_At, end.size(), end) == 0, result.name + " does not end");
    m_At += end.size();
    return result;
  }

  std::string m_Text;
  std::size_t m_At{ 0 };
};

std::vector<std::size_t>
numbersOf(const Element & element)
{
  std::vector<std::size_t> numbers;
  std::istringstream       words(element.text);
  for (std::string word; std::getline(words, word, ',');)
  {
    EXPECT_EQ(word.find_first_not_of("0123456789"), std::string::npos) << word;
    numbers.push_back(std::stoul(word));
  }
  return numbers;
}

/** Every element's name with its attributes must be in the list. */
void
expectKnown(const Element & element, const std::map<std::string, std::set<std::string>> & known)
{
  const auto found = known.find(element.name);
  ASSERT_NE(found, known.end()) << element.name;
  std::set<std::string> names;
  for (const auto & [key, value] : element.attributes)
  {
    names.insert(key);
    EXPECT_FALSE(value.empty()) << element.name << " " << key;
  }
  EXPECT_EQ(names, found->second) << element.name;
  for (const Element & child : element.children)
  {
    expectKnown(child, known);
  }
}

class FebioFile : public testing::Test
{
protected:
  FebioFile()
  {
    const TestFolder folder;
    writeHexMesh(folder / "a.feb", m_Mesh);
    m_Root = XmlReader(readBytes(folder / "a.feb")).document();
    m_MeshSection = m_Root.all("Mesh").at(0);
  }

  [[nodiscard]] const Vector3 &
  node(std::size_t id) const
  {
    return m_Mesh.nodes.at(id - 1);
  }

  [[nodiscard]] Vector3
  middleOf(const std::vector<std::size_t> & ids) const
  {
    Vector3 sum = Vector3::Zero();
    for (const std::size_t id : ids)
    {
      sum += node(id);
    }
    return sum / static_cast<double>(ids.size());
  }

  HexMesh         m_Mesh{ bentLattice(side) };
  Element         m_Root;
  const Element * m_MeshSection{ nullptr };
};

} // namespace

TEST_F(FebioFile, SectionsAndAttributesAreThoseOfVersionFour)
{
  EXPECT_EQ(m_Root.name, "febio_spec");
  EXPECT_EQ(m_Root.attribute("version"), "4.0");
  std::vector<std::string> sections;
  for (const Element & section : m_Root.children)
  {
    sections.push_back(section.name);
  }
  // Module must be first; domains look up the parts of Mesh and the materials when they are read.
  EXPECT_EQ(sections, (std::vector<std::string>{ "Module", "Material", "Mesh", "MeshDomains" }));
  // The reader refuses attributes that it does not know.
  expectKnown(m_Root,
              { { "febio_spec", { "version" } },
                { "Module", { "type" } },
                { "Material", {} },
                { "material", { "id", "name", "type" } },
                { "density", {} },
                { "E", {} },
                { "v", {} },
                { "Mesh", {} },
                { "Nodes", { "name" } },
                { "node", { "id" } },
                { "Elements", { "name", "type" } },
                { "elem", { "id" } },
                { "NodeSet", { "name" } },
                { "Surface", { "name" } },
                { "quad4", { "id" } },
                { "MeshDomains", {} },
                { "SolidDomain", { "mat", "name" } } });
  EXPECT_EQ(m_Root.all("Module").at(0)->attribute("type"), "solid");
}

TEST_F(FebioFile, EveryPartHasOneDomainAndItsMaterialExists)
{
  std::set<std::string> materials;
  std::size_t           number = 0;
  for (const Element * material : m_Root.all("Material").at(0)->all("material"))
  {
    EXPECT_EQ(material->id(), ++number); // counts from 1
    EXPECT_EQ(material->attribute("type"), "neo-Hookean");
    EXPECT_TRUE(materials.insert(material->attribute("name")).second);
  }
  std::vector<std::string> parts;
  for (const Element * part : m_MeshSection->all("Elements"))
  {
    EXPECT_EQ(part->attribute("type"), "hex8");
    EXPECT_FALSE(part->children.empty());
    parts.push_back(part->attribute("name"));
  }
  EXPECT_EQ(parts, (std::vector<std::string>{ "SHELL_1", "SHELL_2", "SHELL_3" }));
  std::vector<std::string> domains;
  for (const Element * domain : m_Root.all("MeshDomains").at(0)->all("SolidDomain"))
  {
    domains.push_back(domain->attribute("name"));
    EXPECT_EQ(materials.count(domain->attribute("mat")), 1U) << domain->attribute("mat");
  }
  EXPECT_EQ(domains, parts);
}

TEST_F(FebioFile, NumbersRiseAndReferToNodesThatExist)
{
  ASSERT_EQ(m_MeshSection->all("Nodes").size(), 1U);
  ASSERT_EQ(m_MeshSection->children.front().name, "Nodes"); // before all that refers to them
  std::size_t last = 0;
  for (const Element & node : m_MeshSection->all("Nodes")[0]->children)
  {
    EXPECT_EQ(node.id(), last + 1); // the reader wants them rising
    last = node.id();
  }
  EXPECT_EQ(last, m_Mesh.nodes.size());
  std::set<std::size_t> cells;
  for (const Element * part : m_MeshSection->all("Elements"))
  {
    std::size_t before = 0;
    for (const Element & cell : part->children)
    {
      EXPECT_GT(cell.id(), before); // rising within a part
      before = cell.id();
      EXPECT_TRUE(cells.insert(cell.id()).second) << cell.id();
      const std::vector<std::size_t> nodes = numbersOf(cell);
      ASSERT_EQ(nodes.size(), 8U);
      EXPECT_EQ(std::set<std::size_t>(nodes.begin(), nodes.end()).size(), 8U);
      // Node 1, and the edges to 2, 4 and 5: positive, or FEBio calls the element inverted.
      const Vector3 u = node(nodes[1]) - node(nodes[0]);
      const Vector3 v = node(nodes[3]) - node(nodes[0]);
      const Vector3 w = node(nodes[4]) - node(nodes[0]);
      EXPECT_GT(u.cross(v).dot(w), 0.0) << cell.id();
    }
  }
  EXPECT_EQ(cells.size(), static_cast<std::size_t>((side - 1) * (side - 1) * (side - 1)));
  EXPECT_EQ(*cells.rbegin(), cells.size());
}

TEST_F(FebioFile, NamesOfSetsAreTheirOwn)
{
  for (const char * kind : { "NodeSet", "Surface", "Elements" })
  {
    std::set<std::string> names; // Nodes with a name is a node set, too
    names.insert(kind == std::string("NodeSet") ? m_MeshSection->all("Nodes").at(0)->attribute("name") : "");
    for (const Element * set : m_MeshSection->all(kind))
    {
      EXPECT_TRUE(names.insert(set->attribute("name")).second) << kind << " " << set->attribute("name");
    }
  }
}

TEST_F(FebioFile, SurfacesAreSidesOfElementsAndTogetherTheBoundary)
{
  // Sides of hexahedra by their four nodes: how many elements have it, and the middle of the last.
  std::map<std::set<std::size_t>, std::pair<int, Vector3>> sides;
  const std::vector<std::array<std::size_t, 4>>            sidesOfCell{ { 0, 1, 2, 3 }, { 4, 5, 6, 7 }, { 0, 1, 5, 4 },
                                                             { 1, 2, 6, 5 }, { 2, 3, 7, 6 }, { 3, 0, 4, 7 } };
  for (const Element * part : m_MeshSection->all("Elements"))
  {
    for (const Element & cell : part->children)
    {
      const std::vector<std::size_t> nodes = numbersOf(cell);
      for (const auto & corners : sidesOfCell)
      {
        auto & [count, middle] = sides[{ nodes[corners[0]], nodes[corners[1]], nodes[corners[2]], nodes[corners[3]] }];
        ++count;
        middle = middleOf(nodes);
      }
    }
  }
  std::size_t found = 0;
  for (const Element * surface : m_MeshSection->all("Surface"))
  {
    std::set<std::size_t> nodes;
    std::size_t           last = 0;
    for (const Element & quad : surface->children)
    {
      EXPECT_EQ(quad.id(), ++last);
      const std::vector<std::size_t> ids = numbersOf(quad);
      ASSERT_EQ(ids.size(), 4U);
      nodes.insert(ids.begin(), ids.end());
      const auto one = sides.find({ ids.begin(), ids.end() });
      ASSERT_NE(one, sides.end()) << quad.text;
      EXPECT_EQ(one->second.first, 1) << quad.text << " lies inside, or is in two surfaces";
      one->second.first = -1;
      ++found;
      const Vector3 normal = (node(ids[2]) - node(ids[0])).cross(node(ids[3]) - node(ids[1]));
      EXPECT_GT(normal.dot(middleOf(ids) - one->second.second), 0.0) << quad.text << " faces inwards";
    }
    const auto sets = m_MeshSection->all("NodeSet");
    const auto same = std::find_if(sets.begin(), sets.end(), [&](const Element * set) {
      return set->attribute("name") == surface->attribute("name");
    });
    ASSERT_NE(same, sets.end()) << surface->attribute("name");
    EXPECT_TRUE((*same)->children.empty()); // the reader wants a leaf
    EXPECT_EQ(numbersOf(**same), std::vector<std::size_t>(nodes.begin(), nodes.end()));
  }
  EXPECT_EQ(found, static_cast<std::size_t>(6 * (side - 1) * (side - 1)));
  EXPECT_TRUE(std::none_of(sides.begin(), sides.end(), [](const auto & one) { return one.second.first == 1; }));
}
