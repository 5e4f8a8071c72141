#include "moserhex/CubeTransfer/RefinedMeans.h"

#include "TestMeshes.h"
#include "moserhex/Analytic/Refusals.h"

#include <gtest/gtest.h>

#include <cmath>

// Integrals against closed forms, within the error that is stated for them and within the tolerance where it is met.
// Comparisons of numbers of threads: to the last bit.

using namespace moserhex;

namespace
{

constexpr int firstPoints = 4;

RefinedMeans
refined(const HexMesh & mesh, const CubeFunction & f, int components, const RefinementOptions & options = {})
{
  CubeMeans first = cubeMeans(mesh, f, components, { 0, firstPoints, 0 });
  return refinedMeans(mesh, f, std::move(first), firstPoints, options);
}

/** Of the plane x = 0.3123 in the unit cube, along an axis: the worst case of a product rule. */
constexpr double kinkAt = 0.3123;

void
kink(const CubePoint & point, double * values)
{
  *values = std::max(0.0, point.position[0] - kinkAt);
}

/** 1 below the plane x + 1.3 y + 0.8 z = 0.7, else 0: as a lesion mask is a density. */
void
step(const CubePoint & point, double * values)
{
  *values = point.position.dot(Vector3(1.0, 1.3, 0.8)) < 0.7 ? 1.0 : 0.0;
}

} // namespace

TEST(RefinedMeans, ASmoothFunctionIsWithinTheTolerance)
{
  const HexMesh      mesh = bentLattice(5);
  const CubeFunction f = [](const CubePoint & point, double * values) {
    values[0] = std::sin(0.1 * point.position[0]) + 2.0;
    values[1] = 0.0;
  };
  const RefinedMeans result = refined(mesh, f, 2);
  const CubeMeans    finest = cubeMeans(mesh, f, 2, { 0, 32, 0 });
  double             expected = 0.0;
  for (std::size_t box = 0; box < finest.volumes.size(); ++box)
  {
    expected += finest.volumes[box] * finest.image.at(box)[0];
  }
  EXPECT_NEAR(result.integrals[0], expected, 1e-12 * expected);
  EXPECT_LE(result.relativeError, 1e-6);
  EXPECT_EQ(result.integrals[1], 0.0);
  EXPECT_EQ(result.errors[1], 0.0);
}

TEST(RefinedMeans, AKinkIsRefinedToTheTolerance)
{
  const HexMesh     mesh = analytic::cubeLattice(6, 0.2);
  const double      exact = 0.5 * (1.0 - kinkAt) * (1.0 - kinkAt);
  RefinementOptions options;
  options.tolerance = 1e-5;
  const RefinedMeans result = refined(mesh, kink, 1, options);
  EXPECT_LE(result.relativeError, 1e-5);
  EXPECT_NEAR(result.integrals[0], exact, 1e-5 * exact);
  double of = 0.0;
  for (std::size_t box = 0; box < result.means.volumes.size(); ++box)
  {
    of += result.means.volumes[box] * result.means.image.values[box];
  }
  EXPECT_NEAR(of, result.integrals[0], 1e-14); // the means are of the last rules
}

TEST(RefinedMeans, TheStatedErrorOfAStepHolds)
{
  const HexMesh mesh = analytic::cubeLattice(6, 0.2);
  const double  exact = 0.7 * 0.7 * 0.7 / (6.0 * 1.3 * 0.8);
  for (const double mostPoints : { 1.0, 1e6, 1e7 })
  {
    RefinementOptions options;
    options.mostPoints = mostPoints;
    const RefinedMeans result = refined(mesh, step, 1, options);
    EXPECT_GT(result.relativeError, 1e-6) << mostPoints;
    EXPECT_LE(std::abs(result.integrals[0] - exact), result.errors[0]) << mostPoints;
    EXPECT_NEAR(result.relativeError * result.integrals[0], result.errors[0], 1e-12);
  }
}

TEST(RefinedMeans, MorePointsMakeAStepMoreExact)
{
  const HexMesh     mesh = analytic::cubeLattice(6, 0.2);
  RefinementOptions few;
  few.mostPoints = 1.0;
  RefinementOptions many;
  many.mostPoints = 1e7;
  EXPECT_LT(refined(mesh, step, 1, many).errors[0], 0.1 * refined(mesh, step, 1, few).errors[0]);
}

TEST(RefinedMeans, ThreadsDoNotMatter)
{
  const HexMesh     mesh = bentLattice(4);
  RefinementOptions options;
  options.mostPoints = 1e6;
  options.threads = 1;
  const RefinedMeans one = refined(mesh, kink, 1, options);
  options.threads = 2;
  const RefinedMeans two = refined(mesh, kink, 1, options);
  EXPECT_EQ(one.means.image.values, two.means.image.values);
  EXPECT_EQ(one.errors, two.errors);
}

TEST(RefinedMeans, WhatIsNoStartIsRefused)
{
  const HexMesh   mesh = bentLattice(3);
  const CubeMeans first = cubeMeans(mesh, kink, 1, { 0, firstPoints, 0 });
  const auto      refused = [&](const CubeMeans & means, int points, double tolerance) {
    RefinementOptions options;
    options.tolerance = tolerance;
    return analytic::messageOf([&] { (void)refinedMeans(mesh, kink, means, points, options); }) != "accepted";
  };
  CubeMeans withoutVolumes = first;
  withoutVolumes.volumes.clear();
  EXPECT_TRUE(refused(withoutVolumes, firstPoints, 1e-6));
  EXPECT_TRUE(refused(first, 0, 1e-6));
  EXPECT_TRUE(refused(first, firstPoints, 0.0));
  EXPECT_FALSE(refused(first, firstPoints, 1e-3));
}
