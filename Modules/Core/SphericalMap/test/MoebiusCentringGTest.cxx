// Round-off class: the centroid is the criterion itself (1e-12); a boost and its inverse cancel to 1e-13.
#include "TestPositions.h"
#include "moserhex/Analytic/SurfaceShapes.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/SphericalMap/FrameAlignment.h"
#include "moserhex/SphericalMap/MoebiusCentring.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

using namespace moserhex;
using namespace moserhex::testing;

namespace
{

Positions
boosted(Positions sphere, const Vector3 & c)
{
  for (Vector3 & s : sphere)
  {
    s = moebiusBoost(s, c).normalized();
  }
  return sphere;
}

} // namespace

TEST(MoebiusCentring, BoostStaysOnTheSphereAndItsOppositeUndoesIt)
{
  const Vector3 c(0.3, -0.2, 0.4);
  for (const Vector3 & s : analytic::icosphere(2).vertices)
  {
    EXPECT_NEAR(moebiusBoost(s, c).norm(), 1.0, 1e-14);
    EXPECT_LT((moebiusBoost(moebiusBoost(s, c), -c) - s).norm(), 1e-13);
  }
}

TEST(MoebiusCentring, BoostKeepsAngles)
{
  // Angle between two small steps at a point, before and after: conformal, so equal up to the step size.
  const Vector3 c(0.5, 0.1, -0.3);
  const Vector3 s = Vector3(1, 2, 3).normalized();
  const Vector3 u = s.cross(Vector3::UnitX()).normalized();
  const Vector3 v = (u + 0.7 * s.cross(u)).normalized();
  const double  step = 1e-6;
  const auto    image = [&](const Vector3 & p) { return moebiusBoost(p.normalized(), c); };
  const Vector3 du = (image(s + step * u) - image(s - step * u)).normalized();
  const Vector3 dv = (image(s + step * v) - image(s - step * v)).normalized();
  EXPECT_NEAR(du.dot(dv), u.dot(v), 1e-9);
}

TEST(MoebiusCentring, CentroidIsAtTheCentreAfterFewSteps)
{
  const TriangleMesh surface = analytic::ellipsoidSurface(3, Vector3(3, 1, 1));
  const auto result = moebiusCentring(surface, boosted(analytic::icosphere(3).vertices, Vector3(0.4, 0.5, 0.1)));
  EXPECT_TRUE(result.report.converged);
  EXPECT_LE(result.report.residual, 1e-12);
  EXPECT_LE(result.report.steps, 8);
}

TEST(MoebiusCentring, UndoesABoostOfTheSphere)
{
  const TriangleMesh sphere = analytic::icosphere(3);
  for (const double strength : { 0.3, 0.9, 0.99 })
  {
    const Vector3   boost = strength * Vector3(1, -2, 2).normalized();
    const auto      result = moebiusCentring(sphere, boosted(sphere.vertices, boost));
    const Positions aligned = rotated(result.positions, bodyFrameRotation(sphere, result.positions));
    EXPECT_LT(largestDistance(aligned, sphere.vertices), 1e-10) << "boost " << strength;
  }
}

TEST(MoebiusCentring, ScaleOfTheSurfaceDoesNotMatter)
{
  TriangleMesh surface = analytic::ellipsoidSurface(2, Vector3(2, 1, 1));
  const auto   start = boosted(analytic::icosphere(2).vertices, Vector3(0.2, 0.1, 0.0));
  const auto   reference = moebiusCentring(surface, start);
  for (Vector3 & p : surface.vertices)
  {
    p *= 1e-8;
  }
  EXPECT_LT(largestDistance(moebiusCentring(surface, start).positions, reference.positions), 1e-11);
}

TEST(MoebiusCentring, AllAreaInOnePointIsNotConverged)
{
  const TriangleMesh sphere = analytic::icosphere(1);
  const Positions    point(sphere.vertices.size(), Vector3::UnitZ());
  EXPECT_THROW((void)moebiusCentring(sphere, point), NotConverged);
}

TEST(MoebiusCentring, BadArgumentsAreRefused)
{
  TriangleMesh surface = analytic::icosphere(1);
  EXPECT_THROW((void)moebiusCentring(surface, Positions(2, Vector3::UnitX())), InvalidInput);
  const Positions sphere = surface.vertices;
  for (Vector3 & p : surface.vertices)
  {
    p.setZero();
  }
  EXPECT_THROW((void)moebiusCentring(surface, sphere), InvalidInput);
}
