// Topology and determinism are exact; volumes to 1e-6 (the promise); distances to a fraction of the grid spacing, which
// is what interpolation between voxels can give; moved images to 1e-9 mm.
#include "TestShapes.h"
#include "moserhex/Analytic/Refusals.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Geometry/TriangleTopology.h"
#include "moserhex/LevelSet/CubicInterpolation.h"
#include "moserhex/LevelSet/LabelConditioning.h"
#include "moserhex/LevelSet/MarchingTetrahedra.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace moserhex;
using test::labelOf;

namespace
{

constexpr double radius = 18.0;

double
ballDistance(const Vector3 & p)
{
  return p.norm() - radius;
}

LabelVolume
ballLabel(const std::array<int, 3> & size, const Vector3 & spacing)
{
  return labelOf(size, spacing, ballDistance);
}

/** Fast: a coarse grid is enough for most of what is tested here. */
ConditioningOptions
coarse()
{
  ConditioningOptions options;
  options.nodesPerSide = 8;
  return options;
}

/** An ellipsoid with two bumps: no symmetry. */
double
lobulated(const Vector3 & p)
{
  const double body = p.cwiseQuotient(Vector3(20, 15, 17)).norm() - 1.0;
  const double bumps = 0.15 * std::sin(0.4 * p.x() + 1.0) * std::cos(0.3 * p.y());
  return 15.0 * (body + bumps);
}

void
expectSpheresAround(const LevelSet & phi)
{
  for (const double level : { -0.25, -0.1, 0.0, 0.1, 0.25 })
  {
    EXPECT_TRUE(summarizeTopology(marchingTetrahedra(phi, level * phi.grid.spacing)).isSphere()) << "level " << level;
  }
}

std::string
refusalOf(const LabelVolume & label, const ConditioningOptions & options)
{
  return analytic::messageOf([&] { (void)conditionLabel(label, options); });
}

} // namespace

TEST(LabelConditioning, BallComesOutAsItsSignedDistance)
{
  const auto              solid = conditionLabel(ballLabel({ { 45, 45, 45 } }, Vector3::Ones()));
  const CubicInterpolator phi(solid.levelSet);
  Random                  random(1);
  double                  squares = 0.0;
  double                  slopeSquares = 0.0;
  constexpr int           points = 1000;
  for (int n = 0; n < points; ++n)
  {
    const Vector3 direction = Vector3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)).normalized();
    const Vector3 p = random.uniform(0.5, 1.05) * radius * direction;
    const double  error = phi.value(p) - ballDistance(p);
    EXPECT_LT(std::abs(error), 0.6); // flat caps of the voxelised ball are half a voxel off
    squares += error * error;
    slopeSquares += std::pow(phi.at(radius * direction).gradient.norm() - 1.0, 2);
  }
  EXPECT_LT(std::sqrt(squares / points), 0.25);
  EXPECT_LT(std::sqrt(slopeSquares / points), 0.03);
  EXPECT_GT(solid.report.dice, 0.99);
  expectSpheresAround(solid.levelSet);
}

TEST(LabelConditioning, VolumeOfTheLabelIsKept)
{
  for (const double thickness : { 1.0, 3.0, 6.0 })
  {
    const auto label =
      labelOf({ { 55, 45, static_cast<int>(48.0 / thickness) } }, Vector3(1.0, 1.0, thickness), lobulated);
    const auto solid = conditionLabel(label, coarse());
    EXPECT_EQ(solid.labelVolume, static_cast<double>(voxelCount(label)) * label.voxelVolume());
    EXPECT_NEAR(enclosedVolume(marchingTetrahedra(solid.levelSet, 0.0)) / solid.labelVolume, 1.0, 1e-6);
    EXPECT_LT(std::abs(solid.report.volumeError), 1e-6);
    expectSpheresAround(solid.levelSet);
  }
}

TEST(LabelConditioning, ThickSlicesAreInterpolatedByShape)
{
  // 14:1, eleven slices. The solid is compared with the ball itself, not with its terraces.
  const auto              label = ballLabel({ { 101, 101, 11 } }, Vector3(0.4, 0.4, 5.6));
  const auto              solid = conditionLabel(label);
  const CubicInterpolator phi(solid.levelSet);
  EXPECT_EQ(solid.report.sliceAxis, 2);
  const RegularGrid & grid = solid.levelSet.grid;
  double              both = 0, either = 0;
  for (std::size_t node = 0; node < grid.nodeCount(); ++node)
  {
    const bool a = solid.levelSet.values[node] < 0.0;
    const bool b = ballDistance(grid.point(node)) < 0.0;
    both += a && b ? 2 : 0;
    either += (a ? 1 : 0) + (b ? 1 : 0);
  }
  EXPECT_GT(both / either, 0.97);
  expectSpheresAround(solid.levelSet);
}

TEST(LabelConditioning, AnyAxisMayBeTheThickOne)
{
  const Vector3       thick[3] = { { 5, 1, 1 }, { 1, 5, 1 }, { 1, 1, 5 } };
  std::vector<double> volumes;
  for (int axis = 0; axis < 3; ++axis)
  {
    std::array<int, 3> size{ { 45, 45, 45 } };
    size[static_cast<std::size_t>(axis)] = 9;
    const auto solid = conditionLabel(ballLabel(size, thick[axis]), coarse());
    EXPECT_EQ(solid.report.sliceAxis, axis);
    EXPECT_GT(solid.report.dice, 0.95);
    volumes.push_back(solid.labelVolume);
  }
  EXPECT_EQ(volumes[0], volumes[2]);
}

TEST(LabelConditioning, LabelCutByTheFirstAndLastSliceIsClosedHalfASliceOut)
{
  // Only slices |z| <= 9 of the ball are in the image.
  const auto label = ballLabel({ { 51, 51, 7 } }, Vector3(0.8, 0.8, 3.0));
  const auto solid = conditionLabel(label, coarse());
  EXPECT_EQ(solid.report.borders.names(), "first k, last k");
  expectSpheresAround(solid.levelSet);
  const CubicInterpolator phi(solid.levelSet);
  const double            spacing = solid.levelSet.grid.spacing;
  EXPECT_NEAR(phi.value(Vector3(0, 0, 10.5)), 0.0, spacing);
  EXPECT_NEAR(phi.value(Vector3(0, 0, -10.5)), 0.0, spacing);
  EXPECT_FALSE(conditionLabel(ballLabel({ { 51, 51, 17 } }, Vector3(0.8, 0.8, 3.0)), coarse()).report.borders.any());
}

TEST(LabelConditioning, ObliqueAndLeftHandedImagesGiveTheMovedSolid)
{
  const LabelVolume label = labelOf({ { 60, 50, 14 } }, Vector3(0.8, 0.8, 3.5), lobulated);
  const auto        expected = conditionLabel(label, coarse());
  const Matrix3     rotation = Eigen::AngleAxisd(0.7, Vector3(1, -2, 0.5).normalized()).toRotationMatrix();
  for (const double mirror : { 1.0, -1.0 })
  {
    const Matrix3 frame = rotation * Vector3(1, mirror, 1).asDiagonal();
    const Vector3 shift(120, -40, 600);
    LabelVolume   moved = label;
    moved.direction = frame * label.direction;
    moved.origin = frame * label.origin + shift;
    const auto actual = conditionLabel(moved, coarse());
    ASSERT_EQ(actual.levelSet.grid.size, expected.levelSet.grid.size);
    for (std::size_t node = 0; node < expected.levelSet.values.size(); node += 7)
    {
      EXPECT_NEAR(actual.levelSet.values[node], expected.levelSet.values[node], 1e-9);
      const Vector3 place = frame * expected.levelSet.grid.point(node) + shift;
      EXPECT_LT((actual.levelSet.grid.point(node) - place).norm(), 1e-9);
    }
    EXPECT_GT(enclosedVolume(marchingTetrahedra(actual.levelSet, 0.0)), 0.0);
  }
}

TEST(LabelConditioning, ResultScalesWithTheImage)
{
  const LabelVolume label = labelOf({ { 60, 50, 14 } }, Vector3(0.8, 0.8, 3.5), lobulated);
  LabelVolume       scaled = label;
  scaled.spacing *= 1e-3;
  scaled.origin *= 1e-3;
  const auto a = conditionLabel(label, coarse());
  const auto b = conditionLabel(scaled, coarse());
  ASSERT_EQ(a.levelSet.grid.size, b.levelSet.grid.size);
  for (std::size_t node = 0; node < a.levelSet.values.size(); node += 7)
  {
    EXPECT_NEAR(a.levelSet.values[node], 1e3 * b.levelSet.values[node], 1e-6);
  }
}

TEST(LabelConditioning, SmallPartsAreLeftOutAndCavitiesFilledAndReported)
{
  LabelVolume label = ballLabel({ { 45, 45, 45 } }, Vector3::Ones());
  const auto  clean = conditionLabel(label, coarse());
  EXPECT_TRUE(clean.report.repair.changes.empty());
  label.inside[label.voxelNumber(22, 22, 22)] = 0;
  label.inside[label.voxelNumber(22, 23, 22)] = 0;
  label.inside[label.voxelNumber(0, 0, 0)] = 1;
  const auto solid = conditionLabel(label, coarse());
  ASSERT_EQ(solid.report.repair.changes.size(), 2u);
  EXPECT_EQ(solid.report.repair.voxelsAdded, 2u);
  EXPECT_EQ(solid.report.repair.voxelsRemoved, 1u);
  EXPECT_EQ(solid.labelVolume, clean.labelVolume);
  EXPECT_EQ(solid.label.inside, clean.label.inside);
  EXPECT_EQ(solid.levelSet.values, clean.levelSet.values);
}

TEST(LabelConditioning, NonManifoldEdgesAreAccepted)
{
  // A finger that comes back to the body and meets it in the edge between two voxels only.
  LabelVolume label = ballLabel({ { 50, 45, 45 } }, Vector3::Ones());
  const int   right = 24 + 19; // beyond the ball
  for (int j = 22; j >= 4; --j)
  {
    label.inside[label.voxelNumber(right, j, 22)] = 1;
  }
  for (int i = right; i > 30; --i)
  {
    label.inside[label.voxelNumber(i, 4, 22)] = 1;
  }
  const VoxelTopology topology = voxelTopology(label);
  ASSERT_TRUE(topology.isBall());
  ASSERT_EQ(label.inside[label.voxelNumber(30, 5, 22)] + label.inside[label.voxelNumber(31, 4, 22)], 2);
  ASSERT_EQ(label.inside[label.voxelNumber(30, 4, 22)] + label.inside[label.voxelNumber(31, 5, 22)], 0);
  const auto solid = conditionLabel(label, coarse());
  expectSpheresAround(solid.levelSet);
}

TEST(LabelConditioning, TopologyIsProtectedWhereTheGridWouldJoinWhatTheLabelSeparates)
{
  // A closed ring but for a slit of one voxel: a ball in voxels, a ring on a grid of three voxels' spacing.
  const LabelVolume label = labelOf({ { 61, 61, 21 } }, Vector3::Ones(), [](const Vector3 & p) {
    const double ring = std::hypot(std::hypot(p.x(), p.y()) - 20.0, p.z()) - 8.0;
    const bool   slit = p.x() > 0.0 && std::abs(p.y()) < 0.6;
    return slit ? 1.0 : ring;
  });
  ASSERT_TRUE(voxelTopology(label).isBall());
  ConditioningOptions options;
  options.spacing = 3.0;
  const auto solid = conditionLabel(label, options);
  EXPECT_EQ(solid.report.eulerBefore, 0);
  EXPECT_GT(solid.report.nodesCut + solid.report.nodesFilled, 0u);
  EXPECT_LT(solid.report.changedVolumeFraction, 0.05);
  EXPECT_LT(std::abs(solid.report.volumeError), 1e-6);
  expectSpheresAround(solid.levelSet);
}

TEST(LabelConditioning, LabelWithAHandleIsRepairedOrRejectedWithItsNumbers)
{
  const LabelVolume   label = labelOf({ { 61, 61, 21 } }, Vector3::Ones(), [](const Vector3 & p) {
    return std::hypot(std::hypot(p.x(), p.y()) - 20.0, p.z()) - 8.0;
  });
  ConditioningOptions options = coarse();
  const auto          solid = conditionLabel(label, options);
  expectSpheresAround(solid.levelSet);
  EXPECT_EQ(solid.report.repair.before.handles(), 1);
  EXPECT_LT(solid.report.repair.changedFraction(), 0.05);
  EXPECT_LT(std::abs(solid.report.volumeError), 1e-6);
  ASSERT_EQ(warningsOf(solid.report).size(), 1u) << "and the smoothing leaves the cut open";

  options.topology = TopologyPolicy::Reject;
  options.labelName = "label 3";
  EXPECT_EQ(refusalOf(label, options), "label 3: 1 handle, V-E+F = 0, need 2 (genus 0)");
  EXPECT_NO_THROW((void)conditionLabel(ballLabel({ { 45, 45, 45 } }, Vector3::Ones()), options));
}

TEST(LabelConditioning, RepairBeyondTheLimitIsRefusedWithItsNumbers)
{
  const LabelVolume   label = labelOf({ { 61, 61, 21 } }, Vector3::Ones(), [](const Vector3 & p) {
    return std::hypot(std::hypot(p.x(), p.y()) - 20.0, p.z()) - 8.0;
  });
  ConditioningOptions options = coarse();
  options.maximumRepair = 0.001;
  EXPECT_NE(refusalOf(label, options).find("label: 1 handle, V-E+F = 0, need 2 (genus 0); a repair changes >= "),
            std::string::npos)
    << refusalOf(label, options);
}

namespace
{

/** Works, or says that the label is too thin. */
void
expectSolidOrThin(const LabelVolume & label, const std::string & what)
{
  ASSERT_TRUE(voxelTopology(label).isBall()) << what;
  try
  {
    const auto solid = conditionLabel(label);
    EXPECT_LT(std::abs(solid.report.volumeError), 1e-6) << what;
    EXPECT_GE(solid.report.dice, 0.8) << what;
    expectSpheresAround(solid.levelSet);
  }
  catch (const InvalidInput & error)
  {
    EXPECT_EQ(error.code(), ErrorCode::Thin) << what << ": " << error.what();
    EXPECT_NE(std::string(error.what()).find("too thin"), std::string::npos) << what << ": " << error.what();
  }
}

} // namespace

TEST(LabelConditioning, VerySmallAndThinLabelsWorkOrAreRefusedAsThin)
{
  const auto box = [](int i, int j, int k, const Vector3 & spacing) {
    return labelOf({ { i + 4, j + 4, k + 4 } }, spacing, [&](const Vector3 & p) {
      return (p.cwiseAbs() - 0.5 * spacing.cwiseProduct(Vector3(i, j, k))).maxCoeff();
    });
  };
  for (const Vector3 & spacing : { Vector3(1, 1, 1), Vector3(0.5, 0.5, 3.0) })
  {
    const std::string voxel = spacing.z() > 1 ? "thick " : "";
    expectSolidOrThin(box(1, 1, 1, spacing), voxel + "one voxel");
    expectSolidOrThin(box(2, 1, 1, spacing), voxel + "two voxels");
    expectSolidOrThin(box(1, 1, 12, spacing), voxel + "row along k");
    expectSolidOrThin(box(12, 1, 1, spacing), voxel + "row along i");
    expectSolidOrThin(box(15, 15, 1, spacing), voxel + "plate");
    expectSolidOrThin(box(1, 15, 15, spacing), voxel + "plate across i");
  }
  LabelVolume neck = box(21, 8, 8, Vector3::Ones());
  for (std::size_t voxel = 0; voxel < neck.inside.size(); ++voxel)
  {
    const int i = static_cast<int>(voxel) % neck.size[0];
    const int j = static_cast<int>(voxel) / neck.size[0] % neck.size[1];
    const int k = static_cast<int>(voxel) / (neck.size[0] * neck.size[1]);
    if (i >= 11 && i < 14 && !(j == 5 && k == 5))
    {
      neck.inside[voxel] = 0;
    }
  }
  expectSolidOrThin(neck, "neck of one voxel");
}

TEST(LabelConditioning, RoundingTakesSpursAwayAndFillsGrooves)
{
  // A ball with a spur of 3 mm and a pit of 3 mm across.
  const auto shape = [](const Vector3 & p) {
    const double spur = std::max(std::hypot(p.y(), p.z()) - 1.5, std::abs(p.x() - 21.0) - 6.0);
    const double pit = std::max(std::hypot(p.y(), p.z()) - 1.5, std::abs(p.x() + 15.0) - 6.0);
    return std::max(std::min(ballDistance(p), spur), -pit);
  };
  const LabelVolume   label = labelOf({ { 60, 44, 44 } }, { 1, 1, 1 }, shape);
  ConditioningOptions options = coarse();
  options.spacing = 0.8;
  const auto valueAt = [&](const ConditionedSolid & solid, const Vector3 & p) {
    return CubicInterpolator(solid.levelSet).value(p);
  };
  const ConditionedSolid plain = conditionLabel(label, options);
  options.roundingRadius = 4.0;
  const ConditionedSolid rounded = conditionLabel(label, options);
  EXPECT_EQ(rounded.report.rounding, 4.0);
  EXPECT_LT(valueAt(plain, { 23, 0, 0 }), 0.0);
  EXPECT_GT(valueAt(rounded, { 23, 0, 0 }), 0.0);
  EXPECT_GT(valueAt(plain, { -12, 0, 0 }), 0.0);
  EXPECT_LT(valueAt(rounded, { -12, 0, 0 }), 0.0);
  EXPECT_LT(valueAt(rounded, { 0, 16.5, 0 }), 0.0); // the ball stays
  EXPECT_GT(valueAt(rounded, { 0, 19.5, 0 }), 0.0);
  EXPECT_NEAR(rounded.report.volumeError, 0.0, 1e-6);
  expectSpheresAround(rounded.levelSet);
}

TEST(LabelConditioning, ABallOfRoundingThatFitsNowhereIsRefusedAsThin)
{
  ConditioningOptions options = coarse();
  options.roundingRadius = 30.0;
  try
  {
    (void)conditionLabel(ballLabel({ { 44, 44, 44 } }, { 1, 1, 1 }), options);
    FAIL() << "rounded by more than its radius";
  }
  catch (const InvalidInput & error)
  {
    EXPECT_EQ(error.code(), ErrorCode::Thin) << error.what();
  }
}

TEST(Simplification, IsFaithfulWithinItsBoundsOfDice)
{
  ConditioningReport first;
  first.dice = 0.98;
  first.sigma = 1.0;
  ConditioningReport simpler;
  simpler.dice = 0.961;
  EXPECT_TRUE(isFaithful(Simplification::Smoother, simpler, first));
  EXPECT_TRUE(isFaithful(Simplification::Rounder, simpler, first));
  simpler.dice = 0.955;
  EXPECT_FALSE(isFaithful(Simplification::Smoother, simpler, first));
  EXPECT_TRUE(isFaithful(Simplification::Rounder, simpler, first));
  simpler.dice = 0.949;
  EXPECT_FALSE(isFaithful(Simplification::Rounder, simpler, first));
  EXPECT_EQ(simplified(Simplification::Smoother, first, 8000.0, 21).minimumSigma, 1.5);
  EXPECT_EQ(simplified(Simplification::Rounder, first, 64000.0, 21).minimumSigma, 2.0); // a cell's edge
  EXPECT_EQ(simplified(Simplification::Rounder, first, 64000.0, 21).roundingRadius, 4.5);
}

TEST(LabelConditioning, TheGridReachesBeyondTheSmoothingOfAPlate)
{
  // One slice: sigma is many spacings of the grid that resolves the plate.
  const LabelVolume      plate = labelOf({ { 15, 13, 3 } }, { 0.5, 0.5, 3.0 }, [](const Vector3 & p) {
    return std::max(std::hypot(p.x() / 3.2, p.y() / 2.4) - 1.0, std::abs(p.z()) - 1.5);
  });
  const ConditionedSolid solid = conditionLabel(plate);
  const LevelSet &       phi = solid.levelSet;
  ASSERT_GT(solid.report.sigma, 3.0 * phi.grid.spacing);
  for (std::size_t node = 0; node < phi.values.size(); ++node)
  {
    if (phi.grid.isBorder(node))
    {
      ASSERT_GT(phi.values[node], phi.grid.spacing) << "node " << node;
    }
  }
  expectSpheresAround(phi);
}

TEST(LabelConditioning, EmptyLabelIsRefused)
{
  LabelVolume label = ballLabel({ { 45, 45, 45 } }, Vector3::Ones());
  std::fill(label.inside.begin(), label.inside.end(), std::uint8_t{ 0 });
  EXPECT_EQ(refusalOf(label, {}), "label: no voxel has this label");
}

TEST(LabelConditioning, LabelThinnerThanTheSmoothingIsRefusedWithARemedy)
{
  const LabelVolume   label = labelOf({ { 60, 60, 3 } }, Vector3::Ones(), [](const Vector3 & p) {
    return std::abs(p.z()) < 0.5 && p.norm() < 25.0 ? -1.0 : 1.0;
  });
  ConditioningOptions options;
  options.smoothing = 2.0;
  options.spacing = 2.0;
  const std::string message = refusalOf(label, options);
  EXPECT_NE(message.find("too thin"), std::string::npos) << message;
  EXPECT_NE(message.find("use less smoothing, a finer image, or a larger label"), std::string::npos) << message;
}

TEST(LabelConditioning, OptionsOutOfRangeAreRefused)
{
  const LabelVolume label = ballLabel({ { 45, 45, 45 } }, Vector3::Ones());
  const auto        refuse = [&](const auto & change) {
    ConditioningOptions options;
    change(options);
    EXPECT_THROW((void)conditionLabel(label, options), InvalidInput);
  };
  refuse([](ConditioningOptions & options) { options.nodesPerSide = 1; });
  refuse([](ConditioningOptions & options) { options.spacing = -1.0; });
  refuse([](ConditioningOptions & options) { options.spacing = 1e-9; });
  refuse([](ConditioningOptions & options) { options.smoothing = -0.1; });
  refuse([](ConditioningOptions & options) { options.sliceAnisotropy = 0.5; });
  refuse([](ConditioningOptions & options) { options.minimumDice = 1.5; });
  refuse([](ConditioningOptions & options) { options.maximumRepair = 1.5; });
}

TEST(LabelConditioning, CallbackSeesRisingProgressAndCanCancel)
{
  const LabelVolume   label = ballLabel({ { 45, 45, 45 } }, Vector3::Ones());
  std::vector<double> seen;
  (void)conditionLabel(label, coarse(), [&](double fraction) {
    seen.push_back(fraction);
    return true;
  });
  EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
  EXPECT_EQ(seen.back(), 1.0);
  EXPECT_THROW((void)conditionLabel(label, coarse(), [](double fraction) { return fraction < 0.5; }), Cancelled);
}

TEST(LabelConditioning, TwoRunsGiveTheSameBytes)
{
  const LabelVolume label = labelOf({ { 60, 50, 14 } }, Vector3(0.8, 0.8, 3.5), lobulated);
  EXPECT_EQ(conditionLabel(label, coarse()).levelSet.values, conditionLabel(label, coarse()).levelSet.values);
}

TEST(LabelConditioning, IsTheSameForAnyNumberOfThreads)
{
  const LabelVolume   label = labelOf({ { 96, 80, 18 } }, Vector3(0.5, 0.5, 3.0), lobulated);
  ConditioningOptions options = coarse();
  options.threads = 1;
  const ConditionedSolid one = conditionLabel(label, options);
  options.threads = 3;
  const ConditionedSolid three = conditionLabel(label, options);
  EXPECT_EQ(one.levelSet.values, three.levelSet.values);
  EXPECT_EQ(one.report.dice, three.report.dice);
}

TEST(WarningsOf, SayWhatWasChangedAndNothingElse)
{
  EXPECT_TRUE(warningsOf({}).empty());
  ConditioningReport report;
  report.repair.labelVoxels = 1000;
  report.repair.voxelVolume = 1.0;
  report.repair.changes = { { TopologyChangeKind::ComponentRemoved, 2, 0, 17, Vector3::Zero() },
                            { TopologyChangeKind::CavityFilled, 1, 0, 5, Vector3::Zero() } };
  report.borders.touched[5] = true;
  report.nodesCut = 3;
  report.changedVolumeFraction = 0.002;
  const std::vector<std::string> warnings = warningsOf(report);
  ASSERT_EQ(warnings.size(), 4u);
  EXPECT_NE(warnings[0].find("2 separate parts left out: 17 voxels"), std::string::npos);
  EXPECT_NE(warnings[1].find("1 cavity filled: 5 voxels"), std::string::npos);
  EXPECT_NE(warnings[2].find("(last k)"), std::string::npos);
  EXPECT_NE(warnings[3].find("0.2 % of the volume"), std::string::npos);
}

TEST(WarningsOf, SayThatTheSmoothedSolidIsFarFromTheVoxels)
{
  ConditioningReport report;
  report.dice = 0.91;
  EXPECT_TRUE(warningsOf(report).empty());
  report.dice = 0.89;
  ASSERT_EQ(warningsOf(report).size(), 1u);
  EXPECT_NE(warningsOf(report)[0].find("0.89"), std::string::npos) << warningsOf(report)[0];
}

TEST(AutomaticSpacing, FollowsTheLatticeAndResolvesThinLabels)
{
  const double cube = 1000.0; // side 10
  EXPECT_DOUBLE_EQ(automaticSpacing(cube, 600.0, 21), 0.25);
  EXPECT_DOUBLE_EQ(automaticSpacing(cube, 600.0, 6), 10.0 / 24.0);
  // A sheet 0.6 mm thick: 0.15 mm, four nodes across.
  EXPECT_DOUBLE_EQ(automaticSpacing(cube, 2.0 * cube / 0.6, 21), 0.15);
  // A sheet 0.1 mm thick would need 1000 times the nodes: half the spacing is the limit.
  EXPECT_DOUBLE_EQ(automaticSpacing(cube, 2.0 * cube / 0.1, 21), 0.125);
}
