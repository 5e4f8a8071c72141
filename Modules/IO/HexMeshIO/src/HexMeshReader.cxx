#include "moserhex/HexMeshIO/HexMeshReader.h"

#include "FileNames.h"
#include "moserhex/HexMeshIO/HexCellReader.h"

namespace moserhex
{

HexMesh
readHexMesh(const std::string & fileName, const ReadOptions & options)
{
  if (!endsWithAny(fileName, { ".vtu", ".vtk" }))
  {
    throw BadInput(ErrorCode::Usage, fileName, "not a mesh file's name", "give a .vtu or .vtk file");
  }
  const HexCellFile file = readHexCells(fileName, options);
  auto              mesh = asLattice(file.mesh);
  if (!mesh)
  {
    throw BadInput(ErrorCode::NotHexahedra,
                   fileName,
                   std::to_string(file.mesh.nodes.size()) + " nodes and " + std::to_string(file.mesh.cells.size()) +
                     " cells that do not connect as a lattice of n^3 and (n-1)^3 does",
                   "give a mesh written by moserhex");
  }
  return *std::move(mesh);
}

} // namespace moserhex
