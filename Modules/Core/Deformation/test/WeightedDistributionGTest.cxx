// Exact, but for sums of weights that are not whole.
#include "moserhex/Deformation/WeightedDistribution.h"

#include "moserhex/Analytic/Refusals.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace moserhex;

TEST(WeightedDistribution, EqualWeights)
{
  std::vector<double> values;
  for (int i = 100; i >= 1; --i)
  {
    values.push_back(i);
  }
  const auto distribution = weightedDistribution(values, std::vector<double>(100, 2.0));
  ASSERT_TRUE(distribution);
  EXPECT_EQ(distribution->weight, 200.0);
  EXPECT_EQ(distribution->mean, 50.5);
  EXPECT_EQ(distribution->minimum, 1.0);
  EXPECT_EQ(distribution->p05, 5.0);
  EXPECT_EQ(distribution->median, 50.0);
  EXPECT_EQ(distribution->p95, 95.0);
  EXPECT_EQ(distribution->maximum, 100.0);
}

TEST(WeightedDistribution, AWeightOfThreeIsThreeValues)
{
  const auto weighted = weightedDistribution({ 4.0, 1.0, 9.0 }, { 3.0, 1.0, 1.0 });
  const auto repeated = weightedDistribution({ 1.0, 4.0, 4.0, 4.0, 9.0 }, { 1.0, 1.0, 1.0, 1.0, 1.0 });
  EXPECT_EQ(weighted->mean, repeated->mean);
  EXPECT_EQ(weighted->median, repeated->median);
  EXPECT_EQ(weighted->p95, repeated->p95);
}

TEST(WeightedDistribution, ValuesWithoutWeightDoNotCount)
{
  const auto distribution = weightedDistribution({ std::nan(""), 5.0, 1000.0 }, { 0.0, 0.25, 0.0 });
  EXPECT_EQ(distribution->maximum, 5.0);
  EXPECT_EQ(distribution->weight, 0.25);
  EXPECT_FALSE(weightedDistribution({ 1.0, 2.0 }, { 0.0, 0.0 }));
  EXPECT_FALSE(weightedDistribution({}, {}));
}

TEST(WeightedDistribution, RefusesWhatHasNoDistribution)
{
  const auto refusal = [](const std::vector<double> & values, const std::vector<double> & weights) {
    return analytic::messageOf([&] { (void)weightedDistribution(values, weights); });
  };
  EXPECT_NE(refusal({ 1.0 }, { 1.0, 1.0 }).find("1 values, 2 weights"), std::string::npos);
  EXPECT_NE(refusal({ 1.0, 2.0 }, { 1.0, -1.0 }).find("value 1"), std::string::npos);
  EXPECT_NE(refusal({ std::nan(""), 2.0 }, { 1.0, 1.0 }).find("value 0"), std::string::npos);
}
