#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <exception>

namespace moserhex::python
{

/** Between long work, which runs without the interpreter's lock, and its caller: lets signals such as Ctrl-C through
 * and tells a callable of the progress, at most some twenty times a second. */
class Interruption
{
public:
  /** \param progress  called with the part done, in [0,1], or None. What it raises ends the work, and so does False. */
  explicit Interruption(pybind11::object progress = pybind11::none());

  /** Whether the work should go on. Takes the lock where there is something to do; on the caller's thread only. */
  [[nodiscard]] bool
  goOn(double fraction);

  /** With the lock: throws what a signal or the callable raised, if anything was. */
  void
  rethrow() const;

private:
  using Clock = std::chrono::steady_clock;

  pybind11::object   m_Progress;
  Clock::time_point  m_Last; ///< long ago: the first call is one
  std::exception_ptr m_Raised;
  bool               m_Stopped{ false };
};

} // namespace moserhex::python
