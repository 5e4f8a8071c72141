#include "OutputLock.h"

#include "moserhex/HexMeshIO/FileErrors.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <thread>

namespace moserhex::app
{
namespace
{

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr auto pause = std::chrono::milliseconds(20);

std::string
thisProcess()
{
  char host[256] = "unknown host";
  (void)::gethostname(host, sizeof host - 1);
  return "process " + std::to_string(::getpid()) + " on " + host;
}

/** Without O_CLOEXEC: the cases' processes hold it, too. */
int
openLock(const std::string & name)
{
  const int file = ::open(name.c_str(), O_RDWR | O_CREAT, 0666);
  if (file < 0)
  {
    throw IOError(ErrorCode::CannotCreate,
                  name,
                  std::string("cannot write there (") + std::strerror(errno) + ")",
                  "choose a writable folder");
  }
  return file;
}

/** Who signed a lock last, to be put behind "another run". */
std::string
holderOf(const std::string & name)
{
  std::ifstream file(name);
  std::string   holder;
  std::getline(file, holder);
  return holder.empty() ? "" : " (" + holder + ")";
}

void
take(const std::string & name, int file, int kind, Clock::time_point deadline)
{
  while (::flock(file, kind | LOCK_NB) != 0)
  {
    if (errno != EWOULDBLOCK && errno != EINTR)
    {
      throw IOError(ErrorCode::CannotCreate,
                    name,
                    std::string("cannot be locked (") + std::strerror(errno) + ")",
                    "choose a folder on another file system");
    }
    if (Clock::now() >= deadline)
    {
      throw IOError(ErrorCode::Locked,
                    fs::path(name).parent_path().string(),
                    "another run works there" + holderOf(name),
                    "wait for it, or choose another output folder");
    }
    std::this_thread::sleep_for(pause);
  }
}

/** For the message of who comes second; nothing depends on it. */
void
sign(int file)
{
  const std::string text = thisProcess() + "\n";
  if (file >= 0 && ::ftruncate(file, 0) == 0)
  {
    (void)!::pwrite(file, text.data(), text.size(), 0);
  }
}

} // namespace

OutputLock::OutputLock(const std::string & outputFolder, const std::string & shard, double patience)
{
  const auto deadline =
    Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(patience));
  const std::string ofFolder = (fs::path(outputFolder) / ".lock").string();
  const std::string ofShard = (fs::path(outputFolder) / (".lock." + shard)).string();
  try
  {
    m_Folder = openLock(ofFolder);
    take(ofFolder, m_Folder, shard.empty() ? LOCK_EX : LOCK_SH, deadline);
    if (!shard.empty())
    {
      m_Shard = openLock(ofShard);
      take(ofShard, m_Shard, LOCK_EX, deadline);
    }
    sign(m_Folder);
    sign(m_Shard);
  }
  catch (...)
  {
    ::close(m_Folder);
    ::close(m_Shard);
    throw;
  }
}

OutputLock::~OutputLock()
{
  ::close(m_Folder);
  ::close(m_Shard);
}

} // namespace moserhex::app
