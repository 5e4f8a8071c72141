// Discretisation class: the map of a sphere is a Moebius map, of an ellipsoid it is conformal, both with errors that
// fall with the mesh size; orders are fitted over four refinements. Identities of a and b: round-off class, 1e-12.
#include "moserhex/Analytic/ObservedOrder.h"
#include "moserhex/Analytic/Refusals.h"
#include "moserhex/Analytic/SurfaceShapes.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/SphericalMap/ConformalMap.h"
#include "moserhex/SphericalMap/FrameAlignment.h"
#include "moserhex/SphericalMap/MoebiusCentring.h"
#include "moserhex/SphericalMap/SphereMapQuality.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace moserhex;

namespace
{

double
rmsDistance(const Positions & a, const Positions & b)
{
  double squares = 0.0;
  for (std::size_t v = 0; v < a.size(); ++v)
  {
    squares += (a[v] - b[v]).squaredNorm();
  }
  return std::sqrt(squares / static_cast<double>(a.size()));
}

} // namespace

TEST(ConformalMap, MapOfASphereIsAMoebiusMap)
{
  // After centring only a rotation is left between the identity and any Moebius map.
  std::vector<double> h;
  std::vector<double> errors;
  for (int level = 2; level <= 5; ++level)
  {
    const TriangleMesh sphere = analytic::icosphere(level, 25.0);
    const auto         map = conformalSphereMap(sphere);
    const Positions    centred = moebiusCentring(sphere, map.positions).positions;
    Positions          expected = sphere.vertices;
    for (Vector3 & s : expected)
    {
      s.normalize();
    }
    h.push_back(std::pow(0.5, level));
    errors.push_back(rmsDistance(rotated(centred, bodyFrameRotation(sphere, centred)), expected));
    EXPECT_EQ(map.flippedTriangles, 0);
  }
  EXPECT_GT(analytic::observedOrder(h, errors), 0.9);
  EXPECT_LT(errors.back(), 2e-2);
}

TEST(ConformalMap, ConformalErrorOnAnEllipsoidIsOfOrderOne)
{
  // sigma_1 / sigma_2 - 1 of every triangle, area-weighted: first derivatives of linear elements, so order one.
  std::vector<double> h;
  std::vector<double> errors;
  for (int level = 2; level <= 5; ++level)
  {
    const TriangleMesh ellipsoid = analytic::ellipsoidSurface(level, Vector3(20, 10, 12));
    const auto         centred = moebiusCentring(ellipsoid, conformalSphereMap(ellipsoid).positions);
    h.push_back(std::pow(0.5, level));
    errors.push_back(sphereMapQuality(ellipsoid, centred.positions).quasiConformal - 1.0);
  }
  EXPECT_NEAR(analytic::observedOrder(h, errors), 1.0, 0.1);
  EXPECT_LT(errors.back(), 0.06);
}

TEST(ConformalMap, RemovedTriangleLiesAroundTheNorthPole)
{
  const TriangleMesh surface = analytic::ellipsoidSurface(3, Vector3(3, 2, 1));
  const auto         map = conformalSphereMap(surface);
  const Triangle &   t = surface.triangles[map.removedTriangle];
  const Vector3      pole = Vector3::UnitZ();
  const Vector3 &    a = map.positions[t[0]];
  const Vector3 &    b = map.positions[t[1]];
  const Vector3 &    c = map.positions[t[2]];
  EXPECT_GT(signedSolidAngle(a, b, pole), 0.0);
  EXPECT_GT(signedSolidAngle(b, c, pole), 0.0);
  EXPECT_GT(signedSolidAngle(c, a, pole), 0.0);
}

TEST(ConformalMap, ScaleAndPlaceOfTheSurfaceDoNotMatter)
{
  const TriangleMesh  surface = analytic::ellipsoidSurface(3, Vector3(3, 2, 1));
  ConformalMapOptions options;
  options.removedNearPoint = Vector3(0.4, 0.3, 1.0); // no tie between symmetric triangles
  const Positions reference = conformalSphereMap(surface, options).positions;
  for (const double scale : { 1e-6, 1e6 })
  {
    const auto   placed = [&](const Vector3 & p) { return Vector3(scale * (p + Vector3(7, -4, 2))); };
    TriangleMesh moved = surface;
    for (Vector3 & p : moved.vertices)
    {
      p = placed(p);
    }
    ConformalMapOptions movedOptions;
    movedOptions.removedNearPoint = placed(*options.removedNearPoint);
    EXPECT_LT(rmsDistance(conformalSphereMap(moved, movedOptions).positions, reference), 1e-9) << "scale " << scale;
  }
}

TEST(ConformalMap, RenumberingChangesRoundOffOnly)
{
  const TriangleMesh  surface = analytic::ellipsoidSurface(3, Vector3(3, 2, 1.5));
  ConformalMapOptions options;
  options.removedNearPoint = surface.vertices[7];
  const auto map = conformalSphereMap(surface, options);
  const auto again = conformalSphereMap(analytic::renumbered(surface, 5), options);
  // Positions as an unordered set: the sum of all of them and of their squares.
  Vector3 sum = Vector3::Zero();
  double  height = 0.0;
  for (std::size_t v = 0; v < map.positions.size(); ++v)
  {
    sum += map.positions[v] - again.positions[v];
    height += std::pow(map.positions[v][2], 3) - std::pow(again.positions[v][2], 3);
  }
  EXPECT_LT(std::abs(sum[2]), 1e-8);
  EXPECT_LT(std::abs(height), 1e-8);
}

TEST(ConformalMap, ResidualIsRoundOff)
{
  EXPECT_LT(conformalSphereMap(analytic::ellipsoidSurface(4, Vector3(3, 2, 1))).report.residual, 1e-13);
}

TEST(ConformalMap, TriangleIsChosenByDirectionOrPoint)
{
  const TriangleMesh surface = analytic::ellipsoidSurface(3, Vector3(10, 10, 10));
  const auto         centre = [&](int f) {
    const Triangle & t = surface.triangles[f];
    return Vector3((surface.vertices[t[0]] + surface.vertices[t[1]] + surface.vertices[t[2]]) / 3.0);
  };
  for (const Vector3 & direction : { Vector3(0, 0, 1), Vector3(-1, 0, 0), Vector3(1, 1, -1) })
  {
    EXPECT_GT(centre(triangleTowards(surface, direction)).normalized().dot(direction.normalized()), 0.96);
    const int near = triangleNear(surface, 30.0 * direction);
    EXPECT_GT(centre(near).normalized().dot(direction.normalized()), 0.99);
    ConformalMapOptions options;
    options.removedNearPoint = centre(near);
    EXPECT_EQ(conformalSphereMap(surface, options).removedTriangle, near);
  }
}

TEST(ConformalMap, SliverIsNotChosen)
{
  TriangleMesh surface = analytic::icosphere(3);
  const int    before = triangleTowards(surface, Vector3::UnitZ());
  const auto & t = surface.triangles[before];
  surface.vertices[t[0]] = (0.99 * surface.vertices[t[1]] + 0.01 * surface.vertices[t[0]]).normalized();
  EXPECT_NE(triangleTowards(surface, Vector3::UnitZ()), before);
}

TEST(ConformalMap, ClampedWeightsMapASliverMeshWithFewFlips)
{
  TriangleMesh surface = analytic::icosphere(3);
  for (Vector3 & p : surface.vertices)
  {
    p[0] *= 30.0;
  }
  ConformalMapOptions options;
  options.weights = LaplacianWeights::ClampedCotangent;
  const auto map = conformalSphereMap(surface, options);
  EXPECT_LE(map.flippedTriangles, 2);
}

TEST(ConformalMap, TwoRunsAreEqualBitForBit)
{
  const TriangleMesh surface = analytic::ellipsoidSurface(3, Vector3(3, 2, 1));
  EXPECT_EQ(conformalSphereMap(surface).positions, conformalSphereMap(surface).positions);
}

TEST(ConformalMap, TorusIsRefusedWithItsEulerNumber)
{
  const std::string message = analytic::messageOf([] { (void)conformalSphereMap(analytic::torusSurface(20, 10)); });
  EXPECT_NE(message.find("V-E+F = 0"), std::string::npos) << message;
}

TEST(ConformalMap, BadArgumentsAreRefused)
{
  TriangleMesh        surface = analytic::icosphere(1);
  ConformalMapOptions options;
  options.removedDirection = Vector3::Zero();
  EXPECT_THROW((void)conformalSphereMap(surface, options), InvalidInput);
  TriangleMesh flat = surface;
  for (Vector3 & p : flat.vertices)
  {
    p[0] = p[1] = 0.0;
  }
  EXPECT_THROW((void)conformalSphereMap(flat), InvalidInput) << "triangle to remove is degenerate";
  surface.vertices[2][0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)conformalSphereMap(surface), InvalidInput);
}
