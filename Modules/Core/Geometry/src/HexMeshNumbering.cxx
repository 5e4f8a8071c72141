#include "moserhex/Geometry/HexMeshNumbering.h"

#include <algorithm>

namespace moserhex
{

namespace
{

/** body(i, j, k) for the nodes of the lattice in the order of their numbers, or for those on its boundary alone. */
template <typename TBody>
void
forEachIndex(int n, bool boundaryOnly, TBody body)
{
  const auto isEnd = [n](int index) { return index == 0 || index == n - 1; };
  for (int k = 0; k < n; ++k)
  {
    for (int j = 0; j < n; ++j)
    {
      for (int i = 0; i < n; ++i)
      {
        if (!boundaryOnly || isEnd(i) || isEnd(j) || isEnd(k))
        {
          body(i, j, k);
        }
      }
    }
  }
}

} // namespace

std::vector<NodeIndex>
nodeIndices(const HexMesh & mesh)
{
  std::vector<NodeIndex> indices;
  indices.reserve(mesh.nodes.size());
  for (int layer = 0; layer <= mesh.paddingLayers; ++layer)
  {
    forEachIndex(mesh.nodesPerSide, layer > 0, [&](int i, int j, int k) { indices.push_back({ { i, j, k }, layer }); });
  }
  return indices;
}

Positions
cubeCoordinates(const HexMesh & mesh)
{
  const int last = mesh.nodesPerSide - 1;
  Positions coordinates;
  coordinates.reserve(mesh.nodes.size());
  for (const auto & [at, layer] : nodeIndices(mesh))
  {
    Vector3 place;
    for (Eigen::Index axis = 0; axis < 3; ++axis)
    {
      const int index = at[static_cast<std::size_t>(axis)];
      const int outwards = index == 0 ? -layer : index == last ? layer : 0;
      place[axis] = static_cast<double>(index + outwards) / last;
    }
    coordinates.push_back(place);
  }
  return coordinates;
}

std::vector<int>
shellOfCells(const HexMesh & mesh)
{
  const int        m = mesh.nodesPerSide - 1;
  const int        shells = mesh.nodesPerSide / 2;
  const auto       layers = [m](int index) { return std::min(index, m - 1 - index); };
  std::vector<int> shellOfCell;
  for (int k = 0; k < m; ++k)
  {
    for (int j = 0; j < m; ++j)
    {
      for (int i = 0; i < m; ++i)
      {
        shellOfCell.push_back(shells - std::min({ layers(i), layers(j), layers(k) }));
      }
    }
  }
  for (std::size_t cell = mesh.latticeCellCount(); cell < mesh.cellCount(); ++cell)
  {
    shellOfCell.push_back(shells + pillowCell(mesh, cell).layer);
  }
  return shellOfCell;
}

std::vector<std::size_t>
boundaryNodes(const HexMesh & mesh)
{
  std::vector<std::size_t> nodes;
  forEachIndex(mesh.nodesPerSide, true, [&](int i, int j, int k) {
    nodes.push_back(mesh.paddingNodeNumber(mesh.paddingLayers, i, j, k));
  });
  return nodes;
}

Positions
boundaryPoints(const HexMesh & mesh)
{
  Positions points;
  for (const std::size_t node : boundaryNodes(mesh))
  {
    points.push_back(mesh.nodes[node]);
  }
  return points;
}

std::vector<Quadrilateral>
boundaryQuads(const HexMesh & mesh)
{
  const int                  n = mesh.nodesPerSide;
  std::vector<Quadrilateral> quads;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    for (const int side : { 0, n - 1 })
    {
      const auto node = [&](int a, int b) {
        std::array<int, 3> at{};
        at[axis] = side;
        at[(axis + 1) % 3] = a;
        at[(axis + 2) % 3] = b;
        return mesh.paddingNodeNumber(mesh.paddingLayers, at[0], at[1], at[2]);
      };
      for (int b = 0; b + 1 < n; ++b)
      {
        for (int a = 0; a + 1 < n; ++a)
        {
          quads.push_back({ node(a, b), node(a + 1, b), node(a + 1, b + 1), node(a, b + 1) });
        }
      }
    }
  }
  return quads;
}

} // namespace moserhex
