// Exact for the generator (published reference values); statistical bounds at six standard deviations for uniform().
#include "moserhex/Common/Random.h"

#include <gtest/gtest.h>

#include <cmath>

using moserhex::Random;

TEST(Random, MatchesThePublishedSplitMix64Sequence)
{
  Random random(1234567);
  EXPECT_EQ(random.next(), 6457827717110365317ULL);
  EXPECT_EQ(random.next(), 3203168211198807973ULL);
  EXPECT_EQ(random.next(), 9817491932198370423ULL);
}

TEST(Random, UniformStaysInRangeWithTheRightMean)
{
  Random    random(1);
  double    sum = 0.0;
  const int count = 100000;
  for (int i = 0; i < count; ++i)
  {
    const double u = random.uniform(-2.0, 4.0);
    ASSERT_GE(u, -2.0);
    ASSERT_LT(u, 4.0);
    sum += u;
  }
  EXPECT_NEAR(sum / count, 1.0, 6 * 6.0 / std::sqrt(12.0 * count));
}
