#pragma once

#include "moserhex/Analytic/Lattices.h"
#include "moserhex/Common/Random.h"
#include "moserhex/Geometry/HexMesh.h"

namespace moserhex
{

inline HexCorners
unitCube()
{
  return { Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(1, 1, 0), Vector3(0, 1, 0),
           Vector3(0, 0, 1), Vector3(1, 0, 1), Vector3(1, 1, 1), Vector3(0, 1, 1) };
}

/** Unit cells, every node moved by up to `amplitude` in every coordinate. */
inline HexMesh
perturbedLattice(int n, double amplitude, std::uint64_t seed)
{
  Random random(seed);
  return analytic::lattice(n, [&](const Vector3 & index) {
    const Vector3 shift(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    return Vector3(index + amplitude * shift);
  });
}

} // namespace moserhex
