#include "LatticeVector.h"

#include "moserhex/Common/Parallel.h"

#include <algorithm>

namespace moserhex
{
namespace
{
/** Two at least: the masked lanes at the end of a slab reach one layer further than its cells do. */
constexpr std::size_t layersPerSlab = 2;

/** Below this the start of a thread costs more than it saves. */
constexpr int fewestNodesForThreads = 14;
} // namespace

LatticeLayout::LatticeLayout(int nodesPerSide_) : nodesPerSide(nodesPerSide_)
{
  const auto n = static_cast<std::size_t>(nodesPerSide);
  nodes = n * n * n;
  stride = nodes + latticePadding;
  for (std::size_t a = 0; a < 8; ++a)
  {
    corner[a] = (a & 1) + n * ((a >> 1 & 1) + n * (a >> 2));
  }
  cellStarts = nodes - corner[7];
}

std::size_t
LatticeLayout::firstNode(std::size_t cell) const
{
  const auto        m = static_cast<std::size_t>(nodesPerSide - 1);
  const std::size_t row = cell / m;
  return cell % m + (m + 1) * (row % m + (m + 1) * (row / m));
}

void
LatticeLayout::clearPadding(Eigen::VectorXd & x) const
{
  for (std::size_t component = 0; component < 3; ++component)
  {
    std::fill_n(x.data() + component * stride + nodes, latticePadding, 0.0);
  }
}

Eigen::VectorXd
latticeVector(const LatticeLayout & layout, const Positions & nodes, const Vector3 & origin, double unit)
{
  Eigen::VectorXd x = Eigen::VectorXd::Zero(layout.size());
  for (std::size_t node = 0; node < layout.nodes; ++node)
  {
    layout.add(x, node, (nodes[node] - origin) / unit);
  }
  return x;
}

Positions
latticePositions(const LatticeLayout & layout, const Eigen::VectorXd & x, const Vector3 & origin, double unit)
{
  Positions nodes(layout.nodes);
  for (std::size_t node = 0; node < layout.nodes; ++node)
  {
    nodes[node] = origin + unit * layout.at(x, node);
  }
  return nodes;
}

std::size_t
slabCount(const LatticeLayout & layout)
{
  return (static_cast<std::size_t>(layout.nodesPerSide - 1) + layersPerSlab - 1) / layersPerSlab;
}

void
forEachSlab(const LatticeLayout &                                              layout,
            unsigned int                                                       threads,
            const std::function<void(std::size_t, std::size_t, std::size_t)> & body)
{
  const auto         n = static_cast<std::size_t>(layout.nodesPerSide);
  const std::size_t  slabs = slabCount(layout);
  const unsigned int used = layout.nodesPerSide < fewestNodesForThreads ? 1 : threads;
  for (std::size_t colour = 0; colour < 2; ++colour)
  {
    parallelFor((slabs + 1 - colour) / 2, used, [&](std::size_t index) {
      const std::size_t slab = 2 * index + colour;
      const std::size_t begin = slab * layersPerSlab * n * n;
      body(slab, begin, std::min(begin + layersPerSlab * n * n, layout.cellStarts));
    });
  }
}

std::vector<std::array<std::size_t, 4>>
boundaryQuads(const LatticeLayout & layout)
{
  const int                               n = layout.nodesPerSide;
  std::vector<std::array<std::size_t, 4>> quads;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    for (const int side : { 0, n - 1 })
    {
      const auto node = [&](int a, int b) {
        std::array<int, 3> at{};
        at[axis] = side;
        at[(axis + 1) % 3] = a;
        at[(axis + 2) % 3] = b;
        return layout.node(at[0], at[1], at[2]);
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
