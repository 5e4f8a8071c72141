#pragma once

#include "Interruption.h"
#include "moserhex/Common/Errors.h"

#include <atomic>
#include <thread>

namespace moserhex::python
{

/** For work that has no progress of its own: functions that it calls, by several threads, look here whether Ctrl-C has
 * come. */
class Watch
{
public:
  explicit Watch(Interruption & interruption) : m_Interruption(interruption), m_Thread(std::this_thread::get_id())
  {}

  /** Cheap: signals are looked for on the caller's thread only, every so many calls. \throws Cancelled */
  void
  look(unsigned int every = 1)
  {
    if (!m_Stopped && std::this_thread::get_id() == m_Thread && ++m_Calls % every == 0)
    {
      m_Stopped = !m_Interruption.goOn(0.0);
    }
    if (m_Stopped)
    {
      throw Cancelled();
    }
  }

  /** As a callback of an algorithm's progress. */
  [[nodiscard]] bool
  goOn(double fraction)
  {
    return m_Interruption.goOn(fraction);
  }

private:
  Interruption &    m_Interruption;
  std::thread::id   m_Thread;
  unsigned int      m_Calls{ 0 }; ///< on the caller's thread
  std::atomic<bool> m_Stopped{ false };
};

/** Calls work(watch) without the interpreter's lock and returns what it does; what a signal or `progress` raised
 * comes out. \param progress  as of Interruption */
template <typename TWork>
auto
unlocked(const TWork & work, pybind11::object progress = pybind11::none())
{
  Interruption interruption(std::move(progress));
  try
  {
    const pybind11::gil_scoped_release release;
    Watch                              watch(interruption);
    return work(watch);
  }
  catch (const Cancelled &)
  {
    interruption.rethrow();
    throw;
  }
}

} // namespace moserhex::python
