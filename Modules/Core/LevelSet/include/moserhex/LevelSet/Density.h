#pragma once

#include "moserhex/LevelSet/CubicInterpolation.h"

namespace moserhex
{

/** The density mu_M of the paper: a positive function in space.
 *
 * C1 with a Lipschitz gradient. Thread-safe. Its unit does not matter: masses are compared with each other. */
class Density
{
public:
  Density() = default;
  virtual ~Density() = default;

  /** Value > 0 and gradient in LPS directions. \param p  LPS [mm], any finite point */
  [[nodiscard]] virtual ValueAndGradient
  at(const Vector3 & p) const = 0;

  /** The value alone, cheaper. */
  [[nodiscard]] virtual double
  value(const Vector3 & p) const
  {
    return at(p).value;
  }

protected:
  ///@{
  /** For derived classes: a copy of the base alone would be no density. */
  Density(const Density &) = default;
  Density(Density &&) = default;
  Density &
  operator=(const Density &) = default;
  Density &
  operator=(Density &&) = default;
  ///@}
};

} // namespace moserhex
