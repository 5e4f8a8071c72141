// Identities to round-off (1e-12 relative); order 3 within 0.1; gradients against central
// differences.
#include "TestDensities.h"
#include "moserhex/Analytic/Refusals.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Random.h"
#include "moserhex/LevelSet/DensityImage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace moserhex;
using namespace moserhex::test;

namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();

/** Contrast of e^8 between neighbours. */
ScalarVolume
roughImage()
{
  Random random(1);
  return imageOf(obliqueVoxels(), [&random](const Vector3 &) { return std::exp(random.uniform(-4.0, 4.0)); });
}

Vector3
randomPoint(const VoxelGrid & grid, Random & random, double margin)
{
  Vector3 index;
  for (int axis = 0; axis < 3; ++axis)
  {
    index[axis] = random.uniform(margin, grid.size[static_cast<std::size_t>(axis)] - 1.0 - margin);
  }
  return grid.origin + grid.direction * grid.spacing.cwiseProduct(index);
}

std::string
refusalOf(double value)
{
  ScalarVolume image = roughImage();
  image.values[image.voxelNumber(2, 3, 1)] = value;
  image.values[image.voxelNumber(2, 3, 4)] = value;
  return analytic::messageOf([&] { const DensityImage density(image); });
}

} // namespace

TEST(DensityImage, QuadraticDensityIsExactOnAnObliqueLeftHandedAnisotropicGrid)
{
  const Vector3      slope(0.3, -0.2, 0.1);
  const Matrix3      curvature = (Matrix3() << 0.02, 0.01, -0.03, 0.01, 0.05, 0.02, -0.03, 0.02, -0.04).finished();
  const auto         quadratic = [&](const Vector3 & p) { return 50.0 + slope.dot(p) + 0.5 * p.dot(curvature * p); };
  const DensityImage density(imageOf(obliqueVoxels(), quadratic));
  Random             random(2);
  for (int n = 0; n < 100; ++n)
  {
    const Vector3 p = randomPoint(obliqueVoxels(), random, 1.5); // the border repeats its voxels
    EXPECT_NEAR(density.at(p).value, quadratic(p), 1e-11);
    EXPECT_LT((density.at(p).gradient - slope - curvature * p).norm(), 1e-11);
  }
}

TEST(DensityImage, LiesBetweenHalfTheSmallestAndSevenFourthsOfTheLargestVoxel)
{
  const ScalarVolume image = roughImage();
  const DensityImage density(image);
  const auto         extremes = std::minmax_element(image.values.begin(), image.values.end());
  Random             random(3);
  for (int n = 0; n < 2000; ++n)
  {
    const double value = density.value(randomPoint(image, random, -3.0));
    EXPECT_GE(value, 0.5 * *extremes.first * (1.0 - 1e-12));
    EXPECT_LE(value, 1.75 * *extremes.second * (1.0 + 1e-12));
  }
}

TEST(DensityImage, AVoxelOfContrastEnoughHasHalfItsValueAsCoefficient)
{
  ScalarVolume image;
  image.size = { { 3, 1, 1 } };
  image.values = { 4.0, 1.0, 4.0 }; // the middle: 1 - 6/8 = 1/4, bounded by 1/2; beside it: 4 + 3/8
  EXPECT_NEAR(DensityImage(image).value(Vector3(1.0, 0.0, 0.0)), 0.75 * 0.5 + 0.25 * (4.0 + 3.0 / 8.0), 1e-14);
}

TEST(DensityImage, ValueAloneIsTheValueWithTheGradient)
{
  const ScalarVolume image = roughImage();
  const DensityImage density(image);
  Random             random(4);
  for (int n = 0; n < 100; ++n)
  {
    const Vector3 p = randomPoint(image, random, -1.0);
    EXPECT_NEAR(density.value(p), density.at(p).value, 1e-13 * density.value(p));
  }
}

TEST(DensityImage, GradientIsTheDerivativeOfTheValueInsideAndOutside)
{
  const ScalarVolume image = roughImage();
  const DensityImage density(image);
  Random             random(5);
  constexpr double   step = 1e-6;
  for (int n = 0; n < 200; ++n)
  {
    const Vector3 p = randomPoint(image, random, -1.5);
    for (int axis = 0; axis < 3; ++axis)
    {
      const Vector3 d = step * Vector3::Unit(axis);
      const double  difference = (density.value(p + d) - density.value(p - d)) / (2.0 * step);
      EXPECT_NEAR(density.at(p).gradient[axis], difference, 1e-3); // second derivatives of 1e3 jump between voxels
    }
  }
}

TEST(DensityImage, GradientIsContinuousBetweenVoxelsAndAcrossTheBorder)
{
  const ScalarVolume image = roughImage();
  const DensityImage density(image);
  for (const double index : { -0.5, 0.5, 3.5, image.size[0] - 0.5 })
  {
    const auto at = [&](double i) {
      return density.at(image.origin + image.direction * image.spacing.cwiseProduct(Vector3(i, 1.3, 2.2)));
    };
    EXPECT_NEAR(at(index - 1e-9).value, at(index + 1e-9).value, 1e-5) << index;
    EXPECT_LT((at(index - 1e-9).gradient - at(index + 1e-9).gradient).norm(), 1e-4) << index;
  }
}

TEST(DensityImage, IsConstantOutside)
{
  const ScalarVolume image = roughImage();
  const DensityImage density(image);
  const auto         at = [&](const Vector3 & index) {
    return density.at(image.origin + image.direction * image.spacing.cwiseProduct(index));
  };
  EXPECT_NEAR(at(Vector3(-40.0, 1.3, 2.2)).value, at(Vector3(-0.5, 1.3, 2.2)).value, 1e-12);
  EXPECT_NEAR(at(Vector3(-40.0, 1.3, 2.2)).gradient.dot(image.direction.col(0)), 0.0, 1e-12);
  EXPECT_NEAR(at(Vector3(-9.0, 1e5, 2.2)).value, at(Vector3(-0.5, image.size[1] - 0.5, 2.2)).value, 1e-12);
  EXPECT_DOUBLE_EQ(at(Vector3(-9.0, -9.0, -9.0)).value, at(Vector3(-0.5, -0.5, -0.5)).value);
}

TEST(DensityImage, MassOfTheImageIsThatOfItsVoxels)
{
  Random             random(6);
  const ScalarVolume image = imageOf(obliqueVoxels(), [&random](const Vector3 &) { return random.uniform(6.0, 9.0); });
  const DensityImage density(image);
  const double       gauss[2] = { 0.5 - std::sqrt(1.0 / 12.0), 0.5 + std::sqrt(1.0 / 12.0) };
  double             mass = 0.0;
  double             voxels = 0.0;
  std::size_t        voxel = 0;
  for (int k = 0; k < image.size[2]; ++k)
  {
    for (int j = 0; j < image.size[1]; ++j)
    {
      for (int i = 0; i < image.size[0]; ++i)
      {
        voxels += image.values[voxel++];
        for (int point = 0; point < 8; ++point)
        {
          const Vector3 index(i - 0.5 + gauss[point % 2], j - 0.5 + gauss[point / 2 % 2], k - 0.5 + gauss[point / 4]);
          mass += density.value(image.origin + image.direction * image.spacing.cwiseProduct(index)) / 8.0;
        }
      }
    }
  }
  EXPECT_NEAR(mass, voxels, 1e-12 * voxels);
}

TEST(DensityImage, ErrorIsOfThirdOrderInTheVoxelSize)
{
  const auto wave = [](const Vector3 & p) { return 2.0 + std::sin(p.x()); };
  double     coarser = 0.0;
  for (const int n : { 81, 161, 321, 641 })
  {
    VoxelGrid grid;
    grid.size = { { n, 3, 3 } };
    grid.spacing = Vector3(4.0 / (n - 1), 1.0, 1.0);
    const DensityImage density(imageOf(grid, wave));
    double             sum = 0.0;
    Random             random(7);
    for (int sample = 0; sample < 4000; ++sample)
    {
      const Vector3 p(random.uniform(1.0, 3.0), 1.0, 1.0);
      sum += std::pow(density.value(p) - wave(p), 2);
    }
    if (n > 81)
    {
      EXPECT_NEAR(std::log2(coarser / std::sqrt(sum)), 3.0, 0.1) << n;
    }
    coarser = std::sqrt(sum);
  }
}

TEST(DensityImage, OneVoxelIsAUniformDensity)
{
  ScalarVolume image;
  image.size = { { 1, 1, 1 } };
  image.values = { 3.5 };
  const DensityImage density(image);
  EXPECT_DOUBLE_EQ(density.at(Vector3(0.2, -0.4, 7.0)).value, 3.5);
  EXPECT_LT(density.at(Vector3(0.2, -0.4, 7.0)).gradient.norm(), 1e-15);
}

TEST(DensityImage, FirstVoxelThatIsNotPositiveAndFiniteIsNamed)
{
  const std::string end = ", need positive and finite";
  EXPECT_EQ(refusalOf(0.0), "density image: voxel (2, 3, 1) holds 0" + end);
  EXPECT_EQ(refusalOf(-0.25), "density image: voxel (2, 3, 1) holds -0.25" + end);
  EXPECT_EQ(refusalOf(infinity), "density image: voxel (2, 3, 1) holds inf" + end);
  EXPECT_EQ(refusalOf(std::nan("")), "density image: voxel (2, 3, 1) holds nan" + end);
}

TEST(DensityImage, WrongNumberOfValuesIsRefused)
{
  ScalarVolume image = roughImage();
  image.values.pop_back();
  EXPECT_THROW(DensityImage{ image }, InvalidInput);
}

TEST(DensityImage, EmptyGridIsRefused)
{
  EXPECT_THROW(DensityImage{ ScalarVolume{} }, InvalidInput);
}
