#pragma once

#include "moserhex/Analytic/Lattices.h"
#include "moserhex/HexMeshIO/HexMeshWriter.h"

#include <cmath>

namespace moserhex
{

/** A smooth, uneven lattice far from the origin, with coordinates that need all their digits. */
inline HexMesh
bentLattice(int n)
{
  HexMesh mesh;
  mesh.nodesPerSide = n;
  for (int node = 0; node < n * n * n; ++node)
  {
    const int i = node % n;
    const int j = node / n % n;
    const int k = node / (n * n);
    mesh.nodes.emplace_back(
      i + 0.1 * std::sin(j), j - 100.0 / 3.0 + 0.1 * std::cos(k), 1e-5 * std::exp(i) + 1.2 * k + 0.1 * std::sin(i));
  }
  return mesh;
}

/** The same with layers of padding. */
inline HexMesh
bentPaddedLattice(int n, int layers)
{
  return analytic::paddedLattice(n, layers, [](const Vector3 & index) {
    const double i = index[0];
    const double j = index[1];
    const double k = index[2];
    return Vector3(
      i + 0.1 * std::sin(j), j - 100.0 / 3.0 + 0.1 * std::cos(k), 1e-5 * std::exp(i) + 1.2 * k + 0.1 * std::sin(i));
  });
}

/** A value of its own for each cell or node. */
inline HexMeshFields
someFields(const HexMesh & mesh)
{
  HexMeshFields fields;
  for (std::size_t cell = 0; cell < mesh.cellCount(); ++cell)
  {
    fields.scaledJacobian.push_back(1.0 / static_cast<double>(cell + 3));
    fields.label.push_back(static_cast<std::int32_t>(cell % 5));
  }
  return fields;
}

} // namespace moserhex
