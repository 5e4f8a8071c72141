// Round-off class (1e-12): rotations that are known are found again.
#include "moserhex/Analytic/SurfaceShapes.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/SphericalMap/FrameAlignment.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <limits>

using namespace moserhex;

TEST(FrameAlignment, KnownRotationIsFoundAgain)
{
  const Positions           directions = analytic::icosphere(1).vertices;
  const Matrix3             expected = analytic::rotation(Vector3(1, 2, -1), 2.3);
  const std::vector<double> weights(directions.size(), 0.7);
  EXPECT_TRUE(bestRotation(directions, rotated(directions, expected), weights).isApprox(expected, 1e-12));
}

TEST(FrameAlignment, MirrorImageGivesARotationStill)
{
  const Positions directions = analytic::icosphere(1).vertices;
  Positions       mirrored = directions;
  for (Vector3 & s : mirrored)
  {
    s[1] = -s[1];
  }
  std::vector<double> weights(directions.size(), 1.0);
  weights[0] = 3.0; // breaks the symmetry
  const Matrix3 rotation = bestRotation(directions, mirrored, weights);
  EXPECT_NEAR(rotation.determinant(), 1.0, 1e-12);
  EXPECT_TRUE((rotation * rotation.transpose()).isIdentity(1e-12));
}

TEST(FrameAlignment, WeightsDecideBetweenDirections)
{
  // One heavy pair is matched exactly when the others cannot all be.
  const Positions           from{ Vector3::UnitX(), Vector3::UnitY() };
  const Positions           to{ Vector3::UnitX(), (Vector3::UnitY() + Vector3::UnitX()).normalized() };
  const std::vector<double> weights{ 1e9, 1.0 };
  EXPECT_TRUE((bestRotation(from, to, weights) * from[0]).isApprox(to[0], 1e-8));
}

TEST(FrameAlignment, TurnedMapOfTheBodyComesBackToTheBody)
{
  const TriangleMesh surface =
    analytic::starShapedSurface(3, [](const Vector3 & n) { return 10.0 * (1.0 + 0.2 * n[0] + 0.1 * n[1] * n[2]); });
  const Positions sphere = analytic::icosphere(3).vertices; // the map "direction from the origin"
  const Matrix3   turn = analytic::rotation(Vector3(0.2, 1, 0.4), 1.9);
  const Matrix3   reference = bodyFrameRotation(surface, sphere);
  EXPECT_TRUE((bodyFrameRotation(surface, rotated(sphere, turn)) * turn).isApprox(reference, 1e-12));
  EXPECT_LT((reference - Matrix3::Identity()).norm(), 0.1) << "directions on the sphere nearly are those in the body";
}

TEST(FrameAlignment, RotatedBodyRotatesTheFrame)
{
  TriangleMesh surface = analytic::ellipsoidSurface(2, Vector3(3, 2, 1));
  const auto   sphere = analytic::icosphere(2).vertices;
  const auto   reference = bodyFrameRotation(surface, sphere);
  const auto   turn = analytic::rotation(Vector3(1, 1, 0), 0.8);
  for (Vector3 & p : surface.vertices)
  {
    p = turn * p + Vector3(5, -3, 2);
  }
  EXPECT_TRUE(bodyFrameRotation(surface, sphere).isApprox(turn * reference, 1e-10));
}

TEST(FrameAlignment, ShellIsAlignedToItsReference)
{
  const TriangleMesh surface = analytic::ellipsoidSurface(2, Vector3(3, 2, 1));
  const Positions    sphere = analytic::icosphere(2).vertices;
  const Matrix3      turn = analytic::rotation(Vector3(-1, 0.3, 2), 0.4);
  EXPECT_TRUE(referenceFrameRotation(surface, sphere, rotated(sphere, turn)).isApprox(turn, 1e-12));
}

TEST(FrameAlignment, BadArgumentsAreRefused)
{
  const TriangleMesh surface = analytic::icosphere(1);
  const Positions    few(3, Vector3::UnitX());
  EXPECT_THROW((void)bestRotation({}, {}, {}), InvalidInput);
  EXPECT_THROW((void)bestRotation(few, few, { 1.0 }), InvalidInput);
  EXPECT_THROW((void)bestRotation(few, few, { 1.0, std::numeric_limits<double>::quiet_NaN(), 1.0 }), InvalidInput);
  EXPECT_THROW((void)bodyFrameRotation(surface, few), InvalidInput);
  EXPECT_THROW((void)referenceFrameRotation(surface, surface.vertices, few), InvalidInput);
}
