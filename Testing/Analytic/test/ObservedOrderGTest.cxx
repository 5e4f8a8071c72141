// Tolerances: round-off (1e-12), the data are exact powers.
#include "moserhex/Analytic/ObservedOrder.h"

#include "moserhex/Common/Errors.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace moserhex;
using analytic::observedOrder;

TEST(ObservedOrder, PowerLawGivesItsExponent)
{
  const std::vector<double> h{ 1.0, 0.5, 0.25, 0.1 };
  for (const double order : { 1.0, 2.0, 3.5 })
  {
    std::vector<double> error;
    for (const double step : h)
    {
      error.push_back(7.0 * std::pow(step, order));
    }
    EXPECT_NEAR(observedOrder(h, error), order, 1e-12);
  }
}

TEST(ObservedOrder, OneSampleIsRefused)
{
  EXPECT_THROW((void)observedOrder({ 1.0 }, { 1.0 }), InvalidInput);
}

TEST(ObservedOrder, DifferentCountsAreRefused)
{
  EXPECT_THROW((void)observedOrder({ 1.0, 0.5 }, { 1.0, 0.5, 0.2 }), InvalidInput);
}

TEST(ObservedOrder, ZeroErrorIsRefused)
{
  EXPECT_THROW((void)observedOrder({ 1.0, 0.5 }, { 1.0, 0.0 }), InvalidInput);
}

TEST(ObservedOrder, EqualStepsAreRefused)
{
  EXPECT_THROW((void)observedOrder({ 0.5, 0.5 }, { 1.0, 0.9 }), InvalidInput);
}
