#pragma once

#include "moserhex/LevelSet/DensityImage.h"
#include "moserhex/LevelSet/LevelSet.h"

namespace moserhex
{

/** Separable Gaussian, weights cut at 3 sigma and normalised to sum 1; values beyond the box repeat the border.
 *
 * \param sigmaInNodes  standard deviation [nodes]; 0 leaves the values as they are
 * \throws InvalidInput  invalid level set, a value that is not finite, or sigma negative or not finite
 * \note Linear functions are reproduced away from the border (3 sigma). O(n sigma). */
void
gaussianSmoothInPlace(LevelSet & levelSet, double sigmaInNodes);

/** The same for an image: as wide along every axis, whatever the voxels' sides.
 *
 * \param sigma  standard deviation [mm]; 0 leaves the values as they are
 * \throws InvalidInput  invalid image, a value that is not finite, or sigma negative or not finite */
void
gaussianSmoothInPlace(ScalarVolume & image, double sigma);

} // namespace moserhex
