#pragma once

#include <vector>

namespace moserhex::analytic
{

/** Slope of the least-squares line through (log h, log error): the order p of error = C h^p.
 *
 * Wants at least two different h; all values positive.
 * \throws InvalidInput  sizes differ or are below two, a value is not positive, or all h are equal */
[[nodiscard]] double
observedOrder(const std::vector<double> & h, const std::vector<double> & error);

/** |value - expected| / |expected|; expected must not be zero. */
[[nodiscard]] double
relativeError(double value, double expected);

} // namespace moserhex::analytic
