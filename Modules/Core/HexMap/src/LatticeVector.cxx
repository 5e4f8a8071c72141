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

LatticeLayout::LatticeLayout(int nodesPerSide_, int paddingLayers_)
  : nodesPerSide(nodesPerSide_), paddingLayers(paddingLayers_), nodes(nodeCount(nodesPerSide, paddingLayers))
{
  const auto n = static_cast<std::size_t>(nodesPerSide);
  stride = nodes + latticePadding;
  for (std::size_t a = 0; a < 8; ++a)
  {
    corner[a] = (a & 1) + n * ((a >> 1 & 1) + n * (a >> 2));
  }
  cellStarts = n * n * n - corner[7];
  const HexMesh mesh = connectivity();
  for (std::size_t cell = mesh.latticeCellCount(); cell < mesh.cellCount(); ++cell)
  {
    const auto vtkNodes = mesh.cellNodes(cell);
    pillowCells.push_back(
      { vtkNodes[0], vtkNodes[1], vtkNodes[3], vtkNodes[2], vtkNodes[4], vtkNodes[5], vtkNodes[7], vtkNodes[6] });
  }
}

CellNodes
LatticeLayout::cellNodes(std::size_t cell) const
{
  if (cell >= latticeCellCount())
  {
    return pillowCells[cell - latticeCellCount()];
  }
  const std::size_t first = firstNode(cell);
  CellNodes         result;
  for (std::size_t a = 0; a < 8; ++a)
  {
    result[a] = first + corner[a];
  }
  return result;
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

HexMesh
LatticeLayout::connectivity() const
{
  return { nodesPerSide, {}, paddingLayers };
}

} // namespace moserhex
