// Closed form: density 1 + a z on the sphere moves z to z + a (z^2 - 1) / 2. Discretisation class: the observed order
// over four refinements is 1.6 (rms; the averaged gradient is of first order at the twelve irregular vertices), the
// time stepping is far below it with 16 steps.
#include "moserhex/Analytic/ObservedOrder.h"
#include "moserhex/Analytic/SurfaceShapes.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/SphericalMap/ConformalMap.h"
#include "moserhex/SphericalMap/MoebiusCentring.h"
#include "moserhex/SphericalMap/MoserAreaFlow.h"
#include "moserhex/SphericalMap/SphereMapQuality.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace moserhex;

namespace
{

std::vector<double>
linearDensity(const Positions & sphere, double a)
{
  std::vector<double> density;
  for (const Vector3 & s : sphere)
  {
    density.push_back(1.0 + a * s[2]);
  }
  return density;
}

/** Where the exact flow of density 1 + a z takes s: along its meridian to z + a (z^2 - 1) / 2. */
Vector3
exactPosition(const Vector3 & s, double a)
{
  const double z = s[2] + 0.5 * a * (s[2] * s[2] - 1.0);
  const double distance = std::hypot(s[0], s[1]);
  const double radius = std::sqrt(std::max(0.0, 1.0 - z * z));
  return distance > 1e-12 ? Vector3(s[0] / distance * radius, s[1] / distance * radius, z)
                          : Vector3(0.0, 0.0, s[2] > 0.0 ? 1.0 : -1.0);
}

double
rmsErrorOfLinearDensity(int level, double a, int steps)
{
  const TriangleMesh   sphere = analytic::icosphere(level);
  MoserAreaFlowOptions options;
  options.stepsPerPass = steps;
  const auto result = moserAreaFlowPass(sphere.triangles, sphere.vertices, linearDensity(sphere.vertices, a), options);
  EXPECT_TRUE(result.report.converged);
  double squares = 0.0;
  for (std::size_t v = 0; v < sphere.vertices.size(); ++v)
  {
    squares += (result.positions[v] - exactPosition(sphere.vertices[v], a)).squaredNorm();
  }
  return std::sqrt(squares / static_cast<double>(sphere.vertices.size()));
}

Positions
centredMap(const TriangleMesh & surface)
{
  return moebiusCentring(surface, conformalSphereMap(surface).positions).positions;
}

} // namespace

TEST(MoserAreaFlow, LinearDensityMatchesTheClosedForm)
{
  for (const double a : { 0.5, 0.9 })
  {
    std::vector<double> h;
    std::vector<double> errors;
    for (int level = 2; level <= 5; ++level)
    {
      h.push_back(std::pow(0.5, level));
      errors.push_back(rmsErrorOfLinearDensity(level, a, 16));
    }
    EXPECT_NEAR(analytic::observedOrder(h, errors), 1.6, 0.2) << "a = " << a;
    EXPECT_LT(errors.back(), 1e-3) << "a = " << a;
  }
}

TEST(MoserAreaFlow, ConstantDensityMovesNothing)
{
  const TriangleMesh sphere = analytic::icosphere(3);
  const auto         result =
    moserAreaFlowPass(sphere.triangles, sphere.vertices, std::vector<double>(sphere.vertices.size(), 7.0));
  for (std::size_t v = 0; v < sphere.vertices.size(); ++v)
  {
    EXPECT_LT((result.positions[v] - sphere.vertices[v]).norm(), 1e-12);
  }
}

TEST(MoserAreaFlow, OneStepInTimeIsWorseThanSixteen)
{
  // The time error must be visible somewhere, else the count of steps would do nothing.
  EXPECT_GT(rmsErrorOfLinearDensity(5, 0.9, 1), 2.0 * rmsErrorOfLinearDensity(5, 0.9, 16));
}

TEST(MoserAreaFlow, RepeatedPassesEqualiseAnEllipsoid)
{
  const TriangleMesh surface = analytic::ellipsoidSurface(4, Vector3(20, 10, 12));
  const Positions    start = centredMap(surface);
  ASSERT_GT(sphereMapQuality(surface, start).areaRatioRms, 0.2);
  MoserAreaFlowOptions options;
  options.tolerance = 0.03;
  const auto             result = moserAreaFlow(surface, start, options);
  const SphereMapQuality quality = sphereMapQuality(surface, result.positions);
  EXPECT_TRUE(result.report.converged);
  EXPECT_TRUE(isBijective(quality));
  EXPECT_LE(quality.areaRatioRms, 0.03);
  EXPECT_NEAR(quality.areaRatioRms, result.report.residual, 1e-12);
}

TEST(MoserAreaFlow, LocalBrakeKeepsALongShapeMoving)
{
  const TriangleMesh   surface = analytic::ellipsoidSurface(4, Vector3(50, 10, 10));
  const Positions      start = centredMap(surface);
  MoserAreaFlowOptions options;
  options.maximumPasses = 2;
  const auto braked = moserAreaFlow(surface, start, options);
  EXPECT_EQ(countFlippedTriangles(surface.triangles, braked.positions), 0);
  EXPECT_LT(braked.report.residual, 0.2 * sphereMapQuality(surface, start).areaRatioRms);
}

TEST(MoserAreaFlow, StallIsReportedNotThrown)
{
  const TriangleMesh   surface = analytic::ellipsoidSurface(3, Vector3(20, 10, 12));
  MoserAreaFlowOptions options;
  options.tolerance = 1e-6; // out of reach: vertex densities cannot see single triangles
  const auto result = moserAreaFlow(surface, centredMap(surface), options);
  EXPECT_FALSE(result.report.converged);
  EXPECT_LE(result.report.steps, options.maximumPasses);
  EXPECT_LT(result.report.residual, 0.1);
}

TEST(MoserAreaFlow, TwoRunsAreEqualBitForBit)
{
  const TriangleMesh sphere = analytic::icosphere(3);
  const auto         density = linearDensity(sphere.vertices, 0.5);
  EXPECT_EQ(moserAreaFlowPass(sphere.triangles, sphere.vertices, density).positions,
            moserAreaFlowPass(sphere.triangles, sphere.vertices, density).positions);
}

TEST(MoserAreaFlow, FlippedStartIsRefused)
{
  const TriangleMesh sphere = analytic::icosphere(1);
  Positions          mirrored = sphere.vertices;
  for (Vector3 & s : mirrored)
  {
    s = -s;
  }
  EXPECT_THROW((void)moserAreaFlow(sphere, mirrored), InvalidInput);
  EXPECT_THROW((void)moserAreaFlowPass(sphere.triangles, mirrored, linearDensity(mirrored, 0.5)), InvalidInput);
}

TEST(MoserAreaFlow, BadArgumentsAreRefused)
{
  const TriangleMesh  sphere = analytic::icosphere(1);
  std::vector<double> density = linearDensity(sphere.vertices, 0.5);
  density[3] = 0.0;
  EXPECT_THROW((void)moserAreaFlowPass(sphere.triangles, sphere.vertices, density), InvalidInput);
  EXPECT_THROW((void)moserAreaFlowPass(sphere.triangles, sphere.vertices, { 1.0, 1.0 }), InvalidInput);
  EXPECT_THROW((void)moserAreaFlow(sphere, { Vector3::UnitX() }), InvalidInput);
  MoserAreaFlowOptions options;
  options.stepsPerPass = 0;
  EXPECT_THROW((void)moserAreaFlow(sphere, sphere.vertices, options), InvalidInput);
}
