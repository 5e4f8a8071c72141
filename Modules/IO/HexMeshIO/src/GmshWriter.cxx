#include "HexMeshFormats.h"
#include "MeshText.h"
#include "moserhex/Geometry/HexMeshNumbering.h"

#include <limits>

namespace moserhex
{
namespace
{

constexpr int quadrilateralType = 3;
constexpr int hexahedronType = 5;

/** MSH 4.1 and 2.2, ASCII. Entity = physical group: surfaces 1 to 6 are the cube's faces, volumes 1 to N the shells.
 *
 * Hexahedron c is element c + 1; the faces' quadrilaterals follow. They carry the data of the cell they belong to:
 * some readers take $ElementData to be as long as the list of elements. */
class GmshText
{
public:
  GmshText(const HexMeshContent & content, GmshVersion version)
    : m_Content(content)
    , m_Mesh(content.mesh)
    , m_Shells(cellsOfShells(content.shell))
    , m_Faces(cubeFaces(content.mesh))
    , m_Version4(version == GmshVersion::Msh41)
  {
    listElements();
  }

  std::string
  write()
  {
    m_Text << "$MeshFormat\n" << (m_Version4 ? "4.1" : "2.2") << " 0 8\n$EndMeshFormat\n";
    writePhysicalNames();
    if (m_Version4)
    {
      writeEntities();
      writeNodes4();
      writeElements4();
    }
    else
    {
      writeNodes2();
      writeElements2();
    }
    writeData();
    return m_Text.take();
  }

private:
  /** An element's number in the file and the cell its data come from. */
  struct Element
  {
    std::size_t number;
    std::size_t cell;
  };

  /** In the order of the file: MSH 4.1 has one block for each entity. */
  void
  listElements()
  {
    if (m_Version4)
    {
      for (const auto & shell : m_Shells)
      {
        for (const std::size_t cell : shell)
        {
          m_Elements.push_back({ cell + 1, cell });
        }
      }
    }
    else
    {
      for (std::size_t cell = 0; cell < m_Mesh.cellCount(); ++cell)
      {
        m_Elements.push_back({ cell + 1, cell });
      }
    }
    for (const CubeFace & face : m_Faces)
    {
      for (const CubeFaceSide & side : face.sides)
      {
        m_Elements.push_back({ m_Elements.size() + 1, side.cell });
      }
    }
  }

  void
  writePhysicalNames()
  {
    m_Text << "$PhysicalNames\n" << m_Faces.size() + m_Shells.size() << '\n';
    for (std::size_t face = 0; face < m_Faces.size(); ++face)
    {
      m_Text << "2 " << face + 1 << " \"" << m_Faces[face].name << "\"\n";
    }
    for (std::size_t shell = 1; shell <= m_Shells.size(); ++shell)
    {
      m_Text << "3 " << shell << " \"" << shellName(m_Mesh, shell) << "\"\n";
    }
    m_Text << "$EndPhysicalNames\n";
  }

  /** Number, box, its physical group, no bounding entities. */
  template <typename TNodes>
  void
  writeEntity(std::size_t number, const TNodes & nodes)
  {
    Vector3 low = Vector3::Constant(std::numeric_limits<double>::infinity());
    Vector3 high = -low;
    for (const std::size_t node : nodes)
    {
      low = low.cwiseMin(m_Mesh.nodes[node]);
      high = high.cwiseMax(m_Mesh.nodes[node]);
    }
    m_Text << number << ' ';
    m_Text.position(low, " ") << ' ';
    m_Text.position(high, " ") << " 1 " << number << " 0\n";
  }

  void
  writeEntities()
  {
    m_Text << "$Entities\n0 0 " << m_Faces.size() << ' ' << m_Shells.size() << '\n';
    for (std::size_t face = 0; face < m_Faces.size(); ++face)
    {
      writeEntity(face + 1, m_Faces[face].nodes);
    }
    for (std::size_t shell = 1; shell <= m_Shells.size(); ++shell)
    {
      std::vector<std::size_t> nodes;
      for (const std::size_t cell : m_Shells[shell - 1])
      {
        const auto corners = m_Mesh.cellNodes(cell);
        nodes.insert(nodes.end(), corners.begin(), corners.end());
      }
      writeEntity(shell, nodes);
    }
    m_Text << "$EndEntities\n";
  }

  /** All nodes in one block, of the outermost shell, so that they keep their order. */
  void
  writeNodes4()
  {
    const std::size_t count = m_Mesh.nodes.size();
    m_Text << "$Nodes\n1 " << count << " 1 " << count << "\n3 " << m_Shells.size() << " 0 " << count << '\n';
    for (std::size_t node = 1; node <= count; ++node)
    {
      m_Text << node << '\n';
    }
    for (const Vector3 & node : m_Mesh.nodes)
    {
      m_Text.position(node, " ") << '\n';
    }
    m_Text << "$EndNodes\n";
  }

  void
  writeElements4()
  {
    const std::size_t count = m_Elements.size();
    m_Text << "$Elements\n" << m_Shells.size() + m_Faces.size() << ' ' << count << " 1 " << count << '\n';
    for (std::size_t shell = 1; shell <= m_Shells.size(); ++shell)
    {
      m_Text << "3 " << shell << ' ' << hexahedronType << ' ' << m_Shells[shell - 1].size() << '\n';
      for (const std::size_t cell : m_Shells[shell - 1])
      {
        m_Text << cell + 1 << ' ';
        m_Text.list(fromOne(m_Mesh.cellNodes(cell)), " ") << '\n';
      }
    }
    std::size_t number = m_Mesh.cellCount();
    for (std::size_t face = 0; face < m_Faces.size(); ++face)
    {
      m_Text << "2 " << face + 1 << ' ' << quadrilateralType << ' ' << m_Faces[face].sides.size() << '\n';
      for (const CubeFaceSide & side : m_Faces[face].sides)
      {
        m_Text << ++number << ' ';
        m_Text.list(fromOne(side.nodes), " ") << '\n';
      }
    }
    m_Text << "$EndElements\n";
  }

  void
  writeNodes2()
  {
    m_Text << "$Nodes\n" << m_Mesh.nodes.size() << '\n';
    for (std::size_t node = 0; node < m_Mesh.nodes.size(); ++node)
    {
      m_Text << node + 1 << ' ';
      m_Text.position(m_Mesh.nodes[node], " ") << '\n';
    }
    m_Text << "$EndNodes\n";
  }

  void
  writeElements2()
  {
    m_Text << "$Elements\n" << m_Elements.size() << '\n';
    for (std::size_t cell = 0; cell < m_Mesh.cellCount(); ++cell)
    {
      const int shell = m_Content.shell[cell];
      m_Text << cell + 1 << ' ' << hexahedronType << " 2 " << shell << ' ' << shell << ' ';
      m_Text.list(fromOne(m_Mesh.cellNodes(cell)), " ") << '\n';
    }
    std::size_t number = m_Mesh.cellCount();
    for (std::size_t face = 1; face <= m_Faces.size(); ++face)
    {
      for (const CubeFaceSide & side : m_Faces[face - 1].sides)
      {
        m_Text << ++number << ' ' << quadrilateralType << " 2 " << face << ' ' << face << ' ';
        m_Text.list(fromOne(side.nodes), " ") << '\n';
      }
    }
    m_Text << "$EndElements\n";
  }

  /** One string tag, one real tag (time 0), three integers: step 0, components, entries. */
  void
  beginData(std::string_view section, std::string_view name, int components, std::size_t count)
  {
    m_Text << '$' << section << "\n1\n\"" << name << "\"\n1\n0\n3\n0\n" << components << '\n' << count << '\n';
  }

  template <typename TValues>
  void
  writeCellData(std::string_view name, const TValues & values)
  {
    if (values.empty())
    {
      return;
    }
    beginData("ElementData", name, 1, m_Elements.size());
    for (const Element & element : m_Elements)
    {
      m_Text << element.number << ' ' << values[element.cell] << '\n';
    }
    m_Text << "$EndElementData\n";
  }

  void
  writeData()
  {
    beginData("NodeData", "LatticeIndex", 3, m_Mesh.nodes.size());
    const std::vector<NodeIndex> indices = nodeIndices(m_Mesh);
    for (std::size_t node = 0; node < indices.size(); ++node)
    {
      const auto & at = indices[node].lattice;
      m_Text << node + 1 << ' ' << at[0] << ' ' << at[1] << ' ' << at[2] << '\n';
    }
    m_Text << "$EndNodeData\n";
    if (m_Mesh.paddingLayers > 0)
    {
      beginData("NodeData", "PaddingLayer", 1, indices.size());
      for (std::size_t node = 0; node < indices.size(); ++node)
      {
        m_Text << node + 1 << ' ' << indices[node].layer << '\n';
      }
      m_Text << "$EndNodeData\n";
    }
    const Positions cube = cubeCoordinates(m_Mesh);
    beginData("NodeData", "CubeCoordinate", 3, cube.size());
    for (std::size_t node = 0; node < cube.size(); ++node)
    {
      m_Text << node + 1 << ' ';
      m_Text.position(cube[node], " ") << '\n';
    }
    m_Text << "$EndNodeData\n";
    writeCellData("Shell", m_Content.shell);
    writeCellData("VolumeRatio", m_Content.volumeRatio);
    writeCellData("ScaledJacobian", m_Content.fields.scaledJacobian);
    writeCellData("Label", m_Content.fields.label);
  }

  const HexMeshContent &                m_Content;
  const HexMesh &                       m_Mesh;
  std::vector<std::vector<std::size_t>> m_Shells;
  std::array<CubeFace, 6>               m_Faces;
  bool                                  m_Version4;
  std::vector<Element>                  m_Elements;
  MeshText                              m_Text;
};

} // namespace

std::string
gmshText(const HexMeshContent & content, GmshVersion version)
{
  return GmshText(content, version).write();
}

} // namespace moserhex
