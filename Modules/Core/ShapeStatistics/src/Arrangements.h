#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace moserhex
{

/** Orders of the subjects: entry s of an order is the subject whose design stands at subject s. */
struct Arrangements
{
  std::vector<std::vector<std::uint16_t>> orders;          ///< the first is the subjects' own
  bool                                    areAll{ false }; ///< all different ones
};

/** All different orders of the design's rows, when there are at most `count` + 1; else the subjects' own order and
 * `count` random ones. Rows that are equal number by number are interchangeable. \param design  N <= 65536 rows */
[[nodiscard]] Arrangements
arrangementsOf(const Eigen::MatrixXd & design, std::size_t count, std::uint64_t seed);

} // namespace moserhex
