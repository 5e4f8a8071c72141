#include "moserhex/HexMeshIO/AtomicFile.h"

#include "moserhex/HexMeshIO/FileErrors.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <utility>

namespace moserhex
{
namespace
{

namespace fs = std::filesystem;

// Names of the parts being written, where a signal handler can reach them: the one place in the library that needs
// process-wide state, because a handler gets no argument.
struct UnfinishedFile
{
  std::atomic<int>           state{ 0 }; // 0 free, 1 being filled, 2 in use
  std::array<char, PATH_MAX> name{};
};
std::array<UnfinishedFile, 16> unfinishedFiles;

void
registerUnfinished(const std::string & name)
{
  for (UnfinishedFile & slot : unfinishedFiles)
  {
    int free = 0;
    if (name.size() < PATH_MAX && slot.state.compare_exchange_strong(free, 1))
    {
      std::memcpy(slot.name.data(), name.c_str(), name.size() + 1);
      slot.state = 2;
      return;
    }
  }
}

void
forgetUnfinished(const std::string & name)
{
  for (UnfinishedFile & slot : unfinishedFiles)
  {
    if (slot.state == 2 && name == slot.name.data())
    {
      slot.state = 0;
      return;
    }
  }
}

std::string
reason(int error)
{
  return std::strerror(error);
}

/** What a part's name begins with: ".name.". */
std::string
beginOfPart(const fs::path & finalName)
{
  return "." + finalName.stem().string().substr(0, 150) + ".";
}

/** ".name.<process>.part.ext" beside the final file. */
std::string
partNameOf(const fs::path & finalName, long process)
{
  const std::string name = beginOfPart(finalName) + std::to_string(process) + ".part" + finalName.extension().string();
  return (finalName.parent_path() / name).string();
}

/** The process that a part's name has, and the name without it; nothing for other files. */
std::optional<std::pair<std::string, long>>
partAndProcess(const std::string & name)
{
  const std::size_t part = name.rfind(".part");
  const std::size_t number = part == std::string::npos || part == 0 ? std::string::npos : name.rfind('.', part - 1);
  if (number == std::string::npos || number == 0 || number + 1 == part || part - number > 18 ||
      name.find_first_not_of("0123456789", number + 1) != part)
  {
    return std::nullopt;
  }
  const std::string others = name.substr(0, number + 1) + name.substr(part + std::strlen(".part"));
  return std::make_pair(others, std::stol(name.substr(number + 1, part - number - 1)));
}

/** What the system tells of a process. */
struct ProcessState
{
  double start{ 0.0 };      ///< [s] since the epoch
  bool   hasEnded{ false }; ///< it is a zombie, which nobody has collected yet
};

/** Nothing where the system does not tell. */
std::optional<ProcessState>
stateOf(long process)
{
  std::ifstream stat("/proc/" + std::to_string(process) + "/stat");
  std::string   text{ std::istreambuf_iterator<char>(stat), std::istreambuf_iterator<char>() };
  const auto    name = text.rfind(')'); // its end; the name may hold anything
  if (name == std::string::npos)
  {
    return std::nullopt;
  }
  std::istringstream fields(text.substr(name + 1));
  std::string        state;
  std::string        skipped;
  fields >> state;
  for (int field = 4; field < 22; ++field)
  {
    fields >> skipped;
  }
  double ticks = 0.0; // since the system began
  if (!(fields >> ticks))
  {
    return std::nullopt;
  }
  const auto secondsOf = [](clockid_t clock) {
    struct timespec now = {};
    ::clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  };
#ifdef CLOCK_BOOTTIME
  const double sinceBoot = secondsOf(CLOCK_BOOTTIME);
#else
  const double            sinceBoot = secondsOf(CLOCK_MONOTONIC);
#endif
  const double age = sinceBoot - ticks / static_cast<double>(::sysconf(_SC_CLK_TCK));
  return ProcessState{ secondsOf(CLOCK_REALTIME) - age, state == "Z" || state == "X" };
}

/** [s] */
double
lastWrite(const struct stat & file)
{
#ifdef __APPLE__
  const struct timespec & time = file.st_mtimespec;
#else
  const struct timespec & time = file.st_mtim;
#endif
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/** Whether the process that made a part may still be writing it: it is there, has not ended, and began before the part
 * was written last. One that began later has got the number of one that is no more. */
bool
isBeingWritten(const std::string & part, long process)
{
  constexpr double clockError = 0.1; // [s]
  if (::kill(static_cast<pid_t>(process), 0) != 0 && errno == ESRCH)
  {
    return false;
  }
  struct stat                       written = {};
  const std::optional<ProcessState> owner = stateOf(process);
  if (!owner || ::stat(part.c_str(), &written) != 0)
  {
    return true;
  }
  return !owner->hasEnded && owner->start <= lastWrite(written) + clockError;
}

void
flushToDisk(const std::string & name, const std::string & reportAs, int flags)
{
  const int descriptor = ::open(name.c_str(), O_RDONLY | O_CLOEXEC | flags);
  if (descriptor < 0)
  {
    throw IOError(ErrorCode::InputOutput, reportAs, "cannot open the new file (" + reason(errno) + ")", "try again");
  }
  const int failed = ::fsync(descriptor) == 0 ? 0 : errno;
  ::close(descriptor);
  // File systems that cannot flush a folder say EINVAL; the rename is still atomic there.
  if (failed != 0 && failed != EINVAL)
  {
    throw IOError(ErrorCode::InputOutput,
                  reportAs,
                  "cannot flush to disk (" + reason(failed) + ")",
                  "free some space or check the device");
  }
}

} // namespace

AtomicFile::AtomicFile(const std::string & finalName) : m_FinalName(finalName)
{
  const fs::path  path(finalName);
  std::error_code ignored;
  if (path.filename().empty() || fs::is_directory(path, ignored))
  {
    throw IOError(ErrorCode::CannotCreate, finalName, "is a folder, not a file", "give a file name");
  }
  m_PartName = partNameOf(path, ::getpid());
  const int descriptor = ::open(m_PartName.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor < 0)
  {
    throw IOError(ErrorCode::CannotCreate,
                  finalName,
                  "cannot write there (" + reason(errno) + ")",
                  "choose a writable, existing folder");
  }
  ::close(descriptor);
  registerUnfinished(m_PartName);
}

AtomicFile::~AtomicFile()
{
  forgetUnfinished(m_PartName);
  if (!m_Committed)
  {
    ::unlink(m_PartName.c_str());
  }
}

void
AtomicFile::writeText(const std::string & text) const
{
  const int   descriptor = ::open(m_PartName.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC);
  std::size_t written = 0;
  int         failed = descriptor < 0 ? errno : 0;
  while (failed == 0 && written < text.size())
  {
    const ssize_t count = ::write(descriptor, text.data() + written, text.size() - written);
    if (count > 0)
    {
      written += static_cast<std::size_t>(count);
    }
    else if (errno != EINTR)
    {
      failed = errno;
    }
  }
  if (descriptor >= 0 && ::close(descriptor) != 0 && failed == 0)
  {
    failed = errno;
  }
  if (failed != 0)
  {
    throw IOError(ErrorCode::InputOutput,
                  m_FinalName,
                  "cannot write (" + reason(failed) + ")",
                  "free some space or choose another folder");
  }
}

void
AtomicFile::commit()
{
  flushToDisk(m_PartName, m_FinalName, 0);
  if (::rename(m_PartName.c_str(), m_FinalName.c_str()) != 0)
  {
    throw IOError(ErrorCode::InputOutput,
                  m_FinalName,
                  "cannot rename the new file (" + reason(errno) + ")",
                  "check the folder's permissions");
  }
  m_Committed = true;
  const std::string folder = fs::path(m_FinalName).parent_path().string();
  flushToDisk(folder.empty() ? "." : folder, m_FinalName, O_DIRECTORY);
}

void
writeTextFile(const std::string & fileName, const std::string & text)
{
  AtomicFile file(fileName);
  file.writeText(text);
  file.commit();
}

void
removePartOf(const std::string & finalName, long process) noexcept
{
  ::unlink(partNameOf(finalName, process).c_str());
}

void
removeAbandonedParts(const std::vector<std::string> & finalNames)
{
  std::map<std::string, std::set<std::string>> namesInFolders;
  for (const std::string & finalName : finalNames)
  {
    const fs::path path(finalName);
    namesInFolders[path.parent_path().string()].insert(beginOfPart(path) + path.extension().string());
  }
  for (const auto & [folder, names] : namesInFolders)
  {
    std::error_code ignored; // a folder that is not there yet
    for (const fs::directory_entry & entry : fs::directory_iterator(folder.empty() ? "." : folder, ignored))
    {
      const auto part = partAndProcess(entry.path().filename().string());
      if (part && names.count(part->first) > 0 && !isBeingWritten(entry.path().string(), part->second))
      {
        ::unlink(entry.path().c_str());
      }
    }
  }
}

void
makeFolder(const std::string & folder)
{
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (!fs::is_directory(folder))
  {
    throw IOError(
      ErrorCode::CannotCreate, folder, "cannot make the folder (" + failed.message() + ")", "choose a writable place");
  }
}

void
removeUnfinishedFiles() noexcept
{
  for (UnfinishedFile & slot : unfinishedFiles)
  {
    if (slot.state == 2)
    {
      ::unlink(slot.name.data());
    }
  }
}

} // namespace moserhex
