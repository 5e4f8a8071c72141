// Topology and unchanged voxels are exact. Areas of cuts in voxels: a digital disc has its area within the length of
// its rim, so a cut is at most a fifth larger than the narrowest cross-section.
#include "TestShapes.h"
#include "moserhex/Analytic/Refusals.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/LevelSet/TopologyRepair.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace moserhex;
using test::labelOf;

namespace
{

double
torusDistance(const Vector3 & p, double large, double small)
{
  return std::hypot(std::hypot(p.x(), p.y()) - large, p.z()) - small;
}

/** Distance to a handle in the plane z = 0 that leaves the ball of radius 8 at x = 8. */
double
handleDistance(const Vector3 & p, double large, double small)
{
  return torusDistance(p - Vector3(8.0, 0.0, 0.0), large, small);
}

/** A ball of radius 8 with a handle of the given thickness. */
LabelVolume
ballWithHandle(double small)
{
  return labelOf({ { 41, 27, 19 } }, Vector3::Ones(), [&](const Vector3 & p) {
    return std::min((p + Vector3(6, 0, 0)).norm() - 8.0, handleDistance(p + Vector3(6, 0, 0), 7.0, small));
  });
}

LabelVolume
ballWithPore(const Vector3 & spacing = Vector3::Ones())
{
  LabelVolume label = labelOf({ { 21, 21, 21 } }, spacing, [&](const Vector3 & p) { return p.norm() - 8.0; });
  for (int k = 0; k < 21; ++k)
  {
    label.inside[label.voxelNumber(10, 10, k)] = 0;
  }
  return label;
}

TopologyRepairResult
repairAll(const LabelVolume & label, double radius = 0.0)
{
  TopologyRepairOptions options;
  options.maximumChange = 1.0;
  options.radius = radius;
  TopologyRepairResult result = repairTopology(label, options);
  EXPECT_TRUE(voxelTopology(result.label).isBall());
  std::size_t added = 0;
  std::size_t removed = 0;
  for (std::size_t voxel = 0; voxel < label.inside.size(); ++voxel)
  {
    added += label.inside[voxel] == 0 && result.label.inside[voxel] != 0 ? 1 : 0;
    removed += label.inside[voxel] != 0 && result.label.inside[voxel] == 0 ? 1 : 0;
  }
  EXPECT_EQ(result.report.voxelsAdded, added);
  EXPECT_EQ(result.report.voxelsRemoved, removed);
  return result;
}

std::vector<TopologyChangeKind>
kindsOf(const TopologyRepairReport & report)
{
  std::vector<TopologyChangeKind> kinds;
  for (const TopologyChange & change : report.changes)
  {
    kinds.push_back(change.kind);
  }
  return kinds;
}

using Kinds = std::vector<TopologyChangeKind>;
constexpr auto removedPart = TopologyChangeKind::ComponentRemoved;
constexpr auto joinedPart = TopologyChangeKind::ComponentsJoined;
constexpr auto filledCavity = TopologyChangeKind::CavityFilled;
constexpr auto cutHandle = TopologyChangeKind::HandleCut;
constexpr auto filledTunnel = TopologyChangeKind::TunnelFilled;

} // namespace

TEST(TopologyRepair, TorusIsCutAcross)
{
  const auto label =
    labelOf({ { 40, 40, 11 } }, Vector3::Ones(), [](const Vector3 & p) { return torusDistance(p, 14.0, 4.0); });
  const auto result = repairAll(label);
  ASSERT_EQ(kindsOf(result.report), Kinds{ cutHandle });
  EXPECT_EQ(result.report.changes[0].handles, 1u);
  EXPECT_EQ(result.report.before.handles(), 1);
  const double crossSection = pi * 4.0 * 4.0;
  EXPECT_LT(static_cast<double>(result.report.changes[0].voxels), 1.2 * crossSection);
  EXPECT_GT(static_cast<double>(result.report.changes[0].voxels), crossSection / std::sqrt(3.0)); // across a diagonal
  const Vector3 centre = result.report.changes[0].centre;
  EXPECT_LT(std::abs(torusDistance(centre, 14.0, 0.0)), 1.5) << centre.transpose();
}

TEST(TopologyRepair, TorusIsCutWhereItIsNarrowest)
{
  const auto label = labelOf({ { 40, 40, 13 } }, Vector3::Ones(), [](const Vector3 & p) {
    return torusDistance(p, 13.0, p.x() > 0 && std::abs(p.y()) < 1.0 ? 2.0 : 5.0);
  });
  const auto result = repairAll(label);
  ASSERT_EQ(kindsOf(result.report), Kinds{ cutHandle });
  EXPECT_LE(result.report.changes[0].voxels, 16u);
  EXPECT_LT((result.report.changes[0].centre - Vector3(13, 0, 0)).norm(), 1.5);
}

TEST(TopologyRepair, PoreOfOneVoxelIsFilledNotCut)
{
  const auto result = repairAll(ballWithPore());
  ASSERT_EQ(kindsOf(result.report), Kinds{ filledTunnel });
  EXPECT_EQ(result.report.changes[0].voxels, 1u);
  EXPECT_EQ(result.report.changes[0].handles, 1u);
}

TEST(TopologyRepair, ThinHandleIsCutNotFilled)
{
  const auto result = repairAll(ballWithHandle(1.6));
  ASSERT_EQ(kindsOf(result.report), Kinds{ cutHandle });
  EXPECT_LE(result.report.changes[0].voxels, 12u);
}

TEST(TopologyRepair, OfTwoHandlesOneIsCutAndTheOtherFilled)
{
  LabelVolume label = ballWithHandle(1.6);
  const int   i = 20 - 10; // through the ball's side, away from the handle
  for (int k = 0; k < 19; ++k)
  {
    label.inside[label.voxelNumber(i, 13, k)] = 0;
  }
  const auto result = repairAll(label);
  EXPECT_EQ(result.report.before.handles(), 2);
  EXPECT_EQ(kindsOf(result.report), (Kinds{ filledTunnel, cutHandle }));
}

TEST(TopologyRepair, KnottedTubeIsCutOnce)
{
  const auto label = labelOf({ { 46, 46, 24 } }, Vector3::Ones(), [](const Vector3 & p) {
    double nearest = HUGE_VAL; // trefoil
    for (int step = 0; step < 300; ++step)
    {
      const double t = 2.0 * pi * step / 300.0;
      const double r = 13.0 + 6.0 * std::cos(3.0 * t);
      nearest =
        std::min(nearest, (p - Vector3(r * std::cos(2.0 * t), r * std::sin(2.0 * t), 7.0 * std::sin(3.0 * t))).norm());
    }
    return nearest - 2.2;
  });
  ASSERT_EQ(voxelTopology(label).handles(), 1);
  const auto result = repairAll(label);
  EXPECT_EQ(kindsOf(result.report), Kinds{ cutHandle });
  EXPECT_LT(result.report.changes[0].voxels, 30u); // the tube's cross-section has 15
}

TEST(TopologyRepair, CavitiesAreFilledAndNamed)
{
  LabelVolume label = labelOf({ { 21, 21, 21 } }, Vector3::Ones(), [](const Vector3 & p) { return p.norm() - 8.0; });
  label.inside[label.voxelNumber(10, 10, 12)] = 0;
  label.inside[label.voxelNumber(10, 10, 13)] = 0;
  label.inside[label.voxelNumber(10, 10, 6)] = 0;
  const auto result = repairAll(label);
  ASSERT_EQ(kindsOf(result.report), (Kinds{ filledCavity, filledCavity }));
  EXPECT_EQ(result.report.changes[1].voxels, 2u);
  EXPECT_EQ(result.report.changes[1].parts, 1u);
  EXPECT_LT((result.report.changes[1].centre - Vector3(0, 0, 2.5)).norm(), 1e-12);
}

TEST(TopologyRepair, SmallIslandIsRemovedAndLargeOneJoined)
{
  const auto twoBalls = [](double small) {
    return labelOf({ { 41, 21, 21 } }, Vector3::Ones(), [&](const Vector3 & p) {
      return std::min((p + Vector3(10, 0, 0)).norm() - 8.0, (p - Vector3(2.0 + small, 0, 0)).norm() - small);
    });
  };
  const auto removed = repairAll(twoBalls(1.0));
  ASSERT_EQ(kindsOf(removed.report), Kinds{ removedPart });
  EXPECT_EQ(removed.report.changes[0].parts, 1u);
  const auto joined = repairAll(twoBalls(6.2));
  ASSERT_EQ(kindsOf(joined.report), Kinds{ joinedPart });
  EXPECT_EQ(joined.report.changes[0].parts, 1u);
  EXPECT_LE(joined.report.changes[0].voxels, 4u); // straight across the gap
  const auto wide = repairAll(twoBalls(6.2), 2.0);
  ASSERT_EQ(kindsOf(wide.report), Kinds{ joinedPart });
  EXPECT_GT(wide.report.changes[0].voxels, 2u * 12u); // a disc of radius 2, at least two voxels deep
}

TEST(TopologyRepair, SeedIsTheLargestComponentThoughAnotherIsDeeper)
{
  // A plate larger than the ball beside it, and shallower.
  const auto label = labelOf({ { 60, 40, 13 } }, Vector3::Ones(), [](const Vector3 & p) {
    const bool plate = std::abs(p.z()) < 1.6 && p.x() < 10.0 && p.x() > -28.0 && std::abs(p.y()) < 18.0;
    return plate || (p - Vector3(20, 0, 0)).norm() < 5.0 ? -1.0 : 1.0;
  });
  const auto result = repairAll(label);
  EXPECT_EQ(kindsOf(result.report), Kinds{ joinedPart });
}

TEST(TopologyRepair, CutsAndPlugsReachAsFarAsTheRadiusInMillimetres)
{
  const Vector3 spacing(0.5, 1.0, 2.0);
  const auto label = labelOf({ { 80, 40, 7 } }, spacing, [](const Vector3 & p) { return torusDistance(p, 13.0, 4.0); });
  const auto thin = repairAll(label);
  const auto wide = repairAll(label, 2.0);
  ASSERT_EQ(kindsOf(wide.report), Kinds{ cutHandle });
  // From a sheet one voxel thick to 2 mm on both sides of it.
  const double thickness = static_cast<double>(wide.report.voxelsRemoved) * label.voxelVolume() / (pi * 16.0);
  EXPECT_NEAR(thickness, 4.5, 1.2);
  EXPECT_LT(thin.report.voxelsRemoved, wide.report.voxelsRemoved / 2);
}

TEST(TopologyRepair, ChoiceFollowsMillimetresNotVoxels)
{
  // A square ring of 7 mm cross-section sides whose hole is long along one axis: the plug needs as many voxels as the
  // hole is wide, the cut as many as the ring is thick, and which is less depends on the voxels.
  const auto ring = [](const Vector3 & spacing, const std::array<int, 3> & size) {
    return labelOf(size, spacing, [](const Vector3 & p) {
      const bool hole = std::abs(p.x()) < 3.0 && std::abs(p.y()) < 3.0;
      return std::abs(p.x()) < 9.0 && std::abs(p.y()) < 9.0 && std::abs(p.z()) < 4.0 && !hole ? -1.0 : 1.0;
    });
  };
  // Plug 6 x 6 mm, one voxel thick along z; cut 6 x 8 mm, one voxel thick along x or y.
  EXPECT_EQ(kindsOf(repairAll(ring(Vector3(1, 1, 0.5), { { 22, 22, 20 } })).report), Kinds{ filledTunnel });
  EXPECT_EQ(kindsOf(repairAll(ring(Vector3(1, 1, 4), { { 22, 22, 4 } })).report), Kinds{ cutHandle });
}

TEST(TopologyRepair, BallComesBackBitForBit)
{
  LabelVolume label = labelOf({ { 25, 23, 9 } }, Vector3(0.8, 0.8, 3.0), [](const Vector3 & p) {
    return p.cwiseQuotient(Vector3(9, 8, 13)).norm() - 1.0;
  });
  label.inside[label.voxelNumber(12, 11, 4)] = 7; // any value but 0 is inside
  const auto result = repairTopology(label, {});
  EXPECT_EQ(result.label.inside, label.inside);
  EXPECT_TRUE(result.report.changes.empty());
  EXPECT_EQ(result.report.changedFraction(), 0.0);
  EXPECT_TRUE(describe(result.report).empty());
}

TEST(TopologyRepair, ObliqueAndLeftHandedImagesChangeTheSameVoxels)
{
  const LabelVolume label = ballWithHandle(1.6);
  const auto        expected = repairAll(label);
  LabelVolume       moved = label;
  moved.direction = Eigen::AngleAxisd(0.7, Vector3(1, 2, -1).normalized()).toRotationMatrix();
  moved.direction.col(1) *= -1.0;
  moved.origin = Vector3(50, -30, 110);
  const auto actual = repairAll(moved);
  EXPECT_EQ(actual.label.inside, expected.label.inside);
  const Vector3 index = label.continuousIndex(expected.report.changes[0].centre);
  EXPECT_LT((moved.continuousIndex(actual.report.changes[0].centre) - index).norm(), 1e-9);
}

TEST(TopologyRepair, FlippedVoxelsGetTheSameKindsOfChange)
{
  LabelVolume label = ballWithHandle(1.6);
  label.inside[label.voxelNumber(2, 2, 2)] = 1;
  const auto expected = repairAll(label);
  std::reverse(label.inside.begin(), label.inside.end());
  const auto actual = repairAll(label);
  EXPECT_EQ(kindsOf(actual.report), kindsOf(expected.report));
  EXPECT_EQ(actual.report.voxelsRemoved, expected.report.voxelsRemoved);
}

TEST(TopologyRepair, RandomVoxelsBecomeABall)
{
  for (std::uint64_t seed = 0; seed < 12; ++seed)
  {
    const LabelVolume label =
      test::randomLabel({ { 13, 12, 11 } }, 0.15 + 0.07 * static_cast<double>(seed), 100 + seed);
    (void)repairAll(label);
    (void)repairAll(label, 1.5);
    EXPECT_EQ(repairAll(label).label.inside, repairAll(label).label.inside) << "seed " << seed;
  }
}

TEST(TopologyRepair, MoreThanAllowedIsRefusedWithTheNumbers)
{
  const auto label =
    labelOf({ { 40, 40, 11 } }, Vector3::Ones(), [](const Vector3 & p) { return torusDistance(p, 14.0, 4.0); });
  TopologyRepairOptions options;
  options.labelName = "label 3";
  options.maximumChange = 0.001;
  const auto  needed = repairAll(label).report;
  const auto  message = analytic::messageOf([&] { (void)repairTopology(label, options); });
  std::size_t at = 0;
  EXPECT_EQ(message.find("label 3: 1 handle, V-E+F = 0, need 2 (genus 0); a repair changes >= "), 0u) << message;
  EXPECT_NEAR(std::stod(message.substr(message.find(">= ") + 3), &at), 100.0 * needed.changedFraction(), 0.01);
  EXPECT_NE(message.find(" % of it, limit 0.1 %"), std::string::npos) << message;
  options.maximumChange = needed.changedFraction();
  EXPECT_EQ(repairTopology(label, options).report.voxelsRemoved, needed.voxelsRemoved);
  try
  {
    options.maximumChange = 0.0;
    (void)repairTopology(label, options);
    FAIL();
  }
  catch (const InvalidInput & error)
  {
    EXPECT_EQ(error.code(), ErrorCode::Topology);
  }
}

TEST(TopologyRepair, ManyHandlesAreRefusedAtOnce)
{
  LabelVolume label = labelOf({ { 40, 40, 40 } }, Vector3::Ones(), [](const Vector3 &) { return -1.0; });
  for (int k = 0; k < 40; ++k)
  {
    for (int j = 0; j < 40; ++j)
    {
      for (int i = 0; i < 40; ++i)
      {
        const int open = (i % 4 < 2 ? 1 : 0) + (j % 4 < 2 ? 1 : 0) + (k % 4 < 2 ? 1 : 0);
        label.inside[label.voxelNumber(i, j, k)] = open >= 2 ? 0 : 1;
      }
    }
  }
  TopologyRepairOptions options;
  options.radius = 2.0;
  EXPECT_NE(analytic::messageOf([&] { (void)repairTopology(label, options); }).find("handles"), std::string::npos);
}

TEST(TopologyRepair, NoiseIsRefusedBeforeAnyWork)
{
  const LabelVolume label = test::randomLabel({ { 60, 60, 60 } }, 0.05, 1);
  const auto        message = analytic::messageOf([&] { (void)repairTopology(label); });
  EXPECT_NE(message.find("components, "), std::string::npos) << message;
  EXPECT_NE(message.find(" % of it, limit 5 %"), std::string::npos) << message;
}

TEST(TopologyRepair, RadiusShrinksWhereTheLimitAllowsNoMore)
{
  const auto label =
    labelOf({ { 40, 40, 11 } }, Vector3::Ones(), [](const Vector3 & p) { return torusDistance(p, 14.0, 4.0); });
  TopologyRepairOptions options;
  options.maximumChange = 0.02; // 89 of 4446 voxels: one sheet of 52
  options.radius = 4.0;
  EXPECT_EQ(repairTopology(label, options).report.voxelsRemoved, repairAll(label).report.voxelsRemoved);
}

TEST(TopologyRepair, BadOptionsAndEmptyLabelsAreRefused)
{
  const LabelVolume     label = ballWithPore();
  TopologyRepairOptions options;
  options.maximumChange = -0.1;
  EXPECT_THROW((void)repairTopology(label, options), InvalidInput);
  options = {};
  options.radius = NAN;
  EXPECT_THROW((void)repairTopology(label, options), InvalidInput);
  EXPECT_THROW((void)repairTopology(labelOf({ { 3, 3, 3 } }, Vector3::Ones(), [](const Vector3 &) { return 1.0; })),
               InvalidInput);
}

TEST(DescribeTopologyRepair, HasOneShortLinePerKindWithVoxelsVolumeShareAndPlace)
{
  TopologyRepairReport report;
  report.labelVoxels = 100000;
  report.voxelVolume = 0.25;
  report.changes = { { removedPart, 1, 0, 7, Vector3(1, 2, 3) },  { cutHandle, 0, 2, 30, Vector3(-12.34, 5, 100) },
                     { removedPart, 1, 0, 13, Vector3(4, 5, 6) }, { joinedPart, 1, 0, 1, Vector3(0, 0, 0) },
                     { filledCavity, 1, 0, 2, Vector3(0, 0, 0) }, { filledTunnel, 0, 1, 3, Vector3(0, 0, 0) } };
  const std::vector<std::string> lines = describe(report);
  ASSERT_EQ(lines.size(), 5u);
  EXPECT_EQ(
    lines[0],
    "2 separate parts left out: 20 voxels removed, 5 mm^3, 0.02 % of the label, the largest at 4.0, 5.0, 6.0 mm "
    "LPS");
  EXPECT_EQ(lines[1],
            "1 separate part joined to the rest: 1 voxel added, 0.25 mm^3, 0.001 % of the label at 0.0, 0.0, "
            "0.0 mm LPS");
  EXPECT_EQ(lines[2].find("1 cavity filled: 2 voxels added"), 0u);
  EXPECT_EQ(lines[3], "2 handles cut: 30 voxels removed, 7.5 mm^3, 0.03 % of the label at -12.3, 5.0, 100.0 mm LPS");
  EXPECT_EQ(lines[4].find("1 tunnel filled: 3 voxels added"), 0u);
}

TEST(DescribeVoxelTopology, NamesWhatIsNotAsInABall)
{
  VoxelTopology topology;
  topology.components = 2;
  topology.cavities = 1;
  topology.eulerCharacteristic = 2; // one handle
  EXPECT_EQ(describe(topology), "2 components, 1 cavity, 1 handle, V-E+F = 4, need 2 (genus 0)");
}
