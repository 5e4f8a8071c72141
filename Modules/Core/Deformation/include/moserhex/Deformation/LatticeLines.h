#pragma once

#include "moserhex/Geometry/HexMesh.h"

namespace moserhex
{

/** Thickness of the organ along the lattice, at every node: entry a of node (i,j,k) is the length of the lattice line
 * along axis a through it, from one face of the cube through the organ to the opposite one, the sum of its n-1 edges.
 * Not a number where that line runs along the organ's surface and not through it: of a node on a face of the cube along
 * the two axes in the face.
 *
 * Chords of a smooth line are shorter than it by O(h^2). \return n^3 x 3 [mm] \throws InvalidInput  as requireLattice
 */
[[nodiscard]] Positions
latticeLineLengths(const HexMesh & mesh);

} // namespace moserhex
