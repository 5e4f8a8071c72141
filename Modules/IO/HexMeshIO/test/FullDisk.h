#pragma once

#include "moserhex/HexMeshIO/FileErrors.h"

#include <csignal>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace moserhex
{

/** Whether `write` ends in an IOError in a process that may write 5000 bytes to a file, which fails like a full disk.
 */
template <typename TWrite>
[[nodiscard]] bool
reportsFullDisk(const TWrite & write)
{
  constexpr int reported = 42;
  const pid_t   child = ::fork();
  if (child == 0)
  {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{ 5000, 5000 };
    ::setrlimit(RLIMIT_FSIZE, &limit);
    try
    {
      write();
    }
    catch (const IOError &)
    {
      ::_exit(reported);
    }
    ::_exit(0);
  }
  int status = 0;
  return ::waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == reported;
}

} // namespace moserhex
