#include "moserhex/Numerics/GaussLegendre.h"

#include "moserhex/Common/Types.h"

#include <cmath>

namespace moserhex
{

GaussRule
gaussLegendre(int q)
{
  GaussRule rule;
  for (int i = 0; i < q; ++i)
  {
    double z = -std::cos(pi * (i + 0.75) / (q + 0.5));
    double slope = 1.0;
    for (int iteration = 0; iteration < 8; ++iteration) // quadratic from 1e-3: four are enough
    {
      double previous = 1.0;
      double value = z;
      for (int degree = 2; degree <= q; ++degree)
      {
        const double next = ((2 * degree - 1) * z * value - (degree - 1) * previous) / degree;
        previous = value;
        value = next;
      }
      slope = q * (z * value - previous) / (z * z - 1.0);
      z -= value / slope;
    }
    rule.abscissae.push_back(0.5 * (1.0 + z));
    rule.weights.push_back(1.0 / ((1.0 - z * z) * slope * slope));
  }
  return rule;
}

} // namespace moserhex
