#pragma once

#include <algorithm>
#include <vector>

namespace moserhex
{

/** What SurfaceAttraction and SurfaceCoverage do with how far each of their springs is stretched. */

/** 0 when there are none. */
[[nodiscard]] inline double
largestOf(const std::vector<double> & distances)
{
  return distances.empty() ? 0.0 : *std::max_element(distances.begin(), distances.end());
}

/** Multiplies the stiffness of the springs whose distance exceeds the tolerance; returns their number. */
inline std::size_t
strengthenBeyond(double                      tolerance,
                 double                      factor,
                 const std::vector<double> & distances,
                 std::vector<double> &       stiffness)
{
  std::size_t count = 0;
  for (std::size_t spring = 0; spring < distances.size(); ++spring)
  {
    if (distances[spring] > tolerance)
    {
      stiffness[spring] *= factor;
      ++count;
    }
  }
  return count;
}

} // namespace moserhex
