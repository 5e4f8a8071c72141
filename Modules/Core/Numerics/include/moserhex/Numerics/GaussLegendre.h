#pragma once

#include <vector>

namespace moserhex
{

/** A rule on [0,1]: integral of f  ~  sum_i w_i f(t_i). */
struct GaussRule
{
  std::vector<double> abscissae; ///< in (0,1), ascending
  std::vector<double> weights;   ///< positive, sum 1
};

/** The Gauss-Legendre rule with q >= 1 points, exact for polynomials of degree 2 q - 1.
 *
 * Roots of the Legendre polynomial P_q by Newton's method from Tricomi's estimate; weights 1 / ((1 - z^2) P_q'(z)^2),
 * z = 2 t - 1. */
[[nodiscard]] GaussRule
gaussLegendre(int q);

} // namespace moserhex
