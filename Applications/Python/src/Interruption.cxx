#include "Interruption.h"

namespace moserhex::python
{

namespace py = pybind11;

Interruption::Interruption(py::object progress) : m_Progress(std::move(progress))
{}

bool
Interruption::goOn(double fraction)
{
  constexpr std::chrono::milliseconds pause(50);
  const Clock::time_point             now = Clock::now();
  if (m_Stopped || (now - m_Last < pause && fraction < 1.0))
  {
    return !m_Stopped;
  }
  const py::gil_scoped_acquire lock;
  try
  {
    if (PyErr_CheckSignals() != 0)
    {
      throw py::error_already_set();
    }
    m_Stopped = !m_Progress.is_none() && m_Progress(fraction).is(py::bool_(false));
  }
  catch (...)
  {
    m_Raised = std::current_exception();
    m_Stopped = true;
  }
  m_Last = Clock::now();
  return !m_Stopped;
}

void
Interruption::rethrow() const
{
  if (m_Raised)
  {
    std::rethrow_exception(m_Raised);
  }
}

} // namespace moserhex::python
