#include "moserhex/Analytic/ObservedOrder.h"

#include "moserhex/Common/Errors.h"

#include <cmath>

namespace moserhex::analytic
{

double
observedOrder(const std::vector<double> & h, const std::vector<double> & error)
{
  if (h.size() != error.size() || h.size() < 2)
  {
    throw InvalidInput("observedOrder: " + std::to_string(h.size()) + " sizes and " + std::to_string(error.size()) +
                       " errors; need as many of both, at least 2");
  }
  double meanX = 0.0;
  double meanY = 0.0;
  for (std::size_t i = 0; i < h.size(); ++i)
  {
    if (!(h[i] > 0.0) || !(error[i] > 0.0))
    {
      throw InvalidInput("observedOrder: entry " + std::to_string(i) + " is not positive");
    }
    meanX += std::log(h[i]);
    meanY += std::log(error[i]);
  }
  meanX /= static_cast<double>(h.size());
  meanY /= static_cast<double>(h.size());
  double covariance = 0.0;
  double variance = 0.0;
  for (std::size_t i = 0; i < h.size(); ++i)
  {
    const double x = std::log(h[i]) - meanX;
    covariance += x * (std::log(error[i]) - meanY);
    variance += x * x;
  }
  if (!(variance > 0.0))
  {
    throw InvalidInput("observedOrder: all h are equal");
  }
  return covariance / variance;
}

double
relativeError(double value, double expected)
{
  return std::abs(value - expected) / std::abs(expected);
}

} // namespace moserhex::analytic
