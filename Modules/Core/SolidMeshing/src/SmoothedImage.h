#pragma once

#include "moserhex/LevelSet/CubicInterpolation.h"
#include "moserhex/LevelSet/DensityImage.h"

#include <memory>

namespace moserhex
{

/** An image around some points, made smooth: means over the boxes of an isotropic grid of sigma / 2, convolved with a
 * Gaussian so that the variance is sigma^2 in all; cubic splines between the nodes. Waves shorter than sigma leave at
 * most 6 % of themselves. Beyond the image the values of its border. Thread-safe. */
class SmoothedImage
{
public:
  /** \param points   what is to be covered, with a margin of 3 sigma [mm] \param sigma  > 0 [mm]
   * \throws InvalidInput  an invalid image, or a value that is not finite */
  SmoothedImage(const ScalarVolume & image, const Positions & points, double sigma);

  /** \param p  LPS [mm] \return value and gradient [unit of the image, per mm] */
  [[nodiscard]] ValueAndGradient
  at(const Vector3 & p) const;

private:
  std::unique_ptr<const LevelSet> m_Values; ///< at a place of its own: the interpolator refers to it
  CubicInterpolator               m_At;
};

} // namespace moserhex
