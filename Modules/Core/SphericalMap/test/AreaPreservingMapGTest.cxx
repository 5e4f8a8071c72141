// The guarantee: exact for flips, 1e-9 for the sum of solid angles, 0.01 for the area ratio rms. Invariances of the
// converged map: iteration class, 1e-5 rad (0.0006 degrees) between runs that differ in path, 1e-9 when only round-off
// differs.
#include "moserhex/Analytic/Refusals.h"
#include "moserhex/Analytic/SurfaceShapes.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/SphericalMap/AreaPreservingMap.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace moserhex;

namespace
{

TriangleMesh
bumpyBall(int level)
{
  return analytic::starShapedSurface(level, [](const Vector3 & n) {
    return 20.0 * (1.0 + 0.2 * std::sin(4.0 * n[0]) * std::cos(3.0 * n[1] + 1.0) + 0.1 * std::sin(5.0 * n[2]));
  });
}

/** Asymmetric and smooth, like an organ: the frame is well defined. */
TriangleMesh
smoothOrgan(int level)
{
  TriangleMesh mesh = analytic::starShapedSurface(
    level, [](const Vector3 & n) { return 20.0 * (1.0 + 0.15 * n[1] * n[2] + 0.1 * n[2] - 0.1 * n[0] * n[0] * n[1]); });
  for (Vector3 & p : mesh.vertices)
  {
    p = Vector3(1.3 * p[0], p[1], 1.15 * p[2]);
  }
  return mesh;
}

/** Bent along an arc of 2 rad, tapered. */
TriangleMesh
banana(int level)
{
  TriangleMesh mesh = analytic::icosphere(level);
  for (Vector3 & p : mesh.vertices)
  {
    const double angle = 1.0 * p[0];
    const double thickness = 8.0 * (1.0 - 0.3 * p[0]);
    const double radius = 25.0 + thickness * p[2];
    p = Vector3(radius * std::sin(angle), thickness * p[1], radius * std::cos(angle));
  }
  return mesh;
}

/** Two lobes and a neck of a third of their radius. */
TriangleMesh
dumbbell(int level)
{
  TriangleMesh mesh = analytic::icosphere(level);
  for (Vector3 & p : mesh.vertices)
  {
    const double waist = 0.35 + 0.65 * std::min(1.0, 2.0 * std::abs(p[0]));
    p = Vector3(40.0 * p[0], 15.0 * waist * p[1], 15.0 * waist * p[2]);
  }
  return mesh;
}

double
largestAngle(const Positions & a, const Positions & b)
{
  double largest = 0.0;
  for (std::size_t v = 0; v < a.size(); ++v)
  {
    largest = std::max(largest, std::atan2(a[v].cross(b[v]).norm(), a[v].dot(b[v])));
  }
  return largest;
}

} // namespace

TEST(AreaPreservingMap, GuaranteeHoldsOnPhantoms)
{
  const std::pair<const char *, TriangleMesh> phantoms[] = {
    { "sphere", analytic::icosphere(3, 20.0) },
    { "ellipsoid 3:1:1", analytic::ellipsoidSurface(4, Vector3(30, 10, 10)) },
    { "ellipsoid 5:1:1", analytic::ellipsoidSurface(4, Vector3(50, 10, 10)) },
    { "bumpy ball", bumpyBall(4) },
    { "banana", banana(4) },
    { "dumbbell", dumbbell(4) },
    { "cube", analytic::cubeSurface(12, 30.0) },
  };
  for (const auto & [name, surface] : phantoms)
  {
    const auto             result = areaPreservingSphereMap(surface);
    const SphereMapQuality quality = sphereMapQuality(surface, result.positions);
    EXPECT_EQ(quality.flippedTriangles, 0) << name;
    EXPECT_NEAR(quality.solidAngleSum, 4.0 * pi, 1e-9) << name;
    EXPECT_LE(quality.areaRatioRms, 0.01) << name << ", path " << result.path;
    EXPECT_EQ(quality.areaRatioRms, result.quality.areaRatioRms) << name;
    EXPECT_FALSE(result.path.empty());
    for (const Vector3 & s : result.positions)
    {
      EXPECT_NEAR(s.norm(), 1.0, 1e-14) << name;
    }
  }
}

TEST(AreaPreservingMap, MapOfASphereIsTheIdentity)
{
  // The flat areas of an icosphere's triangles are its solid angles up to O(h^2), and the frame is the body's.
  const TriangleMesh sphere = analytic::icosphere(4, 12.0);
  Positions          directions;
  for (const Vector3 & p : sphere.vertices)
  {
    directions.push_back(p.normalized());
  }
  EXPECT_LT(largestAngle(areaPreservingSphereMap(sphere).positions, directions), 5e-3);
}

TEST(AreaPreservingMap, RemovedTriangleIsForgotten)
{
  const TriangleMesh surface = smoothOrgan(4);
  const auto         reference = areaPreservingSphereMap(surface);
  for (const Vector3 & direction : { Vector3(0, 0, -1), Vector3(1, 0, 0), Vector3(0, -1, 0), Vector3(1, 1, 1) })
  {
    AreaPreservingMapOptions options;
    options.removedDirection = direction;
    EXPECT_LT(largestAngle(areaPreservingSphereMap(surface, options).positions, reference.positions), 1e-5);
  }
  AreaPreservingMapOptions options;
  options.removedNearPoint = surface.vertices[100];
  EXPECT_LT(largestAngle(areaPreservingSphereMap(surface, options).positions, reference.positions), 1e-5);
}

TEST(AreaPreservingMap, ConformalStageDoesDependOnTheRemovedTriangle)
{
  // The test above could not fail if all maps were alike.
  const TriangleMesh       surface = smoothOrgan(4);
  AreaPreservingMapOptions options;
  options.lastStage = SphereMapStage::Centred;
  const auto reference = areaPreservingSphereMap(surface, options);
  options.removedDirection = Vector3(0, 0, -1);
  EXPECT_GT(largestAngle(areaPreservingSphereMap(surface, options).positions, reference.positions), 1e-3);
}

TEST(AreaPreservingMap, ScaleDoesNotMatter)
{
  const TriangleMesh surface = smoothOrgan(3);
  const auto         reference = areaPreservingSphereMap(surface);
  for (const double scale : { 1e-6, 1e6 })
  {
    TriangleMesh scaled = surface;
    for (Vector3 & p : scaled.vertices)
    {
      p *= scale;
    }
    EXPECT_LT(largestAngle(areaPreservingSphereMap(scaled).positions, reference.positions), 1e-9) << scale;
  }
}

TEST(AreaPreservingMap, RotatedBodyHasTheRotatedMap)
{
  const TriangleMesh surface = smoothOrgan(3);
  const Matrix3      turn = analytic::rotation(Vector3(1, -2, 0.5), 1.2);
  TriangleMesh       turned = surface;
  for (Vector3 & p : turned.vertices)
  {
    p = turn * p + Vector3(10, 20, -30);
  }
  Positions expected = areaPreservingSphereMap(surface).positions;
  for (Vector3 & s : expected)
  {
    s = turn * s;
  }
  EXPECT_LT(largestAngle(areaPreservingSphereMap(turned).positions, expected), 1e-5);
}

TEST(AreaPreservingMap, RenumberingVerticesChangesRoundOffOnly)
{
  const TriangleMesh surface = smoothOrgan(3);
  TriangleMesh       reversed = surface;
  const auto         last = static_cast<VertexIndex>(surface.vertices.size() - 1);
  std::reverse(reversed.vertices.begin(), reversed.vertices.end());
  for (Triangle & t : reversed.triangles)
  {
    t = { last - t[1], last - t[2], last - t[0] };
  }
  std::reverse(reversed.triangles.begin(), reversed.triangles.end());
  Positions again = areaPreservingSphereMap(reversed).positions;
  std::reverse(again.begin(), again.end());
  EXPECT_LT(largestAngle(again, areaPreservingSphereMap(surface).positions), 1e-5);
}

TEST(AreaPreservingMap, TwoRunsAreEqualBitForBit)
{
  const TriangleMesh surface = bumpyBall(3);
  EXPECT_EQ(areaPreservingSphereMap(surface).positions, areaPreservingSphereMap(surface).positions);
}

TEST(AreaPreservingMap, DirectionsOnTheSphereFollowTheBody)
{
  const TriangleMesh surface = smoothOrgan(3);
  const auto         result = areaPreservingSphereMap(surface);
  double             mean = 0.0;
  for (std::size_t v = 0; v < surface.vertices.size(); ++v)
  {
    mean += result.positions[v].dot((surface.vertices[v] - surfaceCentroid(surface)).normalized());
  }
  EXPECT_GT(mean / static_cast<double>(surface.vertices.size()), 0.98);
}

TEST(AreaPreservingMap, EarlierStagesAreThere)
{
  const TriangleMesh       surface = analytic::ellipsoidSurface(3, Vector3(20, 10, 12));
  AreaPreservingMapOptions options;
  double                   previous = std::numeric_limits<double>::infinity();
  for (const SphereMapStage stage : { SphereMapStage::Conformal,
                                      SphereMapStage::Centred,
                                      SphereMapStage::MoserFlow,
                                      SphereMapStage::AreaPreserving })
  {
    options.lastStage = stage;
    const auto result = areaPreservingSphereMap(surface, options);
    EXPECT_EQ(result.quality.flippedTriangles, 0);
    EXPECT_LT(result.quality.areaRatioRms, previous);
    previous = result.quality.areaRatioRms;
  }
}

TEST(AreaPreservingMap, ZeroAreaTrianglesAreAllowed)
{
  TriangleMesh surface = bumpyBall(3);
  for (std::size_t f = 0; f < surface.triangles.size(); f += 40)
  {
    surface.vertices[surface.triangles[f][0]] = surface.vertices[surface.triangles[f][1]];
  }
  const auto result = areaPreservingSphereMap(surface);
  EXPECT_TRUE(isBijective(result.quality));
  EXPECT_LE(result.quality.areaRatioRms, 0.01);
}

TEST(AreaPreservingMap, ShapeWeightGoesDownWhenTheToleranceAsksForIt)
{
  const TriangleMesh       surface = analytic::ellipsoidSurface(3, Vector3(30, 10, 10));
  AreaPreservingMapOptions options;
  options.areaTolerance = 1e-3;
  const auto result = areaPreservingSphereMap(surface, options);
  EXPECT_LT(result.shapeWeight, options.shapeWeight);
  EXPECT_LE(result.quality.areaRatioRms, 1e-3);
  EXPECT_NE(result.path.find("eps"), std::string::npos) << result.path;
}

TEST(AreaPreservingMap, ToleranceOutOfReachIsNotConvergedWithTheNumbers)
{
  AreaPreservingMapOptions options;
  options.areaTolerance = 1e-9;
  options.maximumSteps = 4;
  const std::string message =
    analytic::messageOf<NotConverged>([&] { (void)areaPreservingSphereMap(bumpyBall(3), options); });
  EXPECT_NE(message.find("area ratio rms"), std::string::npos) << message;
}

TEST(AreaPreservingMap, ReportsNameTheStages)
{
  const auto result = areaPreservingSphereMap(smoothOrgan(3));
  ASSERT_GE(result.reports.size(), 3u);
  EXPECT_EQ(result.reports.front().note, "conformal");
  EXPECT_NE(result.reports.back().note.find("barrier"), std::string::npos);
  EXPECT_TRUE(result.reports.back().converged);
}

TEST(AreaPreservingMap, ProgressRisesToOneAndCancellationIsObeyed)
{
  double last = 0.0;
  (void)areaPreservingSphereMap(smoothOrgan(2), {}, [&](double fraction) {
    EXPECT_GE(fraction, last);
    last = fraction;
    return true;
  });
  EXPECT_EQ(last, 1.0);
  EXPECT_THROW((void)areaPreservingSphereMap(smoothOrgan(2), {}, [](double) { return false; }), Cancelled);
}

TEST(AreaPreservingMap, TorusIsRefusedWithItsEulerNumber)
{
  const std::string message =
    analytic::messageOf([] { (void)areaPreservingSphereMap(analytic::torusSurface(20, 10)); });
  EXPECT_NE(message.find("V-E+F = 0"), std::string::npos) << message;
}

TEST(AreaPreservingMap, BadInputIsRefused)
{
  TriangleMesh open = analytic::icosphere(2);
  open.triangles.pop_back();
  EXPECT_THROW((void)areaPreservingSphereMap(open), InvalidInput);

  TriangleMesh inward = analytic::icosphere(2);
  for (Triangle & t : inward.triangles)
  {
    std::swap(t[0], t[1]);
  }
  EXPECT_THROW((void)areaPreservingSphereMap(inward), InvalidInput);

  TriangleMesh infinite = analytic::icosphere(2);
  infinite.vertices[5][2] = std::numeric_limits<double>::infinity();
  EXPECT_THROW((void)areaPreservingSphereMap(infinite), InvalidInput);

  TriangleMesh point = analytic::icosphere(1);
  for (Vector3 & p : point.vertices)
  {
    p.setOnes();
  }
  EXPECT_THROW((void)areaPreservingSphereMap(point), InvalidInput);

  AreaPreservingMapOptions options;
  options.shapeWeight = 0.0;
  EXPECT_THROW((void)areaPreservingSphereMap(analytic::icosphere(1), options), InvalidInput);
}
