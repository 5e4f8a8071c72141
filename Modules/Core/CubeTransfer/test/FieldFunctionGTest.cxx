// Round-off: 1e-12. Refusals exact.
#include "moserhex/CubeTransfer/FieldFunction.h"

#include "moserhex/Common/Errors.h"

#include <gtest/gtest.h>

#include <limits>

using namespace moserhex;

namespace
{

/** 6 x 1 x 1 voxels of 2 mm with the components i and 10 i. */
FieldVolume
ramp()
{
  FieldVolume image;
  image.size = { { 6, 1, 1 } };
  image.spacing = { 2.0, 1.0, 1.0 };
  image.components = 2;
  for (int i = 0; i < 6; ++i)
  {
    image.values.insert(image.values.end(), { static_cast<double>(i), 10.0 * i });
  }
  return image;
}

/** First component at so many voxels along the row, -1 where there is none. */
double
at(const FieldFunction & f, double index)
{
  double values[2] = { -1.0, -1.0 };
  if (f.evaluate({ 2.0 * index, 0.0, 0.0 }, values))
  {
    EXPECT_NEAR(values[1], 10.0 * values[0], 1e-12);
  }
  return values[0];
}

} // namespace

TEST(FieldFunction, WithoutAMaskAllVoxelsHaveData)
{
  const FieldVolume                image = ramp();
  const std::vector<unsigned char> none;
  const FieldFunction              f(image, none, ImageInterpolation::Linear);
  EXPECT_NEAR(at(f, 2.25), 2.25, 1e-12);
  EXPECT_EQ(at(f, 5.6), -1.0);
}

TEST(FieldFunction, TheEdgeOfAMaskIsLikeThatOfTheImage)
{
  const FieldVolume                image = ramp();
  const std::vector<unsigned char> mask{ 0, 0, 1, 1, 0, 0 };
  const FieldFunction              f(image, mask, ImageInterpolation::Linear);
  EXPECT_NEAR(at(f, 2.25), 2.25, 1e-12);
  EXPECT_NEAR(at(f, 1.75), 2.0, 1e-12); // constant in the half voxel beyond the outermost centre
  EXPECT_NEAR(at(f, 3.49), 3.0, 1e-12);
  EXPECT_EQ(at(f, 1.49), -1.0);
  EXPECT_EQ(at(f, 3.51), -1.0);
  EXPECT_EQ(at(f, 0.0), -1.0);
}

TEST(FieldFunction, TheNearestVoxelDecidesToo)
{
  const FieldVolume                image = ramp();
  const std::vector<unsigned char> mask{ 0, 0, 1, 1, 0, 0 };
  const FieldFunction              f(image, mask, ImageInterpolation::Nearest);
  EXPECT_EQ(at(f, 2.4), 2.0);
  EXPECT_EQ(at(f, 1.4), -1.0);
}

TEST(FieldFunction, NumbersOfVoxelsWithoutDataDoNotMatter)
{
  FieldVolume image = ramp();
  image.values[2] = std::numeric_limits<double>::quiet_NaN();
  image.values[3] = std::numeric_limits<double>::infinity();
  const std::vector<unsigned char> mask{ 1, 0, 1, 1, 1, 1 };
  const FieldFunction              f(image, mask, ImageInterpolation::Linear);
  EXPECT_NEAR(at(f, 0.25), 0.0, 1e-12);
  EXPECT_NEAR(at(f, 1.75), 2.0, 1e-12);
}

TEST(FieldFunction, AMaskOfOtherVoxelsIsRefused)
{
  const FieldVolume                image = ramp();
  const std::vector<unsigned char> mask(5, 1);
  EXPECT_THROW(FieldFunction(image, mask, ImageInterpolation::Linear), InvalidInput);
}
