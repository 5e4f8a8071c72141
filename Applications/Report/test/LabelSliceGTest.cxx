// Exact: squares of a box of voxels.
#include "LabelSlice.h"
#include "ReportTest.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace moserhex;
using namespace moserhex::app;

namespace
{

double
areaOf(const LabelSlice & slice)
{
  return slice.step * slice.step * static_cast<double>(std::count(slice.values.begin(), slice.values.end(), 1));
}

} // namespace

TEST(BoxOfLabels, IsThatOfTheVoxelsWithTheirCorners)
{
  const auto box = boxOfLabels(*labelImageOf(boxLabel()), { 1 });
  ASSERT_TRUE(box);
  EXPECT_EQ(box->low, Vector3(-2.5, 12.5, 105.0));
  EXPECT_EQ(box->high, Vector3(1.5, 18.5, 121.0));
  EXPECT_FALSE(boxOfLabels(*labelImageOf(boxLabel()), { 2 }));
}

TEST(LabelSlice, HasTheAreaOfTheLabelInEveryPlane)
{
  const auto image = labelImageOf(boxLabel());
  const Box  box{ Vector3(-5.5, 9.5, 99.0), Vector3(6.5, 21.5, 123.0) };
  EXPECT_DOUBLE_EQ(areaOf(sliceLabels(*image, { 1 }, box, { 0, 0.0 })), 6.0 * 16.0);
  EXPECT_DOUBLE_EQ(areaOf(sliceLabels(*image, { 1 }, box, { 1, 15.0 })), 4.0 * 16.0);
  EXPECT_DOUBLE_EQ(areaOf(sliceLabels(*image, { 1 }, box, { 2, 110.0 })), 4.0 * 6.0);
  EXPECT_EQ(areaOf(sliceLabels(*image, { 1 }, box, { 2, 102.0 })), 0.0);
  EXPECT_EQ(areaOf(sliceLabels(*image, { 2 }, box, { 2, 110.0 })), 0.0);
}

TEST(LabelSlice, BeyondTheImageIsEmpty)
{
  const auto       image = labelImageOf(boxLabel());
  const LabelSlice slice = sliceLabels(*image, { 1 }, { Vector3(50, 50, 50), Vector3(60, 60, 60) }, { 2, 110.0 });
  EXPECT_FALSE(slice.values.empty());
  EXPECT_EQ(areaOf(slice), 0.0);
}

TEST(LabelSlice, OfAnObliqueImageHasTheSameArea)
{
  LabelVolume  label = boxLabel();
  const double angle = pi / 6.0;
  label.spacing = Vector3(1.0, 1.0, 1.0);
  label.direction << std::cos(angle), -std::sin(angle), 0, std::sin(angle), std::cos(angle), 0, 0, 0, 1;
  const auto image = labelImageOf(label);
  const auto box = boxOfLabels(*image, { 1 });
  ASSERT_TRUE(box);
  EXPECT_NEAR(areaOf(sliceLabels(*image, { 1 }, *box, { 2, 105.0 })), 24.0, 1.5); // squares of half a millimetre
}

TEST(LabelSlice, OfALargeLabelHasAtMostSoManySquares)
{
  const auto       image = labelImageOf(boxLabel());
  const LabelSlice slice = sliceLabels(*image, { 1 }, { Vector3(0, 0, 0), Vector3(1000, 500, 1) }, { 2, 0.5 });
  EXPECT_EQ(slice.size[0], 320);
  EXPECT_EQ(slice.size[1], 160);
}
