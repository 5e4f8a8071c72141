#pragma once

#include "moserhex/Common/Types.h"

#include <algorithm>

namespace moserhex::testing
{

/** Between equally many points. */
inline double
largestDistance(const Positions & a, const Positions & b)
{
  double largest = 0.0;
  for (std::size_t v = 0; v < a.size(); ++v)
  {
    largest = std::max(largest, (a[v] - b[v]).norm());
  }
  return largest;
}

} // namespace moserhex::testing
