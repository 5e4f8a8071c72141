#include "ImageHeader.h"

#include "moserhex/HexMeshIO/FileErrors.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

namespace moserhex
{
namespace
{

constexpr std::uint64_t sizeLimit = std::uint64_t{ 1 } << 40;

std::optional<std::uint64_t>
parseCount(const std::string & token)
{
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  if (error != std::errc() || end != token.data() + token.size())
  {
    return std::nullopt;
  }
  return value;
}

} // namespace

std::string
trimmed(const std::string & text)
{
  const auto begin = text.find_first_not_of(" \t\r\n");
  const auto end = text.find_last_not_of(" \t\r\n");
  return begin == std::string::npos ? std::string() : text.substr(begin, end - begin + 1);
}

std::string
lowerCase(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) {
    return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  });
  return text;
}

std::vector<std::string>
wordsOf(const std::string & text)
{
  std::istringstream       stream(text);
  std::vector<std::string> result;
  for (std::string word; stream >> word;)
  {
    result.push_back(word);
  }
  return result;
}

/** Voxels x bytes each, from three sizes given as text. */
std::uint64_t
promisedBytes(const std::string & file, const std::vector<std::string> & sizes, std::uint64_t bytesPerVoxel)
{
  if (sizes.size() != 3)
  {
    throw BadInput(ErrorCode::NotHexahedra,
                   file,
                   "the header gives " + std::to_string(sizes.size()) + " sizes, need 3",
                   exportScalarVolume);
  }
  std::uint64_t bytes = bytesPerVoxel;
  for (const std::string & size : sizes)
  {
    const auto count = parseCount(size);
    if (!count || *count == 0 || *count > 1'000'000 || bytes > sizeLimit / *count)
    {
      throw BadInput(ErrorCode::TooBig, file, "the header gives an impossible size (" + size + ")", exportScalarVolume);
    }
    bytes *= *count;
  }
  return bytes;
}

void
requireData(const std::string & file, std::uint64_t promised, std::uint64_t present)
{
  if (present < promised)
  {
    throw BadInput(ErrorCode::Truncated,
                   file,
                   "the file ends early: " + std::to_string(promised) + " bytes of voxels promised, " +
                     std::to_string(present) + " found",
                   copyAgain);
  }
}

void
requireNumbers(const std::string & file, const std::string & what, std::string text)
{
  std::replace_if(
    text.begin(), text.end(), [](char c) { return c == '(' || c == ')' || c == ','; }, ' ');
  for (const std::string & word : wordsOf(text))
  {
    double       value = 0.0;
    const char * begin = word.data() + (word[0] == '+' ? 1 : 0);
    const auto [end, error] = std::from_chars(begin, word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value) || std::abs(value) > 1e9)
    {
      throw BadInput(ErrorCode::NotHexahedra,
                     file,
                     what + " holds '" + word.substr(0, 20) + "'",
                     "correct the header or export the file again");
    }
  }
}

} // namespace moserhex
