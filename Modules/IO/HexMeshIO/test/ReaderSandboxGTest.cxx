// What a child process may do to its parent: nothing but send an answer.
#include "../src/ReaderSandbox.h"

#include "TestErrors.h"
#include "TestFolder.h"
#include "moserhex/Common/InstructionSets.h"
#include "moserhex/HexMeshIO/FileErrors.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <thread>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace moserhex;

namespace
{

std::string
failureOf(const std::function<std::string()> & work, const SandboxLimits & limits = {})
{
  return errorOf([&] { (void)runInSandbox("a.nrrd", limits, work); });
}

std::size_t
openDescriptors()
{
  std::size_t count = 0;
  for (int descriptor = 0; descriptor < 256; ++descriptor)
  {
    count += ::fcntl(descriptor, F_GETFD) >= 0 ? 1 : 0;
  }
  return count;
}

bool
hasChildren()
{
  return ::waitpid(-1, nullptr, WNOHANG) >= 0 || errno != ECHILD;
}

} // namespace

TEST(ReaderSandbox, AnswerComesBackByteForByte)
{
  const std::string bytes("a\0b\xFF\n", 5);
  EXPECT_EQ(runInSandbox("a.nrrd", {}, [&] { return bytes; }), bytes);
  EXPECT_EQ(runInSandbox("a.nrrd", {}, [] { return std::string(); }), "");
}

TEST(ReaderSandbox, HundredMegabytesComeBack)
{
  const std::string answer = runInSandbox("a.nrrd", {}, [] {
    std::string bytes(100'000'000, 'x');
    bytes.back() = 'y';
    return bytes;
  });
  ASSERT_EQ(answer.size(), 100'000'000u);
  EXPECT_EQ(answer.find_first_not_of('x'), answer.size() - 1);
  EXPECT_EQ(answer.back(), 'y');
}

TEST(ReaderSandbox, WorkChangesNothingHere)
{
  int value = 1;
  (void)runInSandbox("a.nrrd", {}, [&value] {
    value = 2;
    return std::string();
  });
  EXPECT_EQ(value, 1);
}

TEST(ReaderSandbox, ErrorsKeepClassCodeAndMessage)
{
  const auto badInput = [] { throw BadInput(ErrorCode::Checksum, "b.nrrd", "cause", "remedy"); };
  const auto ioError = [] { throw IOError(ErrorCode::InputOutput, "b.nrrd", "cause", "remedy"); };
  const auto invalid = [] { throw InvalidInput(ErrorCode::Usage, "wrong"); };
  const auto inChild = [](const auto & fail) {
    (void)runInSandbox("a.nrrd", {}, [&fail]() -> std::string {
      fail();
      return {};
    });
  };
  EXPECT_THROW(inChild(badInput), BadInput);
  EXPECT_THROW(inChild(ioError), IOError);
  EXPECT_THROW(inChild(invalid), InvalidInput);
  EXPECT_EQ(errorOf([&] { inChild(badInput); }), errorOf(badInput));
  EXPECT_EQ(errorOf([&] { inChild(ioError); }), errorOf(ioError));
  EXPECT_EQ(errorOf([&] { inChild(invalid); }), errorOf(invalid));
}

TEST(ReaderSandbox, OtherExceptionsAreTheReadersFailure)
{
  EXPECT_NE(
    failureOf([]() -> std::string { throw std::runtime_error("odd\nsecond line"); }).find("E_READER a.nrrd: odd;"),
    std::string::npos);
  EXPECT_NE(failureOf([]() -> std::string { throw 3; }).find("an unknown exception"), std::string::npos);
}

TEST(ReaderSandbox, SegmentationFaultIsNamed)
{
  const std::string error = failureOf([]() -> std::string {
    ::signal(SIGSEGV, SIG_DFL);
    ::raise(SIGSEGV);
    return {};
  });
  EXPECT_NE(error.find("E_READER"), std::string::npos) << error;
  EXPECT_NE(error.find("signal 11"), std::string::npos) << error;
}

TEST(ReaderSandbox, AbortIsNamed)
{
  EXPECT_NE(failureOf([]() -> std::string { std::abort(); }).find("signal 6"), std::string::npos);
}

TEST(ReaderSandbox, SilentEndIsNoAnswer)
{
  EXPECT_NE(failureOf([]() -> std::string { ::_exit(7); }).find("without an answer (status 7)"), std::string::npos);
}

TEST(ReaderSandbox, SpinningEndsAtTheLimitOfCpuTime)
{
  SandboxLimits limits;
  limits.cpuSeconds = 1;
  const std::string error = failureOf(
    []() -> std::string {
      for (volatile unsigned int n = 0;; n = n + 1)
      {}
    },
    limits);
  EXPECT_NE(error.find("more than 1 s of CPU time"), std::string::npos) << error;
}

TEST(ReaderSandbox, SleepingEndsAtTheWallLimit)
{
  SandboxLimits limits;
  limits.wallSeconds = 1;
  const std::string error = failureOf(
    [] {
      std::this_thread::sleep_for(std::chrono::seconds(60));
      return std::string();
    },
    limits);
  EXPECT_NE(error.find("E_READER a.nrrd: reading it took more than 1 s;"), std::string::npos) << error;
}

TEST(ReaderSandbox, MemoryIsLimitedAndGrantedOnDemand)
{
  if constexpr (MOSERHEX_INSTRUMENTED)
  {
    GTEST_SKIP() << "memory is not limited under a sanitizer";
  }
  constexpr std::size_t much = 200 << 20;
  const auto            allocate = [] { return std::to_string(std::string(much, 'x').size()); };
  SandboxLimits         limits;
  limits.memoryBytes = 64 << 20;
  EXPECT_EQ(failureOf(allocate, limits).substr(0, 9), "E_TOO_BIG");
  const auto granted = [&allocate] {
    allowSandboxMemory(2 * much);
    return allocate();
  };
  EXPECT_EQ(runInSandbox("a.nrrd", limits, granted), std::to_string(much));
}

TEST(ReaderSandbox, ChildWritesNoFileAndPrintsNowhere)
{
  const TestFolder  folder;
  const std::string name = folder / "written";
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  EXPECT_THROW((void)runInSandbox("a.nrrd",
                                  {},
                                  [&name]() -> std::string {
                                    std::puts("out");
                                    std::fputs("error", stderr);
                                    std::fflush(nullptr);
                                    writeBytes(name, "text"); // SIGXFSZ
                                    return {};
                                  }),
               BadInput);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(readBytes(name), "");
}

TEST(ReaderSandbox, NeitherZombieNorDescriptorIsLeft)
{
  const std::size_t before = openDescriptors();
  for (int run = 0; run < 5; ++run)
  {
    (void)runInSandbox("a.nrrd", {}, [] { return std::string(200'000, 'x'); });
    (void)failureOf([]() -> std::string { std::abort(); });
    (void)failureOf([]() -> std::string { throw BadInput(ErrorCode::Labels, "a", "b", "c"); });
  }
  EXPECT_EQ(openDescriptors(), before);
  EXPECT_FALSE(hasChildren());
}

TEST(ReaderSandbox, ClosedStandardStreamsAreNoMatter)
{
  const int in = ::dup(0);
  const int out = ::dup(1);
  ::close(0);
  ::close(1);
  std::string answer;
  const auto  error = errorOf([&answer] { answer = runInSandbox("a.nrrd", {}, [] { return std::string("whole"); }); });
  ::dup2(in, 0);
  ::dup2(out, 1);
  ::close(in);
  ::close(out);
  EXPECT_EQ(error, "no error");
  EXPECT_EQ(answer, "whole");
}

TEST(ReaderSandbox, NoDescriptorLeftIsAnErrorOfTheSystem)
{
  if constexpr (MOSERHEX_INSTRUMENTED)
  {
    GTEST_SKIP() << "a sanitizer opens a pipe to look at the error";
  }
  struct rlimit before = {};
  ::getrlimit(RLIMIT_NOFILE, &before);
  const struct rlimit none = { 0, before.rlim_max };
  ::setrlimit(RLIMIT_NOFILE, &none);
  const std::string error = failureOf([] { return std::string(); });
  ::setrlimit(RLIMIT_NOFILE, &before);
  EXPECT_EQ(error.substr(0, 4), "E_IO") << error;
}

TEST(ReaderSandbox, SignalsDuringTheWaitAreNoMatter)
{
  struct sigaction before = {};
  struct sigaction nothing = {};
  nothing.sa_handler = [](int) {};
  ::sigaction(SIGUSR1, &nothing, &before);
  const pid_t parent = ::getpid();
  EXPECT_EQ(runInSandbox("a.nrrd",
                         {},
                         [parent] {
                           for (int n = 0; n < 20; ++n)
                           {
                             ::kill(parent, SIGUSR1);
                             std::this_thread::sleep_for(std::chrono::milliseconds(2));
                           }
                           return std::string("done");
                         }),
            "done");
  ::sigaction(SIGUSR1, &before, nullptr);
}
