// A ball and an ellipsoid whose ordering by volume is known in closed form. Volumes and distances: discretisation
// class, bounds well above the measured error; threads: exact.
#include "moserhex/SolidMeshing/SolidMeshing.h"

#include "ExactStage.h"
#include "OrderedEllipsoid.h"
#include "moserhex/Analytic/SurfaceShapes.h"
#include "moserhex/Common/Errors.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

using namespace moserhex;

TEST(MeshSolid, AnEllipsoidBecomesALatticeOfNearlyEqualCells)
{
  const OrderedSolid  solid = ellipsoid({ 15.0, 12.0, 10.0 }, 0.75);
  SolidMeshingOptions options = withShells(5);
  options.lastStage = MeshingStage::Moser;
  const SolidMeshingResult result = meshSolid(solid.ordering, solid.phi, solid.volume, options);
  ASSERT_EQ(result.mesh.nodesPerSide, 10);
  const HexQualitySummary & quality = *result.stages.back().quality;
  EXPECT_LE(quality.volumeVariance, 0.01);
  EXPECT_NEAR(quality.volume / solid.volume, 1.0, 0.03);
  EXPECT_LE(result.boundary.maximumOfNodes, 0.05);
  for (const AreaPreservingMapResult & map : result.sphereMaps)
  {
    EXPECT_EQ(map.quality.flippedTriangles, 0);
  }
}

namespace
{

/** Names of the stages; checks on the way that the meshes, and they only, carry quality. */
std::vector<std::string>
stageNames(const SolidMeshingResult & result)
{
  std::vector<std::string> names;
  for (const MeshingStageReport & stage : result.stages)
  {
    names.push_back(stage.name);
    EXPECT_EQ(stage.quality.has_value(), names.size() > 2) << stage.name;
  }
  return names;
}

} // namespace

TEST(MeshSolid, StagesAreNamedInOrderAndCarryQualityFromTheInitialMapOn)
{
  const OrderedSolid  solid = ellipsoid({ 12.0, 10.0, 10.0 }, 1.0);
  SolidMeshingOptions options = withShells(3);
  options.way = MeshingWay::Faithful;
  EXPECT_EQ(
    stageNames(meshSolid(solid.ordering, solid.phi, solid.volume, options)),
    (std::vector<std::string>{ "shell surfaces", "sphere maps", "initial map", "smoothing", "moser flow", "exact" }));
  options.way = MeshingWay::Fast;
  EXPECT_EQ(stageNames(meshSolid(solid.ordering, solid.phi, solid.volume, options)),
            (std::vector<std::string>{ "shell surfaces", "sphere maps", "initial map", "exact" }));
}

TEST(MeshSolid, BothWaysMakeTheCellsOfAnEllipsoidEqual)
{
  const OrderedSolid  solid = ellipsoid({ 15.0, 12.0, 10.0 }, 0.75);
  SolidMeshingOptions options = withShells(5);
  for (const MeshingWay way : { MeshingWay::Fast, MeshingWay::Faithful })
  {
    options.way = way;
    const SolidMeshingResult result = meshSolid(solid.ordering, solid.phi, solid.volume, options);
    ASSERT_TRUE(result.equalisation);
    EXPECT_TRUE(result.equalisation->exact);
    const HexQualitySummary & quality = *result.stages.back().quality;
    EXPECT_LE(quality.volumeVariance, 1e-18);
    EXPECT_NEAR(quality.volume / solid.volume, 1.0, 1e-9);
    EXPECT_EQ(quality.certified.positive, quality.cells);
    EXPECT_LE(result.boundary.maximum, 0.5);
  }
}

TEST(MeshSolid, ShellsOfACoarserGridLeadToTheSameContract)
{
  const OrderedSolid       solid = ellipsoid({ 15.0, 12.0, 10.0 }, 0.5);
  const OrderedSolid       start = ellipsoid({ 15.0, 12.0, 10.0 }, 1.25);
  const SolidMeshingResult result = meshSolid(start.ordering, start.phi, solid.phi, solid.volume, withShells(6));
  EXPECT_TRUE(result.equalisation->exact);
  const HexQualitySummary & quality = *result.stages.back().quality;
  EXPECT_LE(quality.volumeVariance, 1e-18);
  EXPECT_NEAR(quality.volume / solid.volume, 1.0, 1e-9);
  EXPECT_LE(result.boundary.maximum, 0.5); // to the surface of the finer grid
}

TEST(MeshSolid, AMeshThatIsNotExactIsThrownAwayUnlessAskedFor)
{
  const OrderedSolid  solid = ellipsoid({ 12.0, 10.0, 10.0 }, 1.0);
  SolidMeshingOptions options = withShells(3);
  options.turnedFrames = 0;
  options.equalisation.surfaceTolerance = 1e-4; // the centres of curved quadrilaterals cannot be that near
  EXPECT_THROW((void)meshSolid(solid.ordering, solid.phi, solid.volume, options), NotConverged);
  options.allowPartial = true;
  const SolidMeshingResult result = meshSolid(solid.ordering, solid.phi, solid.volume, options);
  EXPECT_FALSE(result.equalisation->exact);
  ASSERT_FALSE(result.equalisation->shortcomings.empty());
  EXPECT_NE(result.equalisation->shortcomings.front().find("mm off the surface"), std::string::npos);
  for (const std::string & shortcoming : result.equalisation->shortcomings)
  {
    EXPECT_EQ(std::count(result.warnings.begin(), result.warnings.end(), "not exact: " + shortcoming), 1)
      << shortcoming;
  }
}

namespace
{

/** A cube with rounded edges, turned by 25 degrees about z: s = |p / 12|_6, phi = first-order signed distance. */
OrderedSolid
turnedRoundedCube()
{
  OrderedSolid  solid = ellipsoid({ 17.0, 17.0, 13.0 }, 1.0); // for its grid
  const double  angle = 25.0 * pi / 180.0;
  const Vector3 first(std::cos(angle), std::sin(angle), 0.0);
  const Vector3 second(-std::sin(angle), std::cos(angle), 0.0);
  for (std::size_t node = 0; node < solid.phi.grid.nodeCount(); ++node)
  {
    const Vector3        p = solid.phi.grid.point(node);
    const Eigen::Array3d q(p.dot(first) / 12.0, p.dot(second) / 12.0, p[2] / 12.0);
    const double         s = std::pow(q.pow(6).sum(), 1.0 / 6.0);
    const double         slope = s > 0.0 ? (q.abs() / s).pow(5).matrix().norm() : 1.0;
    solid.ordering.values[node] = s;
    solid.phi.values[node] = 12.0 * (s - 1.0) / slope;
  }
  // Dirichlet: the volume of sum |x_i|^6 <= 1 is (2 Gamma(7/6))^3 / Gamma(3/2).
  solid.volume = std::pow(12.0 * 2.0 * std::tgamma(7.0 / 6.0), 3) / std::tgamma(1.5);
  return solid;
}

} // namespace

TEST(MeshSolid, ATurnedFrameIsTakenWhereTheOwnOneDoesNotDo)
{
  const OrderedSolid  solid = turnedRoundedCube();
  SolidMeshingOptions options = withShells(4);
  options.allowPartial = true;
  // So few steps that the lattice cannot slide into the cube's own attitude, and a tolerance out of their reach.
  EqualisationOptions & equalisation = options.equalisation;
  for (auto * stages : { &equalisation.coarseStages, &equalisation.finestStages, &equalisation.directStages })
  {
    for (EqualisationStage & stage : *stages)
    {
      stage.maximumSteps = 4;
    }
  }
  equalisation.repairRounds = 0;
  equalisation.surfaceTolerance = 0.01;
  options.turnedFrames = 0;
  const SolidMeshingResult own = meshSolid(solid.ordering, solid.phi, solid.volume, options);
  EXPECT_FALSE(own.equalisation->exact);
  EXPECT_TRUE(own.turnWarning.empty());
  EXPECT_EQ(latticeTurn(own), Matrix3(Matrix3::Identity()));

  options.turnedFrames = 2;
  const SolidMeshingResult turned = meshSolid(solid.ordering, solid.phi, solid.volume, options);
  EXPECT_NE(turned.turnWarning.find("turned by"), std::string::npos);
  const long degrees = std::lround(Eigen::AngleAxisd(latticeTurn(turned)).angle() * 180.0 / pi);
  EXPECT_GT(degrees, 0);
  EXPECT_NE(turned.turnWarning.find("turned by " + std::to_string(degrees) + " degrees"), std::string::npos);
  EXPECT_LE(turned.equalisation->variance, 1e-12);
  EXPECT_LE(turned.equalisation->uncertifiedCells, own.equalisation->uncertifiedCells);
  EXPECT_GT(turned.stages.back().quality->scaledJacobian.minimum, own.stages.back().quality->scaledJacobian.minimum);
}

TEST(MeshSolid, TheResultIsTheSameForAnyNumberOfThreads)
{
  const OrderedSolid solid = ellipsoid({ 14.0, 11.0, 9.0 }, 1.0);
  const HexMesh      one = meshSolid(solid.ordering, solid.phi, solid.volume, withShells(4, 1)).mesh;
  const HexMesh      three = meshSolid(solid.ordering, solid.phi, solid.volume, withShells(4, 3)).mesh;
  EXPECT_EQ(one.nodes, three.nodes);
}

TEST(MeshSolid, StopsWhenTheCallbackSaysSo)
{
  const OrderedSolid solid = ellipsoid({ 12.0, 10.0, 10.0 }, 1.0);
  EXPECT_THROW(
    (void)meshSolid(
      solid.ordering, solid.phi, solid.volume, withShells(3), [](double fraction) { return fraction < 0.6; }),
    Cancelled);
}

TEST(MeshSolid, GridsThatDifferAreRefused)
{
  OrderedSolid solid = ellipsoid({ 12.0, 10.0, 10.0 }, 1.0);
  solid.ordering.grid.origin[0] += 0.5;
  EXPECT_THROW((void)meshSolid(solid.ordering, solid.phi, solid.volume, withShells(3)), InvalidInput);
}

TEST(MeshSolid, DensityWithoutTheLastStageIsRefused)
{
  struct Uniform final : Density
  {
    [[nodiscard]] ValueAndGradient
    at(const Vector3 &) const override
    {
      return { 1.0, Vector3::Zero() };
    }
  };
  const OrderedSolid  solid = ellipsoid({ 12.0, 10.0, 10.0 }, 1.0);
  const Uniform       density;
  SolidMeshingOptions options = withShells(3);
  options.density = &density;
  options.lastStage = MeshingStage::Moser;
  EXPECT_THROW((void)meshSolid(solid.ordering, solid.phi, solid.volume, options), InvalidInput);
}

TEST(MeshSolid, PaddingFollowsTheExactStage)
{
  const OrderedSolid  solid = ellipsoid({ 15.0, 12.0, 10.0 }, 0.75);
  SolidMeshingOptions options = withShells(4);
  options.lastStage = MeshingStage::Exact;
  options.paddingLayers = 1;
  const SolidMeshingResult result = meshSolid(solid.ordering, solid.phi, solid.volume, options);
  EXPECT_EQ(result.mesh.paddingLayers, 1);
  EXPECT_EQ(result.mesh.nodesPerSide, 8);
  EXPECT_TRUE(result.equalisation->exact);
  EXPECT_EQ(result.stages.back().name, "padding");
  EXPECT_EQ(result.attempts.back().find("padding: exact"), 0u) << result.attempts.back();
  EXPECT_NE(result.stages.back().note.find(result.attempts.back()), std::string::npos);
  EXPECT_LE(result.boundary.maximum, 0.5);
  const HexQualitySummary & lattice = *result.stages[result.stages.size() - 2].quality;
  const HexQualitySummary & withPadding = *result.stages.back().quality;
  EXPECT_NEAR(withPadding.volume, solid.volume, 1e-9 * solid.volume);
  EXPECT_LE(withPadding.volumeVariance, 1e-18);
  EXPECT_GT(withPadding.scaledJacobian.minimum, lattice.scaledJacobian.minimum + 0.1);
  EXPECT_GT(withPadding.scaledJacobian.mean, lattice.scaledJacobian.mean);
}

namespace
{

/** The solid with a hole drilled into it from above, round at its end. */
OrderedSolid
drilled(const OrderedSolid & whole, double radius, double end)
{
  OrderedSolid        solid = whole;
  const RegularGrid & grid = solid.phi.grid;
  solid.volume = 0.0;
  for (std::size_t node = 0; node < grid.nodeCount(); ++node)
  {
    const Vector3 p = grid.point(node);
    const Vector3 fromAxis(p.x(), p.y(), std::min(0.0, p.z() - end));
    double &      phi = solid.phi.values[node];
    phi = std::max(phi, radius - fromAxis.norm());
    solid.volume += std::min(std::max(0.5 - phi / grid.spacing, 0.0), 1.0) * std::pow(grid.spacing, 3);
  }
  return solid;
}

} // namespace

TEST(MeshSolid, PaddingGoesToARounderSolidWhereCornersStayNarrow)
{
  const OrderedSolid  whole = ellipsoid({ 15.0, 12.0, 10.0 }, 0.75);
  const OrderedSolid  solid = drilled(whole, 2.0, 6.0);
  SolidMeshingOptions options = withShells(6);
  options.lastStage = MeshingStage::Exact;
  options.paddingLayers = 2;
  options.simplerSolid = [](Simplification) { return std::nullopt; };
  const SolidMeshingResult asItIs = meshSolid(whole.ordering, whole.phi, solid.phi, solid.volume, options);
  EXPECT_TRUE(asItIs.exactWithoutPadding);
  EXPECT_TRUE(asItIs.equalisation->exact);
  EXPECT_LT(asItIs.equalisation->smallestScaledJacobian, 0.2);
  EXPECT_FALSE(asItIs.simplerSolid.has_value());
  EXPECT_EQ(asItIs.attempts.size(), 4u); // the lattice; padding with strong and with weak angles, of a rounder solid
  EXPECT_EQ(asItIs.attempts.back(), "padding, rounder solid: too far from the label");

  options.simplerSolid = [&whole](Simplification simplification) {
    EXPECT_EQ(simplification, Simplification::Rounder);
    return whole.phi;
  };
  const SolidMeshingResult rounder = meshSolid(whole.ordering, whole.phi, solid.phi, solid.volume, options);
  EXPECT_TRUE(rounder.simplerSolid.has_value());
  EXPECT_TRUE(rounder.equalisation->exact);
  EXPECT_EQ(rounder.attempts.back().find("padding, rounder solid: exact"), 0u) << rounder.attempts.back();
  EXPECT_LE(rounder.boundary.maximum, 0.5);
  const HexQualitySummary & quality = *rounder.stages.back().quality;
  EXPECT_NEAR(quality.volume, solid.volume, 1e-9 * solid.volume);
  EXPECT_GE(quality.scaledJacobian.minimum, 0.2);
  EXPECT_GE(quality.scaledJacobian.mean, 0.9);
}

TEST(MeshSolid, WhereOnlyPaddingFailsTheMessageSaysSo)
{
  const auto messageOf = [](bool exactWithoutPadding) -> std::string {
    SolidMeshingResult result;
    result.exactWithoutPadding = exactWithoutPadding;
    result.equalisation.emplace().shortcomings = { "3 of 1216 cells are concave" };
    try
    {
      requireExact({}, result);
    }
    catch (const NotConverged & error)
    {
      return error.what();
    }
    return {};
  };
  const std::string flaw = "3 of 1216 cells are concave";
  EXPECT_EQ(messageOf(true), "exact without padding, not exact with it: " + flaw);
  EXPECT_EQ(messageOf(false), "not exact: " + flaw);
}

TEST(MeshSolid, PaddingOutOfRangeOrOfAnotherStageIsRefused)
{
  const OrderedSolid  solid = ellipsoid({ 12.0, 10.0, 10.0 }, 1.0);
  SolidMeshingOptions options = withShells(3);
  for (const int layers : { -1, largestPadding + 1 })
  {
    options.paddingLayers = layers;
    EXPECT_THROW((void)meshSolid(solid.ordering, solid.phi, solid.volume, options), InvalidInput) << layers;
  }
  options.paddingLayers = 1;
  options.lastStage = MeshingStage::Moser;
  EXPECT_THROW((void)meshSolid(solid.ordering, solid.phi, solid.volume, options), InvalidInput);
}
