#include "Mutator.h"

#include <itk_zlib.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <stdexcept>

namespace moserhex::fuzz
{
namespace
{

const std::array<std::string, 28> extremeWords{ "0",
                                                "-1",
                                                "1",
                                                "-0",
                                                "nan",
                                                "inf",
                                                "-inf",
                                                "1e308",
                                                "1e-320",
                                                "-1e30",
                                                "2147483647",
                                                "-2147483648",
                                                "4294967295",
                                                "4294967296",
                                                "65536",
                                                "9223372036854775807",
                                                "1e400",
                                                "99999999999999999999999999",
                                                "0.5",
                                                "1,5",
                                                "0x10",
                                                "%s%s%n%x",
                                                "/etc/hostname",
                                                "../../x",
                                                "",
                                                std::string(1500, 'A'),
                                                "\xFF\xFE\x80",
                                                "1 1 1 1" };

constexpr std::array<unsigned char, 12> extremeBytes{ 0x00, 0xFF, 0x7F, 0x80, 0x01, 0x20,
                                                      0x0A, 0x0D, 0x2D, 0x30, 0x22, 0x3C };

[[nodiscard]] bool
isTokenByte(char c)
{
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' || c == '+' ||
         c == '.' || c == '_';
}

} // namespace

std::string
Mutator::mutant(std::string bytes)
{
  for (std::size_t changes = below(2) == 0 ? 1 : 1 + below(4); changes > 0; --changes)
  {
    change(bytes);
  }
  return bytes;
}

std::size_t
Mutator::below(std::size_t count)
{
  return count == 0 ? 0 : static_cast<std::size_t>(m_Random.next() % count);
}

std::size_t
Mutator::place(const std::string & bytes)
{
  constexpr std::size_t header = 600;
  return below(below(2) == 0 ? std::min(bytes.size(), header) : bytes.size());
}

void
Mutator::change(std::string & bytes)
{
  const std::size_t at = place(bytes);
  switch (bytes.empty() ? 4 : below(11))
  {
    case 0:
      bytes[at] = static_cast<char>(static_cast<unsigned char>(bytes[at]) ^ (1U << below(8)));
      break;
    case 1:
      bytes[at] = static_cast<char>(extremeBytes[below(extremeBytes.size())]);
      break;
    case 2:
      bytes.erase(at, 1 + below(below(2) == 0 ? 4 : 200));
      break;
    case 3:
      bytes.insert(at, bytes.substr(place(bytes), 1 + below(64)));
      break;
    case 4:
      bytes.insert(at, 1 + below(16), static_cast<char>(below(256)));
      break;
    case 5:
      bytes.resize(below(4) == 0 ? at : bytes.size() - below(std::min<std::size_t>(bytes.size(), 64)));
      break;
    case 6:
    case 7:
      replaceToken(bytes);
      break;
    case 8:
      changeLine(bytes);
      break;
    case 9:
      changeDigit(bytes);
      break;
    default:
      replaceBinary(bytes);
  }
}

void
Mutator::replaceToken(std::string & bytes)
{
  std::size_t begin = place(bytes);
  while (begin < bytes.size() && !isTokenByte(bytes[begin]))
  {
    ++begin;
  }
  while (begin > 0 && isTokenByte(bytes[begin - 1]))
  {
    --begin;
  }
  std::size_t end = begin;
  while (end < bytes.size() && isTokenByte(bytes[end]))
  {
    ++end;
  }
  bytes.replace(begin, end - begin, extremeWords[below(extremeWords.size())]);
}

void
Mutator::changeDigit(std::string & bytes)
{
  const std::size_t at = bytes.find_first_of("0123456789", place(bytes));
  if (at != std::string::npos)
  {
    bytes[at] = static_cast<char>('0' + below(10));
  }
}

void
Mutator::replaceBinary(std::string & bytes)
{
  const double                      nan = std::numeric_limits<double>::quiet_NaN();
  const std::array<std::int64_t, 7> integers{
    0, -1, 1, 0x7FFFFFFF, 0x80000000LL, 0x7F7FFFFF7F7FFFFFLL, 0x4000000000000000LL
  };
  std::array<char, 8> value{};
  const std::size_t   kind = below(integers.size() + 2);
  const float         shortNan = static_cast<float>(nan);
  if (kind < integers.size())
  {
    std::memcpy(value.data(), &integers[kind], sizeof integers[kind]);
  }
  else if (kind == integers.size())
  {
    std::memcpy(value.data(), &nan, sizeof nan);
  }
  else
  {
    std::memcpy(value.data(), &shortNan, sizeof shortNan);
  }
  const std::size_t width = std::size_t{ 1 } << (1 + below(3)); // 2, 4 or 8
  if (below(4) == 0)
  {
    std::reverse(value.begin(), value.begin() + static_cast<std::ptrdiff_t>(width));
  }
  const std::size_t at = place(bytes);
  bytes.replace(at, std::min(width, bytes.size() - at), value.data(), width);
}

void
Mutator::changeLine(std::string & bytes)
{
  const std::size_t at = place(bytes);
  const std::size_t before = bytes.rfind('\n', at);
  const std::size_t begin = before == std::string::npos ? 0 : before + 1;
  const std::size_t newLine = bytes.find('\n', begin);
  const std::size_t end = newLine == std::string::npos ? bytes.size() : newLine + 1;
  const std::string line = bytes.substr(begin, end - begin);
  switch (below(3))
  {
    case 0:
      bytes.insert(begin, line);
      break;
    case 1:
      bytes.erase(begin, line.size());
      break;
    default:
      bytes.erase(begin, line.size());
      bytes.insert(std::min(place(bytes), bytes.size()), line);
  }
}

std::string
gzipped(const std::string & bytes)
{
  z_stream stream{};
  if (deflateInit2(&stream, Z_BEST_SPEED, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY) != Z_OK)
  {
    throw std::runtime_error("zlib does not start");
  }
  std::string packed(deflateBound(&stream, static_cast<uLong>(bytes.size())), '\0');
  stream.next_in = reinterpret_cast<Bytef *>(const_cast<char *>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef *>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  const int status = deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  if (status != Z_STREAM_END)
  {
    throw std::runtime_error("zlib does not pack");
  }
  return packed;
}

std::string
gunzipped(const std::string & bytes)
{
  constexpr std::size_t largestSeed = 1 << 22;
  z_stream              stream{};
  if (inflateInit2(&stream, 15 + 16) != Z_OK)
  {
    throw std::runtime_error("zlib does not start");
  }
  std::string plain(largestSeed, '\0');
  stream.next_in = reinterpret_cast<Bytef *>(const_cast<char *>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef *>(plain.data());
  stream.avail_out = static_cast<uInt>(plain.size());
  const int status = inflate(&stream, Z_FINISH);
  plain.resize(stream.total_out);
  inflateEnd(&stream);
  if (status != Z_STREAM_END)
  {
    throw std::runtime_error("not a gzip seed");
  }
  return plain;
}

} // namespace moserhex::fuzz
