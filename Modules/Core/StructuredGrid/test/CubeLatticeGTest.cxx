// Counting and incidence: exact integers. Positions: identities at round-off (1e-15).
#include "moserhex/StructuredGrid/CubeLattice.h"

#include "moserhex/Common/Errors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

using namespace moserhex;

TEST(CubeLattice, ShellsPartitionTheNodes)
{
  const CubeLattice lattice(10);
  std::vector<int>  seen(lattice.nodeCount(), 0);
  for (int shell = 1; shell <= lattice.shells(); ++shell)
  {
    const auto nodes = lattice.nodesOfShell(shell);
    EXPECT_EQ(nodes.size(), static_cast<std::size_t>(6 * (2 * shell - 1) * (2 * shell - 1) + 2));
    EXPECT_TRUE(std::is_sorted(nodes.begin(), nodes.end()));
    for (const std::size_t node : nodes)
    {
      EXPECT_EQ(lattice.shellOfNode(node), shell);
      ++seen[node];
    }
  }
  EXPECT_TRUE(std::all_of(seen.begin(), seen.end(), [](int count) { return count == 1; }));
}

TEST(CubeLattice, TheInnermostShellHasTheEightNodesOfTheMiddleCell)
{
  const CubeLattice lattice(3);
  EXPECT_EQ(lattice.nodesOfShell(1),
            (std::vector<std::size_t>{ lattice.nodeNumber(2, 2, 2),
                                       lattice.nodeNumber(3, 2, 2),
                                       lattice.nodeNumber(2, 3, 2),
                                       lattice.nodeNumber(3, 3, 2),
                                       lattice.nodeNumber(2, 2, 3),
                                       lattice.nodeNumber(3, 2, 3),
                                       lattice.nodeNumber(2, 3, 3),
                                       lattice.nodeNumber(3, 3, 3) }));
}

TEST(CubeLattice, ShellOfACellIsThatOfItsOutermostNode)
{
  const CubeLattice lattice(4);
  const int         m = lattice.nodesPerSide() - 1;
  std::size_t       cell = 0;
  for (int k = 0; k < m; ++k)
  {
    for (int j = 0; j < m; ++j)
    {
      for (int i = 0; i < m; ++i)
      {
        int outermost = 0;
        for (int corner = 0; corner < 8; ++corner)
        {
          outermost = std::max(
            outermost,
            lattice.shellOfNode(lattice.nodeNumber(i + (corner & 1), j + (corner >> 1 & 1), k + (corner >> 2))));
        }
        EXPECT_EQ(lattice.shellOfCell(cell++), outermost);
      }
    }
  }
  EXPECT_EQ(cell, lattice.cellCount());
}

TEST(CubeLattice, NodeIndexInvertsNodeNumber)
{
  const CubeLattice lattice(3);
  for (std::size_t node = 0; node < lattice.nodeCount(); ++node)
  {
    const auto index = lattice.nodeIndex(node);
    EXPECT_EQ(lattice.nodeNumber(index[0], index[1], index[2]), node);
  }
}

TEST(CubeLattice, QuadsOfAShellFormAClosedOrientedSphere)
{
  const CubeLattice                                  lattice(4);
  const auto                                         quads = lattice.quadsOfShell(3);
  std::map<std::pair<std::size_t, std::size_t>, int> directed;
  for (const Quad & quad : quads)
  {
    for (std::size_t side = 0; side < 4; ++side)
    {
      ++directed[{ quad[side], quad[(side + 1) % 4] }];
    }
  }
  for (const auto & [edge, count] : directed)
  {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(directed.count({ edge.second, edge.first }), 1U);
  }
  const long vertices = static_cast<long>(lattice.nodesOfShell(3).size());
  EXPECT_EQ(vertices - static_cast<long>(directed.size() / 2) + static_cast<long>(quads.size()), 2);
}

TEST(CubeLattice, QuadsFaceOutwards)
{
  const CubeLattice lattice(3);
  for (const Quad & quad : lattice.quadsOfShell(2))
  {
    const Vector3 a = lattice.position(quad[0]);
    const Vector3 b = lattice.position(quad[1]);
    const Vector3 c = lattice.position(quad[2]);
    const Vector3 u = b - a;
    const Vector3 v = c - b;
    const Vector3 normal(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
    EXPECT_GT(normal.dot(a + c), 0.0);
  }
}

TEST(CubeLattice, PositionsFillTheCubeAndShellsAreItsScaledCopies)
{
  const CubeLattice lattice(10);
  EXPECT_EQ(lattice.position(0), Vector3(-1, -1, -1));
  EXPECT_EQ(lattice.position(lattice.nodeCount() - 1), Vector3(1, 1, 1));
  for (std::size_t node = 0; node < lattice.nodeCount(); node += 7)
  {
    const Vector3 onShell = lattice.positionOnShell(node);
    EXPECT_EQ(onShell.cwiseAbs().maxCoeff(), 1.0);
    EXPECT_LT((onShell * lattice.relativeSize(lattice.shellOfNode(node)) - lattice.position(node)).norm(), 1e-15);
  }
}

TEST(CubeLattice, CubedRelativeSizesCountTheCellsInside)
{
  const CubeLattice lattice(5);
  for (int shell = 1; shell <= 5; ++shell)
  {
    std::size_t inside = 0;
    for (std::size_t cell = 0; cell < lattice.cellCount(); ++cell)
    {
      inside += lattice.shellOfCell(cell) <= shell ? 1 : 0;
    }
    EXPECT_NEAR(std::pow(lattice.relativeSize(shell), 3),
                static_cast<double>(inside) / static_cast<double>(lattice.cellCount()),
                1e-15);
  }
}

TEST(CubeLattice, NumberOfShellsOutOfRangeIsRefused)
{
  EXPECT_THROW(CubeLattice(0), InvalidInput);
  EXPECT_THROW(CubeLattice(-3), InvalidInput);
  EXPECT_THROW(CubeLattice(501), InvalidInput);
}

TEST(CubeLattice, ShellNumberOutOfRangeIsRefused)
{
  const CubeLattice lattice(3);
  EXPECT_THROW(static_cast<void>(lattice.nodesOfShell(0)), InvalidInput);
  EXPECT_THROW(static_cast<void>(lattice.quadsOfShell(4)), InvalidInput);
  EXPECT_THROW(static_cast<void>(lattice.relativeSize(0)), InvalidInput);
}
