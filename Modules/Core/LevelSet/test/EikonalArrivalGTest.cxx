// Closed-form class: with constant speed the time is the distance over the speed, of order 1 when the source has a
// fixed size in millimetres (fitted slope within 0.1); with speed 1 + a x it is an arc cosh (Snell), of order h log h
// when the source has a fixed size in nodes (slope above 0.5). Exact class: refusals, symmetry.
#include "moserhex/Analytic/ObservedOrder.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/LevelSet/EikonalArrival.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace moserhex;

namespace
{

constexpr double radius = 10.0;

/** Ball around the middle node; nodesPerRadius sets the spacing. */
LevelSet
ball(int nodesPerRadius)
{
  LevelSet  phi;
  const int n = 2 * nodesPerRadius + 5;
  phi.grid.size = { n, n, n };
  phi.grid.spacing = radius / nodesPerRadius;
  phi.grid.origin = Vector3::Constant(-phi.grid.spacing * (n / 2));
  phi.values.resize(phi.grid.nodeCount());
  for (std::size_t node = 0; node < phi.values.size(); ++node)
  {
    phi.values[node] = phi.grid.point(node).norm() - radius;
  }
  return phi;
}

LevelSet
constantSpeed(const LevelSet & phi, double speed)
{
  return { phi.grid, std::vector<double>(phi.values.size(), speed) };
}

std::size_t
centre(const LevelSet & phi)
{
  return phi.values.size() / 2;
}

/** Largest error of T h (an integral over millimetres) against the closed form. */
template <typename TSpeed, typename TExact>
double
largestError(int nodesPerRadius, double sourceRadius, const TSpeed & speed, const TExact & exact)
{
  const LevelSet phi = ball(nodesPerRadius);
  LevelSet       weight = phi;
  for (std::size_t node = 0; node < phi.values.size(); ++node)
  {
    weight.values[node] = speed(phi.grid.point(node));
  }
  EikonalArrivalOptions options;
  options.sourceRadius = sourceRadius;
  const LevelSet time = eikonalArrival(phi, weight, centre(phi), options).levelSet;
  double         error = 0.0;
  for (std::size_t node = 0; node < phi.values.size(); ++node)
  {
    if (phi.values[node] < 0.0)
    {
      error = std::max(error, std::abs(time.values[node] * phi.grid.spacing - exact(phi.grid.point(node))));
    }
  }
  return error;
}

} // namespace

TEST(EikonalArrival, ConstantSpeedGivesDistanceOverSpeedWithOrderOne)
{
  const auto          speed = [](const Vector3 &) { return 2.5; };
  const auto          exact = [](const Vector3 & p) { return p.norm() / 2.5; };
  std::vector<double> spacings;
  std::vector<double> errors;
  for (const int nodes : { 10, 14, 20, 28 })
  {
    spacings.push_back(1.0 / nodes);
    errors.push_back(largestError(nodes, 0.3 * nodes, speed, exact));
  }
  EXPECT_NEAR(analytic::observedOrder(spacings, errors), 1.0, 0.1);
}

TEST(EikonalArrival, LinearSpeedGivesSnellsTime)
{
  // Speed 1 + a x: T = arccosh(1 + a^2 r^2 / (2 (1 + a x))) / a from the origin.
  constexpr double a = 0.05;
  const auto       speed = [](const Vector3 & p) { return std::max(0.1, 1.0 + a * p.x()); };
  const auto       exact = [](const Vector3 & p) {
    return std::acosh(1.0 + a * a * p.squaredNorm() / (2.0 * (1.0 + a * p.x()))) / a;
  };
  const double coarse = largestError(8, 2, speed, exact);
  const double fine = largestError(32, 2, speed, exact);
  EXPECT_LT(fine, 0.6);
  EXPECT_GT(std::log(coarse / fine) / std::log(4.0), 0.5);
}

TEST(EikonalArrival, IsSymmetricUnderReflectionOfTheGrid)
{
  const LevelSet phi = ball(7);
  const LevelSet time = eikonalArrival(phi, constantSpeed(phi, 1), centre(phi)).levelSet;
  for (std::size_t node = 0; node < phi.values.size(); ++node)
  {
    const double other = time.values[phi.values.size() - 1 - node];
    EXPECT_TRUE(time.values[node] == other || std::abs(time.values[node] - other) < 1e-9);
  }
}

TEST(EikonalArrival, OutsideIsNeverReached)
{
  const LevelSet phi = ball(6);
  const LevelSet time = eikonalArrival(phi, constantSpeed(phi, 1), centre(phi)).levelSet;
  for (std::size_t node = 0; node < phi.values.size(); ++node)
  {
    EXPECT_EQ(std::isfinite(time.values[node]), phi.values[node] < 0.0);
  }
  EXPECT_EQ(time.values[centre(phi)], 0.0);
}

TEST(EikonalArrival, PartsWithoutAWayToTheSeedStayAtInfinity)
{
  LevelSet phi = ball(6);
  for (std::size_t node = 0; node < phi.values.size(); ++node)
  {
    if (std::abs(phi.grid.point(node).x()) < 1.1 * phi.grid.spacing)
    {
      phi.values[node] = 1.0; // a wall
    }
  }
  const std::size_t seed = phi.grid.nodeNumber(5, 8, 8);
  ASSERT_LT(phi.values[seed], 0.0);
  const LevelSet time = eikonalArrival(phi, constantSpeed(phi, 1), seed).levelSet;
  EXPECT_TRUE(std::isinf(time.values[phi.grid.nodeNumber(11, 8, 8)]));
  EXPECT_TRUE(std::isfinite(time.values[phi.grid.nodeNumber(4, 9, 8)]));
}

TEST(EikonalArrival, WrongInputIsRefused)
{
  const LevelSet phi = ball(5);
  const LevelSet weight = constantSpeed(phi, 1);
  EXPECT_THROW((void)eikonalArrival(phi, constantSpeed(ball(6), 1), centre(phi)), InvalidInput);
  EXPECT_THROW((void)eikonalArrival(phi, weight, 0), InvalidInput);
  EXPECT_THROW((void)eikonalArrival(phi, weight, phi.values.size()), InvalidInput);
  for (const double bad : { 0.0, -1.0, std::numeric_limits<double>::infinity() })
  {
    LevelSet wrong = weight;
    wrong.values[centre(phi) + 2] = bad;
    EXPECT_THROW((void)eikonalArrival(phi, wrong, centre(phi)), InvalidInput);
  }
  LevelSet touching = phi;
  touching.values[0] = -1.0;
  EXPECT_THROW((void)eikonalArrival(touching, weight, centre(phi)), InvalidInput);
  EikonalArrivalOptions options;
  options.maximumSweeps = 7;
  EXPECT_THROW((void)eikonalArrival(phi, weight, centre(phi), options), InvalidInput);
}

TEST(EikonalArrival, TooFewSweepsAreNotSilent)
{
  const LevelSet        phi = ball(6);
  EikonalArrivalOptions options;
  options.maximumSweeps = 8; // the second round of eight would see that nothing changes
  EXPECT_THROW((void)eikonalArrival(phi, constantSpeed(phi, 1), centre(phi), options), NotConverged);
}
