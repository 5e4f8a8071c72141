#pragma once

#include <cstdint>

namespace moserhex
{

/** SplitMix64: small, seeded, the same numbers with every compiler (the standard distributions are not).
 * For tests, phantoms and tie-breaking; not for cryptography. */
class Random
{
public:
  /** \param seed  any; the same seed gives the same numbers */
  explicit Random(std::uint64_t seed) : m_State(seed)
  {}

  /** Uniform over all 64-bit numbers. */
  [[nodiscard]] std::uint64_t
  next()
  {
    m_State += 0x9E3779B97F4A7C15ULL;
    std::uint64_t z = m_State;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31);
  }

  /** Uniform in [0, 1). */
  [[nodiscard]] double
  uniform()
  {
    return static_cast<double>(next() >> 11) * 0x1.0p-53;
  }

  /** Uniform in [low, high). */
  [[nodiscard]] double
  uniform(double low, double high)
  {
    return low + (high - low) * uniform();
  }

private:
  std::uint64_t m_State;
};

} // namespace moserhex
