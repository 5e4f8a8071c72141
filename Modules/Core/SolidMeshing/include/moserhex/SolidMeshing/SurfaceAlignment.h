#pragma once

#include "moserhex/Common/StepReport.h"
#include "moserhex/Geometry/RigidAlignment.h"
#include "moserhex/LevelSet/LevelSet.h"

namespace moserhex
{

struct SurfaceAlignmentOptions
{
  int    maximumSteps{ 100 };
  double smallestMotion{ 1e-4 }; ///< a step that moves no point farther ends the search [mm]
};

struct SurfaceAlignmentResult
{
  SimilarityTransform motion;           ///< rigid
  double              shift{ 0.0 };     ///< of the points' middle [mm]
  double              rmsBefore{ 0.0 }; ///< of the points to the surface as they were given [mm]
  double              rmsAfter{ 0.0 };  ///< [mm]
  StepReport          report;           ///< residual = rmsAfter
};

/** The rigid motion that brings points of one surface nearest to another,
 *
 *   min over R, t of sum of d(R p + t)^2,     d = phi in phi's grid, and beyond it phi at its border + the way there
 *
 * by Levenberg-Marquardt steps in the rotation vector about the points' middle and the translation, from the points as
 * they are and from their middle on the solid's; the better end counts. A turn that the shapes do not determine, of
 * balls for example, stays what it is at the start.
 *
 * \param points  on a surface, at least three
 * \param phi     negative inside the solid
 * \throws InvalidInput  too few points, or not finite; no solid \note Deterministic. O(points) a step */
[[nodiscard]] SurfaceAlignmentResult
alignToSurface(const Positions & points, const LevelSet & phi, const SurfaceAlignmentOptions & options = {});

} // namespace moserhex
