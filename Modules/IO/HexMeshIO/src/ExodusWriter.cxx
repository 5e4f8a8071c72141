#include "HexMeshFormats.h"
#include "NetcdfFile.h"
#include "moserhex/Geometry/HexMeshNumbering.h"

namespace moserhex
{
namespace
{

using Integers = std::vector<std::int32_t>;

/** Exodus II's side of a hexahedron, from 1, for each of the cube's faces in their order. */
constexpr std::array<std::int32_t, 6> sideOfFace{ 4, 2, 1, 3, 5, 6 };

/** 1 to count. */
Integers
oneTo(std::size_t count)
{
  Integers numbers;
  for (std::size_t number = 1; number <= count; ++number)
  {
    numbers.push_back(static_cast<std::int32_t>(number));
  }
  return numbers;
}

Integers
ones(std::size_t count)
{
  return Integers(count, 1);
}

template <typename TNumbers>
void
appendFromOne(Integers & to, const TNumbers & numbers)
{
  for (const std::size_t number : numbers)
  {
    to.push_back(static_cast<std::int32_t>(number + 1));
  }
}

std::string
numbered(const std::string & name, std::size_t number)
{
  return name + std::to_string(number);
}

struct Field
{
  std::string         name;
  std::vector<double> values;
};

/** Exodus II 5, blocks by shell, node and side sets by face, one time step of fields. No date: the same mesh gives the
 * same bytes. */
class ExodusFile
{
public:
  explicit ExodusFile(const HexMeshContent & content)
    : m_Content(content), m_Mesh(content.mesh), m_Shells(cellsOfShells(content.shell)), m_Faces(cubeFaces(content.mesh))
  {}

  std::string
  write()
  {
    addAttributes();
    addDimensions();
    addNodes();
    addBlocks();
    addNodeSets();
    addSideSets();
    addFields();
    return m_File.bytes();
  }

private:
  void
  addAttributes()
  {
    m_File.addAttribute("api_version", 5.14F);
    m_File.addAttribute("version", 5.14F);
    m_File.addAttribute("floating_point_word_size", std::int32_t{ 8 });
    m_File.addAttribute("file_size", std::int32_t{ 1 });
    m_File.addAttribute("maximum_name_length", std::int32_t{ 32 });
    m_File.addAttribute("int64_status", std::int32_t{ 0 });
    m_File.addAttribute("title", std::string_view("MoserHex hexahedral mesh, LPS millimetres"));
  }

  void
  addDimensions()
  {
    m_NameLength = m_File.addDimension("len_name", 33);
    m_Axes = m_File.addDimension("num_dim", 3);
    m_Nodes = m_File.addDimension("num_nodes", m_Mesh.nodes.size());
    m_Cells = m_File.addDimension("num_elem", m_Mesh.cellCount());
    m_Blocks = m_File.addDimension("num_el_blk", m_Shells.size());
    m_NodeSets = m_File.addDimension("num_node_sets", m_Faces.size());
    m_SideSets = m_File.addDimension("num_side_sets", m_Faces.size());
    m_Time = m_File.addRecordDimension("time_step");
  }

  void
  addNodes()
  {
    const char * const names[] = { "coordx", "coordy", "coordz" };
    for (int axis = 0; axis < 3; ++axis)
    {
      m_File.addVariable(names[axis], { m_Nodes }, component(m_Mesh.nodes, axis));
    }
    m_File.addTexts("coor_names", { m_Axes, m_NameLength }, { "x", "y", "z" });
    m_File.addVariable("node_num_map", { m_Nodes }, oneTo(m_Mesh.nodes.size()));
  }

  /** Status, numbers and names of blocks or sets. */
  void
  addProperties(const std::string & prefix, NetcdfFile::Dimension dimension, const std::vector<std::string> & names)
  {
    m_File.addVariable(prefix + "_status", { dimension }, ones(names.size()));
    m_File.addVariable(prefix + "_prop1", { dimension }, oneTo(names.size()));
    m_File.addVariableAttribute("name", "ID");
    m_File.addTexts(prefix + "_names", { dimension, m_NameLength }, names);
  }

  void
  addBlocks()
  {
    std::vector<std::string> names;
    Integers                 latticeNumbers;
    m_ExodusNumbers.resize(m_Mesh.cellCount());
    for (std::size_t shell = 1; shell <= m_Shells.size(); ++shell)
    {
      const auto & cells = m_Shells[shell - 1];
      names.push_back(shellName(m_Mesh, shell));
      m_CellsOfBlock.push_back(m_File.addDimension(numbered("num_el_in_blk", shell), cells.size()));
      const auto corners = m_File.addDimension(numbered("num_nod_per_el", shell), 8);
      Integers   connectivity;
      for (const std::size_t cell : cells)
      {
        appendFromOne(connectivity, m_Mesh.cellNodes(cell));
        latticeNumbers.push_back(static_cast<std::int32_t>(cell + 1));
        m_ExodusNumbers[cell] = static_cast<std::int32_t>(latticeNumbers.size());
      }
      m_File.addVariable(numbered("connect", shell), { m_CellsOfBlock.back(), corners }, connectivity);
      m_File.addVariableAttribute("elem_type", "HEX8");
    }
    addProperties("eb", m_Blocks, names);
    m_File.addVariable("elem_num_map", { m_Cells }, latticeNumbers);
  }

  [[nodiscard]] std::vector<std::string>
  faceNames() const
  {
    std::vector<std::string> names;
    for (const CubeFace & face : m_Faces)
    {
      names.push_back(face.name);
    }
    return names;
  }

  void
  addNodeSets()
  {
    for (std::size_t face = 1; face <= m_Faces.size(); ++face)
    {
      const auto & nodes = m_Faces[face - 1].nodes;
      const auto   dimension = m_File.addDimension(numbered("num_nod_ns", face), nodes.size());
      Integers     numbers;
      appendFromOne(numbers, nodes);
      m_File.addVariable(numbered("node_ns", face), { dimension }, numbers);
    }
    addProperties("ns", m_NodeSets, faceNames());
  }

  void
  addSideSets()
  {
    for (std::size_t face = 1; face <= m_Faces.size(); ++face)
    {
      const auto & sides = m_Faces[face - 1].sides;
      const auto   dimension = m_File.addDimension(numbered("num_side_ss", face), sides.size());
      Integers     cells;
      for (const CubeFaceSide & side : sides)
      {
        cells.push_back(m_ExodusNumbers[side.cell]);
      }
      m_File.addVariable(numbered("elem_ss", face), { dimension }, cells);
      m_File.addVariable(numbered("side_ss", face), { dimension }, Integers(sides.size(), sideOfFace[face - 1]));
    }
    addProperties("ss", m_SideSets, faceNames());
  }

  [[nodiscard]] static std::vector<double>
  component(const Positions & positions, int axis)
  {
    std::vector<double> values;
    values.reserve(positions.size());
    for (const Vector3 & position : positions)
    {
      values.push_back(position[axis]);
    }
    return values;
  }

  [[nodiscard]] std::vector<Field>
  nodeFields() const
  {
    std::vector<Field> fields{ { "LatticeIndex_X", {} }, { "LatticeIndex_Y", {} }, { "LatticeIndex_Z", {} } };
    for (const NodeIndex & index : nodeIndices(m_Mesh))
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        fields[axis].values.push_back(static_cast<double>(index.lattice[axis]));
      }
    }
    if (m_Mesh.paddingLayers > 0)
    {
      const std::vector<int> layers = paddingLayerOfNodes(m_Mesh);
      fields.push_back({ "PaddingLayer", { layers.begin(), layers.end() } });
    }
    const Positions cube = cubeCoordinates(m_Mesh);
    fields.push_back({ "CubeCoordinate_X", component(cube, 0) });
    fields.push_back({ "CubeCoordinate_Y", component(cube, 1) });
    fields.push_back({ "CubeCoordinate_Z", component(cube, 2) });
    return fields;
  }

  [[nodiscard]] std::vector<Field>
  cellFields() const
  {
    std::vector<Field> fields{ { "Shell", { m_Content.shell.begin(), m_Content.shell.end() } },
                               { "VolumeRatio", m_Content.volumeRatio } };
    if (!m_Content.fields.scaledJacobian.empty())
    {
      fields.push_back({ "ScaledJacobian", m_Content.fields.scaledJacobian });
    }
    if (!m_Content.fields.label.empty())
    {
      fields.push_back({ "Label", { m_Content.fields.label.begin(), m_Content.fields.label.end() } });
    }
    return fields;
  }

  [[nodiscard]] static std::vector<std::string>
  namesOf(const std::vector<Field> & fields)
  {
    std::vector<std::string> names;
    for (const Field & field : fields)
    {
      names.push_back(field.name);
    }
    return names;
  }

  /** Last, because only their variables have a time. */
  void
  addFields()
  {
    const auto onNodes = nodeFields();
    const auto onCells = cellFields();
    const auto nodeCount = m_File.addDimension("num_nod_var", onNodes.size());
    const auto cellCount = m_File.addDimension("num_elem_var", onCells.size());
    m_File.addTexts("name_nod_var", { nodeCount, m_NameLength }, namesOf(onNodes));
    m_File.addTexts("name_elem_var", { cellCount, m_NameLength }, namesOf(onCells));
    m_File.addVariable("elem_var_tab", { m_Blocks, cellCount }, ones(m_Shells.size() * onCells.size()));
    m_File.addVariable("time_whole", { m_Time }, std::vector<double>{ 0.0 });
    for (std::size_t field = 1; field <= onNodes.size(); ++field)
    {
      m_File.addVariable(numbered("vals_nod_var", field), { m_Time, m_Nodes }, onNodes[field - 1].values);
    }
    for (std::size_t field = 1; field <= onCells.size(); ++field)
    {
      for (std::size_t shell = 1; shell <= m_Shells.size(); ++shell)
      {
        std::vector<double> values;
        for (const std::size_t cell : m_Shells[shell - 1])
        {
          values.push_back(onCells[field - 1].values[cell]);
        }
        m_File.addVariable(
          numbered(numbered("vals_elem_var", field) + "eb", shell), { m_Time, m_CellsOfBlock[shell - 1] }, values);
      }
    }
  }

  const HexMeshContent &                m_Content;
  const HexMesh &                       m_Mesh;
  std::vector<std::vector<std::size_t>> m_Shells;
  std::array<CubeFace, 6>               m_Faces;
  NetcdfFile                            m_File;
  NetcdfFile::Dimension                 m_NameLength{};
  NetcdfFile::Dimension                 m_Axes{};
  NetcdfFile::Dimension                 m_Nodes{};
  NetcdfFile::Dimension                 m_Cells{};
  NetcdfFile::Dimension                 m_Blocks{};
  NetcdfFile::Dimension                 m_NodeSets{};
  NetcdfFile::Dimension                 m_SideSets{};
  NetcdfFile::Dimension                 m_Time{};
  std::vector<NetcdfFile::Dimension>    m_CellsOfBlock;
  std::vector<std::int32_t>             m_ExodusNumbers; ///< of the lattice's cells, block by block, from 1
};

} // namespace

std::string
exodusBytes(const HexMeshContent & content)
{
  return ExodusFile(content).write();
}

} // namespace moserhex
