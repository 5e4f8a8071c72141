// Identities: topology in whole numbers, values compared exactly. The random fields are the hardest case there is:
// every second node is a critical point.
#include "TestShapes.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Geometry/TriangleTopology.h"
#include "moserhex/LevelSet/HomotopicGrowth.h"
#include "moserhex/LevelSet/KuhnConnectivity.h"
#include "moserhex/LevelSet/MarchingTetrahedra.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace moserhex;
using test::randomField;

namespace
{

std::size_t
argMin(const LevelSet & f)
{
  return static_cast<std::size_t>(std::min_element(f.values.begin(), f.values.end()) - f.values.begin());
}

/** Finite values, sorted. */
std::vector<double>
levelsOf(const LevelSet & t)
{
  std::vector<double> levels;
  std::copy_if(t.values.begin(), t.values.end(), std::back_inserter(levels), [](double v) { return std::isfinite(v); });
  std::sort(levels.begin(), levels.end());
  return levels;
}

} // namespace

TEST(HomotopicGrowth, EveryLevelSetIsASphere)
{
  for (std::uint64_t seed = 0; seed < 4; ++seed)
  {
    const LevelSet f = randomField({ { 10, 9, 8 } }, seed);
    const auto     result = homotopicGrowth(f, argMin(f));
    const auto     levels = levelsOf(result.levelSet);
    ASSERT_EQ(levels.size(), result.added);
    ASSERT_GT(result.postponed, 0u);
    for (std::size_t n = 1; n < levels.size(); n += 5)
    {
      EXPECT_TRUE(summarizeTopology(marchingTetrahedra(result.levelSet, levels[n])).isSphere())
        << "seed " << seed << " level " << levels[n];
    }
  }
}

TEST(HomotopicGrowth, ValuesAreNeverLowered)
{
  const LevelSet f = randomField({ { 12, 12, 12 } }, 5);
  const auto     t = homotopicGrowth(f, argMin(f)).levelSet;
  for (std::size_t node = 0; node < f.values.size(); ++node)
  {
    EXPECT_GE(t.values[node], f.values[node]);
  }
}

TEST(HomotopicGrowth, FunctionWithOneMinimumIsReturnedAsItIs)
{
  const LevelSet f = test::sample(test::unitGrid(17), [](const Vector3 & p) {
    return (p - Vector3(0.1, 0.05, -0.2)).cwiseProduct(Vector3(1.0, 1.4, 0.8)).norm();
  });
  const auto     result = homotopicGrowth(f, argMin(f));
  EXPECT_EQ(result.postponed, 0u);
  for (std::size_t node = 0; node < f.values.size(); ++node)
  {
    EXPECT_DOUBLE_EQ(result.levelSet.values[node], f.grid.isBorder(node) ? INFINITY : f.values[node]); // ties: + 1 ulp
  }
}

TEST(HomotopicGrowth, ATunnelIsCutAndAnIslandLeftOut)
{
  // A solid torus around the z axis and a ball above it.
  const LevelSet f = test::sample(test::unitGrid(33), [](const Vector3 & p) {
    const double torus = std::hypot(std::hypot(p.x(), p.y()) - 0.55, p.z() + 0.3) - 0.22;
    return std::min(torus, (p - Vector3(0, 0, 0.6)).norm() - 0.2);
  });
  ASSERT_EQ(summarizeTopology(marchingTetrahedra(f, 0.0)).eulerCharacteristic, 2);
  ASSERT_EQ(summarizeTopology(marchingTetrahedra(f, 0.0)).components, 2u);
  HomotopicGrowthOptions options;
  options.stopAbove = 0.0;
  const auto t = homotopicGrowth(f, argMin(f), options).levelSet;
  EXPECT_TRUE(summarizeTopology(marchingTetrahedra(t, 0.0)).isSphere());
}

TEST(HomotopicGrowth, BandHasTheValuesOfTheFullGrowth)
{
  const LevelSet         f = randomField({ { 10, 10, 10 } }, 7);
  const auto             full = homotopicGrowth(f, argMin(f)).levelSet;
  HomotopicGrowthOptions options;
  options.stopAbove = 0.6;
  options.valueOfOthers = 9.0;
  const auto band = homotopicGrowth(f, argMin(f), options).levelSet;
  for (std::size_t node = 0; node < f.values.size(); ++node)
  {
    if (full.values[node] <= 0.6)
    {
      EXPECT_EQ(band.values[node], full.values[node]);
    }
  }
  EXPECT_EQ(band.values[0], 9.0);
}

TEST(HomotopicGrowth, NodesNotAllowedStayOutside)
{
  const LevelSet         f = randomField({ { 8, 8, 8 } }, 8);
  HomotopicGrowthOptions options;
  options.allowed.assign(f.values.size(), 1);
  for (std::size_t node = 0; node < f.values.size(); node += 4)
  {
    options.allowed[node] = 0;
  }
  const std::size_t seed = f.grid.nodeNumber(3, 3, 3);
  ASSERT_EQ(options.allowed[seed], 1);
  const auto t = homotopicGrowth(f, seed, options).levelSet;
  for (std::size_t node = 0; node < f.values.size(); node += 4)
  {
    EXPECT_EQ(t.values[node], INFINITY);
  }
}

TEST(HomotopicGrowth, TiesAreBrokenTheSameWayEveryTime)
{
  LevelSet f = randomField({ { 9, 9, 9 } }, 9);
  for (double & value : f.values)
  {
    value = std::round(4.0 * value);
  }
  EXPECT_EQ(homotopicGrowth(f, f.grid.nodeNumber(4, 4, 4)).levelSet.values,
            homotopicGrowth(f, f.grid.nodeNumber(4, 4, 4)).levelSet.values);
}

TEST(HomotopicShrink, EveryLevelSetIsASphere)
{
  for (std::uint64_t seed = 20; seed < 24; ++seed)
  {
    const LevelSet f = randomField({ { 10, 9, 8 } }, seed);
    const LevelSet t = homotopicShrink(f);
    auto           levels = levelsOf(t);
    levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
    for (std::size_t n = 1; n < levels.size() && levels[n] < 1.5; n += 5)
    {
      EXPECT_TRUE(summarizeTopology(marchingTetrahedra(t, levels[n])).isSphere())
        << "seed " << seed << " level " << levels[n];
    }
  }
}

TEST(HomotopicShrink, ValuesAreNeverRaisedInsideTheBox)
{
  const LevelSet f = randomField({ { 12, 12, 12 } }, 30);
  const LevelSet t = homotopicShrink(f);
  for (std::size_t node = 0; node < f.values.size(); ++node)
  {
    if (!f.grid.isBorder(node))
    {
      EXPECT_LE(t.values[node], f.values[node]);
    }
  }
}

TEST(HomotopicShrink, ATunnelIsFilled)
{
  const LevelSet f = test::sample(
    test::unitGrid(33), [](const Vector3 & p) { return std::hypot(std::hypot(p.x(), p.y()) - 0.45, p.z()) - 0.3; });
  const LevelSet t = homotopicShrink(f);
  EXPECT_TRUE(summarizeTopology(marchingTetrahedra(t, 0.0)).isSphere());
  EXPECT_LT(t.values[f.grid.nodeNumber(16, 16, 16)], 0.0);
}

TEST(HomotopicGrowth, SeedOnTheBorderOrOutsideIsRefused)
{
  const LevelSet f = randomField({ { 8, 8, 8 } }, 1);
  EXPECT_THROW((void)homotopicGrowth(f, 0), InvalidInput);
  EXPECT_THROW((void)homotopicGrowth(f, f.values.size()), InvalidInput);
}

TEST(HomotopicGrowth, SeedNotAllowedOrWrongMaskIsRefused)
{
  const LevelSet         f = randomField({ { 8, 8, 8 } }, 1);
  HomotopicGrowthOptions options;
  options.allowed.assign(f.values.size(), 0);
  EXPECT_THROW((void)homotopicGrowth(f, f.grid.nodeNumber(3, 3, 3), options), InvalidInput);
  options.allowed.assign(3, 1);
  EXPECT_THROW((void)homotopicGrowth(f, f.grid.nodeNumber(3, 3, 3), options), InvalidInput);
}

TEST(HomotopicGrowth, NaNIsRefused)
{
  LevelSet f = randomField({ { 8, 8, 8 } }, 1);
  f.values[100] = NAN;
  EXPECT_THROW((void)homotopicGrowth(f, f.grid.nodeNumber(3, 3, 3)), InvalidInput);
  EXPECT_THROW((void)homotopicShrink(f), InvalidInput);
}

TEST(HomotopicShrink, InfinityIsRefused)
{
  LevelSet f = randomField({ { 8, 8, 8 } }, 1);
  f.values[100] = INFINITY;
  EXPECT_THROW((void)homotopicShrink(f), InvalidInput);
}
