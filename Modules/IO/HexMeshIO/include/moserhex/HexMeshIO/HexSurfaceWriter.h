#pragma once

#include "moserhex/Geometry/HexMesh.h"

#include <string>

namespace moserhex
{

/** Writes the boundary of a structured mesh as quadrilaterals in legacy .vtk (version 4.2, ASCII, doubles that read
 * back as they are, SPACE=LPS in its second line), complete or not at all.
 *
 * Every node of the boundary once, in the order of the lattice; quadrilaterals are counter-clockwise seen from outside.
 * Cell data: CubeFace 0 to 5 for i = 0, i = n-1, j = 0, j = n-1, k = 0, k = n-1. Point data: LatticeIndex (i,j,k). The
 * same mesh gives the same bytes.
 * \throws InvalidInput  fewer than 2 nodes a side, wrong number of nodes or a coordinate that is not finite
 * \throws BadInput      the name does not end with .vtk
 * \throws IOError       the file cannot be written */
void
writeHexSurface(const std::string & fileName, const HexMesh & mesh);

} // namespace moserhex
