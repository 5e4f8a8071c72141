#include "moserhex/LevelSet/MarchingTetrahedra.h"

#include "KuhnTetrahedra.h"
#include "moserhex/Common/Errors.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>

namespace moserhex
{
namespace
{

constexpr double edgeMargin = 1e-4;

/** An edge of a cube as its two corners (three bits each), the smaller set of bits first. */
struct CubeEdge
{
  unsigned int from;
  unsigned int to;
};
using CubeTriangle = std::array<CubeEdge, 3>;

CubeEdge
cubeEdge(unsigned int a, unsigned int b)
{
  return a < b ? CubeEdge{ a, b } : CubeEdge{ b, a };
}

/** Outward triangles of one tetrahedron for one set of inside corners, right-handed grid. */
std::vector<CubeTriangle>
tetrahedronTriangles(const std::array<unsigned int, 4> & path, bool positivePath, unsigned int insideSet)
{
  std::array<unsigned int, 4> order{}; // inside corners first
  unsigned int                insideCount = 0;
  for (unsigned int q = 0; q < 4; ++q)
  {
    insideCount += insideSet >> q & 1u;
  }
  unsigned int nextInside = 0;
  unsigned int nextOutside = insideCount;
  for (unsigned int q = 0; q < 4; ++q)
  {
    order[(insideSet >> q & 1u) != 0 ? nextInside++ : nextOutside++] = q;
  }
  bool flip = !positivePath;
  for (unsigned int a = 0; a < 4; ++a)
  {
    for (unsigned int b = a + 1; b < 4; ++b)
    {
      flip = flip != (order[a] > order[b]);
    }
  }
  const auto edge = [&](unsigned int a, unsigned int b) { return cubeEdge(path[order[a]], path[order[b]]); };
  const auto triangle = [&](CubeEdge a, CubeEdge b, CubeEdge c) {
    return flip ? CubeTriangle{ { a, c, b } } : CubeTriangle{ { a, b, c } };
  };
  switch (insideCount)
  {
    case 1:
      return { triangle(edge(0, 1), edge(0, 2), edge(0, 3)) };
    case 2:
      return { triangle(edge(0, 2), edge(0, 3), edge(1, 3)), triangle(edge(0, 2), edge(1, 3), edge(1, 2)) };
    case 3:
      return { triangle(edge(0, 3), edge(1, 3), edge(2, 3)) };
    default:
      return {};
  }
}

/** Triangles of a cube for each of the 256 sets of inside corners, outward on a right-handed grid. */
std::vector<std::vector<CubeTriangle>>
cubeTriangleTable()
{
  std::vector<std::vector<CubeTriangle>> table(256);
  for (unsigned int inside = 0; inside < 256; ++inside)
  {
    for (std::size_t p = 0; p < detail::kuhnPaths.size(); ++p)
    {
      const auto & path = detail::kuhnPaths[p];
      unsigned int insideSet = 0;
      for (unsigned int q = 0; q < 4; ++q)
      {
        insideSet |= (inside >> path[q] & 1u) << q;
      }
      const bool positive = static_cast<int>(p) < detail::positiveKuhnPaths;
      const auto triangles = tetrahedronTriangles(path, positive, insideSet);
      table[inside].insert(table[inside].end(), triangles.begin(), triangles.end());
    }
  }
  return table;
}

/** Where the level crosses an edge, as the fraction from a to b; in the middle when an end is infinite. */
double
crossing(double a, double b, double level)
{
  if (!std::isfinite(a) || !std::isfinite(b))
  {
    return 0.5;
  }
  return (level - a) / (b - a);
}

/** Numbers of the vertices on the edges that start in one layer of nodes: 7 edges per node, -1 where there is none. */
class EdgeVertices
{
public:
  explicit EdgeVertices(const RegularGrid & grid)
    : m_NodesPerLayer(static_cast<std::size_t>(grid.size[0]) * static_cast<std::size_t>(grid.size[1]))
  {
    for (auto & layer : m_Layers)
    {
      layer.assign(7 * m_NodesPerLayer, -1);
    }
  }

  /** \param layer 0: the lower layer of nodes of the cubes at hand, 1: the upper. */
  VertexIndex &
  at(unsigned int layer, std::size_t nodeInLayer, unsigned int direction)
  {
    return m_Layers[layer][7 * nodeInLayer + direction - 1];
  }

  void
  nextLayer()
  {
    std::swap(m_Layers[0], m_Layers[1]);
    std::fill(m_Layers[1].begin(), m_Layers[1].end(), -1);
  }

private:
  std::size_t                             m_NodesPerLayer;
  std::array<std::vector<VertexIndex>, 2> m_Layers;
};

std::array<std::size_t, 8>
cornerStrides(const RegularGrid & grid)
{
  std::array<std::size_t, 8> strides{};
  for (unsigned int c = 0; c < 8; ++c)
  {
    strides[c] = grid.nodeNumber(c & 1u, c >> 1 & 1u, c >> 2);
  }
  return strides;
}

std::vector<std::uint8_t>
nodesBelow(const LevelSet & levelSet, double level)
{
  std::vector<std::uint8_t> below(levelSet.values.size());
  for (std::size_t node = 0; node < below.size(); ++node)
  {
    below[node] = levelSet.values[node] < level;
    if (below[node] != 0 && levelSet.grid.isBorder(node))
    {
      throw InvalidInput("marching tetrahedra: border node " + std::to_string(node) + " lies inside level " +
                         std::to_string(level) + "; the surface would be open");
    }
  }
  return below;
}

unsigned int
cornersInside(const std::vector<std::uint8_t> & inside, std::size_t base, const std::array<std::size_t, 8> & strides)
{
  unsigned int set = 0;
  for (unsigned int c = 0; c < 8; ++c)
  {
    set |= static_cast<unsigned int>(inside[base + strides[c]]) << c;
  }
  return set;
}

} // namespace

TriangleMesh
marchingTetrahedra(const LevelSet & levelSet, double level)
{
  requireValid(levelSet, "marching tetrahedra");
  const RegularGrid &             grid = levelSet.grid;
  const std::vector<std::uint8_t> inside = nodesBelow(levelSet, level);
  const auto                      table = cubeTriangleTable();
  const bool                      leftHanded = grid.direction.determinant() < 0.0;
  const auto                      strides = cornerStrides(grid);
  EdgeVertices                    edgeVertices(grid);
  TriangleMesh                    mesh;

  const auto vertexOn = [&](const CubeEdge & edge, int i, int j, int k) {
    const int         fromI = i + static_cast<int>(edge.from & 1u);
    const int         fromJ = j + static_cast<int>(edge.from >> 1 & 1u);
    const int         fromK = k + static_cast<int>(edge.from >> 2);
    const std::size_t nodeInLayer = grid.nodeNumber(fromI, fromJ, 0);
    VertexIndex &     vertex = edgeVertices.at(edge.from >> 2, nodeInLayer, edge.from ^ edge.to);
    if (vertex < 0)
    {
      const std::size_t base = grid.nodeNumber(i, j, k);
      const double      a = levelSet.values[base + strides[edge.from]];
      const double      b = levelSet.values[base + strides[edge.to]];
      const double      s = std::min(std::max(crossing(a, b, level), edgeMargin), 1.0 - edgeMargin);
      const unsigned    direction = edge.from ^ edge.to;
      const Vector3     index =
        Vector3(fromI, fromJ, fromK) + s * Vector3(direction & 1u, direction >> 1 & 1u, direction >> 2);
      vertex = static_cast<VertexIndex>(mesh.vertices.size());
      mesh.vertices.push_back(grid.origin + grid.direction * (grid.spacing * index));
    }
    return vertex;
  };

  for (int k = 0; k + 1 < grid.size[2]; ++k)
  {
    for (int j = 0; j + 1 < grid.size[1]; ++j)
    {
      for (int i = 0; i + 1 < grid.size[0]; ++i)
      {
        for (const CubeTriangle & triangle : table[cornersInside(inside, grid.nodeNumber(i, j, k), strides)])
        {
          const VertexIndex a = vertexOn(triangle[0], i, j, k);
          const VertexIndex b = vertexOn(triangle[1], i, j, k);
          const VertexIndex c = vertexOn(triangle[2], i, j, k);
          mesh.triangles.push_back(leftHanded ? Triangle{ { a, c, b } } : Triangle{ { a, b, c } });
        }
      }
    }
    edgeVertices.nextLayer();
  }
  return mesh;
}

} // namespace moserhex
