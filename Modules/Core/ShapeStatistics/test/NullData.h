#pragma once

#include "TestShapes.h"

#include <algorithm>
#include <vector>

namespace moserhex::testing
{

/** Largest distance of the sample's distribution to the uniform one on (0,1], times the root of its size. */
inline double
kolmogorovSmirnov(std::vector<double> p)
{
  std::sort(p.begin(), p.end());
  const double count = static_cast<double>(p.size());
  double       largest = 0.0;
  for (std::size_t i = 0; i < p.size(); ++i)
  {
    largest = std::max({ largest, static_cast<double>(i + 1) / count - p[i], p[i] - static_cast<double>(i) / count });
  }
  return largest * std::sqrt(count);
}

/** Forty subjects that differ in size, bend and noise; those from `first` on have a bulge of 2 mm, 5 mm wide, along x.
 */
inline Eigen::MatrixXd
phantomsWithBulge(const HexMesh & shape, const Vector3 & place, Eigen::Index first, std::uint64_t seed)
{
  Random          random(seed);
  const auto      vector = [&] { return Vector3(normalNumber(random), normalNumber(random), normalNumber(random)); };
  Eigen::MatrixXd y(40, static_cast<Eigen::Index>(3 * shape.nodes.size()));
  for (Eigen::Index subject = 0; subject < 40; ++subject)
  {
    const double  size = 1.0 + 0.02 * normalNumber(random);
    const Vector3 bend = 0.5 * vector();
    for (std::size_t node = 0; node < shape.nodes.size(); ++node)
    {
      const Vector3 & p = shape.nodes[node];
      const double    bulge = subject < first ? 0.0 : 2.0 * std::exp(-(p - place).squaredNorm() / (2.0 * 25.0));
      y.block<1, 3>(subject, static_cast<Eigen::Index>(3 * node)) =
        (size * p + bend * p[2] / 20.0 + bulge * Vector3::UnitX() + 0.3 * vector()).transpose();
    }
  }
  return y;
}

} // namespace moserhex::testing
