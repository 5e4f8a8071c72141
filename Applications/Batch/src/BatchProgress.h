#pragma once

#include "moserhex/Common/ErrorCode.h"
#include "moserhex/Common/Stopwatch.h"

#include <cstddef>
#include <string>

namespace moserhex::app
{

/** How far a run has come: a bar with rate, remaining time and failures on a terminal, a line for every tenth
 * otherwise, nothing when quiet. */
class BatchProgress
{
public:
  BatchProgress(std::size_t cases, bool quiet);
  ~BatchProgress();
  BatchProgress(const BatchProgress &) = delete;
  BatchProgress &
  operator=(const BatchProgress &) = delete;

  /** \param ended  cases that came to an end, those that failed among them */
  void
  show(std::size_t ended, std::size_t failed);

  /** A line above the bar, on the standard error output. */
  void
  warn(const std::string & text);

  /** The same with a code at the line's end. */
  void
  warn(ErrorCode code, const std::string & text);

private:
  void
  clearBar();

  std::size_t m_Cases;
  bool        m_Quiet;
  bool        m_Terminal;
  std::size_t m_LastTenth{ 0 };
  Stopwatch   m_SinceStart;
  double      m_LastShown{ -1.0 };
  std::string m_Bar;
};

/** "0:00:07", "27:46:40". */
[[nodiscard]] std::string
hoursMinutesSeconds(double seconds);

} // namespace moserhex::app
