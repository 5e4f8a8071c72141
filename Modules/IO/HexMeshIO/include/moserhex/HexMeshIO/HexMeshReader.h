#pragma once

#include "moserhex/Geometry/HexMesh.h"
#include "moserhex/HexMeshIO/FileErrors.h"
#include "moserhex/HexMeshIO/ReadOptions.h"

#include <string>

namespace moserhex
{

/** Reads a lattice mesh written by writeHexMesh (.vtu or .vtk).
 *
 * \throws BadInput  missing or damaged file, not n^3 nodes and (n-1)^3 hexahedra, another connectivity than the
 *                   lattice's, or a coordinate that is not finite; the child process that read it died
 * \throws IOError   the file cannot be opened or read */
[[nodiscard]] HexMesh
readHexMesh(const std::string & fileName, const ReadOptions & options = {});

} // namespace moserhex
