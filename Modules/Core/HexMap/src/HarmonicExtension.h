#pragma once

#include "moserhex/Geometry/HexMesh.h"

namespace moserhex
{

/** One implicit diffusion step of the interior nodes with the boundary nodes held; see smoothLattice.
 * `values.nodes` may hold any vector field on the lattice. tau > 0; infinity gives the harmonic extension. */
void
diffuseInteriorInPlace(HexMesh & values, double tau);

/** Replaces the values inside each of the six faces of the cube by the harmonic extension of those on its edges. */
void
extendOverFacesInPlace(HexMesh & values);

} // namespace moserhex
