// libFuzzer's entry for the reader MOSERHEX_FUZZED_READER. The bytes are put into one file in memory, since readers
// take names; only moserhex::Error may leave a reader, and its message must be one short line.
#include "FuzzedReaders.h"
#include "moserhex/HexMeshIO/FileErrors.h"

#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include <fcntl.h>
#include <unistd.h>

namespace
{

/** A file in memory with the ending wanted. It goes when the process ends in order. */
class MemoryFile
{
public:
  explicit MemoryFile(const std::string & ending)
    : m_Name("/dev/shm/moserhex-fuzz-" + std::to_string(::getpid()) + ending)
    , m_Descriptor(::open(m_Name.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600))
  {
    if (m_Descriptor < 0)
    {
      throw std::runtime_error("cannot make " + m_Name);
    }
  }

  ~MemoryFile()
  {
    ::close(m_Descriptor);
    ::unlink(m_Name.c_str());
  }

  MemoryFile(const MemoryFile &) = delete;
  MemoryFile &
  operator=(const MemoryFile &) = delete;

  const std::string &
  holding(const std::uint8_t * bytes, std::size_t size) const
  {
    if (::ftruncate(m_Descriptor, 0) != 0 || ::pwrite(m_Descriptor, bytes, size, 0) != static_cast<ssize_t>(size))
    {
      throw std::runtime_error("cannot write " + m_Name);
    }
    return m_Name;
  }

private:
  std::string m_Name;
  int         m_Descriptor;
};

} // namespace

extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t * bytes, std::size_t size)
{
  static const moserhex::fuzz::FuzzedReader & reader = moserhex::fuzz::fuzzedReader(MOSERHEX_FUZZED_READER);
  static const MemoryFile                     file(reader.ending);
  try
  {
    reader.read(file.holding(bytes, size));
  }
  catch (const moserhex::Error & error)
  {
    const std::string message = error.what();
    if (message.size() > 200 || message.find('\n') != std::string::npos)
    {
      std::abort();
    }
  }
  return 0;
}
