#include "moserhex/HexMeshIO/Sha256.h"

#include "ImageFileCheck.h"
#include "moserhex/HexMeshIO/FileErrors.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <vector>

namespace moserhex
{
namespace
{

// FIPS 180-4, section 4.2.2: fractional parts of the cube roots of the first 64 primes.
constexpr std::array<std::uint32_t, 64> roundConstants{
  0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
  0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
  0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
  0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
  0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
  0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
  0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
  0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2
};

std::uint32_t
rotateRight(std::uint32_t x, unsigned int bits)
{
  return (x >> bits) | (x << (32 - bits));
}

} // namespace

void
Sha256::processBlock(const std::uint8_t * block)
{
  std::array<std::uint32_t, 64> w;
  for (std::size_t t = 0; t < 16; ++t)
  {
    w[t] = (std::uint32_t{ block[4 * t] } << 24) | (std::uint32_t{ block[4 * t + 1] } << 16) |
           (std::uint32_t{ block[4 * t + 2] } << 8) | std::uint32_t{ block[4 * t + 3] };
  }
  for (std::size_t t = 16; t < 64; ++t)
  {
    const std::uint32_t s0 = rotateRight(w[t - 15], 7) ^ rotateRight(w[t - 15], 18) ^ (w[t - 15] >> 3);
    const std::uint32_t s1 = rotateRight(w[t - 2], 17) ^ rotateRight(w[t - 2], 19) ^ (w[t - 2] >> 10);
    w[t] = w[t - 16] + s0 + w[t - 7] + s1;
  }
  auto [a, b, c, d, e, f, g, h] = m_State;
  for (std::size_t t = 0; t < 64; ++t)
  {
    const std::uint32_t s1 = rotateRight(e, 6) ^ rotateRight(e, 11) ^ rotateRight(e, 25);
    const std::uint32_t choice = (e & f) ^ (~e & g);
    const std::uint32_t t1 = h + s1 + choice + roundConstants[t] + w[t];
    const std::uint32_t s0 = rotateRight(a, 2) ^ rotateRight(a, 13) ^ rotateRight(a, 22);
    const std::uint32_t majority = (a & b) ^ (a & c) ^ (b & c);
    const std::uint32_t t2 = s0 + majority;
    h = g;
    g = f;
    f = e;
    e = d + t1;
    d = c;
    c = b;
    b = a;
    a = t1 + t2;
  }
  const std::array<std::uint32_t, 8> mixed{ a, b, c, d, e, f, g, h };
  for (std::size_t i = 0; i < 8; ++i)
  {
    m_State[i] += mixed[i];
  }
}

void
Sha256::update(const void * data, std::size_t size)
{
  const auto * bytes = static_cast<const std::uint8_t *>(data);
  while (size > 0)
  {
    const std::size_t used = m_ByteCount % 64;
    const std::size_t taken = std::min(size, 64 - used);
    std::memcpy(m_Buffer.data() + used, bytes, taken);
    m_ByteCount += taken;
    bytes += taken;
    size -= taken;
    if (used + taken == 64)
    {
      processBlock(m_Buffer.data());
    }
  }
}

std::string
Sha256::hexDigest() const
{
  // Padding: a one bit, zeros, the length in bits as 64-bit big-endian number.
  Sha256                       finished(*this);
  const std::uint64_t          bits = m_ByteCount * 8;
  const std::size_t            used = m_ByteCount % 64;
  std::array<std::uint8_t, 72> padding{ 0x80 };
  const std::size_t            zeros = (used < 56 ? 56 : 120) - used;
  for (std::size_t i = 0; i < 8; ++i)
  {
    padding[zeros + i] = static_cast<std::uint8_t>(bits >> (56 - 8 * i));
  }
  finished.update(padding.data(), zeros + 8);

  constexpr const char * digits = "0123456789abcdef";
  std::string            text;
  for (const std::uint32_t word : finished.m_State)
  {
    for (int shift = 28; shift >= 0; shift -= 4)
    {
      text += digits[(word >> shift) & 15u];
    }
  }
  return text;
}

std::string
sha256OfFile(const std::string & fileName)
{
  requireRegularFile(fileName);
  const std::unique_ptr<std::FILE, int (*)(std::FILE *)> file(std::fopen(fileName.c_str(), "rb"), &std::fclose);
  if (!file)
  {
    throwUnopened(fileName, errno);
  }
  Sha256            hash;
  std::vector<char> buffer(1 << 16);
  std::size_t       count = 0;
  while ((count = std::fread(buffer.data(), 1, buffer.size(), file.get())) > 0)
  {
    hash.update(buffer.data(), count);
  }
  if (std::ferror(file.get()))
  {
    throw IOError(ErrorCode::InputOutput, fileName, "cannot read to the end", "check the device");
  }
  return hash.hexDigest();
}

} // namespace moserhex
