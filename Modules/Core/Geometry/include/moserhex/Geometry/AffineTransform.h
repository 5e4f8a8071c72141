#pragma once

#include "moserhex/Common/Types.h"

namespace moserhex
{

/** x -> A x + t. */
struct AffineTransform
{
  Matrix3 matrix{ Matrix3::Identity() };  ///< A, det A > 0 [1]
  Vector3 translation{ Vector3::Zero() }; ///< t [mm]

  /** A x + t [mm]. */
  [[nodiscard]] Vector3
  operator()(const Vector3 & x) const
  {
    return matrix * x + translation;
  }

  /** R of the polar decomposition A = R S, S symmetric and positive [1]. */
  [[nodiscard]] Matrix3
  rotation() const;

  /** Of R, 0 to 180 [degree]. */
  [[nodiscard]] double
  angle() const;
};

} // namespace moserhex
