#include "ChildRun.h"

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <stdexcept>

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace moserhex::fuzz
{
namespace
{

using Clock = std::chrono::steady_clock;

/** The address sanitizer's own memory is beyond any limit. */
#if defined(__SANITIZE_ADDRESS__)
constexpr bool memoryIsLimited = false;
#else
constexpr bool memoryIsLimited = true;
#endif

/** A mark at the end tells a whole answer from one cut off by death. */
constexpr char endMark = '\x04';

void
limit(int resource, rlim_t soft, rlim_t hard)
{
  const struct rlimit both
  {
    soft, hard
  };
  ::setrlimit(resource, &both);
}

[[noreturn]] void
beChild(const std::function<std::string()> & work, const ChildLimits & limits, int output)
{
  ::setpgid(0, 0);
  limit(RLIMIT_CORE, 0, 0);
  limit(RLIMIT_FSIZE, 64UL << 20, 64UL << 20);
  limit(RLIMIT_CPU, limits.cpuSeconds, RLIM_INFINITY); // a reading process sets its own, and the wall limit sees it
  if (memoryIsLimited)
  {
    limit(RLIMIT_AS, limits.mebibytes << 20, limits.mebibytes << 20);
  }
  const int nowhere = ::open("/dev/null", O_RDWR);
  ::dup2(nowhere, STDIN_FILENO);
  ::dup2(nowhere, STDOUT_FILENO);
  ::dup2(nowhere, STDERR_FILENO);
  const std::string text = work() + endMark;
  std::size_t       sent = 0;
  while (sent < text.size())
  {
    const ssize_t count = ::write(output, text.data() + sent, text.size() - sent);
    if (count <= 0)
    {
      ::_exit(1);
    }
    sent += static_cast<std::size_t>(count);
  }
  ::_exit(0);
}

/** What comes until the end or the deadline. \return false at the deadline */
bool
readUntil(Clock::time_point deadline, int input, std::string & text)
{
  for (;;)
  {
    const auto    left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    struct pollfd ready
    {
      input, POLLIN, 0
    };
    const int events = left > 0 ? ::poll(&ready, 1, static_cast<int>(left)) : 0;
    if (events < 0 && errno == EINTR)
    {
      continue;
    }
    if (events <= 0)
    {
      return false;
    }
    std::array<char, 4096> buffer{};
    const ssize_t          count = ::read(input, buffer.data(), buffer.size());
    if (count <= 0)
    {
      return true;
    }
    text.append(buffer.data(), static_cast<std::size_t>(count));
  }
}

} // namespace

ChildResult
runInChild(const std::function<std::string()> & work, const ChildLimits & limits)
{
  std::array<int, 2> ends{};
  if (::pipe(ends.data()) != 0)
  {
    throw std::runtime_error("cannot make a pipe");
  }
  const auto  deadline = Clock::now() + std::chrono::milliseconds(static_cast<long>(1000.0 * limits.wallSeconds));
  const pid_t child = ::fork();
  if (child < 0)
  {
    throw std::runtime_error("cannot make a child");
  }
  if (child == 0)
  {
    ::close(ends[0]);
    beChild(work, limits, ends[1]);
  }
  ::close(ends[1]);
  ChildResult result;
  const bool  inTime = readUntil(deadline, ends[0], result.text);
  ::close(ends[0]);
  if (!inTime)
  {
    ::kill(-child, SIGKILL);
    ::kill(child, SIGKILL); // before it had a group of its own
  }
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR)
  {}
  result.finished = inTime && !result.text.empty() && result.text.back() == endMark;
  if (result.finished)
  {
    result.text.pop_back();
  }
  else if (!inTime || (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU))
  {
    result.text = "over the time limit";
  }
  else
  {
    result.text = WIFSIGNALED(status) ? "signal " + std::to_string(WTERMSIG(status))
                                      : "exit status " + std::to_string(WEXITSTATUS(status));
  }
  return result;
}

} // namespace moserhex::fuzz
