#pragma once

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

struct z_stream_s;

namespace moserhex
{

/** Decoded bytes of a part of a file, one after the other. */
class ByteSource
{
public:
  enum class Coding
  {
    Plain,
    Gzip,        ///< of one or several members
    GzipOrPlain, ///< told from the first two bytes
    Zlib
  };

  /** \param begin  first byte of the file to decode
   * \param stored  how many bytes of the file belong to it; 0: all there are
   * \throws IOError  the file cannot be opened or read */
  ByteSource(const std::string & fileName, Coding coding, std::uint64_t begin = 0, std::uint64_t stored = 0);
  ~ByteSource();
  ByteSource(const ByteSource &) = delete;
  ByteSource &
  operator=(const ByteSource &) = delete;

  /** Bytes read, fewer than `size` only at the end.
   * \throws BadInput  the compressed stream ends early (Truncated) or is damaged (Checksum) */
  std::size_t
  read(void * buffer, std::size_t size);

  /** Passes over up to `count` bytes; returns how many there were. \throws BadInput  as read */
  std::uint64_t
  skip(std::uint64_t count);

  /** Bytes of the file that no decoded byte comes from, after the end has been read. */
  [[nodiscard]] std::uint64_t
  unusedBytes() const;

private:
  void
  refill();
  void
  startMember(int windowBits);
  std::size_t
  readPlain(char * buffer, std::size_t size);
  std::size_t
  inflateSome(char * buffer, std::size_t size);

  std::string                 m_FileName;
  std::ifstream               m_File;
  bool                        m_Plain{ false };
  bool                        m_Gzip{ false };
  bool                        m_Ended{ false };
  std::uint64_t               m_Left{ 0 }; ///< bytes of the file not yet in m_Input
  std::vector<unsigned char>  m_Input;
  std::size_t                 m_InputPosition{ 0 };
  std::unique_ptr<z_stream_s> m_Stream;
};

} // namespace moserhex
