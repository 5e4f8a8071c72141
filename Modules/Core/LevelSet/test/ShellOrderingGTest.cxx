// Exact class: topology and nesting of every level set, whatever the arrival times are. Closed-form class: the ordering
// of a ball is the squared relative radius (within the ranks of one layer of nodes, 0.02).
#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Random.h"
#include "moserhex/Geometry/TriangleTopology.h"
#include "moserhex/LevelSet/EikonalArrival.h"
#include "moserhex/LevelSet/MarchingTetrahedra.h"
#include "moserhex/LevelSet/ShellOrdering.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace moserhex;

namespace
{

template <typename TFunction>
LevelSet
sampled(double extent, double spacing, const TFunction & f)
{
  LevelSet  phi;
  const int n = 2 * static_cast<int>(extent / spacing + 3) + 1;
  phi.grid.size = { n, n, n };
  phi.grid.spacing = spacing;
  phi.grid.origin = Vector3::Constant(-spacing * (n / 2) + 0.1 * spacing);
  phi.values.resize(phi.grid.nodeCount());
  for (std::size_t node = 0; node < phi.values.size(); ++node)
  {
    phi.values[node] = f(phi.grid.point(node));
  }
  return phi;
}

LevelSet
ball(double spacing = 0.7)
{
  return sampled(10, spacing, [](const Vector3 & p) { return p.norm() - 10; });
}

LevelSet
dumbbell()
{
  return sampled(14, 0.7, [](const Vector3 & p) {
    const double left = (p + Vector3(8, 0, 0)).norm() - 5.5;
    const double right = (p - Vector3(8, 0, 0)).norm() - 5;
    const double bar = std::max(std::abs(p.x()) - 8, std::hypot(p.y(), p.z()) - 2);
    return std::min(std::min(left, right), bar);
  });
}

std::size_t
deepestNode(const LevelSet & phi)
{
  return static_cast<std::size_t>(std::min_element(phi.values.begin(), phi.values.end()) - phi.values.begin());
}

void
expectAllLevelsAreSpheres(const LevelSet & s)
{
  const double lowest = *std::min_element(s.values.begin(), s.values.end());
  for (double level = lowest + 0.002; level < 1.0; level += 0.037)
  {
    EXPECT_TRUE(summarizeTopology(marchingTetrahedra(s, level)).isSphere()) << "level " << level;
  }
}

/** The Gaussian adds 3 (sigma h / R)^2 to the s of a ball; with one node it stays below the bounds here. */
ShellOrderingOptions
lightSmoothing()
{
  ShellOrderingOptions options;
  options.smoothing = 1.0;
  return options;
}

/** Weight with the square of the depth. */
FrontWeightOptions
quadraticDepth()
{
  FrontWeightOptions options;
  options.depthPower = 2.0;
  return options;
}

} // namespace

TEST(CubeVolumeFractions, AreThoseOfTheCubeShells)
{
  const std::vector<double> fractions = cubeVolumeFractions(3);
  ASSERT_EQ(fractions.size(), 3u);
  EXPECT_NEAR(fractions[0], 1.0 / 125, 1e-15);
  EXPECT_NEAR(fractions[1], 27.0 / 125, 1e-15);
  EXPECT_EQ(fractions[2], 1.0);
  EXPECT_THROW((void)cubeVolumeFractions(0), InvalidInput);
}

TEST(FrontWeight, OfABallIsTheSquaredRelativeDepth)
{
  // rho = r / R, so R |grad rho| = 1 and w = (1 - r/R)^2. Near the centre rho has a kink; one-sided differences are of
  // order 1 in the spacing, 0.07 R.
  const LevelSet    phi = ball();
  const FrontWeight front = frontWeight(phi, quadraticDepth());
  EXPECT_LT(phi.grid.point(front.seed).norm(), 0.7);
  for (std::size_t node = 0; node < phi.values.size(); ++node)
  {
    const double r = phi.grid.point(node).norm();
    if (r > 3 && r < 9)
    {
      EXPECT_NEAR(front.weight.values[node], (1 - r / 10) * (1 - r / 10), 0.05) << "r " << r;
    }
    EXPECT_GE(front.weight.values[node], 1e-4);
  }
}

TEST(FrontWeight, OptionsOutOfRangeAreRefused)
{
  const LevelSet phi = ball(1.5);
  const auto     refused = [&](auto change) {
    FrontWeightOptions options;
    change(options);
    EXPECT_THROW((void)frontWeight(phi, options), InvalidInput);
  };
  refused([](auto & o) { o.depthPower = -1; });
  refused([](auto & o) { o.smallestSlope = 0; });
  refused([](auto & o) { o.smallestWeight = 0; });
}

TEST(ShellOrdering, OfABallIsTheSquaredRelativeRadius)
{
  const LevelSet      phi = ball();
  const FrontWeight   front = frontWeight(phi);
  const auto          arrival = eikonalArrival(phi, front.weight, front.seed);
  const ShellOrdering ordering = shellOrdering(phi, arrival.levelSet, front.seed, lightSmoothing());
  EXPECT_EQ(ordering.unreached, 0u);
  EXPECT_EQ(ordering.raised, 0u);
  for (std::size_t node = 0; node < phi.values.size(); ++node)
  {
    const double r = phi.grid.point(node).norm();
    if (r < 9)
    {
      EXPECT_NEAR(ordering.levelSet.values[node], r * r / 100, 0.035) << "r " << r;
    }
  }
}

TEST(ShellOrdering, VolumeBelowALevelFollowsTheLevel)
{
  const LevelSet phi =
    sampled(14, 0.7, [](const Vector3 & p) { return 6 * (Vector3(p.x() / 14, p.y() / 6, p.z() / 8).norm() - 1); });
  const FrontWeight      front = frontWeight(phi);
  const auto             arrival = eikonalArrival(phi, front.weight, front.seed);
  const ShellOrdering    ordering = shellOrdering(phi, arrival.levelSet, front.seed, lightSmoothing());
  const VolumeBelowLevel volumes(ordering.levelSet);
  const VolumeBelowLevel organ(phi);
  for (const double fraction : { 0.1, 0.3, 0.5, 0.7 })
  {
    EXPECT_NEAR(volumes.volume(std::pow(fraction, 2.0 / 3)) / organ.volume(0), fraction, 0.03);
  }
}

TEST(ShellOrdering, EveryLevelSetIsASphereBehindANeckToo)
{
  const LevelSet    phi = dumbbell();
  const FrontWeight front = frontWeight(phi);
  expectAllLevelsAreSpheres(
    shellOrdering(phi, eikonalArrival(phi, front.weight, front.seed).levelSet, front.seed).levelSet);
}

TEST(ShellOrdering, EveryLevelSetIsASphereForRandomTimes)
{
  const LevelSet phi = ball(1.1);
  LevelSet       arrival = phi;
  Random         random(42);
  for (double & time : arrival.values)
  {
    time = random.uniform();
  }
  const ShellOrdering ordering = shellOrdering(phi, arrival, deepestNode(phi), lightSmoothing());
  expectAllLevelsAreSpheres(ordering.levelSet);
}

TEST(ShellOrdering, NodesWithoutATimeFollowByDepth)
{
  const LevelSet phi = ball(1.1);
  LevelSet       arrival = phi;
  std::size_t    late = 0;
  for (std::size_t node = 0; node < phi.values.size(); ++node)
  {
    const double r = phi.grid.point(node).norm();
    arrival.values[node] = r < 6 ? r : std::numeric_limits<double>::infinity();
    late += r >= 6 && r < 10 ? 1 : 0;
  }
  const ShellOrdering ordering = shellOrdering(phi, arrival, deepestNode(phi), lightSmoothing());
  EXPECT_EQ(ordering.unreached, late);
  for (std::size_t node = 0; node < phi.values.size(); ++node)
  {
    const double r = phi.grid.point(node).norm();
    if (r < 8)
    {
      EXPECT_NEAR(ordering.levelSet.values[node], r * r / 100, 0.06);
    }
  }
}

TEST(ShellOrdering, DependsOnTheOrderOfTheTimesOnly)
{
  const LevelSet phi = ball(1.1);
  LevelSet       arrival = phi;
  LevelSet       stretched = phi;
  for (double & time : stretched.values)
  {
    time = std::exp(time);
  }
  const std::size_t seed = deepestNode(phi);
  EXPECT_EQ(shellOrdering(phi, arrival, seed).levelSet.values, shellOrdering(phi, stretched, seed).levelSet.values);
}

TEST(ShellOrdering, WrongInputIsRefused)
{
  const LevelSet    phi = ball(1.5);
  const LevelSet    arrival = phi;
  const std::size_t seed = deepestNode(phi);
  EXPECT_THROW((void)shellOrdering(phi, ball(1.1), seed), InvalidInput);
  EXPECT_THROW((void)shellOrdering(phi, arrival, 0), InvalidInput);
  EXPECT_THROW((void)shellOrdering(phi, arrival, phi.values.size()), InvalidInput);
  LevelSet wrong = arrival;
  wrong.values[seed] = std::nan("");
  EXPECT_THROW((void)shellOrdering(phi, wrong, seed), InvalidInput);
  std::fill(wrong.values.begin(), wrong.values.end(), std::numeric_limits<double>::infinity());
  EXPECT_THROW((void)shellOrdering(phi, wrong, seed), InvalidInput);
}

TEST(Snapshots, OfAFrontOfConstantSpeedInABallAreEquidistant)
{
  const LevelSet  phi = ball();
  const LevelSet  arrival = phi; // T = r - 10: speed 1 from the centre
  const Snapshots snapshots = separatedSnapshots(phi, arrival, 5);
  ASSERT_EQ(snapshots.volumeFractions.size(), 5u);
  for (int k = 1; k <= 4; ++k)
  {
    const double relativeRadius = k / 5.0;
    EXPECT_NEAR(std::cbrt(snapshots.volumeFractions[static_cast<std::size_t>(k - 1)]), relativeRadius, 0.03);
  }
  EXPECT_EQ(snapshots.volumeFractions.back(), 1.0);
}

TEST(Snapshots, StayAwayFromTheSurfaceByTheGap)
{
  // A front that starts next to the wall: without the gap every snapshot would contain it.
  const LevelSet  phi = ball();
  const LevelSet  arrival = sampled(10, 0.7, [](const Vector3 & p) { return (p - Vector3(8, 0, 0)).norm(); });
  SnapshotOptions options;
  options.gap = 0.5;
  const int       shells = 6;
  const Snapshots snapshots = separatedSnapshots(phi, arrival, shells, options);
  double          latest = 0.0;
  double          earliest = std::numeric_limits<double>::infinity();
  for (const double time : arrival.values)
  {
    earliest = std::min(earliest, time);
  }
  std::vector<double> times;
  for (std::size_t node = 0; node < phi.values.size(); ++node)
  {
    if (phi.values[node] < 0.0)
    {
      times.push_back(arrival.values[node]);
    }
  }
  std::sort(times.begin(), times.end());
  latest = times[static_cast<std::size_t>(std::ceil(0.99 * static_cast<double>(times.size()))) - 1];
  for (std::size_t node = 0; node < phi.values.size(); ++node)
  {
    for (int k = 1; k < shells && phi.values[node] < 0.0; ++k)
    {
      const double time = earliest + (latest - earliest) * k / shells;
      if (snapshots.arrival.values[node] < time)
      {
        EXPECT_LT(phi.values[node], -0.5 * 0.7 * (shells - k) + 1e-9);
        EXPECT_LT(arrival.values[node], time);
      }
    }
  }
}

TEST(Snapshots, VolumesIncreaseEvenWhenTheFrontStandsStill)
{
  const LevelSet phi = ball(1.1);
  LevelSet       arrival = phi;
  for (double & time : arrival.values)
  {
    time = time < -5 ? 0.0 : 1.0; // two jumps
  }
  const std::vector<double> fractions = separatedSnapshots(phi, arrival, 8).volumeFractions;
  for (std::size_t k = 1; k < fractions.size(); ++k)
  {
    EXPECT_GT(fractions[k], fractions[k - 1]);
  }
}

TEST(Snapshots, OptionsOutOfRangeAreRefused)
{
  const LevelSet  phi = ball(1.5);
  SnapshotOptions options;
  EXPECT_THROW((void)separatedSnapshots(phi, phi, 0, options), InvalidInput);
  options.gap = 0;
  EXPECT_THROW((void)separatedSnapshots(phi, phi, 3, options), InvalidInput);
  options = {};
  options.reached = 1.5;
  EXPECT_THROW((void)separatedSnapshots(phi, phi, 3, options), InvalidInput);
}
