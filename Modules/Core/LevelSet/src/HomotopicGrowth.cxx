#include "moserhex/LevelSet/HomotopicGrowth.h"

#include "moserhex/Common/Errors.h"
#include "moserhex/LevelSet/KuhnConnectivity.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace moserhex
{
namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();

struct QueuedNode
{
  double       value;
  std::int32_t node;

  bool
  operator>(const QueuedNode & other) const
  {
    return value != other.value ? value > other.value : node > other.node;
  }
};

/** Smallest value first, ties by node number; a node is in the queue at most once. */
class NodeQueue
{
public:
  explicit NodeQueue(std::size_t nodeCount) : m_Queued(nodeCount, 0)
  {}

  [[nodiscard]] bool
  empty() const
  {
    return m_Heap.empty();
  }

  void
  push(std::size_t node, double value)
  {
    if (m_Queued[node] == 0)
    {
      m_Queued[node] = 1;
      m_Heap.push_back({ value, static_cast<std::int32_t>(node) });
      std::push_heap(m_Heap.begin(), m_Heap.end(), std::greater<>());
    }
  }

  std::size_t
  pop()
  {
    std::pop_heap(m_Heap.begin(), m_Heap.end(), std::greater<>());
    const auto node = static_cast<std::size_t>(m_Heap.back().node);
    m_Heap.pop_back();
    m_Queued[node] = 0;
    return node;
  }

private:
  std::vector<std::uint8_t> m_Queued;
  std::vector<QueuedNode>   m_Heap;
};

/** Which nodes growth may add: finite values up to the limit, inside the box, allowed by the caller. */
std::vector<std::uint8_t>
candidates(const LevelSet & f, const HomotopicGrowthOptions & options)
{
  std::vector<std::uint8_t> candidate(f.values.size(), 0);
  const RegularGrid &       grid = f.grid;
  for (int k = 1; k < grid.size[2] - 1; ++k)
  {
    for (int j = 1; j < grid.size[1] - 1; ++j)
    {
      for (int i = 1; i < grid.size[0] - 1; ++i)
      {
        const std::size_t node = grid.nodeNumber(i, j, k);
        const double      value = f.values[node];
        candidate[node] =
          value < infinity && value <= options.stopAbove && (options.allowed.empty() || options.allowed[node] != 0);
      }
    }
  }
  return candidate;
}

} // namespace

HomotopicGrowthResult
homotopicGrowth(const LevelSet & f, std::size_t seed, const HomotopicGrowthOptions & options)
{
  requireValid(f, "homotopic growth");
  const std::size_t nodeCount = f.values.size();
  if (!options.allowed.empty() && options.allowed.size() != nodeCount)
  {
    throw InvalidInput("homotopic growth: " + std::to_string(options.allowed.size()) +
                       " entries say which nodes are allowed, need " + std::to_string(nodeCount));
  }
  if (seed >= nodeCount)
  {
    throw InvalidInput("homotopic growth: seed " + std::to_string(seed) + " is not one of " +
                       std::to_string(nodeCount) + " nodes");
  }
  const std::vector<std::uint8_t> candidate = candidates(f, options);
  if (candidate[seed] == 0)
  {
    throw InvalidInput("homotopic growth: seed " + std::to_string(seed) +
                       " lies on the border of the grid, above the limit, or is not allowed");
  }

  HomotopicGrowthResult result;
  result.levelSet.grid = f.grid;
  result.levelSet.values.assign(nodeCount, options.valueOfOthers);
  const KuhnConnectivity    kuhn(f.grid);
  std::vector<std::uint8_t> inside(nodeCount, 0);
  NodeQueue                 queue(nodeCount);
  double                    level = -infinity;

  const auto add = [&](std::size_t node) {
    inside[node] = 1;
    ++result.added;
    level = std::max(f.values[node], std::nextafter(level, infinity));
    result.levelSet.values[node] = level;
    for (const std::ptrdiff_t stride : kuhn.strides())
    {
      const std::size_t neighbour = node + static_cast<std::size_t>(stride);
      if (candidate[neighbour] != 0 && inside[neighbour] == 0)
      {
        queue.push(neighbour, f.values[neighbour]);
      }
    }
  };

  add(seed);
  while (!queue.empty())
  {
    const std::size_t node = queue.pop();
    if (kuhn.isSimple(inside, node))
    {
      add(node);
    }
    else
    {
      ++result.postponed; // queued again when a neighbour is added
    }
  }
  return result;
}

LevelSet
homotopicShrink(const LevelSet & f)
{
  requireValid(f, "homotopic shrink");
  if (std::find(f.values.begin(), f.values.end(), infinity) != f.values.end())
  {
    throw InvalidInput("homotopic shrink: a value is not finite");
  }
  const RegularGrid &       grid = f.grid;
  const std::size_t         nodeCount = f.values.size();
  const KuhnConnectivity    kuhn(grid);
  std::vector<std::uint8_t> outside(nodeCount, 0);
  NodeQueue                 queue(nodeCount);
  LevelSet                  t{ grid, std::vector<double>(nodeCount, infinity) };

  const auto queueNeighbours = [&](std::size_t node) {
    const RegularGrid::Index index = grid.indexOf(node);
    for (std::size_t a = 0; a < kuhnOffsets.size(); ++a)
    {
      const int i = index[0] + kuhnOffsets[a][0];
      const int j = index[1] + kuhnOffsets[a][1];
      const int k = index[2] + kuhnOffsets[a][2];
      if (grid.isBorder(i, j, k)) // the border is outside from the start
      {
        continue;
      }
      const std::size_t neighbour = grid.nodeNumber(i, j, k);
      if (outside[neighbour] == 0)
      {
        queue.push(neighbour, -f.values[neighbour]);
      }
    }
  };

  double highest = -infinity;
  for (std::size_t node = 0; node < nodeCount; ++node)
  {
    if (grid.isBorder(node))
    {
      outside[node] = 1;
      highest = std::max(highest, f.values[node]);
    }
  }
  for (std::size_t node = 0; node < nodeCount; ++node)
  {
    if (outside[node] != 0)
    {
      queueNeighbours(node);
    }
  }
  double level = infinity;
  while (!queue.empty())
  {
    const std::size_t node = queue.pop();
    if (!kuhn.isSimple(outside, node))
    {
      continue;
    }
    outside[node] = 1;
    level = std::min(f.values[node], std::nextafter(level, -infinity));
    t.values[node] = level;
    highest = std::max(highest, level);
    queueNeighbours(node);
  }
  double lowest = level;
  for (std::size_t node = 0; node < nodeCount; ++node)
  {
    lowest = outside[node] == 0 ? std::min(lowest, f.values[node]) : lowest;
  }
  for (std::size_t node = 0; node < nodeCount; ++node)
  {
    if (outside[node] == 0)
    {
      t.values[node] = lowest;
    }
    else if (t.values[node] == infinity)
    {
      t.values[node] = std::max(highest, f.values[node]);
    }
  }
  return t;
}

} // namespace moserhex
