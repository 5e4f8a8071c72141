// Identities between whole numbers: exact.
#include "TestShapes.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Geometry/TriangleTopology.h"
#include "moserhex/LevelSet/KuhnConnectivity.h"
#include "moserhex/LevelSet/MarchingTetrahedra.h"

#include <gtest/gtest.h>

using namespace moserhex;

namespace
{

std::vector<std::uint8_t>
randomNodeSet(const RegularGrid & grid, double density, std::uint64_t seed)
{
  Random                    random(seed);
  std::vector<std::uint8_t> inside(grid.nodeCount(), 0);
  for (std::size_t node = 0; node < inside.size(); ++node)
  {
    inside[node] = !grid.isBorder(node) && random.uniform() < density;
  }
  return inside;
}

TriangleMesh
surfaceOf(const RegularGrid & grid, const std::vector<std::uint8_t> & inside)
{
  LevelSet f{ grid, {} };
  for (const auto node : inside)
  {
    f.values.push_back(node != 0 ? -1.0 : 1.0);
  }
  return marchingTetrahedra(f, 0.0);
}

RegularGrid
smallGrid()
{
  RegularGrid grid;
  grid.size = { { 9, 8, 7 } };
  return grid;
}

} // namespace

TEST(KuhnConnectivity, NeighboursComeInOppositePairs)
{
  for (std::size_t a = 0; a < 7; ++a)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      EXPECT_EQ(kuhnOffsets[a][axis], -kuhnOffsets[a + 7][axis]);
    }
  }
}

TEST(KuhnConnectivity, SimplicityIsTheSameFromInsideAndOutside)
{
  int simple = 0;
  for (unsigned int mask = 0; mask < (1u << 14); ++mask)
  {
    ASSERT_EQ(isSimpleLink(mask), isSimpleLink(~mask & 0x3fffu)) << "mask " << mask;
    simple += isSimpleLink(mask) ? 1 : 0;
  }
  EXPECT_FALSE(isSimpleLink(0));
  EXPECT_FALSE(isSimpleLink(0x3fff));
  EXPECT_GT(simple, 0);
}

TEST(KuhnConnectivity, NodeBetweenTwoOppositeNeighboursIsNotSimple)
{
  EXPECT_FALSE(isSimpleLink((1u << 0) | (1u << 7))); // +i and -i
  EXPECT_TRUE(isSimpleLink((1u << 0) | (1u << 2)));  // +i and +i+j, which are neighbours
}

TEST(KuhnConnectivity, SurfaceHasTwiceTheEulerCharacteristicOfTheSolid)
{
  const RegularGrid grid = smallGrid();
  for (std::uint64_t seed = 0; seed < 60; ++seed)
  {
    const auto inside = randomNodeSet(grid, 0.1 + 0.8 * static_cast<double>(seed) / 60.0, seed);
    const auto summary = summarizeTopology(surfaceOf(grid, inside));
    EXPECT_EQ(summary.eulerCharacteristic, 2 * kuhnEulerCharacteristic(grid, inside)) << "seed " << seed;
    EXPECT_EQ(summary.boundaryEdges + summary.nonManifoldEdges + summary.nonManifoldVertices, 0u) << "seed " << seed;
  }
}

TEST(KuhnConnectivity, FlippingASimpleNodeKeepsTheSurfacesTopology)
{
  const RegularGrid      grid = smallGrid();
  const KuhnConnectivity kuhn(grid);
  int                    flipped = 0;
  for (std::uint64_t seed = 0; seed < 10; ++seed)
  {
    auto inside = randomNodeSet(grid, 0.5, 100 + seed);
    auto before = summarizeTopology(surfaceOf(grid, inside));
    for (std::size_t node = 0; node < inside.size(); node += 3)
    {
      if (!grid.isBorder(node) && kuhn.isSimple(inside, node))
      {
        inside[node] = inside[node] != 0 ? 0 : 1;
        ++flipped;
      }
    }
    const auto after = summarizeTopology(surfaceOf(grid, inside));
    EXPECT_EQ(before.eulerCharacteristic, after.eulerCharacteristic) << "seed " << seed;
    EXPECT_EQ(before.components, after.components) << "seed " << seed;
  }
  EXPECT_GT(flipped, 100);
}

TEST(KuhnConnectivity, FlippingANodeThatIsNotSimpleChangesTheSurface)
{
  const RegularGrid      grid = smallGrid();
  const KuhnConnectivity kuhn(grid);
  for (std::uint64_t seed = 0; seed < 10; ++seed)
  {
    auto       inside = randomNodeSet(grid, 0.5, 200 + seed);
    const auto before = summarizeTopology(surfaceOf(grid, inside));
    for (std::size_t node = 0; node < inside.size(); ++node)
    {
      if (grid.isBorder(node) || kuhn.isSimple(inside, node))
      {
        continue;
      }
      inside[node] = inside[node] != 0 ? 0 : 1;
      const auto after = summarizeTopology(surfaceOf(grid, inside));
      EXPECT_TRUE(before.eulerCharacteristic != after.eulerCharacteristic || before.components != after.components)
        << "seed " << seed << " node " << node;
      break;
    }
  }
}

TEST(KuhnConnectivity, WrongNumberOfEntriesIsRefused)
{
  EXPECT_THROW((void)kuhnEulerCharacteristic(smallGrid(), std::vector<std::uint8_t>(5)), InvalidInput);
}
