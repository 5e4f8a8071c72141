#pragma once

#include "moserhex/Geometry/HexMesh.h"

namespace moserhex::analytic
{

/** Lattice of n nodes a side whose node (i,j,k) lies at place(Vector3(i,j,k)); called in the order of the nodes. */
template <typename TPlace>
[[nodiscard]] HexMesh
lattice(int n, const TPlace & place)
{
  HexMesh mesh{ n, {} };
  for (int k = 0; k < n; ++k)
  {
    for (int j = 0; j < n; ++j)
    {
      for (int i = 0; i < n; ++i)
      {
        mesh.nodes.push_back(place(Vector3(i, j, k)));
      }
    }
  }
  return mesh;
}

/** With so many layers of padding, each step of a layer leading outwards along every axis at whose end the node is. */
template <typename TPlace>
[[nodiscard]] HexMesh
paddedLattice(int n, int layers, const TPlace & place)
{
  HexMesh mesh = lattice(n, place);
  mesh.paddingLayers = layers;
  for (int layer = 1; layer <= layers; ++layer)
  {
    (void)lattice(n, [&](const Vector3 & index) {
      const auto    outwards = [n](double at) { return at == 0.0 ? -1.0 : at == n - 1 ? 1.0 : 0.0; };
      const Vector3 step(outwards(index[0]), outwards(index[1]), outwards(index[2]));
      if (!step.isZero())
      {
        mesh.nodes.push_back(place(Vector3(index + layer * step)));
      }
      return index;
    });
  }
  return mesh;
}

/** Cells are cubes of this edge, the first node is the origin. */
[[nodiscard]] inline HexMesh
cubeLattice(int n, double edge = 1.0)
{
  return lattice(n, [edge](const Vector3 & index) { return Vector3(edge * index); });
}

} // namespace moserhex::analytic
