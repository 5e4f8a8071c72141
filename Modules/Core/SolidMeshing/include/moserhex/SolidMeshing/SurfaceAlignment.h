#pragma once

#include "moserhex/Common/StepReport.h"
#include "moserhex/Geometry/AffineTransform.h"
#include "moserhex/LevelSet/LevelSet.h"

#include <vector>

namespace moserhex
{

/** What may be done to points to bring them to a surface. */
enum class SurfaceAlignmentKind
{
  Rigid, ///< moved and turned
  Affine ///< also stretched and sheared, without a change of volume
};

/** Options of alignToSurface. */
struct SurfaceAlignmentOptions
{
  SurfaceAlignmentKind kind{ SurfaceAlignmentKind::Rigid }; ///< what may be done to the points
  int                  maximumSteps{ 100 };                 ///< of each search and scale
  double               smallestMotion{ 1e-4 };              ///< a step that moves no point farther ends the search [mm]
};

/** What alignToSurface found. */
struct SurfaceAlignmentResult
{
  AffineTransform motion;             ///< takes the points to the surface
  double          shift{ 0.0 };       ///< of the points' middle [mm]
  double          rmsBefore{ 0.0 };   ///< of the points to the surface as they were given [mm]
  double          rmsAfter{ 0.0 };    ///< [mm]
  double          medianAfter{ 0.0 }; ///< of the distances' amounts [mm]
  StepReport      report;             ///< residual = rmsAfter
};

/** The motion that brings points of one surface nearest to another,
 *
 *   min over A, t of sum of s^2 log(1 + d(A p + t)^2 / s^2),     d = phi in phi's grid, beyond it phi at its border +
 * the way there
 *
 * A a rotation (Rigid) or any matrix of determinant 1 (Affine: give points of a solid of the same volume; free to
 * shrink, robust points may do best on one side of the surface), by Levenberg-Marquardt steps about the points' middle
 * on reweighted squares. With the scale s = 1.5 times the median of |d|, at least 0.05 mm, a part of one solid that the
 * other lacks has little influence (Cauchy's weights; Holland and Welsch, Comm. Statist. A6 (1977) 813). Starts: the
 * points as they are, their middle on the solid's, and the rigid motions of least squares from these; the best end
 * counts. A turn that the shapes do not determine, of balls for example, stays what it is at the start; so do the three
 * numbers that maps of ellipsoids onto each other leave open to an affine map.
 *
 * \param points  on a surface, at least three
 * \param phi     negative inside the solid
 * \throws InvalidInput  too few points, or not finite; no solid \note Deterministic. O(points) a step */
[[nodiscard]] SurfaceAlignmentResult
alignToSurface(const Positions & points, const LevelSet & phi, const SurfaceAlignmentOptions & options = {});

/** The distances d of alignToSurface. \param points  any \return negative inside [mm]
 * \throws InvalidInput  a point is not finite */
[[nodiscard]] std::vector<double>
signedDistancesToSurface(const Positions & points, const LevelSet & phi);

} // namespace moserhex
