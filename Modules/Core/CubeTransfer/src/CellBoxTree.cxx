#include "CellBoxTree.h"

#include <algorithm>

namespace moserhex
{
namespace
{

constexpr int smallestSide = 2; ///< of a block [cells]

} // namespace

CellBoxTree::CellBoxTree(const HexMesh & mesh, double slack) : m_CellsPerSide(mesh.nodesPerSide - 1)
{
  const int m = m_CellsPerSide;
  m_Nodes.push_back(Node{ { { { 0, 0, 0 } }, { { m, m, m } } } });
  build(0, mesh, slack);
}

void
CellBoxTree::build(std::size_t node, const HexMesh & mesh, double slack)
{
  const Block block = m_Nodes[node].block;
  int         axis = 0;
  for (int other = 1; other < 3; ++other)
  {
    axis = block.end[other] - block.begin[other] > block.end[axis] - block.begin[axis] ? other : axis;
  }
  if (block.end[axis] - block.begin[axis] > smallestSide)
  {
    const std::size_t left = m_Nodes.size();
    m_Nodes[node].left = static_cast<int>(left);
    const int middle = (block.begin[axis] + block.end[axis]) / 2;
    Block     first = block;
    Block     second = block;
    first.end[axis] = middle;
    second.begin[axis] = middle;
    m_Nodes.push_back(Node{ first });
    m_Nodes.push_back(Node{ second });
    build(left, mesh, slack);
    build(left + 1, mesh, slack);
    m_Nodes[node].lower = m_Nodes[left].lower.cwiseMin(m_Nodes[left + 1].lower);
    m_Nodes[node].upper = m_Nodes[left].upper.cwiseMax(m_Nodes[left + 1].upper);
    return;
  }
  Vector3 lower = mesh.nodes[mesh.nodeNumber(block.begin[0], block.begin[1], block.begin[2])];
  Vector3 upper = lower;
  for (int k = block.begin[2]; k <= block.end[2]; ++k)
  {
    for (int j = block.begin[1]; j <= block.end[1]; ++j)
    {
      for (int i = block.begin[0]; i <= block.end[0]; ++i)
      {
        lower = lower.cwiseMin(mesh.nodes[mesh.nodeNumber(i, j, k)]);
        upper = upper.cwiseMax(mesh.nodes[mesh.nodeNumber(i, j, k)]);
      }
    }
  }
  m_Nodes[node].lower = lower.array() - slack;
  m_Nodes[node].upper = upper.array() + slack;
}

void
CellBoxTree::cellsNear(const Vector3 & p, std::vector<std::size_t> & cells) const
{
  constexpr std::size_t    deepest = 64;
  std::array<int, deepest> open{};
  std::size_t              count = 1;
  const auto               m = static_cast<std::size_t>(m_CellsPerSide);
  cells.clear();
  while (count > 0)
  {
    const Node & node = m_Nodes[static_cast<std::size_t>(open[--count])];
    if ((p.array() < node.lower.array()).any() || (p.array() > node.upper.array()).any())
    {
      continue;
    }
    if (node.left > 0)
    {
      open[count++] = node.left + 1;
      open[count++] = node.left;
      continue;
    }
    for (int k = node.block.begin[2]; k < node.block.end[2]; ++k)
    {
      for (int j = node.block.begin[1]; j < node.block.end[1]; ++j)
      {
        for (int i = node.block.begin[0]; i < node.block.end[0]; ++i)
        {
          cells.push_back(static_cast<std::size_t>(i) +
                          m * (static_cast<std::size_t>(j) + m * static_cast<std::size_t>(k)));
        }
      }
    }
  }
  std::sort(cells.begin(), cells.end());
}

} // namespace moserhex
