#include "Signals.h"

#include "moserhex/HexMeshIO/AtomicFile.h"

#include <csignal>

namespace moserhex::app
{
namespace
{

extern "C" void
removePartsAndEnd(int signalNumber)
{
  removeUnfinishedFiles();
  std::signal(signalNumber, SIG_DFL);
  std::raise(signalNumber);
}

} // namespace

void
installSignalHandlers()
{
  for (const int signalNumber : { SIGINT, SIGTERM, SIGHUP })
  {
    std::signal(signalNumber, removePartsAndEnd);
  }
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN); // the mesh counts, also when nobody reads the table
}

} // namespace moserhex::app
