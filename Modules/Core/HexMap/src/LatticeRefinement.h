#pragma once

#include "moserhex/Common/Types.h"

#include <vector>

namespace moserhex
{

/** Values at the n'^3 nodes of another lattice over the same cube by tensor products of cubic Lagrange polynomials
 * through the four nearest of the n nodes a side (all of them when n < 4). Exact for cubics, error O(h^4).
 *
 * \param nodes  n^3 positions, n >= 2 \param nodesPerSide n' >= 2 */
[[nodiscard]] Positions
interpolateLattice(const Positions & nodes, int nodesPerSide, int finerNodesPerSide);

/** Nodes a side of the lattices from a coarse to a fine one, both included: the fine one halved, to even numbers, until
 * the step to the coarse one is at most a factor of two. */
[[nodiscard]] std::vector<int>
refinementLevels(int coarse, int fine);

} // namespace moserhex
