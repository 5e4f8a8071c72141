#include "moserhex/HexMeshIO/AtomicFile.h"

#include "moserhex/HexMeshIO/FileErrors.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <cstring>
#include <filesystem>

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

/** ".name.<process>.part.ext" beside the final file. */
std::string
partNameOf(const fs::path & finalName)
{
  const std::string base = finalName.stem().string().substr(0, 150);
  const std::string name = "." + base + "." + std::to_string(::getpid()) + ".part" + finalName.extension().string();
  return (finalName.parent_path() / name).string();
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
  m_PartName = partNameOf(path);
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
