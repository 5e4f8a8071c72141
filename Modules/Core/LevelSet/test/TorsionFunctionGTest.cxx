// Closed-form class: torsion of a ball and of an ellipsoid are quadratic; the error has order 2 in the spacing (fitted
// slope within 0.15: the distance of the nearest node to the surface varies from grid to grid). Exact class: refusals.
#include "moserhex/Analytic/ObservedOrder.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/LevelSet/TorsionFunction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace moserhex;

namespace
{

/** phi of the ellipsoid sum (x_a / axes_a)^2 < 1, scaled so that it is a distance to first order for a ball. */
LevelSet
ellipsoid(const Vector3 & axes, double spacing)
{
  LevelSet phi;
  phi.grid.spacing = spacing;
  for (std::size_t a = 0; a < 3; ++a)
  {
    phi.grid.size[a] = 2 * static_cast<int>(std::ceil(axes[static_cast<int>(a)] / spacing) + 2) + 1;
    phi.grid.origin[static_cast<int>(a)] = -spacing * (phi.grid.size[a] / 2) + 0.123 * spacing;
  }
  phi.values.resize(phi.grid.nodeCount());
  for (std::size_t node = 0; node < phi.values.size(); ++node)
  {
    phi.values[node] = axes.minCoeff() * (phi.grid.point(node).cwiseQuotient(axes).norm() - 1.0);
  }
  return phi;
}

double
largestError(const LevelSet & phi, const Vector3 & axes)
{
  // u = (1 - sum (x_a/axes_a)^2) / (2 sum 1/axes_a^2) has -Lap u = 1.
  const double scale = 0.5 / axes.cwiseInverse().squaredNorm();
  const auto   result = torsionFunction(phi);
  EXPECT_TRUE(result.report.converged);
  double error = 0.0;
  for (std::size_t node = 0; node < phi.values.size(); ++node)
  {
    const double exact = std::max(0.0, scale * (1.0 - phi.grid.point(node).cwiseQuotient(axes).squaredNorm()));
    error = std::max(error, std::abs(result.levelSet.values[node] - exact));
  }
  return error;
}

double
observedOrder(const Vector3 & axes)
{
  std::vector<double> spacings;
  std::vector<double> errors;
  for (int i = 0; i < 5; ++i)
  {
    spacings.push_back(1.6 / std::pow(1.5, i));
    errors.push_back(largestError(ellipsoid(axes, spacings.back()), axes));
  }
  return analytic::observedOrder(spacings, errors);
}

} // namespace

TEST(TorsionFunction, BallIsAParaboloidWithOrderTwo)
{
  // On a ball of radius R: u = (R^2 - r^2) / 6.
  EXPECT_LT(largestError(ellipsoid({ 9, 9, 9 }, 0.5), { 9, 9, 9 }), 0.01);
  EXPECT_NEAR(observedOrder({ 9, 9, 9 }), 2.0, 0.15);
}

TEST(TorsionFunction, EllipsoidIsAParaboloidWithOrderTwo)
{
  EXPECT_NEAR(observedOrder({ 14, 7, 9 }), 2.0, 0.15);
}

TEST(TorsionFunction, IsZeroOutsideAndPositiveInside)
{
  const LevelSet phi = ellipsoid({ 6, 5, 4 }, 0.7);
  const auto     u = torsionFunction(phi).levelSet;
  for (std::size_t node = 0; node < phi.values.size(); ++node)
  {
    EXPECT_EQ(u.values[node] > 0.0, phi.values[node] < 0.0);
  }
}

TEST(TorsionFunction, DoesNotChangeWhenTheGridIsTurned)
{
  LevelSet       phi = ellipsoid({ 6, 5, 4 }, 0.7);
  const LevelSet before = torsionFunction(phi).levelSet;
  phi.grid.direction << 0.6, -0.8, 0, 0.8, 0.6, 0, 0, 0, -1;
  phi.grid.origin = Vector3(100, -50, 7);
  EXPECT_EQ(torsionFunction(phi).levelSet.values, before.values);
}

TEST(TorsionFunction, ScalesWithTheSquareOfLength)
{
  LevelSet       phi = ellipsoid({ 6, 5, 4 }, 0.7);
  const LevelSet before = torsionFunction(phi).levelSet;
  for (const double scale : { 1e-8, 1e8 })
  {
    LevelSet scaled = phi;
    scaled.grid.spacing *= scale;
    for (double & value : scaled.values)
    {
      value *= scale;
    }
    const LevelSet after = torsionFunction(scaled).levelSet;
    for (std::size_t node = 0; node < phi.values.size(); node += 37)
    {
      EXPECT_NEAR(after.values[node] / (scale * scale), before.values[node], 1e-9 * 3);
    }
  }
}

TEST(TorsionFunction, ReportsTheTrueResidual)
{
  TorsionFunctionOptions options;
  options.relativeTolerance = 1e-11;
  const auto result = torsionFunction(ellipsoid({ 6, 5, 4 }, 0.7), options);
  EXPECT_LE(result.report.residual, 2e-11);
  EXPECT_GT(result.report.steps, 5);
}

TEST(TorsionFunction, TooFewIterationsAreNotSilent)
{
  TorsionFunctionOptions options;
  options.maximumIterations = 3;
  EXPECT_THROW((void)torsionFunction(ellipsoid({ 6, 5, 4 }, 0.7), options), NotConverged);
}

TEST(TorsionFunction, EmptyAndTouchingOrgansAreRefused)
{
  LevelSet phi = ellipsoid({ 6, 5, 4 }, 0.7);
  LevelSet empty = phi;
  std::fill(empty.values.begin(), empty.values.end(), 1.0);
  EXPECT_THROW((void)torsionFunction(empty), InvalidInput);
  phi.values[0] = -1.0;
  EXPECT_THROW((void)torsionFunction(phi), InvalidInput);
}

TEST(TorsionFunction, OptionsOutOfRangeAreRefused)
{
  const LevelSet phi = ellipsoid({ 6, 5, 4 }, 0.7);
  const auto     refused = [&](auto change) {
    TorsionFunctionOptions options;
    change(options);
    EXPECT_THROW((void)torsionFunction(phi, options), InvalidInput);
  };
  refused([](auto & o) { o.relativeTolerance = 0; });
  refused([](auto & o) { o.maximumIterations = 0; });
  refused([](auto & o) { o.smallestFraction = 0; });
}
