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

/** About an axis along the first one through the middle. */
HexMesh
turned(const HexMesh & mesh, double degrees)
{
  const Matrix3 turn = analytic::rotation(Vector3::UnitX(), degrees * pi / 180.0);
  const Vector3 middle = 0.5 * (mesh.nodes.front() + mesh.nodes.back());
  return transformed(mesh, { 1.0, turn, middle - turn * middle });
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

namespace
{

HexMesh
shifted(const HexMesh & mesh, const Vector3 & shift)
{
  return transformed(mesh, { 1.0, Matrix3::Identity(), shift });
}

} // namespace

TEST(Comparison, VisitsThatAreNotRegisteredAreAWarningWithoutAnAlignment)
{
  const HexMesh baseline = analytic::cubeLattice(5, 2.0); // the ball of its volume has a radius of 5 mm
  EXPECT_TRUE(warningsOf(seriesOf(baseline, shifted(baseline, { 0.5, 0, 0 })), "none").empty());
  EXPECT_TRUE(warningsOf(seriesOf(baseline, shifted(baseline, { 30, 0, 0 })), "rigid").empty());
  const auto warnings = warningsOf(seriesOf(baseline, shifted(baseline, { 30, 0, 0 })), "none");
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].find("b.vtu: its surface lies 2"), 0u) << warnings[0];
}

TEST(Comparison, ATransformTheWrongWayRoundIsAWarning)
{
  const HexMesh             baseline = analytic::cubeLattice(5, 2.0);
  const SimilarityTransform toFollowUp{ 1.0, Matrix3::Identity(), Vector3(10, 0, 0) };
  TimeSeries                series = seriesOf(baseline, transformed(baseline, toFollowUp));
  series.points[1].transform.name = "t.tfm";
  series.points[1].alignment = toFollowUp.inverse();
  EXPECT_TRUE(warningsOf(series, "file").empty());
  series.points[1].alignment = toFollowUp;
  const auto warnings = warningsOf(series, "file");
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].find("t.tfm: its inverse brings the surfaces to 0.0 mm instead of 1"), 0u) << warnings[0];
  series.points[1].alignment = SimilarityTransform{ 1.0, Matrix3::Identity(), Vector3(0, 20, 0) };
  const auto ofOther = warningsOf(series, "file");
  ASSERT_EQ(ofOther.size(), 1u);
  EXPECT_NE(ofOther[0].find("is it the transform of these visits?"), std::string::npos) << ofOther[0];
}

TEST(Comparison, ChangeOfVolumeIsThatOfTheWholeOrgan)
{
  TimeSeries series = seriesOf(analytic::cubeLattice(4), analytic::cubeLattice(4));
  series.points[0].volume = 100.0;
  series.points[1].volume = 130.0; // all of it in the padding
  EXPECT_NEAR(volumeChange(series, 1), 30.0, 1e-9);
  EXPECT_NEAR(compareSeries(series, "none", {}, 1).times[1].latticeVolumeChange, 0.0, 1e-9);
}
