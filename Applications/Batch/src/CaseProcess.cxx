#include "CaseProcess.h"

#include "moserhex/Common/InstructionSets.h"
#include "moserhex/HexMeshIO/FileErrors.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>

#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace moserhex::app
{
namespace
{

constexpr std::size_t longestLastWords = 4096;

/** Between SIGTERM, on which a case removes its unfinished files, and SIGKILL. */
constexpr auto grace = std::chrono::seconds(2);

/** Where a process has closed its messages, its end shows only when asked for. */
constexpr auto pause = std::chrono::milliseconds(20);

void
setLimit(int resource, rlim_t value)
{
  struct rlimit limit = {};
  if (::getrlimit(resource, &limit) == 0)
  {
    limit.rlim_max = std::min(limit.rlim_max, value);
    limit.rlim_cur = limit.rlim_max;
    (void)::setrlimit(resource, &limit);
  }
}

/** In the new process, where only what is async-signal-safe may be called. */
[[noreturn]] void
become(char * const * command, const CaseLimits & limits, int messages, pid_t parent)
{
  (void)::setpgid(0, 0);
#ifdef __linux__
  (void)::prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
  if (::getppid() != parent)
  {
    ::_exit(1); // it died before the request above
  }
  for (const int signalNumber : { SIGINT, SIGTERM, SIGHUP, SIGCHLD, SIGPIPE })
  {
    (void)::signal(signalNumber, SIG_DFL);
  }
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  const int nowhere = ::open("/dev/null", O_RDWR);
  (void)::dup2(nowhere, STDIN_FILENO);
  (void)::dup2(nowhere, STDOUT_FILENO);
  (void)::dup2(messages, STDERR_FILENO);
  setLimit(RLIMIT_CORE, 0);
  if (limits.mebibytes > 0.0 && !MOSERHEX_INSTRUMENTED) // a sanitizer's shadow memory takes terabytes of addresses
  {
    setLimit(RLIMIT_AS, static_cast<rlim_t>(limits.mebibytes * 1024.0 * 1024.0));
  }
  ::execv(command[0], command);
  const char * reason = std::strerror(errno);
  (void)!::write(STDERR_FILENO, reason, std::strlen(reason));
  ::_exit(127);
}

} // namespace

CaseProcess::CaseProcess(const std::vector<std::string> & command, const CaseLimits & limits) : m_Limits(limits)
{
  const auto refuse = [&command](const char * what) {
    throw IOError(ErrorCode::InputOutput,
                  command.front(),
                  std::string("cannot be started: ") + what + ": " + std::strerror(errno),
                  "end other programs, or use fewer --jobs");
  };
  std::vector<char *> arguments;
  for (const std::string & argument : command)
  {
    arguments.push_back(const_cast<char *>(argument.c_str()));
  }
  arguments.push_back(nullptr);
  int ends[2] = { -1, -1 };
  if (::pipe(ends) != 0)
  {
    refuse("pipe");
  }
  ::fcntl(ends[0], F_SETFD, FD_CLOEXEC);
  ::fcntl(ends[1], F_SETFD, FD_CLOEXEC);
  ::fcntl(ends[0], F_SETFL, O_NONBLOCK);
  const pid_t parent = ::getpid();
  m_Id = ::fork();
  if (m_Id == 0)
  {
    become(arguments.data(), limits, ends[1], parent);
  }
  ::close(ends[1]);
  m_Messages = ends[0];
  if (m_Id < 0)
  {
    ::close(m_Messages);
    refuse("fork");
  }
  (void)::setpgid(m_Id, m_Id); // whoever comes first
}

CaseProcess::~CaseProcess()
{
  if (m_Id > 0)
  {
    signalGroup(SIGKILL);
    while (::waitpid(m_Id, nullptr, 0) < 0 && errno == EINTR)
    {}
  }
  if (m_Messages >= 0)
  {
    ::close(m_Messages);
  }
}

std::optional<CaseEnd>
CaseProcess::poll()
{
  readMessages();
  endWhereTimeIsOver();
  siginfo_t ended = {};
  if (::waitid(P_PID, static_cast<id_t>(m_Id), &ended, WEXITED | WNOHANG | WNOWAIT) != 0 || ended.si_pid == 0)
  {
    return std::nullopt;
  }
  signalGroup(SIGKILL); // what it may have left behind, while its number cannot be another's
  readMessages();
  int           status = 0;
  struct rusage usage = {};
  while (::wait4(m_Id, &status, 0, &usage) < 0 && errno == EINTR)
  {}
  m_Id = -1;
  m_End.exitStatus = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  m_End.signalNumber = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  m_End.seconds = std::chrono::duration<double>(Clock::now() - m_Start).count();
#ifdef __APPLE__
  m_End.peakMebibytes = static_cast<double>(usage.ru_maxrss) / (1024.0 * 1024.0);
#else
  m_End.peakMebibytes = static_cast<double>(usage.ru_maxrss) / 1024.0;
#endif
  return m_End;
}

void
CaseProcess::stop()
{
  if (!m_Terminated)
  {
    m_End.wasStopped = true;
    m_Terminated = Clock::now();
    signalGroup(SIGTERM);
  }
}

CaseProcess::Clock::time_point
CaseProcess::nextDeadline() const
{
  Clock::time_point next =
    m_Start + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(m_Limits.seconds));
  if (m_Terminated)
  {
    next = *m_Terminated + grace;
  }
  return m_Messages < 0 || m_Killed ? std::min(next, Clock::now() + pause) : next;
}

void
CaseProcess::readMessages()
{
  char bytes[1024];
  while (m_Messages >= 0)
  {
    const ssize_t count = ::read(m_Messages, bytes, sizeof bytes);
    if (count > 0)
    {
      m_End.lastWords.append(bytes, static_cast<std::size_t>(count));
      if (m_End.lastWords.size() > longestLastWords)
      {
        m_End.lastWords.erase(0, m_End.lastWords.size() - longestLastWords);
      }
    }
    else if (count == 0 || (errno != EINTR && errno != EAGAIN))
    {
      ::close(m_Messages);
      m_Messages = -1;
    }
    else if (errno == EAGAIN)
    {
      return;
    }
  }
}

void
CaseProcess::endWhereTimeIsOver()
{
  const auto now = Clock::now();
  if (!m_Terminated && std::chrono::duration<double>(now - m_Start).count() >= m_Limits.seconds)
  {
    m_End.wasTooSlow = true;
    m_Terminated = now;
    signalGroup(SIGTERM);
  }
  if (m_Terminated && !m_Killed && now >= *m_Terminated + grace)
  {
    m_Killed = true;
    signalGroup(SIGKILL);
  }
}

void
CaseProcess::signalGroup(int signalNumber) const
{
  if (m_Id > 0)
  {
    (void)::kill(-m_Id, signalNumber);
  }
}

} // namespace moserhex::app
