// Areas: solid angles of fine polygons, error O(h^2) of straight sides, so tolerances follow the subdivision; the
// pointwise Jacobian is by central differences (1e-8). Round trip and symmetry: round-off (1e-13).
#include "moserhex/StructuredGrid/CubeToSphere.h"

#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Random.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

using namespace moserhex;

namespace
{

/** The rotations of the cube: signed permutation matrices of determinant 1. */
std::vector<Matrix3>
cubeRotations()
{
  std::vector<Matrix3> rotations;
  const int permutations[6][3] = { { 0, 1, 2 }, { 1, 2, 0 }, { 2, 0, 1 }, { 0, 2, 1 }, { 2, 1, 0 }, { 1, 0, 2 } };
  for (const auto & permutation : permutations)
  {
    for (int signs = 0; signs < 8; ++signs)
    {
      Matrix3 matrix = Matrix3::Zero();
      for (int row = 0; row < 3; ++row)
      {
        matrix(row, permutation[row]) = (signs >> row & 1) != 0 ? -1.0 : 1.0;
      }
      if (matrix.determinant() > 0.0)
      {
        rotations.push_back(matrix);
      }
    }
  }
  return rotations;
}

std::vector<Vector3>
randomSurfacePoints(int count)
{
  Random               random(11);
  std::vector<Vector3> points;
  for (int i = 0; i < count; ++i)
  {
    Vector3 point(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    point[static_cast<Eigen::Index>(random.next() % 3)] = random.uniform() < 0.5 ? -1.0 : 1.0;
    points.push_back(point);
  }
  return points;
}

double
solidAngle(const Vector3 & a, const Vector3 & b, const Vector3 & c)
{
  return 2.0 * std::atan2(a.dot(b.cross(c)), 1.0 + a.dot(b) + b.dot(c) + c.dot(a));
}

/** Solid angle of the image of the rectangle [x0,x1] x [y0,y1] of the face z = 1, from a fan over its boundary. */
double
imageSolidAngle(double x0, double x1, double y0, double y1, int pieces)
{
  std::vector<Vector3> boundary;
  const auto           side = [&](double ax, double ay, double bx, double by) {
    for (int i = 0; i < pieces; ++i)
    {
      const double t = static_cast<double>(i) / pieces;
      boundary.push_back(cubeToSphere({ ax + t * (bx - ax), ay + t * (by - ay), 1.0 }));
    }
  };
  side(x0, y0, x1, y0);
  side(x1, y0, x1, y1);
  side(x1, y1, x0, y1);
  side(x0, y1, x0, y0);
  const Vector3 centre = cubeToSphere({ 0.5 * (x0 + x1), 0.5 * (y0 + y1), 1.0 });
  double        sum = 0.0;
  for (std::size_t i = 0; i < boundary.size(); ++i)
  {
    sum += solidAngle(centre, boundary[i], boundary[(i + 1) % boundary.size()]);
  }
  return sum;
}
} // namespace

TEST(CubeToSphere, JacobianIsConstantAwayFromTheDiagonals)
{
  const double expected = 4.0 * pi / 24.0;
  const double step = 1e-5;
  for (const auto & [x, y] : std::vector<std::pair<double, double>>{
         { 0.3, 0.1 }, { 0.9, -0.7 }, { -0.5, 0.2 }, { 0.1, 0.8 }, { -0.2, -0.95 }, { 0.999, 0.05 }, { 0.6, 0.59 } })
  {
    const Vector3 dx = (cubeToSphere({ x + step, y, 1 }) - cubeToSphere({ x - step, y, 1 })) / (2 * step);
    const Vector3 dy = (cubeToSphere({ x, y + step, 1 }) - cubeToSphere({ x, y - step, 1 })) / (2 * step);
    EXPECT_NEAR(dx.cross(dy).dot(cubeToSphere({ x, y, 1 })), expected, 1e-8) << x << " " << y;
  }
}

TEST(CubeToSphere, RectanglesKeepTheirShareOfArea)
{
  const double perArea = 4.0 * pi / 24.0;
  for (const auto & r : std::vector<std::array<double, 4>>{
         { -1, 1, -1, 1 }, { 0, 1, 0, 1 }, { -0.3, 0.8, 0.1, 0.4 }, { 0.9, 1, 0.9, 1 }, { -0.05, 0.05, -0.05, 0.05 } })
  {
    const double area = (r[1] - r[0]) * (r[3] - r[2]);
    EXPECT_NEAR(imageSolidAngle(r[0], r[1], r[2], r[3], 2000) / (area * perArea), 1.0, 2e-7);
  }
}

TEST(CubeToSphere, AreaErrorOfPolygonsFallsWithOrderTwo)
{
  const double exact = 4.0 * pi / 24.0 * 0.4 * 0.5;
  double       previous = 0.0;
  for (const int pieces : { 10, 20, 40, 80 })
  {
    const double error = std::abs(imageSolidAngle(0.5, 0.9, -0.2, 0.3, pieces) - exact);
    if (previous > 0.0)
    {
      EXPECT_NEAR(std::log2(previous / error), 2.0, 0.1);
    }
    previous = error;
  }
}

TEST(CubeToSphere, InverseRoundTrip)
{
  for (const Vector3 & point : randomSurfacePoints(2000))
  {
    const Vector3 direction = cubeToSphere(point);
    EXPECT_NEAR(direction.norm(), 1.0, 1e-15);
    EXPECT_LT((sphereToCube(direction) - point).norm(), 1e-13);
    EXPECT_LT((cubeToSphere(sphereToCube(-3.0 * direction)) + direction).norm(), 1e-13);
  }
}

TEST(CubeToSphere, CommutesWithThe24RotationsOfTheCube)
{
  const auto rotations = cubeRotations();
  ASSERT_EQ(rotations.size(), 24U);
  for (const Vector3 & point : randomSurfacePoints(50))
  {
    for (const Matrix3 & rotation : rotations)
    {
      EXPECT_LT((cubeToSphere(rotation * point) - rotation * cubeToSphere(point)).norm(), 1e-14);
    }
  }
}

TEST(CubeToSphere, CentresEdgesAndCornersKeepTheirDirections)
{
  EXPECT_LT((cubeToSphere({ 0, 0, 1 }) - Vector3(0, 0, 1)).norm(), 1e-15);
  EXPECT_LT((cubeToSphere({ 1, 0, -1 }) - Vector3(1, 0, -1).normalized()).norm(), 1e-15);
  EXPECT_LT((cubeToSphere({ -1, 1, 1 }) - Vector3(-1, 1, 1).normalized()).norm(), 1e-15);
  EXPECT_LT((sphereToCube({ 5, 0, 0 }) - Vector3(1, 0, 0)).norm(), 1e-15);
}

TEST(CubeToSphere, IsContinuousAcrossEdgesAndDiagonals)
{
  const double tiny = 1e-12;
  for (const double t : { -1.0, -0.4, 0.0, 0.7, 1.0 })
  {
    EXPECT_LT((cubeToSphere({ 1, t, 1 - tiny }) - cubeToSphere({ 1 - tiny, t, 1 })).norm(), 1e-11);
    EXPECT_LT((cubeToSphere({ t, t * (1 - tiny), 1 }) - cubeToSphere({ t * (1 - tiny), t, 1 })).norm(), 1e-11);
  }
}

TEST(CubeToSphere, PointOffTheSurfaceIsRefused)
{
  EXPECT_THROW(static_cast<void>(cubeToSphere({ 0.5, 0.2, 0.9 })), InvalidInput);
  EXPECT_THROW(static_cast<void>(cubeToSphere({ 0.5, 1.1, 0.9 })), InvalidInput);
  EXPECT_THROW(static_cast<void>(cubeToSphere({ std::numeric_limits<double>::quiet_NaN(), 0, 0 })), InvalidInput);
}

TEST(CubeToSphere, DirectionWithoutLengthIsRefused)
{
  EXPECT_THROW(static_cast<void>(sphereToCube(Vector3::Zero())), InvalidInput);
  EXPECT_THROW(static_cast<void>(sphereToCube({ std::numeric_limits<double>::infinity(), 0, 0 })), InvalidInput);
}
