// Identities within round-off (1e-12), and one test per refusal of grids and level sets.
#include "TestShapes.h"
#include "moserhex/Analytic/Refusals.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/LevelSet/LevelSet.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <cmath>

using namespace moserhex;

namespace
{

RegularGrid
obliqueGrid()
{
  RegularGrid grid;
  grid.size = { { 5, 6, 7 } };
  grid.spacing = 0.3;
  grid.origin = Vector3(1, 2, 3);
  grid.direction = Eigen::AngleAxisd(0.4, Vector3(1, 1, 0).normalized()).toRotationMatrix();
  return grid;
}

} // namespace

TEST(RegularGrid, NodeNumbersAndIndicesAreInverse)
{
  const RegularGrid grid = obliqueGrid();
  for (std::size_t node = 0; node < grid.nodeCount(); ++node)
  {
    const auto index = grid.indexOf(node);
    EXPECT_EQ(grid.nodeNumber(index[0], index[1], index[2]), node);
  }
  EXPECT_EQ(grid.stride(1, 1, 1), static_cast<std::ptrdiff_t>(grid.nodeNumber(1, 1, 1)));
}

TEST(RegularGrid, ContinuousIndexInvertsPoint)
{
  const RegularGrid grid = obliqueGrid();
  EXPECT_LT((grid.continuousIndex(grid.point(4, 2, 5)) - Vector3(4, 2, 5)).norm(), 1e-12);
  EXPECT_LT((grid.point(grid.nodeNumber(4, 2, 5)) - grid.point(4, 2, 5)).norm(), 1e-12);
}

TEST(RegularGrid, BorderIsTheSurfaceOfTheBox)
{
  const RegularGrid grid = obliqueGrid();
  std::size_t       inner = 0;
  for (std::size_t node = 0; node < grid.nodeCount(); ++node)
  {
    inner += grid.isBorder(node) ? 0 : 1;
  }
  EXPECT_EQ(inner, 3u * 4u * 5u);
}

TEST(RegularGrid, BadGridsAreRefused)
{
  const auto refuse = [](const auto & change) {
    RegularGrid grid = obliqueGrid();
    change(grid);
    EXPECT_THROW(requireValid(grid, "test"), InvalidInput);
  };
  EXPECT_NO_THROW(requireValid(obliqueGrid(), "test"));
  refuse([](RegularGrid & grid) { grid.size[1] = 3; });
  refuse([](RegularGrid & grid) { grid.size = { { 2000, 2000, 2000 } }; });
  refuse([](RegularGrid & grid) { grid.spacing = 0.0; });
  refuse([](RegularGrid & grid) { grid.spacing = INFINITY; });
  refuse([](RegularGrid & grid) { grid.direction *= 1.1; });
  refuse([](RegularGrid & grid) { grid.origin[0] = NAN; });
}

TEST(LevelSet, BadValuesAreRefusedWithTheirNode)
{
  LevelSet f{ obliqueGrid(), {} };
  f.values.assign(f.grid.nodeCount(), 1.0);
  EXPECT_NO_THROW(requireValid(f, "test"));
  f.values[17] = INFINITY;
  EXPECT_NO_THROW(requireValid(f, "test"));
  f.values[17] = NAN;
  EXPECT_EQ(analytic::messageOf([&] { requireValid(f, "test"); }), "test: value of node 17 is NaN or -infinity");
  f.values[17] = -INFINITY;
  EXPECT_THROW(requireValid(f, "test"), InvalidInput);
  f.values.pop_back();
  EXPECT_THROW(requireValid(f, "test"), InvalidInput);
}
