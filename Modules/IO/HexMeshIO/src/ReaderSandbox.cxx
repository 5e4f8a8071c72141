#include "ReaderSandbox.h"

#include "moserhex/Common/InstructionSets.h"
#include "moserhex/HexMeshIO/FileErrors.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <new>

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace moserhex
{
namespace
{

using Clock = std::chrono::steady_clock;

/** How an answer begins: what it is, and how many bytes follow. */
struct AnswerHead
{
  char          kind{ '\0' }; ///< Result, or the class of an error
  std::int32_t  code{ 0 };    ///< of an error
  std::uint64_t bytes{ 0 };
};

constexpr std::uint64_t longestAnswer = std::uint64_t{ 1 } << 36;

constexpr char resultKind = 'R';
constexpr char badInputKind = 'B';
constexpr char ioErrorKind = 'O';
constexpr char invalidInputKind = 'V';
constexpr char memoryKind = 'M';
constexpr char otherKind = 'X';

class Descriptor
{
public:
  explicit Descriptor(int number) : m_Number(number)
  {}
  ~Descriptor()
  {
    close();
  }
  Descriptor(const Descriptor &) = delete;
  Descriptor &
  operator=(const Descriptor &) = delete;

  void
  close()
  {
    if (m_Number >= 0)
    {
      ::close(m_Number);
    }
    m_Number = -1;
  }

  [[nodiscard]] int
  get() const
  {
    return m_Number;
  }

private:
  int m_Number;
};

/** Never leaves a zombie. */
class ChildProcess
{
public:
  explicit ChildProcess(pid_t pid) : m_Pid(pid)
  {}
  ~ChildProcess()
  {
    if (m_Pid > 0)
    {
      kill();
      (void)wait();
    }
  }
  ChildProcess(const ChildProcess &) = delete;
  ChildProcess &
  operator=(const ChildProcess &) = delete;

  void
  kill() const
  {
    ::kill(m_Pid, SIGKILL);
  }

  /** Its status; 0 when somebody else has collected it. */
  int
  wait()
  {
    int   status = 0;
    pid_t got = -1;
    do
    {
      got = ::waitpid(m_Pid, &status, 0);
    } while (got < 0 && errno == EINTR);
    m_Pid = -1;
    return got < 0 ? 0 : status;
  }

private:
  pid_t m_Pid;
};

void
setLimit(int resource, rlim_t soft, rlim_t hard)
{
  struct rlimit now = {};
  if (::getrlimit(resource, &now) == 0)
  {
    const struct rlimit limit = { std::min(soft, now.rlim_max), std::min(hard, now.rlim_max) };
    ::setrlimit(resource, &limit);
  }
}

bool
writeAll(int descriptor, const void * bytes, std::size_t count)
{
  const char * next = static_cast<const char *>(bytes);
  while (count > 0)
  {
    const ssize_t written = ::write(descriptor, next, count);
    if (written < 0 && errno != EINTR)
    {
      return false;
    }
    next += written > 0 ? written : 0;
    count -= written > 0 ? static_cast<std::size_t>(written) : 0;
  }
  return true;
}

void
answer(int descriptor, AnswerHead head, const std::string & text)
{
  head.bytes = text.size();
  if (writeAll(descriptor, &head, sizeof head))
  {
    (void)writeAll(descriptor, text.data(), text.size());
  }
}

/** A sanitizer's report in the child must not pass for the end of a reader that was given a bad file: the child keeps
 * the sanitizer's signals and, unless that is a file, which it must not write, the standard error. */
bool
isOfSanitizer(int signalNumber)
{
  return MOSERHEX_INSTRUMENTED && (signalNumber == SIGSEGV || signalNumber == SIGBUS || signalNumber == SIGFPE);
}

int
lastSilenced()
{
  struct stat error = {};
  return MOSERHEX_INSTRUMENTED && ::fstat(STDERR_FILENO, &error) == 0 && !S_ISREG(error.st_mode) ? STDOUT_FILENO
                                                                                                 : STDERR_FILENO;
}

void
shutIn(const SandboxLimits & limits, pid_t parent)
{
#ifdef __linux__
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  ::prctl(PR_SET_DUMPABLE, 0);
#endif
  if (::getppid() != parent)
  {
    ::_exit(1); // it died before the request above
  }
  for (int number = 1; number < 32; ++number)
  {
    if (!isOfSanitizer(number))
    {
      ::signal(number, SIG_DFL); // the parent's handlers are about the parent's files
    }
  }
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  const int nowhere = ::open("/dev/null", O_RDWR);
  const int last = lastSilenced();
  for (int standard = STDIN_FILENO; standard <= last && nowhere >= 0; ++standard)
  {
    ::dup2(nowhere, standard);
  }
  setLimit(RLIMIT_CORE, 0, 0);
  setLimit(RLIMIT_FSIZE, 0, 0);
  setLimit(RLIMIT_CPU, limits.cpuSeconds, limits.cpuSeconds + 1);
  allowSandboxMemory(limits.memoryBytes);
}

[[noreturn]] void
runChild(int descriptor, const SandboxLimits & limits, pid_t parent, const std::function<std::string()> & work)
{
  shutIn(limits, parent);
  const auto answerError = [descriptor](char kind, ErrorCode code, const char * what) {
    answer(descriptor, { kind, static_cast<std::int32_t>(code), 0 }, what);
  };
  try
  {
    answer(descriptor, { resultKind, 0, 0 }, work());
  }
  catch (const BadInput & error)
  {
    answerError(badInputKind, error.code(), error.what());
  }
  catch (const IOError & error)
  {
    answerError(ioErrorKind, error.code(), error.what());
  }
  catch (const InvalidInput & error)
  {
    answerError(invalidInputKind, error.code(), error.what());
  }
  catch (const std::bad_alloc &)
  {
    answerError(memoryKind, ErrorCode::TooBig, "");
  }
  catch (const std::exception & error)
  {
    answerError(otherKind, ErrorCode::ReaderFailed, error.what());
  }
  catch (...)
  {
    answerError(otherKind, ErrorCode::ReaderFailed, "an unknown exception");
  }
  ::_exit(0);
}

/** Reads up to `count` bytes; fewer at the end of the pipe. `inTime` becomes false when the time is over. */
std::size_t
readUntil(int descriptor, void * bytes, std::size_t count, Clock::time_point deadline, bool & inTime)
{
  char *      next = static_cast<char *>(bytes);
  std::size_t total = 0;
  while (total < count)
  {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    if (left <= 0)
    {
      inTime = false;
      break;
    }
    struct pollfd waiting = { descriptor, POLLIN, 0 };
    const int     ready = ::poll(&waiting, 1, static_cast<int>(std::min<std::int64_t>(left, 60'000)));
    if (ready <= 0)
    {
      continue; // time or a signal
    }
    const ssize_t got = ::read(descriptor, next + total, std::min<std::size_t>(count - total, 1 << 20));
    if (got == 0 || (got < 0 && errno != EINTR && errno != EAGAIN))
    {
      break;
    }
    total += got > 0 ? static_cast<std::size_t>(got) : 0;
  }
  return total;
}

[[noreturn]] void
throwReaderFailed(const std::string & fileName, const std::string & cause)
{
  throw BadInput(ErrorCode::ReaderFailed, fileName, cause, "export it again in another format");
}

[[noreturn]] void
throwDeath(const std::string & fileName, const SandboxLimits & limits, int status)
{
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU)
  {
    throwReaderFailed(fileName, "reading it took more than " + std::to_string(limits.cpuSeconds) + " s of CPU time");
  }
  if (WIFSIGNALED(status))
  {
    throwReaderFailed(fileName,
                      "the reader died of signal " + std::to_string(WTERMSIG(status)) + " (" +
                        ::strsignal(WTERMSIG(status)) + ")");
  }
  throwReaderFailed(fileName,
                    "the reader ended without an answer (status " + std::to_string(WEXITSTATUS(status)) + ")");
}

[[noreturn]] void
rethrow(const std::string & fileName, const AnswerHead & head, const std::string & text)
{
  const auto code = static_cast<ErrorCode>(head.code >= 0 && head.code <= static_cast<std::int32_t>(lastErrorCode)
                                             ? head.code
                                             : static_cast<std::int32_t>(ErrorCode::ReaderFailed));
  switch (head.kind)
  {
    case badInputKind:
      throw BadInput(code, FinishedMessage{ text });
    case ioErrorKind:
      throw IOError(code, FinishedMessage{ text });
    case invalidInputKind:
      throw InvalidInput(code, text);
    case memoryKind:
      throw BadInput(ErrorCode::TooBig, fileName, "reading it needs more memory than is allowed", "make it smaller");
    default:
      throwReaderFailed(fileName, text.substr(0, text.find('\n')));
  }
}

} // namespace

void
allowSandboxMemory(std::uint64_t bytes)
{
#if MOSERHEX_INSTRUMENTED
  (void)bytes; // a sanitizer's shadow memory takes terabytes of addresses
#else
  std::uint64_t pages = 0;
  if (std::ifstream("/proc/self/statm") >> pages)
  {
    const auto mapped = pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
    setLimit(RLIMIT_AS, static_cast<rlim_t>(mapped + bytes), RLIM_INFINITY);
  }
#endif
}

std::string
runInSandbox(const std::string & fileName, const SandboxLimits & limits, const std::function<std::string()> & work)
{
  const auto refuse = [&fileName](const char * what) {
    throw IOError(ErrorCode::InputOutput,
                  fileName,
                  std::string("cannot start a process to read it: ") + what + ": " + std::strerror(errno),
                  "end other programs, or read without a sandbox");
  };
  int ends[2] = { -1, -1 };
  if (::pipe(ends) != 0)
  {
    refuse("pipe");
  }
  Descriptor reading(ends[0]);
  Descriptor writing(ends[1]);
  ::fcntl(ends[0], F_SETFD, FD_CLOEXEC);
  ::fcntl(ends[1], F_SETFD, FD_CLOEXEC);
#ifdef F_SETPIPE_SZ
  ::fcntl(ends[1], F_SETPIPE_SZ, 1 << 20); // fewer switches; refused, it is only slower
#endif
  const pid_t parent = ::getpid();
  const auto  deadline = Clock::now() + std::chrono::seconds(limits.wallSeconds);
  const pid_t pid = ::fork();
  if (pid < 0)
  {
    refuse("fork");
  }
  if (pid == 0)
  {
    // Away from 0, 1 and 2, which may be closed and become the null device.
    const int high = ::fcntl(ends[1], F_DUPFD_CLOEXEC, 3);
    ::close(ends[0]);
    runChild(high, limits, parent, work);
  }
  ChildProcess child(pid);
  writing.close();

  bool        inTime = true;
  AnswerHead  head;
  std::string text;
  bool        whole = readUntil(reading.get(), &head, sizeof head, deadline, inTime) == sizeof head;
  if (whole && head.bytes > longestAnswer)
  {
    throwReaderFailed(fileName, "the reader sent an impossible answer");
  }
  if (whole)
  {
    text.resize(static_cast<std::size_t>(head.bytes));
    whole = readUntil(reading.get(), text.data(), text.size(), deadline, inTime) == text.size();
  }
  if (!inTime)
  {
    throwReaderFailed(fileName, "reading it took more than " + std::to_string(limits.wallSeconds) + " s");
  }
  if (!whole)
  {
    throwDeath(fileName, limits, child.wait());
  }
  if (head.kind != resultKind)
  {
    rethrow(fileName, head, text);
  }
  return text;
}

} // namespace moserhex
