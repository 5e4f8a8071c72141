#include "FileText.h"
#include "HexCellCollector.h"
#include "HexCellFormats.h"

#include <algorithm>
#include <cctype>
#include <map>

namespace moserhex
{
namespace
{

std::string_view
withoutSpace(std::string_view text)
{
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  const std::size_t end = text.find_last_not_of(" \t\r\n");
  return begin == std::string_view::npos ? std::string_view() : text.substr(begin, end - begin + 1);
}

std::string
upperCase(std::string_view text)
{
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(), [](unsigned char c) {
    return static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
  });
  return result;
}

std::vector<std::string_view>
fieldsOf(std::string_view line)
{
  std::vector<std::string_view> fields;
  for (std::size_t begin = 0; begin <= line.size();)
  {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    fields.push_back(withoutSpace(line.substr(begin, end - begin)));
    begin = end + 1;
  }
  return fields;
}

bool
startsWith(const std::string & text, std::string_view begin)
{
  return text.compare(0, begin.size(), begin) == 0;
}

/** C3D8, C3D8R, C3D8I, C3D8H, C3D8T, ...: stress elements of 8 nodes with any formulation, and CalculiX's. */
bool
isHexahedron(const std::string & type)
{
  return startsWith(type, "C3D8") && (type.size() == 4 || std::isalpha(static_cast<unsigned char>(type[4])));
}

/** Shells, membranes, plane and axisymmetric elements, beams, trusses, rigid faces, springs, masses. */
bool
isOfLowerDimension(const std::string & type)
{
  for (const char * family : { "CPS",
                               "CPE",
                               "CAX",
                               "M3D",
                               "SFM3D",
                               "T2D",
                               "T3D",
                               "R2D",
                               "R3D",
                               "RAX",
                               "STRI",
                               "SPRING",
                               "DASHPOT",
                               "MASS",
                               "GAP",
                               "CONN",
                               "PIPE" })
  {
    if (startsWith(type, family))
    {
      return true;
    }
  }
  const bool shellOrBeam = startsWith(type, "S") || startsWith(type, "B");
  return shellOrBeam && type.size() > 1 && std::isdigit(static_cast<unsigned char>(type[1]));
}

class AbaqusReader
{
public:
  explicit AbaqusReader(const std::string & fileName)
    : m_Text(fileName, "write one flat input file of nodes and C3D8 elements"), m_Cells(fileName)
  {}

  HexCellFile
  read()
  {
    while (!m_Text.atEnd())
    {
      const std::string_view line = withoutSpace(m_Text.nextLine());
      if (line.empty() || startsWith(std::string(line.substr(0, 2)), "**"))
      {
        continue;
      }
      if (line[0] == '*')
      {
        requireCompleteElement();
        beginKeyword(line);
      }
      else
      {
        m_AnyKeyword ? readData(line) : m_Text.refuse("the content is not an Abaqus input file");
      }
    }
    requireCompleteElement();
    HexCellFile file = m_Cells.finish();
    if (!m_Text.endsWithNewLine())
    {
      file.warnings.emplace_back("the last line has no end: the file may be cut");
    }
    return file;
  }

private:
  enum class Block
  {
    Ignored,
    Nodes,
    Hexahedra,
    OtherElements,
    Instance
  };

  /** A keyword's line goes on when it ends with a comma. */
  void
  beginKeyword(std::string_view firstLine)
  {
    std::string line(firstLine);
    while (line.back() == ',' && !m_Text.atEnd())
    {
      line += withoutSpace(m_Text.nextLine());
    }
    m_AnyKeyword = true;
    m_Block = Block::Ignored;
    m_Continued = false;

    const auto                         fields = fieldsOf(line);
    const std::string                  keyword = upperCase(fields[0]);
    std::map<std::string, std::string> parameters;
    for (std::size_t i = 1; i < fields.size(); ++i)
    {
      const std::size_t equals = std::min(fields[i].find('='), fields[i].size());
      const auto        value = equals < fields[i].size() ? fields[i].substr(equals + 1) : std::string_view();
      parameters[upperCase(withoutSpace(fields[i].substr(0, equals)))] = upperCase(withoutSpace(value));
    }
    requireSupported(keyword, parameters);
    if (keyword == "*NODE")
    {
      m_Block = Block::Nodes;
    }
    else if (keyword == "*ELEMENT")
    {
      m_Type = parameters["TYPE"];
      m_Block = isHexahedron(m_Type) ? Block::Hexahedra : Block::OtherElements;
    }
    else if (keyword == "*INSTANCE")
    {
      m_Block = Block::Instance;
    }
  }

  /** What would put nodes or elements elsewhere than this reader does. */
  void
  requireSupported(const std::string & keyword, const std::map<std::string, std::string> & parameters) const
  {
    const auto has = [&parameters](const char * name) { return parameters.count(name) > 0; };
    for (const char * generator : { "*INCLUDE", "*NGEN", "*NFILL", "*NCOPY", "*ELGEN", "*ELCOPY", "*NMAP", "*SYSTEM" })
    {
      if (keyword == generator)
      {
        m_Text.refuse("has " + keyword + ", which is not supported");
      }
    }
    if ((keyword == "*NODE" || keyword == "*ELEMENT") && has("INPUT"))
    {
      m_Text.refuse("has " + keyword + " with INPUT, an include, which is not supported");
    }
    if (keyword == "*NODE" && has("SYSTEM") && parameters.at("SYSTEM") != "R")
    {
      m_Text.refuse("has *NODE in the coordinate system " + parameters.at("SYSTEM") + ", need rectangular ones");
    }
    if (keyword == "*ELEMENT" && !has("TYPE"))
    {
      m_Text.refuse("has *ELEMENT without TYPE");
    }
  }

  void
  readData(std::string_view line)
  {
    switch (m_Block)
    {
      case Block::Nodes:
        readNode(line);
        break;
      case Block::Hexahedra:
        readElement(line);
        break;
      case Block::OtherElements:
        if (!m_Continued)
        {
          m_Cells.addOther(m_Type.substr(0, 20), isOfLowerDimension(m_Type) ? 2 : 3, 1);
        }
        m_Continued = line.back() == ',';
        break;
      case Block::Instance:
        m_Text.refuse("has a moved *INSTANCE, which is not supported");
      case Block::Ignored:
        break;
    }
  }

  template <typename T>
  T
  numberOf(std::string_view field, const char * what)
  {
    T value{};
    if (!parseNumber(field, value))
    {
      m_Text.refuse("'" + std::string(field.substr(0, 20)) + "' where " + what + " is expected");
    }
    return value;
  }

  void
  readNode(std::string_view line)
  {
    const auto fields = fieldsOf(line);
    if (fields.size() < 4)
    {
      m_Text.refuse("node '" + std::string(line.substr(0, 30)) + "' has no three coordinates");
    }
    Vector3 position;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      position[static_cast<Eigen::Index>(axis)] = numberOf<double>(fields[axis + 1], "a coordinate");
    }
    m_Cells.addNode(numberOf<HexCellCollector::NodeTag>(fields[0], "a node number"), position);
  }

  /** Element number and eight nodes, on one line or several. */
  void
  readElement(std::string_view line)
  {
    for (const std::string_view field : fieldsOf(line))
    {
      if (!field.empty())
      {
        m_Element.push_back(numberOf<HexCellCollector::NodeTag>(field, "a node number"));
      }
    }
    if (m_Element.size() > 9)
    {
      m_Text.refuse("element " + std::to_string(m_Element[0]) + " has more than 8 nodes");
    }
    if (m_Element.size() == 9)
    {
      std::array<HexCellCollector::NodeTag, 8> tags{};
      std::copy_n(m_Element.begin() + 1, 8, tags.begin());
      m_Cells.addHexahedron(tags);
      m_Element.clear();
    }
  }

  void
  requireCompleteElement() const
  {
    if (!m_Element.empty())
    {
      m_Text.refuse("element " + std::to_string(m_Element[0]) + " has fewer than 8 nodes");
    }
  }

  FileText                               m_Text;
  HexCellCollector                       m_Cells;
  Block                                  m_Block{ Block::Ignored };
  bool                                   m_AnyKeyword{ false };
  bool                                   m_Continued{ false }; ///< the line before ended with a comma
  std::string                            m_Type;               ///< of the elements being read
  std::vector<HexCellCollector::NodeTag> m_Element;            ///< read so far
};

} // namespace

HexCellFile
readAbaqusCells(const std::string & fileName)
{
  return AbaqusReader(fileName).read();
}

} // namespace moserhex
