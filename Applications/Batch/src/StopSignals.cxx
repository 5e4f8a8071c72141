#include "StopSignals.h"

#include "Signals.h"
#include "moserhex/HexMeshIO/AtomicFile.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>

namespace moserhex::app
{
namespace
{

// A handler gets no argument: what it must reach is of the process.
std::atomic<int>   receivedSignal{ 0 };
std::array<int, 2> wakeUp{ -1, -1 };

extern "C" void
askForEnd(int signalNumber)
{
  const int keptErrno = errno;
  if (receivedSignal.exchange(signalNumber) != 0)
  {
    removeUnfinishedFiles();
    ::_exit(128 + signalNumber);
  }
  (void)!::write(wakeUp[1], "", 1);
  errno = keptErrno;
}

} // namespace

StopSignals::StopSignals()
{
  receivedSignal = 0;
  if (::pipe(wakeUp.data()) == 0)
  {
    for (const int end : wakeUp)
    {
      ::fcntl(end, F_SETFD, FD_CLOEXEC);
      ::fcntl(end, F_SETFL, O_NONBLOCK);
    }
  }
  for (const int signalNumber : { SIGINT, SIGTERM, SIGHUP })
  {
    std::signal(signalNumber, askForEnd);
  }
}

StopSignals::~StopSignals()
{
  installSignalHandlers();
  for (int & end : wakeUp)
  {
    ::close(end);
    end = -1;
  }
}

int
StopSignals::received() const
{
  return receivedSignal;
}

int
StopSignals::descriptor() const
{
  return wakeUp[0];
}

} // namespace moserhex::app
