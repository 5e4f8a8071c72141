#pragma once

#include "moserhex/Geometry/HexMesh.h"
#include "moserhex/HexMeshIO/HexCellReader.h"

#include <string>
#include <vector>

namespace moserhex
{

/** The lattice that a mesh is, numbered and connected as in HexMesh.
 *
 * \param fileName  named in the message
 * \throws BadInput  not n^3 nodes and (n-1)^3 hexahedra, or another connectivity than the lattice's (NotHexahedra) */
[[nodiscard]] HexMesh
latticeOf(const UnstructuredHexMesh & mesh, const std::string & fileName);

/** A lattice mesh and what its file says of it. */
struct HexMeshFile
{
  HexMesh                 mesh;       ///< LPS [mm]
  std::vector<NamedArray> meshArrays; ///< as HexCellFile::meshArrays
};

/** Reads a lattice mesh with what stands in its file once for the mesh. \throws as readHexMesh */
[[nodiscard]] HexMeshFile
readHexMeshFile(const std::string & fileName, const ReadOptions & options = {});

/** Reads a lattice mesh written by writeHexMesh, or another tool's in the same order (.vtu .vtk .msh .mesh .inp).
 *
 * \throws BadInput  as readHexCells and latticeOf
 * \throws IOError   the file cannot be opened or read */
[[nodiscard]] HexMesh
readHexMesh(const std::string & fileName, const ReadOptions & options = {});

} // namespace moserhex
