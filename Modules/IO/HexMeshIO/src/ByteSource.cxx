#include "ByteSource.h"

#include "moserhex/HexMeshIO/FileErrors.h"

#include <itk_zlib.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <vector>

namespace moserhex
{
namespace
{

constexpr std::size_t bufferSize = 1 << 18;

[[noreturn]] void
throwDamaged(const std::string & fileName)
{
  throw BadInput(
    ErrorCode::Checksum, fileName, "the compressed data are cut off or damaged", "copy or export the file again");
}

} // namespace

GzipFile::GzipFile(const std::string & fileName) : m_FileName(fileName), m_File(gzopen(fileName.c_str(), "rb"))
{
  if (!m_File)
  {
    throw IOError(ErrorCode::InputOutput,
                  fileName,
                  std::string("cannot open (") + std::strerror(errno) + ")",
                  "check the file's permissions");
  }
  gzbuffer(m_File, bufferSize);
}

GzipFile::~GzipFile()
{
  gzclose(m_File);
}

std::size_t
GzipFile::read(void * buffer, std::size_t size)
{
  const int count = gzread(m_File, buffer, static_cast<unsigned int>(size));
  int       status = Z_OK;
  gzerror(m_File, &status);
  // Z_BUF_ERROR is how a stream that ends too early shows itself.
  if (count < 0 || status == Z_BUF_ERROR || status == Z_DATA_ERROR)
  {
    throwDamaged(m_FileName);
  }
  return static_cast<std::size_t>(count);
}

std::uint64_t
GzipFile::skipToEnd()
{
  std::vector<char> buffer(bufferSize);
  std::uint64_t     total = 0;
  while (const std::size_t count = read(buffer.data(), buffer.size()))
  {
    total += count;
  }
  return total;
}

std::uint64_t
inflatedSize(const std::string & fileName, std::uint64_t begin)
{
  std::ifstream file(fileName, std::ios::binary);
  if (!file || !file.seekg(static_cast<std::streamoff>(begin)))
  {
    throw IOError(ErrorCode::InputOutput, fileName, "cannot read the voxels", "check the file's permissions");
  }
  z_stream stream{};
  // 32: zlib or gzip, told from the stream itself.
  if (inflateInit2(&stream, 15 + 32) != Z_OK)
  {
    throw IOError(ErrorCode::OutOfMemory, fileName, "not enough memory to decompress", "close other programs");
  }
  std::vector<unsigned char> input(bufferSize);
  std::vector<unsigned char> output(bufferSize);
  std::uint64_t              total = 0;
  int                        status = Z_OK;
  while (status == Z_OK)
  {
    if (stream.avail_in == 0)
    {
      file.read(reinterpret_cast<char *>(input.data()), static_cast<std::streamsize>(input.size()));
      stream.avail_in = static_cast<unsigned int>(file.gcount());
      stream.next_in = input.data();
      if (stream.avail_in == 0)
      {
        break;
      }
    }
    stream.avail_out = static_cast<unsigned int>(output.size());
    stream.next_out = output.data();
    status = inflate(&stream, Z_NO_FLUSH);
    total += output.size() - stream.avail_out;
  }
  inflateEnd(&stream);
  if (status != Z_STREAM_END)
  {
    throwDamaged(fileName);
  }
  return total;
}

} // namespace moserhex
