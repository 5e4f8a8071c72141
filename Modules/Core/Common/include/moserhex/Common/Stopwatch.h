#pragma once

#include <chrono>

namespace moserhex
{

/** Wall time since construction. For reports only: no result may depend on it. */
class Stopwatch
{
public:
  /** Since construction [s]. */
  [[nodiscard]] double
  seconds() const
  {
    return std::chrono::duration<double>(Clock::now() - m_Start).count();
  }

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point m_Start{ Clock::now() };
};

} // namespace moserhex
