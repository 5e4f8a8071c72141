// Closed forms on boxes to 1e-12.
#include "RegionMeasures.h"

#include "ComparisonSummary.h"
#include "moserhex/Analytic/Lattices.h"
#include "moserhex/Common/Errors.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace moserhex;
using namespace moserhex::app;

namespace
{

/** Cubes of 2 mm; n = 6, so that the planes of octants go through cells. */
HexMesh
box()
{
  return analytic::cubeLattice(6, 2.0);
}

/** The last cell along i grows to three times its length: 10 mm become 14 mm. */
HexMesh
grown()
{
  HexMesh mesh = box();
  for (Vector3 & node : mesh.nodes)
  {
    node[0] += node[0] > 9.0 ? 4.0 : 0.0;
  }
  return mesh;
}

const WeightedDistribution &
in(const std::vector<RegionRow> & rows, const std::string & region, const std::string & measure)
{
  for (const RegionRow & row : rows)
  {
    if (row.region == region && row.measure == measure)
    {
      return row.values;
    }
  }
  throw InvalidInput("no row " + region + " " + measure);
}

} // namespace

TEST(RegionMeasures, RegionsAddUpToTheOrgan)
{
  const auto comparison = compareWithBaseline(box(), grown(), AlignmentKind::None, 1);
  const auto rows = regionRows(box(), comparison, chosenRegions({ "octants", "shells" }, 6));
  for (const std::string set : { "octants", "shells" })
  {
    double volume = 0.0;
    double before = 0.0;
    double displacement = 0.0;
    for (const RegionRow & row : rows)
    {
      if (row.set == set && row.measure == "displacement")
      {
        volume += row.volume;
        before += row.values.weight;
        displacement += row.values.weight * row.values.mean;
      }
    }
    EXPECT_NEAR(volume, 14.0 * 10.0 * 10.0, 1e-9) << set;
    EXPECT_NEAR(before, 1000.0, 1e-9) << set;
    EXPECT_NEAR(displacement / 1000.0, in(rows, "organ", "displacement").mean, 1e-12) << set;
  }
}

TEST(RegionMeasures, KnownGrowthIsFoundInItsPlace)
{
  const auto comparison = compareWithBaseline(box(), grown(), AlignmentKind::None, 1);
  const auto rows = regionRows(box(), comparison, chosenRegions({ "halves" }, 6));
  EXPECT_NEAR(comparison.latticeVolumeChange, 40.0, 1e-10);
  EXPECT_NEAR(in(rows, "organ", "volumetric").maximum, 3.0 / 1.4 - 1.0, 1e-12);
  EXPECT_NEAR(in(rows, "organ", "volumetric").mean, 0.0, 1e-12);
  EXPECT_NEAR(in(rows, "organ", "displacement").mean, 0.2 * 2.0, 1e-12); // the centre of the last cells moves by 2 mm
  EXPECT_NEAR(in(rows, "organ", "largest_stretch").maximum, 3.0 / std::cbrt(1.4), 1e-12);
  EXPECT_NEAR(in(rows, "organ", "signed_distance").maximum, 4.0, 1e-12);
  // A third of the surface lies across i, half of it on the side that moves; both see the organ 4 mm thicker.
  EXPECT_NEAR(in(rows, "organ", "thickness_change").mean, 4.0 / 3.0, 1e-12);
  EXPECT_NEAR(in(rows, "right", "volumetric").maximum, 1.0 / 1.4 - 1.0, 1e-12);
  EXPECT_GT(in(rows, "left", "normal_motion").maximum, 3.0);
}

TEST(RegionMeasures, EachDistanceIsWeightedByTheSurfaceThatItsNodesLieOn)
{
  const auto rows = regionRows(box(), compareWithBaseline(box(), grown(), AlignmentKind::None, 1), {});
  EXPECT_NEAR(in(rows, "organ", "baseline_signed_distance").weight, 6.0 * 100.0, 1e-9);
  EXPECT_NEAR(in(rows, "organ", "normal_motion").weight, 6.0 * 100.0, 1e-9);
  EXPECT_NEAR(in(rows, "organ", "signed_distance").weight, 4.0 * 140.0 + 2.0 * 100.0, 1e-9);
}

TEST(RegionMeasures, TheInnermostShellIsOneCell)
{
  const HexMesh small = analytic::cubeLattice(20, 2.0);
  HexMesh       large = small;
  for (Vector3 & node : large.nodes)
  {
    node += 0.003 * node[0] * node[0] * Vector3::UnitX();
  }
  const auto rows =
    regionRows(small, compareWithBaseline(small, large, AlignmentKind::None, 1), chosenRegions({ "shells" }, 20));
  for (const char * measure : { "displacement", "strain_1", "volumetric", "largest_stretch" })
  {
    const WeightedDistribution & values = in(rows, "shell-1", measure);
    EXPECT_EQ(values.minimum, values.maximum) << measure;
    EXPECT_LT(in(rows, "shell-2", measure).minimum, values.minimum) << measure;
  }
}

TEST(RegionMeasures, OnlyLinesThatCrossTheOrganAreItsThickness)
{
  HexMesh bulged = box(); // edges of the cube along i are drawn out, lines inside are not
  for (int i = 0; i < 6; ++i)
  {
    bulged.nodes[bulged.nodeNumber(i, 0, 0)][0] *= 1.05;
  }
  const auto rows = regionRows(box(), compareWithBaseline(box(), bulged, AlignmentKind::None, 1), {});
  EXPECT_NEAR(in(rows, "organ", "thickness_change").maximum, 0.0, 1e-12);
}

TEST(RegionMeasures, ALatticeOfOneCellHasNoThickness)
{
  const HexMesh cell = analytic::cubeLattice(2, 2.0);
  const auto    rows = regionRows(cell, compareWithBaseline(cell, cell, AlignmentKind::None, 1), {});
  EXPECT_THROW((void)in(rows, "organ", "thickness_change"), InvalidInput);
  EXPECT_NO_THROW((void)in(rows, "organ", "signed_distance"));
}

TEST(RegionMeasures, RegionsWithoutSurfaceHaveNoRowOfIt)
{
  const auto rows =
    regionRows(box(), compareWithBaseline(box(), grown(), AlignmentKind::None, 1), chosenRegions({ "shells" }, 6));
  EXPECT_THROW((void)in(rows, "shell-2", "normal_motion"), InvalidInput);
  EXPECT_NO_THROW((void)in(rows, "shell-2", "strain_1"));
  EXPECT_NO_THROW((void)in(rows, "shell-3", "normal_motion"));
}

TEST(RegionMeasures, VolumesAreThoseOfTheOrganAlsoWhenItsSizeIsTakenAway)
{
  HexMesh large = box();
  for (Vector3 & node : large.nodes)
  {
    node = 1.5 * node + Vector3(1, 2, 3);
  }
  const auto comparison = compareWithBaseline(box(), large, AlignmentKind::Similarity, 1);
  const auto rows = regionRows(box(), comparison, {});
  EXPECT_NEAR(rows.front().volume, 3375.0, 1e-8);
  EXPECT_NEAR(comparison.latticeVolumeChange, 237.5, 1e-9);
  EXPECT_NEAR(in(rows, "organ", "displacement").maximum, 0.0, 1e-12);
}

TEST(RegionMeasures, TheBaselineHasNotChangedToTheLastBit)
{
  const TimeComparison none = unchanged(grown(), 1);
  for (const Measure & measure : measuresOf(none))
  {
    const double expected = measure.name == "largest_stretch" || measure.name == "area_ratio" ? 1.0 : 0.0;
    EXPECT_EQ(measure.values, std::vector<double>(measure.values.size(), expected)) << measure.name;
  }
}

TEST(ComparisonSummary, TheLargestStretchHasACellAPlaceAndADirection)
{
  const LargestStretch largest =
    largestStretchOf(box(), compareWithBaseline(box(), grown(), AlignmentKind::None, 1).cells);
  EXPECT_EQ(largest.cell[0], 4);
  EXPECT_NEAR(largest.place[0], 9.0, 1e-12);
  EXPECT_NEAR(largest.direction[0], 1.0, 1e-12);
}

TEST(ComparisonSummary, GrowthIsUniformOnlyWhereAllCellsGrowAlike)
{
  EXPECT_FALSE(isUniformGrowth(compareWithBaseline(box(), grown(), AlignmentKind::None, 1).cells));
  EXPECT_TRUE(isUniformGrowth(compareWithBaseline(box(), analytic::cubeLattice(6, 3.0), AlignmentKind::None, 1).cells));
}
