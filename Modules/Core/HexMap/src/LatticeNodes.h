#pragma once

#include "moserhex/Geometry/HexMesh.h"

#include <array>

namespace moserhex::lattice
{

using Index3 = std::array<int, 3>;

/** Steps to the six neighbours of a node. */
inline constexpr std::array<Index3, 6> neighbourSteps{
  { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } }
};

inline bool
isExtreme(int nodesPerSide, int index)
{
  return index == 0 || index == nodesPerSide - 1;
}

inline bool
isBoundary(int nodesPerSide, const Index3 & at)
{
  return isExtreme(nodesPerSide, at[0]) || isExtreme(nodesPerSide, at[1]) || isExtreme(nodesPerSide, at[2]);
}

inline bool
isInside(int nodesPerSide, const Index3 & at)
{
  return at[0] >= 0 && at[1] >= 0 && at[2] >= 0 && at[0] < nodesPerSide && at[1] < nodesPerSide && at[2] < nodesPerSide;
}

inline std::size_t
number(const HexMesh & mesh, const Index3 & at)
{
  return mesh.nodeNumber(at[0], at[1], at[2]);
}

/** body(Index3, node number) over all nodes in increasing number. */
template <typename TBody>
void
forEachNode(int nodesPerSide, TBody body)
{
  std::size_t node = 0;
  for (int k = 0; k < nodesPerSide; ++k)
  {
    for (int j = 0; j < nodesPerSide; ++j)
    {
      for (int i = 0; i < nodesPerSide; ++i)
      {
        body(Index3{ i, j, k }, node++);
      }
    }
  }
}

/** Mean of the neighbours of a node; of those on the boundary when the node itself is there. */
inline Vector3
neighbourMean(const HexMesh & mesh, const Index3 & at)
{
  const int  n = mesh.nodesPerSide;
  const bool onBoundary = isBoundary(n, at);
  Vector3    sum = Vector3::Zero();
  int        count = 0;
  for (const Index3 & step : neighbourSteps)
  {
    const Index3 neighbour{ at[0] + step[0], at[1] + step[1], at[2] + step[2] };
    if (isInside(n, neighbour) && (!onBoundary || isBoundary(n, neighbour)))
    {
      sum += mesh.nodes[number(mesh, neighbour)];
      ++count;
    }
  }
  return sum / count;
}

} // namespace moserhex::lattice
