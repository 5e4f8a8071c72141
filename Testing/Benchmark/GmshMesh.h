#pragma once

#include "moserhex/Geometry/TriangleMesh.h"
#include "moserhex/Geometry/UnstructuredHexMesh.h"

namespace moserhex::results
{

/** Whether a `gmsh` executable is in the PATH. */
[[nodiscard]] bool
hasGmsh();

struct GmshMesh
{
  UnstructuredHexMesh mesh;
  double              seconds{ 0.0 }; ///< of the process, reading and writing included
};

/** Hexahedra that gmsh, as a process of its own, makes inside a closed surface: the surface is given as STL and
 * remeshed, filled with tetrahedra of about cells / 4, and each of these is cut into four hexahedra
 * (Mesh.SubdivisionAlgorithm = 2), new boundary nodes left on the triangles (Mesh.SecondOrderLinear = 1): moved onto
 * the surface they turn some cells over. \throws std::runtime_error  gmsh failed \throws BadInput  as readHexCells */
[[nodiscard]] GmshMesh
gmshHexahedra(const TriangleMesh & surface, double volume, double cells);

} // namespace moserhex::results
