#pragma once

#include "moserhex/HexMap/LatticeSmoothing.h"

namespace moserhex
{

/** Step 1 of smoothLattice, once. The projection must not be empty. */
void
slideCubeEdgesInPlace(HexMesh & mesh, const SurfaceProjection & projection, const EdgeSlidingOptions & options);

} // namespace moserhex
