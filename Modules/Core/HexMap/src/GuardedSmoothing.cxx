#include "GuardedSmoothing.h"

#include "LatticeNodes.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace moserhex
{
namespace
{
using lattice::Index3;

/** Place of corner c in its cell, VTK_HEXAHEDRON order. */
constexpr std::array<Index3, 8> cornerPlace{
  { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } }
};
/** Neighbours of corner c within its cell, right-handed. */
constexpr std::array<std::array<std::size_t, 3>, 8> cornerNeighbours{
  { { 1, 3, 4 }, { 2, 0, 5 }, { 3, 1, 6 }, { 0, 2, 7 }, { 7, 5, 0 }, { 4, 6, 1 }, { 5, 7, 2 }, { 6, 4, 3 } }
};
/** Fractions of the full move that are tried in turn. The last one goes away from the mean: it opens a corner that the
 * mean of the neighbours would close further. */
constexpr std::array<double, 3> trialFractions{ 1.0, 0.5, -0.25 };

/** max(0, threshold - scaled Jacobian) at a corner; edges without length count as scaled Jacobian 0. */
double
shortfall(const HexCorners & corners, std::size_t c, double threshold)
{
  const Vector3 a = corners[cornerNeighbours[c][0]] - corners[c];
  const Vector3 b = corners[cornerNeighbours[c][1]] - corners[c];
  const Vector3 d = corners[cornerNeighbours[c][2]] - corners[c];
  const double  determinant = a.dot(b.cross(d));
  const double  squaredLengths = a.squaredNorm() * b.squaredNorm() * d.squaredNorm();
  if (determinant > 0.0 && determinant * determinant >= threshold * threshold * squaredLengths)
  {
    return 0.0; // the common case, without a square root
  }
  const double scaled = squaredLengths > 0.0 ? determinant / std::sqrt(squaredLengths) : 0.0;
  return std::max(0.0, threshold - scaled);
}

/** Sum of max(0, threshold - scaled Jacobian)^2 over the corners that depend on one node, were it at `position`.
 * Stops early, with some number above `limit`, once the sum exceeds it. */
double
badness(const HexMesh & mesh, const Index3 & at, const Vector3 & position, double threshold, double limit)
{
  double sum = 0.0;
  for (std::size_t self = 0; self < 8; ++self)
  {
    const Index3 & place = cornerPlace[self];
    const Index3   cell{ at[0] - place[0], at[1] - place[1], at[2] - place[2] };
    if (!lattice::isInside(mesh.nodesPerSide - 1, cell))
    {
      continue;
    }
    HexCorners corners;
    for (std::size_t c = 0; c < 8; ++c)
    {
      const Index3 & offset = cornerPlace[c];
      corners[c] = c == self
                     ? position
                     : mesh.nodes[mesh.nodeNumber(cell[0] + offset[0], cell[1] + offset[1], cell[2] + offset[2])];
    }
    const auto & neighbours = cornerNeighbours[self];
    for (const std::size_t c : { self, neighbours[0], neighbours[1], neighbours[2] })
    {
      const double missing = shortfall(corners, c, threshold);
      sum += missing * missing;
    }
    if (sum > limit)
    {
      break;
    }
  }
  return sum;
}
} // namespace

void
guardedSweepInPlace(HexMesh & mesh, const SurfaceProjection & projection, const GuardedSmoothingOptions & options)
{
  const int    n = mesh.nodesPerSide;
  const double unlimited = std::numeric_limits<double>::infinity();
  lattice::forEachNode(n, [&](const Index3 & at, std::size_t node) {
    const bool onBoundary = lattice::isBoundary(n, at);
    if (onBoundary && !projection)
    {
      return;
    }
    const Vector3 position = mesh.nodes[node];
    const double  before = badness(mesh, at, position, options.threshold, unlimited);
    if (onBoundary && before == 0.0)
    {
      return;
    }
    const Vector3 move = options.strength * (lattice::neighbourMean(mesh, at) - position);
    for (const double fraction : trialFractions)
    {
      const Vector3 moved = position + fraction * move;
      const Vector3 trial = onBoundary ? projection(moved) : moved;
      if (badness(mesh, at, trial, options.threshold, before) <= before)
      {
        mesh.nodes[node] = trial;
        break;
      }
    }
  });
}

} // namespace moserhex
