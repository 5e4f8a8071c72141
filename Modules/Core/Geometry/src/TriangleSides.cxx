#include "TriangleSides.h"

#include <algorithm>

namespace moserhex
{

std::vector<TriangleSide>
sortedSides(const TriangleMesh & mesh)
{
  std::vector<TriangleSide> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const VertexIndex a = mesh.triangles[f][k];
      const VertexIndex b = mesh.triangles[f][(k + 1) % 3];
      sides.push_back({ std::min(a, b), std::max(a, b), static_cast<int>(f), k, a < b });
    }
  }
  std::stable_sort(sides.begin(), sides.end(), [](const TriangleSide & p, const TriangleSide & q) {
    return p.low != q.low ? p.low < q.low : p.high < q.high;
  });
  return sides;
}

std::size_t
rootOf(std::vector<std::size_t> & parent, std::size_t v)
{
  while (parent[v] != v)
  {
    parent[v] = parent[parent[v]];
    v = parent[v];
  }
  return v;
}

} // namespace moserhex
