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

} // namespace moserhex
