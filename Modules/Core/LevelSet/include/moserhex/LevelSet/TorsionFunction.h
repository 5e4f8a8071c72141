#pragma once

#include "moserhex/Common/StepReport.h"
#include "moserhex/LevelSet/LevelSet.h"

namespace moserhex
{

/** Options of torsionFunction. */
struct TorsionFunctionOptions
{
  double relativeTolerance{ 1e-8 }; ///< of the residual of the linear system, Euclidean norm [1]
  int    maximumIterations{ 2000 }; ///< conjugate-gradient steps [1]
  double smallestFraction{ 0.01 };  ///< a node nearer than this to the surface counts as this far [grid edge]
};

/** What torsionFunction found. */
struct TorsionFunctionResult
{
  LevelSet   levelSet; ///< u >= 0; 0 outside the organ [mm^2]
  StepReport report;   ///< steps: conjugate-gradient steps; residual: relative, recomputed at the end [1]
};

/** Torsion function of an organ: -Lap u = 1 in {phi < 0}, u = 0 on {phi = 0}.
 *
 * Seven-point Laplacian; where an edge of the grid is cut by the surface at the fraction
 * theta = phi(inside) / (phi(inside) - phi(outside)) of its length, the boundary value 0 is used there: the symmetric
 * form of Gibou, Fedkiw, Cheng and Kang, order 2. Conjugate gradients with the diagonal as preconditioner.
 *
 * \param phi  negative inside, the border of the grid outside, at least one node inside       [mm]
 * \throws InvalidInput  invalid level set, no node inside, a border node inside, options out of range
 * \throws NotConverged  tolerance not met; carries the report
 * \note Ball of radius R: u = (R^2 - r^2) / 6. Deterministic, serial. */
[[nodiscard]] TorsionFunctionResult
torsionFunction(const LevelSet & phi, const TorsionFunctionOptions & options = {});

} // namespace moserhex
