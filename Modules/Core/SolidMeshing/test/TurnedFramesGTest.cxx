// Turns of the cube's frame. Coverage: half the diagonal of the lattice's cell, and a quarter for
// curvature and the rim, where the lattice does not go on evenly. The frame of
// a turned cube: the turn is on the lattice, so it is found to round-off (1e-9).
#include "TurnedFrames.h"

#include "moserhex/Analytic/SurfaceShapes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace moserhex;

namespace
{

constexpr double degree = 0.017453292519943295;

double
angleInDegrees(const Matrix3 & rotation)
{
  return Eigen::AngleAxisd(rotation).angle() / degree;
}

/** The 24 turns of the cube, as words of two quarter turns. */
std::vector<Matrix3>
cubeTurns()
{
  std::vector<Matrix3> turns{ Matrix3::Identity() };
  const Matrix3        quarters[2] = { analytic::rotation(Vector3::UnitX(), 90.0 * degree),
                                       analytic::rotation(Vector3::UnitY(), 90.0 * degree) };
  for (std::size_t t = 0; t < turns.size(); ++t)
  {
    for (const Matrix3 & quarter : quarters)
    {
      const Matrix3 next = quarter * turns[t];
      const auto    isNext = [&next](const Matrix3 & turn) { return (turn - next).norm() < 0.1; };
      if (std::none_of(turns.begin(), turns.end(), isNext))
      {
        turns.push_back(next);
      }
    }
  }
  return turns;
}

/** To the nearest of the cube's turns [degree]. */
double
angleModuloCube(const Matrix3 & rotation)
{
  double smallest = 180.0;
  for (const Matrix3 & turn : cubeTurns())
  {
    smallest = std::min(smallest, angleInDegrees(turn * rotation));
  }
  return smallest;
}

/** A cube with rounded edges, turned away from the axes; its map is the direction. */
TriangleMesh
roundedCube(const Matrix3 & turn)
{
  return analytic::starShapedSurface(4, [&](const Vector3 & direction) {
    return 20.0 / std::pow((turn.transpose() * direction).array().abs().pow(6).sum(), 1.0 / 6.0);
  });
}

} // namespace

TEST(TurnsOfTheCube, BeginAtTheIdentityAndGoOutward)
{
  const std::vector<Matrix3> turns = turnsOfTheCube(15.0);
  ASSERT_GT(turns.size(), 100u);
  EXPECT_EQ(turns.front(), Matrix3(Matrix3::Identity()));
  for (std::size_t t = 1; t < turns.size(); ++t)
  {
    EXPECT_GE(angleInDegrees(turns[t]), angleInDegrees(turns[t - 1]) - 1e-9);
  }
}

TEST(TurnsOfTheCube, NoneComesNearerByATurnOfTheCube)
{
  ASSERT_EQ(cubeTurns().size(), 24u);
  for (const Matrix3 & turn : turnsOfTheCube(20.0))
  {
    EXPECT_NEAR(angleModuloCube(turn), angleInDegrees(turn), 1e-6);
  }
}

TEST(TurnsOfTheCube, LeaveNoRotationFarAway)
{
  const double               step = 15.0;
  const std::vector<Matrix3> turns = turnsOfTheCube(step);
  for (int i = 0; i < 40; ++i)
  {
    const Vector3 axis(std::cos(3.0 * i), std::sin(5.0 * i), std::cos(7.0 * i + 1.0));
    const Matrix3 rotation = analytic::rotation(axis.normalized(), 0.1 * i);
    double        nearest = 180.0;
    for (const Matrix3 & turn : turns)
    {
      nearest = std::min(nearest, angleModuloCube(rotation * turn.transpose()));
    }
    EXPECT_LT(nearest, 1.25 * 0.5 * std::sqrt(3.0) * step) << i;
  }
}

TEST(PromisingTurns, BringTheFrameOntoATurnedCube)
{
  const Vector3              vector = 12.5 * degree * Vector3(2, 1, 0);
  const Matrix3              turn = analytic::rotation(vector.normalized(), vector.norm());
  const std::vector<Matrix3> turns = promisingTurns(roundedCube(turn), analytic::icosphere(4).vertices, 5, 1);
  ASSERT_EQ(turns.size(), 5u);
  EXPECT_LT(angleModuloCube(turns.front() * turn), 1e-6);
  for (const Matrix3 & other : turns)
  {
    EXPECT_GT(angleInDegrees(other), 1.0) << "the frame's own attitude is not among them";
  }
}

TEST(PromisingTurns, AreTheSameForAnyNumberOfThreads)
{
  const TriangleMesh surface = roundedCube(analytic::rotation(Vector3(1, 2, 3).normalized(), 0.4));
  EXPECT_EQ(promisingTurns(surface, analytic::icosphere(4).vertices, 9, 1),
            promisingTurns(surface, analytic::icosphere(4).vertices, 9, 3));
}
