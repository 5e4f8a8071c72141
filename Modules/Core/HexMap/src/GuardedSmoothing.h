#pragma once

#include "moserhex/HexMap/LatticeSmoothing.h"

namespace moserhex
{

/** Step 4 of smoothLattice, one sweep. An empty projection holds the boundary. */
void
guardedSweepInPlace(HexMesh & mesh, const SurfaceProjection & projection, const GuardedSmoothingOptions & options);

} // namespace moserhex
