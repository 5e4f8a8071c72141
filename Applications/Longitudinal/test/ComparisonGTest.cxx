// Exact: what is said of the meshes that are compared. Volumes to 1e-9.
#include "Comparison.h"

#include "moserhex/Analytic/Lattices.h"
#include "moserhex/Analytic/Refusals.h"
#include "moserhex/Analytic/SurfaceShapes.h"
#include "moserhex/HexMeshIO/FileErrors.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace moserhex;
using namespace moserhex::app;

namespace
{

TimePoint
pointOf(const std::string & file, const HexMesh & lattice)
{
  TimePoint point;
  point.file = { file, "" };
  point.lattice = lattice;
  return point;
}

TimeSeries
seriesOf(const HexMesh & baseline, const HexMesh & followUp)
{
  TimeSeries series;
  series.points = { pointOf("a.vtu", baseline), pointOf("b.vtu", followUp) };
  return series;
}

std::vector<std::string>
warningsOf(const TimeSeries & series, const std::string & align)
{
  return compareSeries(series, align, {}, 1).series.warnings;
}

/** About the first axis. */
HexMesh
turned(const HexMesh & mesh, double degrees)
{
  const Matrix3 turn = analytic::rotation(Vector3::UnitX(), degrees * std::acos(-1.0) / 180.0);
  HexMesh       result = mesh;
  for (Vector3 & node : result.nodes)
  {
    node = turn * node;
  }
  return result;
}

} // namespace

TEST(Comparison, ACellWithoutVolumeIsReportedWithItsFile)
{
  HexMesh bad = analytic::cubeLattice(4);
  bad.nodes[0] = Vector3(2, 2, 2);
  const auto refusal = [](const HexMesh & baseline, const HexMesh & followUp) {
    return analytic::messageOf<BadInput>([&] { (void)compareSeries(seriesOf(baseline, followUp), "none", {}, 1); });
  };
  EXPECT_EQ(refusal(analytic::cubeLattice(4), bad).find("b.vtu: cell 0 of the follow-up"), 0u)
    << refusal(analytic::cubeLattice(4), bad);
  EXPECT_EQ(refusal(bad, analytic::cubeLattice(4)).find("a.vtu: cell 0 of the baseline"), 0u)
    << refusal(bad, analytic::cubeLattice(4));
}

TEST(Comparison, ALatticeThatLiesTurnedIsWarnedOfWhateverTheAlignment)
{
  const HexMesh baseline = analytic::cubeLattice(5, 2.0);
  for (const char * align : { "rigid", "similarity", "none" })
  {
    EXPECT_TRUE(warningsOf(seriesOf(baseline, turned(baseline, 15.0)), align).empty()) << align;
    const auto warnings = warningsOf(seriesOf(baseline, turned(baseline, 90.0)), align);
    ASSERT_EQ(warnings.size(), 1u) << align;
    EXPECT_EQ(warnings[0].find("b.vtu: its nodes lie turned by 90 degrees"), 0u) << warnings[0];
  }
}

TEST(Comparison, ATurnThatATransformHasTakenAwayIsNoWarning)
{
  const HexMesh baseline = analytic::cubeLattice(5, 2.0);
  TimeSeries    series = seriesOf(baseline, turned(baseline, 90.0));
  series.points[1].alignment = latticeAlignment(series.points[1].lattice, baseline, AlignmentKind::Rigid);
  EXPECT_TRUE(warningsOf(series, "file").empty());
  series.points[1].lattice = baseline;
  EXPECT_EQ(warningsOf(series, "file").size(), 1u);
}

TEST(Comparison, ChangeOfVolumeIsThatOfTheWholeOrgan)
{
  TimeSeries series = seriesOf(analytic::cubeLattice(4), analytic::cubeLattice(4));
  series.points[0].volume = 100.0;
  series.points[1].volume = 130.0; // all of it in the padding
  EXPECT_NEAR(volumeChange(series, 1), 30.0, 1e-9);
  EXPECT_NEAR(compareSeries(series, "none", {}, 1).times[1].latticeVolumeChange, 0.0, 1e-9);
}
