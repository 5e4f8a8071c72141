// Exact: how processes end, whatever they do.
#include "CaseFailure.h"
#include "CaseProcess.h"

#include "moserhex/Common/InstructionSets.h"
#include "moserhex/Common/Stopwatch.h"
#include "moserhex/HexMeshIO/FileErrors.h"

#include <gtest/gtest.h>

#include <csignal>
#include <thread>

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace moserhex;
using namespace moserhex::app;

namespace
{

CaseEnd
endOf(CaseProcess & process)
{
  std::optional<CaseEnd> end;
  while (!(end = process.poll()))
  {
    struct pollfd waiting = { process.messages(), POLLIN, 0 };
    (void)::poll(&waiting, 1, 5);
  }
  return *end;
}

CaseEnd
runShell(const std::string & script, const CaseLimits & limits = {})
{
  CaseProcess process({ "/bin/sh", "-c", script }, limits);
  return endOf(process);
}

CaseLimits
secondsAllowed(double seconds)
{
  CaseLimits limits;
  limits.seconds = seconds;
  return limits;
}

bool
isRunning(pid_t process)
{
  return ::kill(process, 0) == 0;
}

} // namespace

TEST(CaseProcess, TellsStatusAndLastWords)
{
  const CaseEnd end = runShell("echo to nobody; echo some words >&2; exit 3");
  EXPECT_EQ(end.exitStatus, 3);
  EXPECT_EQ(end.signalNumber, 0);
  EXPECT_EQ(end.lastWords, "some words\n");
  EXPECT_FALSE(end.wasTooSlow);
  EXPECT_GT(end.peakMebibytes, 0.0);
}

TEST(CaseProcess, KeepsTheEndOfLongSpeeches)
{
  const CaseEnd end = runShell("i=0; while [ $i -lt 3000 ]; do echo line $i >&2; i=$((i+1)); done");
  EXPECT_EQ(end.exitStatus, 0);
  EXPECT_LE(end.lastWords.size(), 4096u);
  EXPECT_EQ(end.lastWords.substr(end.lastWords.size() - 10), "line 2999\n");
}

TEST(CaseProcess, ASignalIsTheEndOfTheCaseOnly)
{
  const CaseEnd end = runShell("kill -SEGV $$");
  EXPECT_EQ(end.signalNumber, SIGSEGV);
  const std::optional<CaseFailure> failure = failureOf(end, {});
  ASSERT_TRUE(failure);
  EXPECT_EQ(failure->failure.code, ErrorCode::Crashed);
  EXPECT_NE(failure->failure.message.find("signal 11"), std::string::npos) << failure->failure.message;
}

TEST(CaseProcess, EndsWhatIsTooSlowAndTellsSo)
{
  const Stopwatch stopwatch;
  const CaseEnd   end = runShell("sleep 60", secondsAllowed(0.2));
  EXPECT_TRUE(end.wasTooSlow);
  EXPECT_EQ(end.signalNumber, SIGTERM);
  EXPECT_LT(stopwatch.seconds(), 10.0);
  EXPECT_EQ(failureOf(end, secondsAllowed(0.2))->failure.code, ErrorCode::TimeLimit);
}

TEST(CaseProcess, KillsWhatDoesNotListen)
{
  const CaseEnd end = runShell("trap '' TERM; while :; do sleep 0.05; done", secondsAllowed(0.2));
  EXPECT_TRUE(end.wasTooSlow);
  EXPECT_EQ(end.signalNumber, SIGKILL);
  EXPECT_GE(end.seconds, 2.0);
}

TEST(CaseProcess, EndsItsChildrenToo)
{
  const CaseEnd end = runShell("sleep 60 & echo $! >&2");
  const auto    child = static_cast<pid_t>(std::stol(end.lastWords));
  for (int wait = 0; wait < 200 && isRunning(child); ++wait)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(10)); // until init has collected it
  }
  EXPECT_FALSE(isRunning(child));
}

TEST(CaseProcess, MemoryIsLimited)
{
  if (MOSERHEX_INSTRUMENTED)
  {
    GTEST_SKIP() << "a sanitizer needs all addresses there are";
  }
  CaseLimits limits;
  limits.mebibytes = 256.0;
  const CaseEnd end = runShell("ulimit -v >&2", limits);
  EXPECT_EQ(end.lastWords, "262144\n");
}

TEST(CaseProcess, StopIsNoTimeLimit)
{
  CaseProcess process({ "/bin/sh", "-c", "sleep 60" }, {});
  process.stop();
  const CaseEnd end = endOf(process);
  EXPECT_TRUE(end.wasStopped);
  EXPECT_FALSE(end.wasTooSlow);
  EXPECT_EQ(end.signalNumber, SIGTERM);
}

TEST(CaseProcess, AProgramThatIsNotThereFails)
{
  CaseProcess   process({ "/nowhere/program" }, {});
  const CaseEnd end = endOf(process);
  EXPECT_EQ(end.exitStatus, 127);
  EXPECT_NE(end.lastWords.find("No such file"), std::string::npos) << end.lastWords;
}

TEST(CaseProcess, DiesWithTheProcessThatStartedIt)
{
  int ends[2] = {};
  ASSERT_EQ(::pipe(ends), 0);
  const pid_t middle = ::fork();
  if (middle == 0)
  {
    CaseProcess process({ "/bin/sh", "-c", "sleep 60" }, {});
    const pid_t id = process.id();
    (void)!::write(ends[1], &id, sizeof id);
    ::kill(::getpid(), SIGKILL);
  }
  pid_t grandchild = 0;
  ASSERT_EQ(::read(ends[0], &grandchild, sizeof grandchild), static_cast<ssize_t>(sizeof grandchild));
  ASSERT_EQ(::waitpid(middle, nullptr, 0), middle);
  for (int wait = 0; wait < 200 && isRunning(grandchild); ++wait)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_FALSE(isRunning(grandchild));
}

TEST(CaseFailure, TakesTheLastErrorLine)
{
  CaseEnd end;
  end.exitStatus = 3;
  end.lastWords = "warning: w\nerror: a.nrrd: no [E_EMPTY]\nerror: b.nrrd: cut; copy it [E_TRUNCATED]\nnoise\n";
  const std::optional<CaseFailure> failure = failureOf(end, {});
  ASSERT_TRUE(failure);
  EXPECT_EQ(failure->failure.code, ErrorCode::Truncated);
  EXPECT_EQ(failure->failure.message, "b.nrrd: cut; copy it");
  EXPECT_TRUE(failure->isReported);
}

TEST(CaseFailure, AnEndWithoutAReasonIsACrash)
{
  CaseEnd end;
  end.exitStatus = 9;
  end.lastWords = "terminate called";
  EXPECT_EQ(failureOf(end, {})->failure.code, ErrorCode::Crashed);
  end.exitStatus = 0;
  EXPECT_FALSE(failureOf(end, {}));
}
