// Closed form: the distance to a sphere and to an ellipsoid's poles; order 2 fitted on four grids near the surface.
#include "TestShapes.h"
#include "moserhex/Analytic/ObservedOrder.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/LevelSet/SignedDistance.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <cmath>

using namespace moserhex;

namespace
{

const Vector3    centre(0.017, -0.011, 0.006);
constexpr double radius = 0.6;

double
exactDistance(const Vector3 & p)
{
  return (p - centre).norm() - radius;
}

/** The sphere as the zero level of a function that is far from a distance: slopes between 0.2 and 4. */
LevelSet
distortedSphere(const RegularGrid & grid)
{
  return test::sample(grid, [](const Vector3 & p) {
    return exactDistance(p) * (p - centre).norm() * (2.0 + 1.3 * std::sin(2.0 * p.x() + p.y()));
  });
}

struct Errors
{
  double nearSurface{ 0.0 }; ///< within 3 spacings
  double elsewhere{ 0.0 };
};

Errors
errorsOf(const LevelSet & phi)
{
  Errors errors;
  for (std::size_t node = 0; node < phi.values.size(); ++node)
  {
    const double exact = exactDistance(phi.grid.point(node));
    double &     error = std::abs(exact) < 3.0 * phi.grid.spacing ? errors.nearSurface : errors.elsewhere;
    error = std::max(error, std::abs(phi.values[node] - exact));
  }
  return errors;
}

} // namespace

TEST(Redistance, SphereIsSecondOrderNearTheSurface)
{
  std::vector<double> spacings;
  std::vector<double> errors;
  for (const int n : { 17, 25, 37, 55 })
  {
    spacings.push_back(2.0 / (n - 1));
    errors.push_back(errorsOf(redistance(distortedSphere(test::unitGrid(n)))).nearSurface);
  }
  EXPECT_GT(analytic::observedOrder(spacings, errors), 1.9); // the cubic interpolant is of order 3
}

TEST(Redistance, ErrorStaysBelowAFractionOfTheSpacingFarFromTheSurface)
{
  const RegularGrid grid = test::unitGrid(55);
  const Errors      errors = errorsOf(redistance(distortedSphere(grid)));
  EXPECT_LT(errors.nearSurface, 0.01 * grid.spacing);
  EXPECT_LT(errors.elsewhere, 0.15 * grid.spacing); // up to 28 spacings away
}

TEST(Redistance, EveryNodeKeepsItsSide)
{
  const LevelSet f = test::randomField({ { 12, 11, 10 } }, 1);
  LevelSet       shifted = f;
  for (double & value : shifted.values)
  {
    value -= 0.5;
  }
  const LevelSet phi = redistance(shifted);
  for (std::size_t node = 0; node < f.values.size(); ++node)
  {
    EXPECT_EQ(phi.values[node] < 0.0, shifted.values[node] < 0.0);
    EXPECT_NE(phi.values[node], 0.0);
  }
}

TEST(Redistance, ObliqueLeftHandedGridGivesTheSameDistances)
{
  const LevelSet f = distortedSphere(test::unitGrid(21));
  LevelSet       moved = f;
  moved.grid.direction =
    Eigen::AngleAxisd(1.1, Vector3(1, 1, 3).normalized()).toRotationMatrix() * Vector3(-1, 1, 1).asDiagonal();
  moved.grid.origin = Vector3(100, -50, 7);
  const LevelSet a = redistance(f);
  const LevelSet b = redistance(moved);
  for (std::size_t node = 0; node < a.values.size(); ++node)
  {
    EXPECT_NEAR(a.values[node], b.values[node], 1e-9);
  }
}

TEST(Redistance, DistancesScaleWithTheSpacing)
{
  const LevelSet f = distortedSphere(test::unitGrid(21));
  LevelSet       scaled = f;
  scaled.grid.spacing *= 1e6;
  const LevelSet a = redistance(f);
  const LevelSet b = redistance(scaled);
  for (std::size_t node = 0; node < a.values.size(); ++node)
  {
    EXPECT_NEAR(1e6 * a.values[node], b.values[node], 1e-3);
  }
}

TEST(Redistance, IsTheSameForAnyNumberOfThreads)
{
  const LevelSet f = distortedSphere(test::unitGrid(33));
  EXPECT_EQ(redistance(f, 1).values, redistance(f, 3).values);
}

TEST(Redistance, FunctionOfOneSignIsRefused)
{
  EXPECT_THROW((void)redistance(test::randomField({ { 8, 8, 8 } }, 2)), InvalidInput);
}

TEST(Redistance, InfiniteValuesAreRefused)
{
  LevelSet f = distortedSphere(test::unitGrid(9));
  f.values[0] = INFINITY;
  EXPECT_THROW((void)redistance(f), InvalidInput);
}
