// Closed form: quadratics are reproduced (1e-12); order 3 fitted on four grids; gradient against central differences.
#include "TestShapes.h"
#include "moserhex/Analytic/ObservedOrder.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/LevelSet/CubicInterpolation.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <cmath>

using namespace moserhex;

namespace
{

RegularGrid
obliqueGrid()
{
  RegularGrid grid;
  grid.size = { { 12, 10, 11 } };
  grid.spacing = 0.4;
  grid.direction =
    Eigen::AngleAxisd(0.5, Vector3(0.2, 1, -0.6).normalized()).toRotationMatrix() * Vector3(1, 1, -1).asDiagonal();
  grid.origin = Vector3(3, -8, 1);
  return grid;
}

double
quadratic(const Vector3 & p)
{
  return 1.5 + p.x() - 2.0 * p.y() * p.z() + 0.3 * p.z() * p.z() + p.x() * p.y();
}

Vector3
quadraticGradient(const Vector3 & p)
{
  return { 1.0 + p.y(), -2.0 * p.z() + p.x(), -2.0 * p.y() + 0.6 * p.z() };
}

double
smooth(const Vector3 & p)
{
  return std::sin(2.0 * p.x() + 0.3) * std::cos(1.5 * p.y()) + std::exp(0.5 * p.z());
}

Vector3
randomPoint(const RegularGrid & grid, Random & random)
{
  const Vector3 index(random.uniform(1.0, grid.size[0] - 2.0),
                      random.uniform(1.0, grid.size[1] - 2.0),
                      random.uniform(1.0, grid.size[2] - 2.0));
  return grid.origin + grid.direction * (grid.spacing * index);
}

} // namespace

TEST(CubicInterpolation, QuadraticsAreExactOnAnObliqueLeftHandedGrid)
{
  const LevelSet          f = test::sample(obliqueGrid(), quadratic);
  const CubicInterpolator interpolator(f);
  Random                  random(1);
  for (int n = 0; n < 100; ++n)
  {
    const Vector3 p = randomPoint(f.grid, random);
    EXPECT_NEAR(interpolator.value(p), quadratic(p), 1e-10);
    EXPECT_NEAR(interpolator.at(p).value, quadratic(p), 1e-10);
    EXPECT_LT((interpolator.at(p).gradient - quadraticGradient(p)).norm(), 1e-10);
  }
}

TEST(CubicInterpolation, NodesAreInterpolated)
{
  const LevelSet          f = test::randomField({ { 7, 7, 7 } }, 3);
  const CubicInterpolator interpolator(f);
  for (std::size_t node = 0; node < f.values.size(); ++node)
  {
    if (!f.grid.isBorder(node))
    {
      EXPECT_NEAR(interpolator.value(f.grid.point(node)), f.values[node], 1e-12);
    }
  }
}

TEST(CubicInterpolation, ErrorIsThirdOrder)
{
  std::vector<double> spacings;
  std::vector<double> errors;
  for (const int n : { 11, 21, 41, 81 })
  {
    const LevelSet          f = test::sample(test::unitGrid(n), smooth);
    const CubicInterpolator interpolator(f);
    Random                  random(2);
    double                  sum = 0.0;
    for (int sampleNumber = 0; sampleNumber < 4000; ++sampleNumber)
    {
      const Vector3 p(random.uniform(-0.7, 0.7), random.uniform(-0.7, 0.7), random.uniform(-0.7, 0.7));
      sum += std::pow(interpolator.value(p) - smooth(p), 2);
    }
    spacings.push_back(f.grid.spacing);
    errors.push_back(std::sqrt(sum));
  }
  EXPECT_NEAR(analytic::observedOrder(spacings, errors), 3.0, 0.1);
}

TEST(CubicInterpolation, GradientIsTheDerivativeOfTheValue)
{
  const LevelSet          f = test::randomField({ { 9, 9, 9 } }, 4);
  const CubicInterpolator interpolator(f);
  Random                  random(5);
  constexpr double        step = 1e-6;
  for (int n = 0; n < 50; ++n)
  {
    const Vector3 p = randomPoint(f.grid, random);
    for (int axis = 0; axis < 3; ++axis)
    {
      const Vector3 d = step * Vector3::Unit(axis);
      const double  difference = (interpolator.value(p + d) - interpolator.value(p - d)) / (2.0 * step);
      EXPECT_NEAR(interpolator.at(p).gradient[axis], difference, 1e-5); // the spline is C1: kinks of f'' at the nodes
    }
  }
}

TEST(CubicInterpolation, PointsOutsideTakeTheNearestPointInside)
{
  const LevelSet          f = test::sample(test::unitGrid(9), smooth);
  const CubicInterpolator interpolator(f);
  EXPECT_EQ(interpolator.value(Vector3(5.0, 0.1, 0.2)), interpolator.value(Vector3(0.75, 0.1, 0.2)));
}

TEST(CubicInterpolation, ProjectionReachesTheLevel)
{
  const LevelSet          f = test::sample(test::unitGrid(41), [](const Vector3 & p) { return p.squaredNorm(); });
  const CubicInterpolator interpolator(f);
  const Vector3           p = projectToLevel(interpolator, Vector3(0.4, 0.2, -0.1), 0.36, 0.05, 20);
  EXPECT_NEAR(p.norm(), 0.6, 1e-10);
  EXPECT_LT(p.normalized().cross(Vector3(0.4, 0.2, -0.1).normalized()).norm(), 1e-10);
}

TEST(CubicInterpolation, ProjectionStepsAreNoLongerThanAllowed)
{
  const LevelSet          f = test::sample(test::unitGrid(41), [](const Vector3 & p) { return p.norm(); });
  const CubicInterpolator interpolator(f);
  const Vector3           start(0.3, 0.2, -0.1);
  EXPECT_NEAR((projectToLevel(interpolator, start, 0.8, 0.05, 3) - start).norm(), 0.15, 1e-3);
}

TEST(CubicInterpolation, WrongNumberOfValuesIsRefused)
{
  LevelSet f = test::sample(test::unitGrid(9), smooth);
  f.values.pop_back();
  EXPECT_THROW(CubicInterpolator{ f }, InvalidInput);
}

TEST(CubicInterpolation, FewerThanFourNodesAreRefused)
{
  LevelSet f;
  f.grid.size = { { 3, 8, 8 } };
  f.values.resize(f.grid.nodeCount());
  EXPECT_THROW(CubicInterpolator{ f }, InvalidInput);
}
