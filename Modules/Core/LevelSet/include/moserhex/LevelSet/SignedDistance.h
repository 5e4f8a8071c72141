#pragma once

#include "moserhex/LevelSet/LabelVolume.h"
#include "moserhex/LevelSet/LevelSet.h"

#include <array>
#include <vector>

namespace moserhex
{

/** Exact Euclidean distance between voxel centres, measured along the chosen axes only, signed and moved to the faces:
 *
 *   +(distance to the nearest inside centre  - s/2)   outside the label
 *   -(distance to the nearest outside centre - s/2)   inside the label          s = smallest spacing of the axes [mm]
 *
 * With two axes every slice is a problem of its own. A voxel with nothing of the other kind in reach (in its slice or
 * row) gets +infinity outside and -infinity inside. Lower envelopes of parabolas (Felzenszwalb and Huttenlocher 2012),
 * O(voxels) per axis, anisotropic spacing included. Threads 0: all; the result does not depend on them.
 * \throws InvalidInput  invalid or empty label, or no axis chosen */
[[nodiscard]] std::vector<double>
voxelSignedDistance(const LabelVolume & label, const std::array<bool, 3> & axes, unsigned int threads = 0);

/** Signed distance to the surface f = 0 [mm] with the sign of f at every node (0 counts as outside).
 *
 * Nodes with a neighbour on the other side get their nearest point on the zero surface of the Catmull-Rom
 * interpolant (Newton and tangential steps, Chopp 2001; the plane through the crossings of the grid edges where these
 * do not settle). Two scans hand nearest points on to the nodes around (Danielsson 1980, 26 neighbours); those within
 * four spacings then find their own, and more scans carry these on to all other nodes. O(h^2) or better near a smooth
 * surface; beyond four spacings the error is about 0.1 h. O(n), deterministic for any number of threads (0: all).
 *
 * \throws InvalidInput  invalid level set, a value that is not finite, or no node inside or outside */
[[nodiscard]] LevelSet
redistance(const LevelSet & f, unsigned int threads = 0);

} // namespace moserhex
