#pragma once

#include "moserhex/Analytic/Lattices.h"

#include <cmath>

namespace moserhex
{

/** A smooth, uneven lattice on some 10 mm, det J > 0. */
inline HexMesh
unevenLattice(int n)
{
  return analytic::lattice(n, [n](const Vector3 & index) {
    const Vector3 c = index / (n - 1);
    return Vector3(10.0 * c[0] + 0.7 * std::sin(3.0 * c[1]),
                   9.0 * c[1] - 0.8 * c[0] * c[2] + 40.0,
                   8.0 * c[2] + 0.5 * std::cos(4.0 * c[0]));
  });
}

/** A mesh whose nodes are those of another, each moved by a map of space. */
template <typename TMap>
[[nodiscard]] HexMesh
mapped(const HexMesh & mesh, const TMap & map)
{
  HexMesh result = mesh;
  for (Vector3 & node : result.nodes)
  {
    node = map(node);
  }
  return result;
}

/** A box about the origin with equal cells. */
inline HexMesh
boxLattice(int n, const Vector3 & size)
{
  return analytic::lattice(
    n, [&](const Vector3 & index) { return Vector3((index / (n - 1)).cwiseProduct(size) - 0.5 * size); });
}

/** A ball about the origin: the cube's shells become spheres, each cell is as thick as the others. */
inline HexMesh
ballLattice(int n, double radius)
{
  return mapped(boxLattice(n, Vector3::Constant(2.0 * radius)), [](const Vector3 & x) {
    const double length = x.norm();
    return length > 0.0 ? Vector3(x * (x.cwiseAbs().maxCoeff() / length)) : x;
  });
}

} // namespace moserhex
