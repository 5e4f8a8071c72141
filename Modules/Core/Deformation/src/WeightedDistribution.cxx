#include "moserhex/Deformation/WeightedDistribution.h"

#include "moserhex/Common/Errors.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace moserhex
{
namespace
{

using Sample = std::pair<double, double>; ///< value, weight

/** Those that count, ascending. */
std::vector<Sample>
samplesOf(const std::vector<double> & values, const std::vector<double> & weights)
{
  if (values.size() != weights.size())
  {
    throw InvalidInput("weighted distribution: " + std::to_string(values.size()) + " values, " +
                       std::to_string(weights.size()) + " weights, need as many");
  }
  std::vector<Sample> samples;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    if (!(weights[i] >= 0.0) || (weights[i] > 0.0 && !std::isfinite(values[i])))
    {
      throw InvalidInput("weighted distribution: value " + std::to_string(i) +
                         " is not finite or has a weight that is not >= 0");
    }
    if (weights[i] > 0.0)
    {
      samples.emplace_back(values[i], weights[i]);
    }
  }
  std::sort(samples.begin(), samples.end());
  return samples;
}

double
quantile(const std::vector<Sample> & samples, double wanted)
{
  double sum = 0.0;
  for (const auto & [value, weight] : samples)
  {
    sum += weight;
    if (sum >= wanted)
    {
      return value;
    }
  }
  return samples.back().first; // the sum is short of the whole by rounding
}

} // namespace

std::optional<WeightedDistribution>
weightedDistribution(const std::vector<double> & values, const std::vector<double> & weights)
{
  const std::vector<Sample> samples = samplesOf(values, weights);
  if (samples.empty())
  {
    return std::nullopt;
  }
  WeightedDistribution result;
  double               moment = 0.0;
  for (const auto & [value, weight] : samples)
  {
    result.weight += weight;
    moment += weight * value;
  }
  result.mean = moment / result.weight;
  result.minimum = samples.front().first;
  result.p05 = quantile(samples, 0.05 * result.weight);
  result.median = quantile(samples, 0.5 * result.weight);
  result.p95 = quantile(samples, 0.95 * result.weight);
  result.maximum = samples.back().first;
  return result;
}

} // namespace moserhex
