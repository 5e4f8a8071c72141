#pragma once

#include "moserhex/CubeTransfer/CubeSamples.h"

#include <vector>

namespace moserhex
{

/** Options of refinedMeans. */
struct RefinementOptions
{
  double       tolerance{ 1e-6 }; ///< wanted error of each integral, over the sum of its boxes' |integral| [1]
  double       mostPoints{ 1e9 }; ///< points that the function may be evaluated at, in all; the second rule is always
  unsigned int threads{ 0 };      ///< 0: all of the machine's
};

/** Means over the boxes of a cube, and how exact their integrals over the mesh are. */
struct RefinedMeans
{
  CubeMeans           means;                ///< of the boxes, as cubeMeans has them
  std::vector<double> integrals;            ///< of each component
  std::vector<double> errors;               ///< of these, as estimated, in their unit
  double              relativeError{ 0.0 }; ///< the largest error over the sum of its boxes' |integral| [1]
};

/** Means with so many Gauss points that the integral over the mesh is known to a tolerance.
 *
 *   error = max(|sum_b d_b|, 2 sqrt(sum_b d_b^2), 0.4 e),      d_b = change of box b's integral by its last rule,
 *                                                              e = the error of the round before
 *
 * Every box is evaluated by a second rule, of half as many points more along each axis; then those whose change is a
 * large part of the error by a third one, and so on, until the error is within the tolerance, or the next round would
 * need more points than allowed. The first term is that of a smooth function, whose error has one sign in many boxes;
 * the second that of an image with steps, kinks or noise, whose errors are independent and cancel in part; the third
 * keeps a change that is small by chance from ending the rounds. As d_b is the change to the last rule, which is better
 * than the one before, the estimate is on the safe side; it is no bound.
 *
 * \param first          cubeMeans(mesh, f, ..., rule)
 * \param pointsPerAxis  of that rule
 * \return the last means; the error may be above the tolerance
 * \note The same for any number of threads.
 * \throws InvalidInput  as requireLattice(mesh); a tolerance that is not positive; points out of range; means of
 *                       another number of boxes than the grid has; or what f throws */
[[nodiscard]] RefinedMeans
refinedMeans(const HexMesh &           mesh,
             const CubeFunction &      f,
             CubeMeans                 first,
             int                       pointsPerAxis,
             const RefinementOptions & options = {});

} // namespace moserhex
