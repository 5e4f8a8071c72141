#include "moserhex/Numerics/GaussLegendre.h"

#include <gtest/gtest.h>

#include <cmath>

// Closed form, to round-off: 1e-14.

using namespace moserhex;

TEST(GaussLegendre, PolynomialsOfDegreeTwoQMinusOneAreExact)
{
  for (int q = 1; q <= 48; ++q)
  {
    const GaussRule rule = gaussLegendre(q);
    ASSERT_EQ(rule.abscissae.size(), static_cast<std::size_t>(q));
    for (int degree = 0; degree <= 2 * q - 1; ++degree)
    {
      double sum = 0.0;
      for (std::size_t i = 0; i < rule.weights.size(); ++i)
      {
        sum += rule.weights[i] * std::pow(rule.abscissae[i], degree);
      }
      EXPECT_NEAR(sum, 1.0 / (degree + 1), 1e-14) << q << " points, degree " << degree;
    }
  }
}

TEST(GaussLegendre, TheNextDegreeHasTheErrorOfTheRule)
{
  // Of two points for t^4 on [0,1]: (2!)^4 / (5 (4!)^3) * 4!  =  1 / 180
  const GaussRule rule = gaussLegendre(2);
  double          sum = 0.0;
  for (std::size_t i = 0; i < 2; ++i)
  {
    sum += rule.weights[i] * std::pow(rule.abscissae[i], 4);
  }
  EXPECT_NEAR(1.0 / 5.0 - sum, 1.0 / 180.0, 1e-15);
}

TEST(GaussLegendre, PointsAscendWithin0And1)
{
  const GaussRule rule = gaussLegendre(13);
  for (std::size_t i = 0; i < rule.abscissae.size(); ++i)
  {
    EXPECT_GT(rule.abscissae[i], i == 0 ? 0.0 : rule.abscissae[i - 1]);
    EXPECT_LT(rule.abscissae[i], 1.0);
    EXPECT_GT(rule.weights[i], 0.0);
  }
}
