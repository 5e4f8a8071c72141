#include "moserhex/CubeTransfer/ImageFunction.h"

#include "moserhex/Analytic/ObservedOrder.h"
#include "moserhex/Analytic/Refusals.h"
#include "moserhex/Analytic/SolidShapes.h"
#include "moserhex/Common/Random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

// Values at voxel centres and linear functions to round-off: 1e-12; orders within 0.1.

using namespace moserhex;

namespace
{

template <typename TFunction>
ScalarVolume
imageOf(const VoxelGrid & grid, const TFunction & f)
{
  ScalarVolume image{ grid, {} };
  for (int k = 0; k < grid.size[2]; ++k)
  {
    for (int j = 0; j < grid.size[1]; ++j)
    {
      for (int i = 0; i < grid.size[0]; ++i)
      {
        image.values.push_back(f(grid.point(i, j, k)));
      }
    }
  }
  return image;
}

VoxelGrid
obliqueGrid()
{
  return { { { 5, 4, 3 } }, { 0.5, 0.7, 3.0 }, { 11.0, -20.0, 300.0 }, analytic::obliqueDirection() };
}

double
linear(const Vector3 & p)
{
  return 2.0 + Vector3(1.5, -0.5, 0.25).dot(p);
}

Vector3
pointAt(const VoxelGrid & grid, const Vector3 & index)
{
  return grid.origin + grid.direction * grid.spacing.cwiseProduct(index);
}

} // namespace

TEST(ImageFunction, VoxelCentresHaveTheirValues)
{
  const ScalarVolume image = imageOf(obliqueGrid(), [](const Vector3 & p) { return std::sin(p[0]) + p[1] * p[2]; });
  for (const auto how : { ImageInterpolation::Nearest, ImageInterpolation::Linear })
  {
    const ImageFunction f(image, { how, 0.0 });
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_NEAR(f(image.point(2, 1, k)), image.values[image.voxelNumber(2, 1, k)], 1e-9);
    }
  }
}

TEST(ImageFunction, LinearFunctionsAreReproducedBetweenTheCentres)
{
  const ScalarVolume  image = imageOf(obliqueGrid(), linear);
  const ImageFunction f(image);
  Random              random(1);
  for (int n = 0; n < 200; ++n)
  {
    const double  x = 4.0 * random.uniform();
    const double  y = 3.0 * random.uniform();
    const Vector3 p = pointAt(image, { x, y, 2.0 * random.uniform() });
    EXPECT_NEAR(f(p), linear(p), 1e-11);
  }
}

TEST(ImageFunction, TheErrorOfLinearInterpolationIsOfSecondOrder)
{
  std::vector<double> spacings;
  std::vector<double> errors;
  for (const int voxels : { 9, 17, 33, 65 })
  {
    const double       h = 8.0 / (voxels - 1);
    const ScalarVolume image =
      imageOf({ { { voxels, 2, 2 } }, { h, 8.0, 8.0 } }, [](const Vector3 & p) { return std::sin(p[0]); });
    const ImageFunction f(image);
    double              largest = 0.0;
    for (int i = 0; i + 1 < voxels; ++i)
    {
      const Vector3 p((i + 0.5) * h, 1.0, 3.0);
      largest = std::max(largest, std::abs(f(p) - std::sin(p[0])));
    }
    spacings.push_back(h);
    errors.push_back(largest);
  }
  EXPECT_NEAR(analytic::observedOrder(spacings, errors), 2.0, 0.1);
}

TEST(ImageFunction, TheBorderIsHalfAVoxelWide)
{
  const ScalarVolume image = imageOf(obliqueGrid(), linear);
  for (const auto how : { ImageInterpolation::Nearest, ImageInterpolation::Linear })
  {
    const ImageFunction f(image, { how, -99.0 });
    const double        corner = image.values.back();
    EXPECT_NEAR(f(pointAt(image, { 4.49, 3.49, 2.49 })), corner, 1e-12);
    EXPECT_EQ(f(pointAt(image, { 4.51, 3.0, 2.0 })), -99.0);
    EXPECT_EQ(f(pointAt(image, { -0.51, 0.0, 0.0 })), -99.0);
    EXPECT_EQ(f(pointAt(image, { 0.0, 0.0, 1e30 })), -99.0);
    EXPECT_EQ(f(Vector3(std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0)), -99.0);
  }
}

TEST(ImageFunction, TheNearestVoxelIsThatOfTheIndex)
{
  const ScalarVolume  image = imageOf({ { { 3, 1, 1 } } }, [](const Vector3 & p) { return p[0]; });
  const ImageFunction f(image, { ImageInterpolation::Nearest, -1.0 });
  EXPECT_EQ(f({ 0.49, 0.0, 0.0 }), 0.0);
  EXPECT_EQ(f({ 0.5, 0.0, 0.0 }), 1.0);
  EXPECT_EQ(f({ 2.5, 0.0, 0.0 }), 2.0);
}

TEST(ImageFunction, AVoxelWithoutWeightDoesNotMatter)
{
  ScalarVolume image = imageOf({ { { 3, 1, 1 } } }, [](const Vector3 & p) { return p[0]; });
  image.values[2] = std::numeric_limits<double>::quiet_NaN();
  const ImageFunction f(image);
  EXPECT_EQ(f({ 1.0, 0.0, 0.0 }), 1.0);
  EXPECT_TRUE(std::isnan(f({ 1.25, 0.0, 0.0 })));
}

TEST(ImageFunction, AnImageWithoutItsValuesIsRefused)
{
  ScalarVolume image = imageOf(obliqueGrid(), linear);
  image.values.pop_back();
  EXPECT_NE(analytic::messageOf([&] { const ImageFunction f(image); }), "accepted");
}
