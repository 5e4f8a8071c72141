// Exact: integers and order of execution only.
#include "moserhex/Common/Errors.h"
#include "moserhex/Common/InstructionSets.h"
#include "moserhex/Common/Parallel.h"

#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cfenv>
#include <chrono>
#include <csignal>
#include <numeric>
#include <string>
#include <thread>
#include <vector>

using namespace moserhex;

namespace
{

/** The exit status of a child, or what else became of it; a child that hangs is killed. */
std::string
endOf(pid_t child, std::chrono::steady_clock::duration patience)
{
  const auto deadline = std::chrono::steady_clock::now() + patience;
  int        status = 0;
  while (waitpid(child, &status, WNOHANG) == 0)
  {
    if (std::chrono::steady_clock::now() > deadline)
    {
      kill(child, SIGKILL);
      waitpid(child, &status, 0);
      return "hangs";
    }
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
  return WIFEXITED(status) ? "exits with " + std::to_string(WEXITSTATUS(status)) : "is killed";
}

bool
sumIsRight()
{
  std::vector<int> values(100, 0);
  parallelFor(values.size(), 3, [&](std::size_t i) { values[i] = static_cast<int>(i); });
  return std::accumulate(values.begin(), values.end(), 0) == 4950;
}

/** What both of two threads say that work at the same time. */
template <typename TSay>
std::vector<double>
sayOfTwoThreads(TSay say)
{
  std::vector<double>          said(2, 0.0);
  std::vector<std::thread::id> by(2);
  std::atomic<int>             arrived{ 0 };
  const auto                   deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  parallelFor(2, 2, [&](std::size_t i) {
    ++arrived;
    while (arrived < 2 && std::chrono::steady_clock::now() < deadline)
    {
      std::this_thread::yield();
    }
    by[i] = std::this_thread::get_id();
    said[i] = say();
  });
  EXPECT_NE(by[0], by[1]);
  return said;
}

} // namespace

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

TEST(ParallelFor, RethrowsTheExceptionOfTheSmallestOfManyFailingIndices)
{
  for (int repeat = 0; repeat < 20000; ++repeat)
  {
    std::string said;
    try
    {
      parallelFor(40, 4, [](std::size_t i) {
        if (i >= 3)
        {
          throw InvalidInput(std::to_string(i));
        }
      });
    }
    catch (const InvalidInput & error)
    {
      said = error.what();
    }
    ASSERT_EQ(said, "3") << "repeat " << repeat;
  }
}

TEST(ParallelFor, WorksInTheChildOfAForkWhateverOtherThreadsWereDoing)
{
  if constexpr (MOSERHEX_INSTRUMENTED) // TSan refuses threads in such a child
  {
    GTEST_SKIP() << "no fork under a sanitizer";
  }
  std::atomic<bool> done{ false };
  std::thread       other([&done] {
    while (!done)
    {
      sumIsRight();
    }
  });
  std::string       end = "exits with 0";
  for (int repeat = 0; repeat < 300 && end == "exits with 0"; ++repeat)
  {
    const pid_t child = fork();
    if (child == 0)
    {
      alarm(60); // should the parent be gone
      _exit(sumIsRight() ? 0 : 1);
    }
    end = child > 0 ? endOf(child, std::chrono::seconds(20)) : "is not made";
  }
  done = true;
  other.join();
  EXPECT_EQ(end, "exits with 0");
  EXPECT_TRUE(sumIsRight());
}

TEST(ParallelFor, EveryThreadHasTheFloatingPointEnvironmentOfTheCaller)
{
  const auto third = [] {
    volatile double three = 3.0;
    return 1.0 / three;
  };
  const auto nearest = sayOfTwoThreads(third); // the helping thread is made here
  const int  before = std::fegetround();
  std::fesetround(FE_UPWARD);
  const auto upward = sayOfTwoThreads(third);
  std::fesetround(before);
  EXPECT_GT(upward[0], nearest[0]);
  EXPECT_EQ(upward[0], upward[1]);
  EXPECT_EQ(sayOfTwoThreads(third), nearest);
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
