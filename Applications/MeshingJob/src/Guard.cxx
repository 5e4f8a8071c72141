#include "Guard.h"

#include "Console.h"
#include "moserhex/Common/Errors.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>

namespace moserhex::app
{

Failure
describeFailure(const std::exception_ptr & exception)
{
  try
  {
    std::rethrow_exception(exception);
  }
  catch (const Error & error)
  {
    return { error.code(), error.what() };
  }
  catch (const std::bad_alloc &)
  {
    return { ErrorCode::OutOfMemory,
             "not enough memory; use fewer shells or boxes, a smaller image, or a larger machine" };
  }
  catch (const std::exception & error)
  {
    return { ErrorCode::Internal, std::string(error.what()) + "; please report this" };
  }
}

int
runGuarded(const std::function<void()> & command)
{
  return runGuardedForStatus([&command] {
    command();
    return EXIT_SUCCESS;
  });
}

int
runGuardedForStatus(const std::function<int()> & command)
{
  try
  {
    return command();
  }
  catch (...)
  {
    const Failure failure = describeFailure(std::current_exception());
    printError(failure.code, failure.message);
    return exitStatusOf(failure.code);
  }
}

void
openMissingStreams()
{
  for (const int stream : { STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO })
  {
    if (::fcntl(stream, F_GETFD) == -1 && errno == EBADF)
    {
      // The lowest number that is free, which is this one: those below it are open by now.
      (void)::open("/dev/null", stream == STDIN_FILENO ? O_RDONLY : O_WRONLY);
    }
  }
}

int
flushOutput(int exitCode)
{
  errno = 0;
  const bool failed = std::fflush(stdout) != 0 || std::ferror(stdout) != 0;
  if (!failed || errno == EPIPE || exitCode != EXIT_SUCCESS)
  {
    return exitCode;
  }
  printError(ErrorCode::InputOutput,
             std::string("standard output: cannot write (") + std::strerror(errno) + "); free some space");
  return exitStatusOf(ErrorCode::InputOutput);
}

} // namespace moserhex::app
