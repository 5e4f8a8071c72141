#pragma once

#include "moserhex/Common/Random.h"

#include <string>

namespace moserhex::fuzz
{

/** Changes bytes as damage and malice do: bits flipped, bytes set, parts deleted, repeated or exchanged, the end cut
 * off, numbers and words replaced by extreme ones, digits by others, lines repeated or dropped. Half of the places are
 * in the first 600 bytes, where headers are. The same seed makes the same mutants. */
class Mutator
{
public:
  explicit Mutator(std::uint64_t seed) : m_Random(seed)
  {}

  /** One change to four, mostly one. */
  [[nodiscard]] std::string
  mutant(std::string bytes);

private:
  void
  change(std::string & bytes);

  /** In [0, count); 0 when count is 0. */
  [[nodiscard]] std::size_t
  below(std::size_t count);

  [[nodiscard]] std::size_t
  place(const std::string & bytes);

  void
  replaceToken(std::string & bytes);

  void
  changeDigit(std::string & bytes);

  void
  replaceBinary(std::string & bytes);

  void
  changeLine(std::string & bytes);

  Random m_Random;
};

/** gzip: the bytes packed again, or unpacked. \throws std::runtime_error  not gzip, or too large to be a seed */
[[nodiscard]] std::string
gzipped(const std::string & bytes);
[[nodiscard]] std::string
gunzipped(const std::string & bytes);

} // namespace moserhex::fuzz
