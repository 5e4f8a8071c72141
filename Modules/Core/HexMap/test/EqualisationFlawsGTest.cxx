// Tables: every row is on one side of one limit. No rounding is at stake.
#include "EqualisationFlaws.h"

#include <gtest/gtest.h>

using namespace moserhex;

namespace
{
const FlawLimits limits{ 0.5, 1.0, 0.1 };

/** Nothing left to repair: each exactly at its limit. */
const EqualisationFlaws atLimits{ 0, 0.5, 1.0, 0.1 };
const EqualisationFlaws bad{ 10, 2.0, 4.0, 0.05 };

bool
fewer(const EqualisationFlaws & one, const EqualisationFlaws & other)
{
  return one.fewerThan(other, limits);
}
} // namespace

TEST(EqualisationFlaws, NoneAreLeftWhenAllAreWithinTheirLimits)
{
  EXPECT_TRUE(atLimits.none(limits));
  EXPECT_TRUE((EqualisationFlaws{ 0, 0.0, 0.0, 1.0 }.none(limits)));
  EXPECT_FALSE((EqualisationFlaws{ 1, 0.5, 1.0, 0.1 }.none(limits)));
  EXPECT_FALSE((EqualisationFlaws{ 0, 0.51, 1.0, 0.1 }.none(limits)));
  EXPECT_FALSE((EqualisationFlaws{ 0, 0.5, 1.01, 0.1 }.none(limits)));
  EXPECT_FALSE((EqualisationFlaws{ 0, 0.5, 1.0, 0.09 }.none(limits)));
}

TEST(EqualisationFlaws, EachOutweighsWhatComesAfterIt)
{
  EXPECT_TRUE(fewer({ 9, 9.0, 9.0, -1.0 }, bad));
  EXPECT_TRUE(fewer({ 10, 1.9, 9.0, -1.0 }, bad));
  EXPECT_TRUE(fewer({ 10, 2.0, 3.9, -1.0 }, bad));
  EXPECT_TRUE(fewer({ 10, 2.0, 4.0, 0.06 }, bad));
  EXPECT_FALSE(fewer({ 11, 0.0, 0.0, 1.0 }, bad));
  EXPECT_FALSE(fewer({ 10, 2.1, 0.0, 1.0 }, bad));
  EXPECT_FALSE(fewer({ 10, 2.0, 4.1, 1.0 }, bad));
  EXPECT_FALSE(fewer({ 10, 2.0, 4.0, 0.04 }, bad));
  EXPECT_FALSE(fewer(bad, bad));
}

TEST(EqualisationFlaws, WhatIsBetterThanItsLimitDoesNotCount)
{
  const EqualisationFlaws better{ 0, 0.1, 0.2, 0.9 };
  EXPECT_FALSE(fewer(better, atLimits));
  EXPECT_FALSE(fewer(atLimits, better));
  EXPECT_TRUE(fewer({ 0, 0.4, 0.9, 0.2 }, { 0, 0.1, 0.2, 0.09 })); // only the last of the four is beyond
}

TEST(EqualisationFlaws, RoundIsWorthwhileForAFifthFewerUncertifiedCells)
{
  EXPECT_TRUE((EqualisationFlaws{ 7, 9.0, 9.0, -1.0 }.worthwhileAfter(bad, limits)));
  EXPECT_FALSE((EqualisationFlaws{ 8, 2.0, 4.0, 0.05 }.worthwhileAfter(bad, limits)));
  EXPECT_FALSE(bad.worthwhileAfter(bad, limits));
}

TEST(EqualisationFlaws, RoundIsWorthwhileForALengthThreePercentOrAScaledJacobianAQuarterBetter)
{
  EXPECT_TRUE((EqualisationFlaws{ 10, 1.93, 4.0, 0.05 }.worthwhileAfter(bad, limits)));
  EXPECT_FALSE((EqualisationFlaws{ 10, 1.95, 4.0, 0.05 }.worthwhileAfter(bad, limits)));
  EXPECT_TRUE((EqualisationFlaws{ 10, 2.0, 3.87, 0.05 }.worthwhileAfter(bad, limits)));
  EXPECT_FALSE((EqualisationFlaws{ 10, 2.0, 3.89, 0.05 }.worthwhileAfter(bad, limits)));
  EXPECT_TRUE((EqualisationFlaws{ 10, 2.0, 4.0, 0.063 }.worthwhileAfter(bad, limits)));
  EXPECT_FALSE((EqualisationFlaws{ 10, 2.0, 4.0, 0.062 }.worthwhileAfter(bad, limits)));
}

TEST(EqualisationFlaws, RoundThatCostsCertifiedCellsIsNotWorthwhile)
{
  EXPECT_FALSE((EqualisationFlaws{ 11, 1.0, 2.0, 0.1 }.worthwhileAfter(bad, limits)));
}

TEST(EqualisationFlaws, GainBeyondALimitIsNotWorthwhile)
{
  EXPECT_FALSE((EqualisationFlaws{ 0, 0.1, 0.2, 0.9 }.worthwhileAfter(atLimits, limits)));
}

TEST(EqualisationFlaws, ScaledJacobianThatStaysNegativeIsNotWorthwhile)
{
  const EqualisationFlaws inverted{ 10, 2.0, 4.0, -0.5 };
  EXPECT_FALSE((EqualisationFlaws{ 10, 2.0, 4.0, -0.1 }.worthwhileAfter(inverted, limits)));
  EXPECT_TRUE((EqualisationFlaws{ 10, 2.0, 4.0, 0.01 }.worthwhileAfter(inverted, limits)));
}
