#include "moserhex/Common/StepReport.h"
#include "moserhex/Common/Errors.h"

namespace moserhex
{

void
reportProgress(const ProgressCallback & callback, double fraction)
{
  if (callback && !callback(fraction))
  {
    throw Cancelled();
  }
}

ProgressCallback
progressBetween(const ProgressCallback & callback, double from, double to)
{
  if (!callback)
  {
    return {};
  }
  return [callback, from, to](double fraction) { return callback(from + (to - from) * fraction); };
}

ProgressCallback
progressOfPart(const ProgressCallback & callback, std::size_t part, std::size_t parts)
{
  const auto count = static_cast<double>(parts);
  return progressBetween(callback, static_cast<double>(part) / count, static_cast<double>(part + 1) / count);
}

ParallelProgress::ParallelProgress(const ProgressCallback & callback, std::size_t parts)
  : m_Callback(callback), m_Parts(parts), m_Thread(std::this_thread::get_id())
{}

ProgressCallback
ParallelProgress::callback()
{
  return [this](double) { return goOn(); };
}

void
ParallelProgress::endPart()
{
  ++m_Done;
  if (!goOn())
  {
    throw Cancelled();
  }
}

bool
ParallelProgress::goOn()
{
  if (m_Callback && std::this_thread::get_id() == m_Thread && !m_Stopped &&
      !m_Callback(static_cast<double>(m_Done) / static_cast<double>(m_Parts)))
  {
    m_Stopped = true;
  }
  return !m_Stopped;
}

} // namespace moserhex
