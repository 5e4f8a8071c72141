// Exact: integers and order of execution only.
#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Parallel.h"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

using namespace moserhex;

TEST(ParallelFor, VisitsEveryIndexOnceForAnyThreadCount)
{
  for (const unsigned int threads : { 1u, 2u, 3u, 8u, 0u })
  {
    std::vector<int> visits(257, 0);
    parallelFor(visits.size(), threads, [&](std::size_t i) { ++visits[i]; });
    EXPECT_EQ(visits, std::vector<int>(257, 1)) << threads << " threads";
  }
}

TEST(ParallelFor, DoesNothingForNoWork)
{
  parallelFor(0, 4, [](std::size_t) { FAIL(); });
}

TEST(ParallelFor, RethrowsTheExceptionOfAWorker)
{
  for (const unsigned int threads : { 1u, 4u })
  {
    EXPECT_THROW(parallelFor(100,
                             threads,
                             [](std::size_t i) {
                               if (i == 37)
                               {
                                 throw InvalidInput("37");
                               }
                             }),
                 InvalidInput);
  }
}

TEST(ParallelFor, WorksInsideItself)
{
  std::vector<std::vector<int>> visits(6, std::vector<int>(50, 0));
  parallelFor(visits.size(), 3, [&](std::size_t row) {
    parallelFor(visits[row].size(), 3, [&](std::size_t i) { ++visits[row][i]; });
  });
  for (const std::vector<int> & row : visits)
  {
    EXPECT_EQ(row, std::vector<int>(50, 1));
  }
}

TEST(ParallelFor, WorksForCallersAtTheSameTime)
{
  std::vector<std::vector<int>> visits(4, std::vector<int>(20, 0));
  std::vector<std::thread>      callers;
  for (std::vector<int> & row : visits)
  {
    callers.emplace_back([&row] {
      for (int repeat = 0; repeat < 500; ++repeat)
      {
        parallelFor(row.size(), 2, [&](std::size_t i) { ++row[i]; });
      }
    });
  }
  for (std::thread & caller : callers)
  {
    caller.join();
  }
  for (const std::vector<int> & row : visits)
  {
    EXPECT_EQ(row, std::vector<int>(20, 500));
  }
}

TEST(ParallelFor, WorksAgainAfterAnException)
{
  for (int repeat = 0; repeat < 50; ++repeat)
  {
    EXPECT_THROW(parallelFor(10, 4, [](std::size_t) { throw InvalidInput("no"); }), InvalidInput);
    std::vector<int> visits(10, 0);
    parallelFor(visits.size(), 4, [&](std::size_t i) { ++visits[i]; });
    EXPECT_EQ(visits, std::vector<int>(10, 1));
  }
}

TEST(ParallelForBlocks, CutsTheSameBlocksForAnyThreadCount)
{
  for (const unsigned int threads : { 1u, 2u, 5u })
  {
    std::vector<std::size_t> endOfBlock(10, 0);
    parallelForBlocks(95, 10, threads, [&](std::size_t begin, std::size_t end) { endOfBlock[begin / 10] = end; });
    EXPECT_EQ(endOfBlock, (std::vector<std::size_t>{ 10, 20, 30, 40, 50, 60, 70, 80, 90, 95 }));
  }
}
