#pragma once

#include "moserhex/Analytic/Lattices.h"

#include <cmath>

namespace moserhex
{

/** Where bentLattice puts a point of the unit cube: a bent, tapered bar of some 40 mm, det J > 0. */
inline Vector3
bent(const Vector3 & c)
{
  const double angle = 1.5 * c[0];
  const double radius = 30.0 + 12.0 * c[1] * (1.0 - 0.3 * c[0]) + 2.0 * std::sin(2.0 * c[2]);
  return { -20.0 + radius * std::sin(angle),
           5.0 + radius * std::cos(angle),
           100.0 + 15.0 * c[2] * (1.0 - 0.2 * c[1]) + 1.5 * std::sin(3.0 * c[0]) };
}

inline HexMesh
bentLattice(int n)
{
  return analytic::lattice(n, [n](const Vector3 & index) { return bent(index / (n - 1)); });
}

/** A cell whose four lower edges are nearly in line at one corner, as on a cube's edge on a smooth surface. */
inline HexMesh
flatCornerCell()
{
  HexMesh mesh = analytic::cubeLattice(2);
  mesh.nodes[3] = { 0.505, 0.505, 0.0 }; // (1,1,0): straight for 0.5
  return mesh;
}

} // namespace moserhex
