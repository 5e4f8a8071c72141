// Closed form: places to round-off (1e-12).
#include "Layout.h"

#include <gtest/gtest.h>

using namespace moserhex::app;

namespace
{

Panel
square(double left, double bottom, double side)
{
  SeenFacet facet;
  facet.outline = {
    { left, bottom }, { left + side, bottom }, { left + side, bottom + side }, { left, bottom + side }
  };
  return { { facet }, "" };
}

} // namespace

TEST(Layout, OnePanelFillsTheAreaAndStandsInItsMiddle)
{
  const Arrangement arrangement = arrange({ square(5.0, -3.0, 2.0) }, { 10.0, 20.0, 400.0, 200.0 }, 0.0, 10.0);
  EXPECT_NEAR(arrangement.scale, 100.0, 1e-12);
  EXPECT_LE((arrangement.place(0, { 5.0, -3.0 }) - Point2(110.0, 220.0)).norm(), 1e-12) << "lower left corner";
  EXPECT_LE((arrangement.place(0, { 7.0, -1.0 }) - Point2(310.0, 20.0)).norm(), 1e-12) << "upper right corner";
}

TEST(Layout, PanelsTakeAsManyRowsAsLetThemBeLargest)
{
  const std::vector<Panel> four(4, square(0.0, 0.0, 1.0));
  EXPECT_NEAR(arrange(four, { 0.0, 0.0, 430.0, 100.0 }, 0.0, 10.0).scale, 100.0, 1e-12) << "one row";
  const Arrangement inRows = arrange(four, { 0.0, 0.0, 210.0, 260.0 }, 25.0, 10.0);
  EXPECT_NEAR(inRows.scale, 100.0, 1e-12) << "two rows";
  EXPECT_LE((inRows.place(3, { 0.0, 1.0 }) - Point2(110.0, 135.0)).norm(), 1e-12);
  EXPECT_LE((inRows.captions[3] - Point2(160.0, 235.0 + 0.75 * 25.0)).norm(), 1e-12);
}

TEST(Layout, NumbersOfLegendAndScaleAreRound)
{
  EXPECT_DOUBLE_EQ(roundNumberBelow(7.3), 5.0);
  EXPECT_DOUBLE_EQ(roundNumberBelow(0.02), 0.02);
  EXPECT_DOUBLE_EQ(roundNumberBelow(199.0), 100.0);
  EXPECT_DOUBLE_EQ(roundNumberBelow(10.0), 10.0);
  const std::vector<double> unit = ticksBetween(0.0, 1.0);
  ASSERT_EQ(unit.size(), 6U);
  EXPECT_DOUBLE_EQ(unit[1], 0.2);
  EXPECT_DOUBLE_EQ(unit.back(), 1.0);
  const std::vector<double> around = ticksBetween(0.9, 1.1);
  ASSERT_EQ(around.size(), 5U);
  EXPECT_DOUBLE_EQ(around[2], 1.0);
}
