// Exact: integers and order of execution only.
#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Parallel.h"

#include <gtest/gtest.h>

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

TEST(ParallelForBlocks, CutsTheSameBlocksForAnyThreadCount)
{
  for (const unsigned int threads : { 1u, 2u, 5u })
  {
    std::vector<std::size_t> endOfBlock(10, 0);
    parallelForBlocks(95, 10, threads, [&](std::size_t begin, std::size_t end) { endOfBlock[begin / 10] = end; });
    EXPECT_EQ(endOfBlock, (std::vector<std::size_t>{ 10, 20, 30, 40, 50, 60, 70, 80, 90, 95 }));
  }
}
