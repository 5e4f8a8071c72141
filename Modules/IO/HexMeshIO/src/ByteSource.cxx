#include "ByteSource.h"

#include "moserhex/HexMeshIO/FileErrors.h"

#include <itk_zlib.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

namespace moserhex
{
namespace
{

constexpr std::size_t   bufferSize = 1 << 18;
constexpr unsigned char gzipMagic[] = { 0x1F, 0x8B };

} // namespace

ByteSource::ByteSource(const std::string & fileName, Coding coding, std::uint64_t begin, std::uint64_t stored)
  : m_FileName(fileName), m_File(fileName, std::ios::binary)
{
  std::error_code error;
  const auto      size = std::filesystem::file_size(fileName, error);
  if (!m_File || error || !m_File.seekg(static_cast<std::streamoff>(std::min<std::uint64_t>(begin, size))))
  {
    throwUnopened(fileName, errno);
  }
  m_Left = size > begin ? size - begin : 0;
  m_Left = stored > 0 ? std::min(m_Left, stored) : m_Left;
  refill();
  const bool startsLikeGzip = m_Input.size() > 1 && std::equal(gzipMagic, gzipMagic + 2, m_Input.begin());
  m_Gzip = coding == Coding::Gzip || (coding == Coding::GzipOrPlain && startsLikeGzip);
  m_Plain = coding == Coding::Plain || (coding == Coding::GzipOrPlain && !startsLikeGzip);
  if (!m_Plain)
  {
    startMember(m_Gzip ? 15 + 16 : 15);
  }
}

ByteSource::~ByteSource()
{
  if (m_Stream)
  {
    inflateEnd(m_Stream.get());
  }
}

void
ByteSource::startMember(int windowBits)
{
  if (m_Stream)
  {
    inflateEnd(m_Stream.get());
  }
  m_Stream = std::make_unique<z_stream_s>();
  if (inflateInit2(m_Stream.get(), windowBits) != Z_OK)
  {
    m_Stream.reset();
    throw IOError(ErrorCode::OutOfMemory, m_FileName, "not enough memory to decompress", "close other programs");
  }
}

/** Keeps what is unread of the input and adds to it. */
void
ByteSource::refill()
{
  m_Input.erase(m_Input.begin(), m_Input.begin() + static_cast<std::ptrdiff_t>(m_InputPosition));
  m_InputPosition = 0;
  const std::size_t before = m_Input.size();
  const std::size_t more = static_cast<std::size_t>(std::min<std::uint64_t>(bufferSize, m_Left));
  m_Input.resize(before + more);
  m_File.read(reinterpret_cast<char *>(m_Input.data() + before), static_cast<std::streamsize>(more));
  if (static_cast<std::size_t>(m_File.gcount()) != more)
  {
    throw IOError(ErrorCode::InputOutput, m_FileName, "cannot be read to its end", "check the disk");
  }
  m_Left -= more;
}

std::size_t
ByteSource::readPlain(char * buffer, std::size_t size)
{
  if (m_InputPosition == m_Input.size() && m_Left > 0)
  {
    refill();
  }
  const std::size_t count = std::min(size, m_Input.size() - m_InputPosition);
  std::copy_n(m_Input.begin() + static_cast<std::ptrdiff_t>(m_InputPosition), count, buffer);
  m_InputPosition += count;
  return count;
}

std::size_t
ByteSource::inflateSome(char * buffer, std::size_t size)
{
  if (m_InputPosition == m_Input.size() && m_Left > 0)
  {
    refill();
  }
  m_Stream->next_in = m_Input.data() + m_InputPosition;
  m_Stream->avail_in = static_cast<unsigned int>(m_Input.size() - m_InputPosition);
  m_Stream->next_out = reinterpret_cast<unsigned char *>(buffer);
  m_Stream->avail_out = static_cast<unsigned int>(size);
  const int status = inflate(m_Stream.get(), Z_NO_FLUSH);
  m_InputPosition = m_Input.size() - m_Stream->avail_in;
  const std::size_t count = size - m_Stream->avail_out;
  if (status == Z_STREAM_END)
  {
    if (m_Input.size() - m_InputPosition < 2 && m_Left > 0)
    {
      refill();
    }
    const bool another =
      m_Gzip && m_Input.size() - m_InputPosition >= 2 &&
      std::equal(gzipMagic, gzipMagic + 2, m_Input.begin() + static_cast<std::ptrdiff_t>(m_InputPosition));
    m_Ended = !another;
    if (another)
    {
      startMember(15 + 16);
    }
    return count;
  }
  if (status != Z_OK && status != Z_BUF_ERROR)
  {
    throw BadInput(ErrorCode::Checksum,
                   m_FileName,
                   std::string("the compressed data are damaged (") +
                     (m_Stream->msg ? m_Stream->msg : "not such a stream") + ")",
                   "copy or export the file again");
  }
  if (count == 0 && m_InputPosition == m_Input.size() && m_Left == 0)
  {
    throw BadInput(ErrorCode::Truncated, m_FileName, "the compressed data end early", "copy or export the file again");
  }
  return count;
}

std::size_t
ByteSource::read(void * buffer, std::size_t size)
{
  auto *      bytes = static_cast<char *>(buffer);
  std::size_t total = 0;
  while (total < size && !m_Ended)
  {
    // zlib counts in 32 bits.
    const std::size_t part = std::min<std::size_t>(size - total, 1 << 30);
    const std::size_t count = m_Plain ? readPlain(bytes + total, part) : inflateSome(bytes + total, part);
    total += count;
    m_Ended = m_Ended || (m_Plain && count == 0);
  }
  return total;
}

std::uint64_t
ByteSource::skip(std::uint64_t count)
{
  std::vector<char> buffer(static_cast<std::size_t>(std::min<std::uint64_t>(count, bufferSize)));
  std::uint64_t     total = 0;
  while (total < count)
  {
    const auto part = static_cast<std::size_t>(std::min<std::uint64_t>(count - total, buffer.size()));
    const auto got = read(buffer.data(), part);
    total += got;
    if (got < part)
    {
      break;
    }
  }
  return total;
}

std::uint64_t
ByteSource::unusedBytes() const
{
  return m_Left + m_Input.size() - m_InputPosition;
}

} // namespace moserhex
