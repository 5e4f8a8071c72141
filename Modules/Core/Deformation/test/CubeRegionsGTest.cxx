// Sums to 1e-12.
#include "moserhex/Deformation/CubeRegions.h"

#include "moserhex/Analytic/Refusals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <numeric>

using namespace moserhex;

namespace
{

double
sumOf(const std::vector<double> & values)
{
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/** Whether the regions fill the cube once: every cell and quadrilateral is in them by 1 in all. */
void
expectPartition(const std::vector<CubeRegion> & regions, int n)
{
  std::vector<double> cells(cellFractions(wholeRegion(), n).size(), 0.0);
  std::vector<double> quads(quadFractions(wholeRegion(), n).size(), 0.0);
  for (const CubeRegion & region : regions)
  {
    const auto ofCells = cellFractions(region, n);
    const auto ofQuads = quadFractions(region, n);
    std::transform(cells.begin(), cells.end(), ofCells.begin(), cells.begin(), std::plus<>());
    std::transform(quads.begin(), quads.end(), ofQuads.begin(), quads.begin(), std::plus<>());
  }
  for (const auto & sums : { cells, quads })
  {
    for (const double sum : sums)
    {
      EXPECT_NEAR(sum, 1.0, 1e-12) << n;
    }
  }
}

} // namespace

TEST(CubeRegions, OctantsShellsAndOppositeHalvesFillTheCube)
{
  for (const int n : { 2, 3, 4, 7, 20 })
  {
    const auto halves = halfRegions();
    expectPartition({ wholeRegion() }, n);
    expectPartition(octantRegions(), n);
    expectPartition(shellRegions(n), n);
    expectPartition({ halves[0], halves[1] }, n);
    expectPartition({ halves[2], halves[3] }, n);
    expectPartition({ halves[4], halves[5] }, n);
  }
}

TEST(CubeRegions, OctantsAreNamedByThePatientsSides)
{
  const auto octants = octantRegions();
  EXPECT_EQ(octants[0].name, "right-anterior-inferior");
  EXPECT_EQ(octants[1].name, "left-anterior-inferior");
  EXPECT_EQ(octants[2].name, "right-posterior-inferior");
  EXPECT_EQ(octants[7].name, "left-posterior-superior");
  EXPECT_EQ(cellFractions(octants[1], 5)[3], 1.0); // i = 3, j = 0, k = 0
  EXPECT_EQ(cellFractions(octants[0], 5)[3], 0.0);
  EXPECT_EQ(halfRegions()[1].name, "left");
  EXPECT_EQ(cellFractions(halfRegions()[1], 5)[3], 1.0);
}

TEST(CubeRegions, ACellThatIsCutCountsByItsParts)
{
  const auto left = cellFractions(halfRegions()[1], 4); // three cells along i, the middle one cut
  EXPECT_EQ(left[0], 0.0);
  EXPECT_NEAR(left[1], 0.5, 1e-15);
  EXPECT_EQ(left[2], 1.0);
  const auto octant = cellFractions(octantRegions()[7], 4);
  EXPECT_NEAR(octant[13], 0.125, 1e-15); // the cell in the middle
}

TEST(CubeRegions, ShellsAreOneCellThick)
{
  const auto shells = shellRegions(6);
  ASSERT_EQ(shells.size(), 3u);
  EXPECT_EQ(shells[0].name, "shell-1");
  EXPECT_NEAR(sumOf(cellFractions(shells[0], 6)), 1.0, 1e-12);
  EXPECT_NEAR(sumOf(cellFractions(shells[1], 6)), 26.0, 1e-12);
  EXPECT_NEAR(sumOf(cellFractions(shells[2], 6)), 98.0, 1e-12);
  EXPECT_EQ(sumOf(quadFractions(shells[1], 6)), 0.0);
  EXPECT_EQ(sumOf(quadFractions(shells[2], 6)), 150.0);
}

TEST(CubeRegions, ShellsHaveNoCellOfTheirNeighbours)
{
  for (const int n : { 6, 7, 12, 20, 64 })
  {
    const auto shells = shellRegions(n);
    for (std::size_t shell = 0; shell < shells.size(); ++shell)
    {
      const auto side = [&shells, n](std::size_t number) { // cells along the shell's side, 0: of no shell
        return number < shells.size() ? n - 1 - 2 * static_cast<int>(shells.size() - 1 - number) : 0;
      };
      const int  outer = side(shell);
      const int  inner = shell > 0 ? side(shell - 1) : 0;
      const auto fractions = cellFractions(shells[shell], n);
      EXPECT_EQ(std::count_if(fractions.begin(), fractions.end(), [](double part) { return part > 0.0; }),
                outer * outer * outer - inner * inner * inner)
        << n << " " << shells[shell].name;
      EXPECT_TRUE(
        std::all_of(fractions.begin(), fractions.end(), [](double part) { return part == 0.0 || part == 1.0; }));
    }
  }
}

TEST(CubeRegions, ABoundThatIsRoundedCutsNoSliverOffACell)
{
  const CubeRegion third{ "third", { { 0, 0, 0 }, { 1.0 - 2.0 / 3.0, 1, 1 } }, {} }; // a little more than 1/3
  const auto       fractions = cellFractions(third, 4);
  EXPECT_EQ(fractions[0], 1.0);
  EXPECT_EQ(fractions[1], 0.0);
}

TEST(CubeRegions, OnlyTheFacesThatARegionReachesAreItsSurface)
{
  const CubeRegion box{ "box", { { 0.0, 0.25, 0.0 }, { 0.5, 0.75, 0.5 } }, {} };
  const auto       quads = quadFractions(box, 5); // 16 quadrilaterals a face; order i0 i1 j0 j1 k0 k1
  const auto       ofFace = [&quads](int face) {
    return std::accumulate(quads.begin() + 16 * face, quads.begin() + 16 * (face + 1), 0.0);
  };
  EXPECT_NEAR(ofFace(0), 4.0, 1e-12);
  EXPECT_EQ(ofFace(1) + ofFace(2) + ofFace(3) + ofFace(5), 0.0);
  EXPECT_NEAR(ofFace(4), 4.0, 1e-12);
  EXPECT_EQ(quads[0 + 4 * 0], 0.0); // face i = 0, j = 0, k = 0
  EXPECT_EQ(quads[1 + 4 * 0], 1.0);
  EXPECT_EQ(quads[1 + 4 * 2], 0.0);
}

TEST(CubeRegions, NumbersOfCellsAreThoseOfTheFirstRegionThatHoldsMostOfThem)
{
  EXPECT_EQ(regionOfCells(halfRegions(), 4)[0], 1);
  EXPECT_EQ(regionOfCells(halfRegions(), 4)[2], 2);
  EXPECT_EQ(regionOfCells({ octantRegions()[0], octantRegions()[1] }, 4)[1], 0); // cut in the middle
  EXPECT_EQ(regionOfCells({ octantRegions()[0], wholeRegion() }, 4)[1], 2);
}

TEST(CubeRegions, BoxesOutsideTheCubeAreRefused)
{
  const auto refusal = [](const CubeRegion & region) {
    return analytic::messageOf([&] { (void)cellFractions(region, 4); });
  };
  EXPECT_NE(refusal({ "apex", { { 0, 0, -0.1 }, { 1, 1, 1 } }, {} }).find("region apex"), std::string::npos);
  EXPECT_NE(refusal({ "apex", { { 0, 0.5, 0 }, { 1, 0.5, 1 } }, {} }), "accepted");
  EXPECT_NE(refusal({ "apex", { { 0, 0, 0 }, { 1, 1, 1.1 } }, {} }), "accepted");
  EXPECT_NE(refusal({ "apex", { { 0, 0, 0 }, { 1, 1, 0.5 } }, CubeBox{ { 0, 0, 0 }, { 1, 1, 1 } } }), "accepted");
  EXPECT_NE(analytic::messageOf([] { (void)shellRegions(1); }), "accepted");
}
