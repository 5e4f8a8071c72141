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

} // namespace moserhex
