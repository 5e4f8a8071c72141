// Exact: control flow only.
#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Parallel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

using namespace moserhex;

TEST(ReportProgress, AcceptsAnEmptyCallback)
{
  EXPECT_NO_THROW(reportProgress({}, 0.5));
}

TEST(ReportProgress, ThrowsCancelledWhenTheCallbackSaysStop)
{
  EXPECT_THROW(reportProgress([](double) { return false; }, 0.5), Cancelled);
  EXPECT_NO_THROW(reportProgress([](double) { return true; }, 0.5));
}

TEST(ProgressBetween, MapsTheSubTaskIntoItsPart)
{
  std::vector<double>    seen;
  const ProgressCallback whole = [&](double f) {
    seen.push_back(f);
    return true;
  };
  const ProgressCallback part = progressBetween(whole, 0.25, 0.75);
  reportProgress(part, 0.0);
  reportProgress(part, 0.5);
  reportProgress(part, 1.0);
  EXPECT_EQ(seen, (std::vector<double>{ 0.25, 0.5, 0.75 }));
}

TEST(ProgressBetween, PassesTheStopOn)
{
  const ProgressCallback part = progressBetween([](double f) { return f < 0.5; }, 0.0, 1.0);
  EXPECT_NO_THROW(reportProgress(part, 0.4));
  EXPECT_THROW(reportProgress(part, 0.6), Cancelled);
}

TEST(ProgressOfPart, DividesTheWholeEvenly)
{
  std::vector<double>    seen;
  const ProgressCallback whole = [&seen](double fraction) {
    seen.push_back(fraction);
    return true;
  };
  for (std::size_t part = 0; part < 4; ++part)
  {
    reportProgress(progressOfPart(whole, part, 4), 0.5);
  }
  EXPECT_EQ(seen, (std::vector<double>{ 0.125, 0.375, 0.625, 0.875 }));
}

TEST(ParallelProgress, IsReportedByTheCallersThreadOnly)
{
  const auto             caller = std::this_thread::get_id();
  std::vector<double>    seen;
  const ProgressCallback whole = [&](double fraction) {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    seen.push_back(fraction);
    return true;
  };
  ParallelProgress shared(whole, 40);
  parallelFor(40, 3, [&](std::size_t) {
    reportProgress(shared.callback(), 0.5);
    shared.endPart();
  });
  shared.callback()(0.0);
  EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
  EXPECT_EQ(seen.back(), 1.0);
}

TEST(ParallelProgress, AStopReachesAllThreads)
{
  const ProgressCallback whole = [](double) { return false; };
  ParallelProgress       shared(whole, 3);
  EXPECT_THROW(parallelFor(3,
                           3,
                           [&](std::size_t) {
                             for (;;) // until it is stopped, on whichever thread
                             {
                               reportProgress(shared.callback(), 0.5);
                             }
                           }),
               Cancelled);
}

TEST(ParallelProgress, AcceptsAnEmptyCallback)
{
  const ProgressCallback none;
  ParallelProgress       shared(none, 1);
  EXPECT_NO_THROW(shared.endPart());
  EXPECT_TRUE(shared.callback()(0.0));
}

TEST(NotConverged, CarriesItsReport)
{
  StepReport report;
  report.steps = 17;
  try
  {
    throw NotConverged("stalled", report);
  }
  catch (const NotConverged & error)
  {
    EXPECT_EQ(error.report.steps, 17);
    EXPECT_STREQ(error.what(), "stalled");
  }
}
