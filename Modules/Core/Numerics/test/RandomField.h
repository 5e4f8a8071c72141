#pragma once

#include "moserhex/Common/Random.h"

#include <Eigen/Core>

#include <cstdint>

namespace moserhex
{

/** Uniform in [-1, 1]. */
inline Eigen::VectorXd
randomField(Eigen::Index count, std::uint64_t seed)
{
  Random          random(seed);
  Eigen::VectorXd field(count);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    field[i] = random.uniform(-1.0, 1.0);
  }
  return field;
}

} // namespace moserhex
