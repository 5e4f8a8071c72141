#include "SeedParts.h"
#include "moserhex/Analytic/Lattices.h"
#include "moserhex/Geometry/UnstructuredHexMesh.h"
#include "moserhex/HexMeshIO/HexMeshWriter.h"

#include <sstream>

namespace moserhex::fuzz
{
namespace
{

/** For every node `before` its number from 1, its position and `after`. */
std::string
nodeRows(const UnstructuredHexMesh & mesh, bool numbered, const char * separator, const char * after)
{
  std::ostringstream text;
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
  {
    const Vector3 & p = mesh.nodes[node];
    if (numbered)
    {
      text << node + 1 << separator;
    }
    text << p.x() << separator << p.y() << separator << p.z() << after << '\n';
  }
  return text.str();
}

/** For every cell its number and `before`, its corners from 1, and `after`. */
std::string
cellRows(const UnstructuredHexMesh & mesh,
         bool                        numbered,
         const std::string &         before,
         const char *                separator,
         const char *                after)
{
  std::ostringstream text;
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
  {
    if (numbered)
    {
      text << cell + 1 << before;
    }
    for (std::size_t corner = 0; corner < 8; ++corner)
    {
      text << (corner > 0 ? separator : "") << mesh.cells[cell][corner] + 1;
    }
    text << after << '\n';
  }
  return text.str();
}

std::string
gmshText(const UnstructuredHexMesh & mesh)
{
  return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" + std::to_string(mesh.nodes.size()) + "\n" +
         nodeRows(mesh, true, " ", "") + "$EndNodes\n$Elements\n" + std::to_string(mesh.cells.size()) + "\n" +
         cellRows(mesh, true, " 5 2 0 0 ", " ", "") + "$EndElements\n";
}

template <typename T>
void
append(std::string & bytes, T value)
{
  bytes.append(reinterpret_cast<const char *>(&value), sizeof value);
}

std::string
gmshBinary(const UnstructuredHexMesh & mesh)
{
  std::string bytes = "$MeshFormat\n2.2 1 8\n";
  append(bytes, std::int32_t{ 1 });
  bytes += "\n$EndMeshFormat\n$Nodes\n" + std::to_string(mesh.nodes.size()) + "\n";
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
  {
    append(bytes, static_cast<std::int32_t>(node + 1));
    for (int axis = 0; axis < 3; ++axis)
    {
      append(bytes, mesh.nodes[node][axis]);
    }
  }
  bytes += "\n$EndNodes\n$Elements\n" + std::to_string(mesh.cells.size()) + "\n";
  append(bytes, std::int32_t{ 5 });
  append(bytes, static_cast<std::int32_t>(mesh.cells.size()));
  append(bytes, std::int32_t{ 2 });
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
  {
    append(bytes, static_cast<std::int32_t>(cell + 1));
    append(bytes, std::int32_t{ 0 });
    append(bytes, std::int32_t{ 0 });
    for (const std::size_t node : mesh.cells[cell])
    {
      append(bytes, static_cast<std::int32_t>(node + 1));
    }
  }
  return bytes + "\n$EndElements\n";
}

/** Version 4.1: the numbers of all nodes of a block, then their positions. */
std::string
gmshBlocks(const UnstructuredHexMesh & mesh)
{
  const std::string nodes = std::to_string(mesh.nodes.size());
  const std::string cells = std::to_string(mesh.cells.size());
  std::string       text =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 " + nodes + " 1 " + nodes + "\n3 1 0 " + nodes + "\n";
  for (std::size_t node = 1; node <= mesh.nodes.size(); ++node)
  {
    text += std::to_string(node) + "\n";
  }
  return text + nodeRows(mesh, false, " ", "") + "$EndNodes\n$Elements\n1 " + cells + " 1 " + cells + "\n3 1 5 " +
         cells + "\n" + cellRows(mesh, true, " ", " ", "") + "$EndElements\n";
}

std::string
medit(const UnstructuredHexMesh & mesh)
{
  return "MeshVersionFormatted 2\nDimension\n3\nVertices\n" + std::to_string(mesh.nodes.size()) + "\n" +
         nodeRows(mesh, false, " ", " 1") + "Hexahedra\n" + std::to_string(mesh.cells.size()) + "\n" +
         cellRows(mesh, false, "", " ", " 1") + "End\n";
}

std::string
abaqus(const UnstructuredHexMesh & mesh)
{
  return "*HEADING\nseed\n*NODE, NSET=ALL\n" + nodeRows(mesh, true, ", ", "") + "*ELEMENT, TYPE=C3D8, ELSET=E1\n" +
         cellRows(mesh, true, ", ", ", ", "") + "*END STEP\n";
}

} // namespace

void
addMeshes(std::vector<Seed> & seeds)
{
  const HexMesh             lattice = analytic::cubeLattice(4, 5.0);
  const UnstructuredHexMesh mesh = unstructured(lattice);
  const auto                add = [&seeds](const char * format, SeedFile file) {
    seeds.push_back({ SeedUse::Hexahedra, format, std::move(file), {} });
  };
  const ScratchFolder folder;
  writeHexMesh(folder / "mesh.vtu", lattice);
  writeHexMesh(folder / "mesh.vtk", lattice);
  add("mesh-vtu", folder.take("mesh.vtu"));
  add("mesh-vtk", folder.take("mesh.vtk"));
  add("gmsh-text", { "text.msh", gmshText(mesh) });
  add("gmsh-binary", { "binary.msh", gmshBinary(mesh) });
  add("gmsh-4.1", { "blocks.msh", gmshBlocks(mesh) });
  add("medit", { "mesh.mesh", medit(mesh) });
  add("abaqus", { "mesh.inp", abaqus(mesh) });
}

} // namespace moserhex::fuzz
