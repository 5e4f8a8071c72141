#pragma once

#include <optional>
#include <vector>

namespace moserhex
{

/** Distribution of a measure over a region, by volume or area. */
struct WeightedDistribution
{
  double weight{ 0.0 };  ///< of the region: sum of the weights
  double mean{ 0.0 };    ///< sum w v / sum w
  double minimum{ 0.0 }; ///< of the values with weight
  double p05{ 0.0 };     ///< 5 % quantile
  double median{ 0.0 };  ///< 50 % quantile
  double p95{ 0.0 };     ///< 95 % quantile
  double maximum{ 0.0 }; ///< of the values with weight
};

/** Mean = sum w v / sum w. A quantile q is the smallest value up to which, itself included, lies at least the part q of
 * the weight: a value that occurs, never one between two. Values without weight do not count. Nothing when no value
 * has weight. \param weights  >= 0
 * \throws InvalidInput  sizes differ, a weight is negative or not a number, or a value that counts is not finite
 * \note O(n log n). Deterministic. */
[[nodiscard]] std::optional<WeightedDistribution>
weightedDistribution(const std::vector<double> & values, const std::vector<double> & weights);

} // namespace moserhex
