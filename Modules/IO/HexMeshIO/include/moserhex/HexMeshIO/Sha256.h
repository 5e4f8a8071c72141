#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace moserhex
{

/** SHA-256 (FIPS 180-4) of a stream of bytes: identifies the input of a run in its report. */
class Sha256
{
public:
  /** Takes `size` further bytes. */
  void
  update(const void * data, std::size_t size);

  /** The digest of all bytes so far as 64 lower-case hexadecimal digits. */
  [[nodiscard]] std::string
  hexDigest() const;

private:
  void
  processBlock(const std::uint8_t * block);

  std::array<std::uint32_t, 8> m_State{ 0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                        0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19 };
  std::array<std::uint8_t, 64> m_Buffer{};
  std::uint64_t                m_ByteCount{ 0 };
};

/** SHA-256 of a file's content. \throws BadInput (NoInput)  no regular file, or it may not be read; IOError  the file
 * cannot be read */
[[nodiscard]] std::string
sha256OfFile(const std::string & fileName);

} // namespace moserhex
