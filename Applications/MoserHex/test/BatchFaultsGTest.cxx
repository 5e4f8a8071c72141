// Exact: nothing is lost, half written or wrong, whatever happens to a batch run or to its cases.
// MOSERHEX_KILLS=300 and MOSERHEX_POISONED_CASES=200 in the environment make the long forms of two tests.
#include "BatchFolder.h"

#include "moserhex/Common/InstructionSets.h"
#include "moserhex/Common/Random.h"
#include "moserhex/Common/Stopwatch.h"

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <thread>

#include <sys/wait.h>

using namespace moserhex;
using namespace moserhex::app;
namespace fs = std::filesystem;

namespace
{

using BatchFaults = BatchFolder;

int
numberFromEnvironment(const char * name, int otherwise)
{
  const char * text = std::getenv(name);
  return text == nullptr ? otherwise : std::atoi(text);
}

/** The row of a case in summary.csv. */
std::string
summaryRow(const std::string & summary, const std::string & name)
{
  const std::size_t at = summary.find("\n" + name + ",");
  return at == std::string::npos ? "" : summary.substr(at + 1, summary.find('\n', at + 1) - at - 1);
}

} // namespace

TEST_F(BatchFaults, PoisonedCasesEndAloneAndAreReported)
{
  if (MOSERHEX_INSTRUMENTED)
  {
    GTEST_SKIP() << "a sanitizer's memory cannot be limited";
  }
  const int cases = numberFromEnvironment("MOSERHEX_POISONED_CASES", 12);
  writeSolids(cases - 3);
  for (const char * poison : { "crash", "hang", "memory" })
  {
    fs::copy_file(path("in/case-001.nrrd"), path("in/" + std::string(poison) + ".nrrd"));
  }
  writeFaultyProgram({ { "crash.nrrd", "kill -SEGV $$" },
                       { "hang.nrrd", "trap '' TERM; while :; do sleep 0.1; done" },
                       { "memory.nrrd", "ulimit -v 120000; set -- $(echo \"$@\" | sed s/--shells=2/--shells=24/)" } });
  const Stopwatch                stopwatch;
  const std::vector<std::string> arguments{ "--jobs", "2", "--time-limit", "20", "--program", path("faulty.sh") };
  const Outcome                  outcome = batch(arguments);
  const double                   seconds = stopwatch.seconds();
  EXPECT_EQ(outcome.exitCode, 1) << outcome.error;
  EXPECT_EQ(filesWithEnding("out", ".vtu"), static_cast<std::size_t>(cases - 3)) << outcome.error;
  const std::string summary = contentOf(path("out/summary.csv"));
  EXPECT_NE(summaryRow(summary, "crash.vtu").find("failed,E_CRASH"), std::string::npos) << summary;
  EXPECT_NE(summaryRow(summary, "hang.vtu").find("failed,E_TIMEOUT"), std::string::npos) << summary;
  EXPECT_NE(summaryRow(summary, "memory.vtu").find("failed,E_MEMORY"), std::string::npos) << summary;
  EXPECT_NE(contentOf(path("out/hang.json")).find("E_TIMEOUT"), std::string::npos);
  const Outcome again = batch(arguments);
  EXPECT_EQ(again.exitCode, 1);
  EXPECT_EQ(again.error, ""); // not tried again
  EXPECT_EQ(doneEntries().size(), static_cast<std::size_t>(cases - 3));
  std::printf("%d cases, 3 of them poisoned: %.1f s\n", cases, seconds);
}

TEST_F(BatchFaults, AHangingCaseIsReportedWithinItsLimitAndThreeSeconds)
{
  writeSolids(1);
  writeFaultyProgram({ { "case-001", "trap '' TERM; while :; do sleep 0.1; done" } });
  const Stopwatch   stopwatch;
  const Outcome     outcome = batch({ "--time-limit", "1", "--program", path("faulty.sh") });
  const double      seconds = stopwatch.seconds();
  const std::string summary = contentOf(path("out/summary.csv"));
  EXPECT_EQ(outcome.exitCode, 1);
  EXPECT_LT(seconds, 1.0 + 3.0 + 4.0); // its limit, three seconds, and room for a busy machine
  EXPECT_NE(summary.find("took more than 1 s"), std::string::npos) << summary;
  const Outcome again = batch({ "--time-limit", "1", "--program", path("faulty.sh") });
  const Outcome raised = batch({ "--time-limit", "30" });
  EXPECT_EQ(again.exitCode, 1);
  EXPECT_EQ(again.error, "");
  EXPECT_EQ(raised.exitCode, 0) << raised.error;
}

TEST_F(BatchFaults, KillsAtRandomMomentsLoseNothing)
{
  const int kills = numberFromEnvironment("MOSERHEX_KILLS", 12);
  const int cases = 24;
  const int jobs = 2;
  writeSolids(cases);
  writeBadFile("bad.nrrd");
  const Stopwatch stopwatch;
  ASSERT_EQ(batch({ "--jobs", "2" }, "reference").exitCode, 1);
  const double                             wholeRun = stopwatch.seconds();
  const std::map<std::string, std::string> reference = treeOf("reference");
  ASSERT_EQ(filesWithEnding("reference", ".vtu"), static_cast<std::size_t>(cases));

  Random random(11);
  int    rounds = 0;
  int    notInJournal = 0;
  for (int kill = 0; kill < kills; ++kill)
  {
    const pid_t process = startProgram(batchArguments({ "--jobs", "2" }), m_Root / "streams");
    std::this_thread::sleep_for(std::chrono::duration<double>(random.uniform(0.0, 0.4 * wholeRun)));
    ::kill(process, SIGKILL);
    const Outcome outcome = waitForProgram(process, m_Root / "streams");
    const bool    isOver = outcome.signalNumber != SIGKILL;
    if (!isOver)
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(200)); // for its cases to die
      const int without = static_cast<int>(filesWithEnding("out", ".vtu") - doneEntries().size());
      EXPECT_LE(without, jobs) << "kill " << kill;
      notInJournal += without;
    }
    for (const auto & [name, bytes] : treeOf("out"))
    {
      const bool isPart = name.find(".part") != std::string::npos;
      EXPECT_TRUE(isPart || reference.at(name) == bytes) << name << ", kill " << kill;
    }
    if (isOver || kill + 1 == kills)
    {
      EXPECT_EQ(batch({ "--jobs", "2" }).exitCode, 1);
      EXPECT_TRUE(sameTree(treeOf("out"), reference));
      for (const auto & [name, count] : doneEntries())
      {
        EXPECT_EQ(count, 1) << name << " was done more than once";
      }
      fs::remove_all(path("out"));
      ++rounds;
    }
  }
  std::printf("%d kills in %d runs of %d cases: %d meshes were made again\n", kills, rounds, cases, notInJournal);
}

TEST_F(BatchFaults, AFullDiskStopsTheRunAndAnotherOneGoesOn)
{
  writeSolids(4);
  const Outcome full = run(batchArguments({ "--jobs", "1" }), 3000); // no file may be larger
  EXPECT_EQ(full.exitCode, 74) << full.error;
  EXPECT_EQ(filesWithEnding("out", ".vtu"), 0u);
  EXPECT_NE(full.error.find("no room"), std::string::npos) << full.error;
  EXPECT_EQ(batch().exitCode, 0);
  EXPECT_EQ(filesWithEnding("out", ".vtu"), 4u);
}

TEST_F(BatchFaults, ASignalEndsTheRunSoonAndAnotherOneGoesOn)
{
  writeSolids(6);
  const fs::path started = path("started");
  writeFaultyProgram({ { "case-003", "touch " + started.string() + "; exec sleep 60" } });
  for (const int signalNumber : { SIGTERM, SIGINT })
  {
    const pid_t process =
      startProgram(batchArguments({ "--jobs", "1", "--program", path("faulty.sh") }), m_Root / "streams");
    for (int wait = 0; wait < 600 && !fs::exists(started); ++wait)
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    fs::remove(started);
    const Stopwatch stopwatch;
    ::kill(process, signalNumber);
    const Outcome outcome = waitForProgram(process, m_Root / "streams");
    EXPECT_EQ(outcome.exitCode, 128 + signalNumber) << outcome.error;
    EXPECT_LT(stopwatch.seconds(), 5.0);
    EXPECT_EQ(doneEntries().size(), 2u);
  }
  EXPECT_NE(contentOf(path("out/summary.csv")).find("case-003.vtu,missing"), std::string::npos);
  EXPECT_EQ(batch().exitCode, 0);
  EXPECT_EQ(doneEntries().size(), 6u);
}

TEST_F(BatchFaults, ASecondRunIsSentAwayAndAKilledOneHoldsNothing)
{
  writeSolids(2);
  writeFaultyProgram({ { "case-001", "exec sleep 60" } });
  const pid_t process = startProgram(batchArguments({ "--program", path("faulty.sh") }), m_Root / "streams");
  for (int wait = 0; wait < 600 && !fs::exists(path("out/journal.jsonl")); ++wait)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  fs::create_directory(m_Root / "second");
  const Outcome second = waitForProgram(startProgram(batchArguments(), m_Root / "second"), m_Root / "second");
  EXPECT_EQ(second.exitCode, 75);
  expectErrorCode(second, "E_LOCKED");
  ::kill(process, SIGKILL);
  EXPECT_EQ(waitForProgram(process, m_Root / "streams").signalNumber, SIGKILL);
  EXPECT_EQ(batch().exitCode, 0);
}

TEST_F(BatchFaults, DamagedMeshesAreFoundAndMadeAgain)
{
  writeSolids(5);
  ASSERT_EQ(batch().exitCode, 0);
  const std::map<std::string, std::string> whole = treeOf("out");
  Random                                   random(3);
  for (int damage = 0; damage < 20; ++damage)
  {
    const std::string name = "out/case-00" + std::to_string(1 + damage % 5) + (damage % 4 == 3 ? ".json" : ".vtu");
    std::string       bytes = contentOf(path(name));
    const auto        place = static_cast<std::size_t>(random.uniform() * static_cast<double>(bytes.size()));
    damage % 2 == 0 ? bytes.resize(place) : (void)(bytes[place] = static_cast<char>(bytes[place] ^ 1));
    std::ofstream(path(name), std::ios::binary) << bytes;
    const Outcome verified = batch({ "--verify" });
    EXPECT_EQ(verified.exitCode, 1) << name;
    EXPECT_NE(verified.error.find("changed"), std::string::npos) << verified.error;
    EXPECT_EQ(batch().exitCode, 0);
    EXPECT_TRUE(sameTree(treeOf("out"), whole));
  }
  EXPECT_EQ(batch({ "--verify" }).exitCode, 0);
  fs::remove(path("out/case-002.vtu"));
  EXPECT_NE(batch({ "--verify" }).error.find("case-002.vtu: mesh missing"), std::string::npos);
}
