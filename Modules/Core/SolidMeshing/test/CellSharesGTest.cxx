// Closed forms on a lattice of unit cubes, of which some are stretched.
#include "CellShares.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

using namespace moserhex;

namespace
{

/** n^3 nodes; cells of column i have the width widths[i]. */
HexMesh
columns(const std::vector<double> & widths)
{
  HexMesh mesh;
  mesh.nodesPerSide = static_cast<int>(widths.size()) + 1;
  for (int k = 0; k < mesh.nodesPerSide; ++k)
  {
    for (int j = 0; j < mesh.nodesPerSide; ++j)
    {
      double x = 0.0;
      for (int i = 0; i < mesh.nodesPerSide; ++i)
      {
        mesh.nodes.emplace_back(x, j, k);
        x += i + 1 < mesh.nodesPerSide ? widths[static_cast<std::size_t>(i)] : 0.0;
      }
    }
  }
  return mesh;
}

double
meanOf(const std::vector<double> & values)
{
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

} // namespace

TEST(CellShares, AreVolumesOverTheirMean)
{
  const std::vector<double> shares = cellShares(columns({ 1.0, 2.0, 3.0 }));
  EXPECT_NEAR(shares[0], 0.5, 1e-14);
  EXPECT_NEAR(shares[1], 1.0, 1e-14);
  EXPECT_NEAR(shares[2], 1.5, 1e-14);
}

TEST(CellShares, GrowthIsAgainstTheSharesBefore)
{
  const HexMesh     same = columns({ 1.0, 2.0, 3.0 });
  const GrownShares found = grownShares(same, cellShares(same));
  const LocalGrowth growth = growthBetween(cellShares(same), found.shares);
  EXPECT_NEAR(growth.smallest, 1.0, 1e-12);
  EXPECT_NEAR(growth.largest, 1.0, 1e-12);
}

TEST(CellShares, GrowthIsLimitedAndTheCellsAreCounted)
{
  HexMesh folded = columns({ 1.0, 1.0, 1.0 });
  for (std::size_t node = 0; node < folded.nodes.size(); node += 4)
  {
    folded.nodes[node].x() = 1.5; // the first column is turned inside out, the others stay
  }
  const GrownShares found = grownShares(folded, std::vector<double>(27, 1.0));
  EXPECT_EQ(found.limited, 9u);
  for (const double share : found.shares)
  {
    EXPECT_GT(share, 0.0);
  }
}

TEST(CellShares, PartOfAGrowthIsGeometric)
{
  const std::vector<double> half = partlyGrown({ 1.0, 1.0 }, { 0.4, 1.6 }, 0.5);
  EXPECT_NEAR(meanOf(half), 1.0, 1e-14);
  EXPECT_NEAR(half[1] / half[0], 2.0, 1e-12);
}
