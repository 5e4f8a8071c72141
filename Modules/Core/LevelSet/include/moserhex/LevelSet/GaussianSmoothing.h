#pragma once

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

} // namespace moserhex
