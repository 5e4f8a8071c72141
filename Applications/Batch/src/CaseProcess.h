#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace moserhex::app
{

/** What the process of a case may use. */
struct CaseLimits
{
  double seconds{ 3600.0 };   ///< of wall time; then SIGTERM, and SIGKILL two seconds later
  double mebibytes{ 4096.0 }; ///< of address space; 0: as much as there is
};

/** How the process of a case ended. */
struct CaseEnd
{
  int         exitStatus{ -1 };    ///< -1: by a signal
  int         signalNumber{ 0 };   ///< 0: by itself
  bool        wasTooSlow{ false }; ///< it was ended for its time limit
  bool        wasStopped{ false }; ///< it was ended because the run was
  double      seconds{ 0.0 };      ///< of wall time
  double      peakMebibytes{ 0.0 };
  std::string lastWords; ///< the end of its standard error output
};

/** A program that works on one case, in a process group of its own. It is killed when this process ends, however that
 * happens. */
class CaseProcess
{
public:
  using Clock = std::chrono::steady_clock;

  /** Starts the program with an empty standard input and its standard output thrown away.
   * \param command  the program's path, then its arguments
   * \throws IOError  it cannot be started */
  CaseProcess(const std::vector<std::string> & command, const CaseLimits & limits);
  ~CaseProcess();
  CaseProcess(const CaseProcess &) = delete;
  CaseProcess &
  operator=(const CaseProcess &) = delete;

  /** Takes what the process has said, ends it where its time is over, and tells how it ended once it did. */
  [[nodiscard]] std::optional<CaseEnd>
  poll();

  /** Asks it to end, as a time limit does. */
  void
  stop();

  /** To wait on: readable when the process says something or ends; -1 when it has closed it. */
  [[nodiscard]] int
  messages() const
  {
    return m_Messages;
  }

  /** When poll() has something to do at the latest. */
  [[nodiscard]] Clock::time_point
  nextDeadline() const;

  [[nodiscard]] pid_t
  id() const
  {
    return m_Id;
  }

private:
  void
  readMessages();
  void
  endWhereTimeIsOver();
  void
  signalGroup(int signalNumber) const;

  pid_t                            m_Id{ -1 };
  int                              m_Messages{ -1 };
  CaseLimits                       m_Limits;
  Clock::time_point                m_Start{ Clock::now() };
  std::optional<Clock::time_point> m_Terminated;
  bool                             m_Killed{ false };
  CaseEnd                          m_End;
};

} // namespace moserhex::app
