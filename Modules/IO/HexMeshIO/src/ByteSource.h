#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

struct gzFile_s;

namespace moserhex
{

/** A file read through zlib: gzip of one or several members, or plain bytes as they are. */
class GzipFile
{
public:
  /** \throws IOError  the file cannot be opened */
  explicit GzipFile(const std::string & fileName);
  ~GzipFile();
  GzipFile(const GzipFile &) = delete;
  GzipFile &
  operator=(const GzipFile &) = delete;

  /** Bytes read, fewer than `size` only at the end. \throws BadInput  cut off or damaged stream */
  std::size_t
  read(void * buffer, std::size_t size);

  /** Reads on to the end and counts. \throws BadInput  cut off or damaged stream */
  std::uint64_t
  skipToEnd();

private:
  std::string m_FileName;
  gzFile_s *  m_File;
};

/** Bytes that the zlib or gzip stream starting at `begin` decodes to, checksum included.
 * \throws BadInput  cut off or damaged stream; IOError  the file cannot be opened */
[[nodiscard]] std::uint64_t
inflatedSize(const std::string & fileName, std::uint64_t begin);

} // namespace moserhex
