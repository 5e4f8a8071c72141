// Identities within round-off (1e-12); the variance of the kernel cut at 3 sigma is 2.7 % below sigma^2 at most.
#include "TestShapes.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/LevelSet/GaussianSmoothing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

using namespace moserhex;

TEST(GaussianSmoothing, LinearFunctionIsReproducedAwayFromTheBorder)
{
  const auto linear = [](const Vector3 & p) { return 2.0 * p.x() - p.y() + 0.5 * p.z() + 3.0; };
  LevelSet   f = test::sample(test::unitGrid(21), linear);
  gaussianSmoothInPlace(f, 1.3);
  for (int i = 4; i < 17; ++i)
  {
    const std::size_t node = f.grid.nodeNumber(i, 20 - i, 10);
    EXPECT_NEAR(f.values[node], linear(f.grid.point(node)), 1e-12);
  }
}

TEST(GaussianSmoothing, ImpulseSpreadsEquallyAlongTheThreeAxes)
{
  LevelSet f = test::sample(test::unitGrid(31), [](const Vector3 &) { return 0.0; });
  f.values[f.grid.nodeNumber(15, 15, 15)] = 1.0;
  gaussianSmoothInPlace(f, 2.0);
  double  sum = 0.0;
  Vector3 variance = Vector3::Zero();
  for (std::size_t node = 0; node < f.values.size(); ++node)
  {
    const auto index = f.grid.indexOf(node);
    sum += f.values[node];
    variance += f.values[node] * Vector3(index[0] - 15, index[1] - 15, index[2] - 15).cwiseAbs2();
  }
  EXPECT_NEAR(sum, 1.0, 1e-12);
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_NEAR(variance[axis], 4.0, 0.03 * 4.0);
  }
  EXPECT_NEAR(variance[0], variance[2], 1e-12);
}

TEST(GaussianSmoothing, AnImageIsSmoothedByTheSameLengthAlongEveryAxis)
{
  ScalarVolume image;
  image.size = { { 61, 31, 21 } };
  image.spacing = Vector3(0.5, 1.0, 1.5);
  image.values.assign(image.gridVoxels(), 0.0);
  image.values[image.voxelNumber(30, 15, 10)] = 1.0;
  gaussianSmoothInPlace(image, 3.0);
  EXPECT_NEAR(std::accumulate(image.values.begin(), image.values.end(), 0.0), 1.0, 1e-12);
  const auto logRatio = [&](int i, int j, int k) {
    return std::log(image.values[image.voxelNumber(30, 15, 10)] /
                    image.values[image.voxelNumber(30 + i, 15 + j, 10 + k)]);
  };
  EXPECT_NEAR(logRatio(6, 0, 0), 0.5, 1e-12); // r^2 / (2 sigma^2), 3 mm along each axis
  EXPECT_NEAR(logRatio(0, 3, 0), 0.5, 1e-12);
  EXPECT_NEAR(logRatio(0, 0, 2), 0.5, 1e-12);
}

TEST(GaussianSmoothing, ZeroSigmaLeavesTheValues)
{
  LevelSet       f = test::randomField({ { 6, 6, 6 } }, 1);
  const LevelSet before = f;
  gaussianSmoothInPlace(f, 0.0);
  EXPECT_EQ(f.values, before.values);
}

TEST(GaussianSmoothing, KernelWiderThanTheGridTendsToTheBorder)
{
  LevelSet f = test::sample(test::unitGrid(5), [](const Vector3 &) { return 7.0; });
  gaussianSmoothInPlace(f, 10.0);
  for (const double value : f.values)
  {
    EXPECT_NEAR(value, 7.0, 1e-12);
  }
}

TEST(GaussianSmoothing, NegativeSigmaAndInfiniteValuesAreRefused)
{
  LevelSet f = test::randomField({ { 6, 6, 6 } }, 1);
  EXPECT_THROW(gaussianSmoothInPlace(f, -1.0), InvalidInput);
  EXPECT_THROW(gaussianSmoothInPlace(f, NAN), InvalidInput);
  ScalarVolume image;
  EXPECT_THROW(gaussianSmoothInPlace(image, 1.0), InvalidInput); // no voxels
  f.values[3] = INFINITY;
  EXPECT_THROW(gaussianSmoothInPlace(f, 1.0), InvalidInput);
}
