// To round-off, also where the mean is far larger than the deviation.
#include "RunningMoments.h"

#include "moserhex/Analytic/Refusals.h"
#include "moserhex/Common/Random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

using namespace moserhex;
using namespace moserhex::app;

TEST(RunningMoments, AreThoseOfTwoPasses)
{
  Random                           random(3);
  std::vector<std::vector<double>> lists(40, std::vector<double>(7));
  RunningMoments                   moments;
  for (std::vector<double> & list : lists)
  {
    for (double & value : list)
    {
      value = 1e8 + random.uniform(-1.0, 1.0);
    }
    moments.add(list);
  }
  ASSERT_EQ(moments.count(), 40u);
  for (std::size_t i = 0; i < 7; ++i)
  {
    double sum = 0.0; // less 1e8
    for (const auto & list : lists)
    {
      sum += list[i] - 1e8;
    }
    double squares = 0.0;
    for (const auto & list : lists)
    {
      squares += std::pow(list[i] - 1e8 - sum / 40.0, 2);
    }
    EXPECT_NEAR(moments.mean()[i] - 1e8, sum / 40.0, 1e-7);
    EXPECT_NEAR(moments.standardDeviation()[i], std::sqrt(squares / 39.0), 1e-7);
  }
}

TEST(RunningMoments, EqualListsHaveNoDeviation)
{
  RunningMoments moments;
  for (int i = 0; i < 3; ++i)
  {
    moments.add({ 0.1, -7.0 });
  }
  EXPECT_EQ(moments.standardDeviation(), (std::vector<double>{ 0.0, 0.0 }));
}

TEST(RunningMoments, AListOfAnotherLengthIsRefused)
{
  RunningMoments moments;
  moments.add({ 1.0, 2.0 });
  EXPECT_EQ(analytic::messageOf([&] { moments.add({ 1.0 }); }), "moments: 1 numbers, those before 2");
}
