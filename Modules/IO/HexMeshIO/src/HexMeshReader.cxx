#include "moserhex/HexMeshIO/HexMeshReader.h"

#include <utility>

namespace moserhex
{

HexMesh
latticeOf(const UnstructuredHexMesh & mesh, const std::string & fileName)
{
  auto lattice = asLattice(mesh);
  if (!lattice)
  {
    throw BadInput(ErrorCode::NotHexahedra,
                   fileName,
                   std::to_string(mesh.nodes.size()) + " nodes and " + std::to_string(mesh.cells.size()) +
                     " cells that do not connect as a lattice of n^3 and (n-1)^3 does",
                   "give a mesh written by moserhex");
  }
  return *std::move(lattice);
}

HexMeshFile
readHexMeshFile(const std::string & fileName, const ReadOptions & options)
{
  if (!isHexCellName(fileName))
  {
    throw BadInput(ErrorCode::Usage, fileName, "not a mesh file's name", "give a .vtu, .vtk, .msh, .mesh or .inp file");
  }
  HexCellFile file = readHexCells(fileName, options);
  return { latticeOf(file.mesh, fileName), std::move(file.meshArrays) };
}

HexMesh
readHexMesh(const std::string & fileName, const ReadOptions & options)
{
  return readHexMeshFile(fileName, options).mesh;
}

} // namespace moserhex
