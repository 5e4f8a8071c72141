#pragma once

#include "moserhex/Common/StepReport.h"
#include "moserhex/Geometry/HexMesh.h"
#include "moserhex/HexMap/CellMeasure.h"
#include "moserhex/HexMap/SignedDistance.h"

#include <vector>

namespace moserhex
{

/** Options of projectOntoEqualMeasure. */
struct EqualMeasureOptions
{
  double       tolerance{ 1e-24 };        ///< done when mean (measure / target - 1)^2 is below [1]
  int          maximumSteps{ 12 };        ///< of Newton's method
  int          maximumSolverSteps{ 400 }; ///< of conjugate gradients within one Newton step
  double       normalMotion{ 0.3 };       ///< in (0,1]: how freely boundary nodes move along the normal [1]
  double       shift{ 0.1 };              ///< of the lattice Laplacian: > 0 [1]
  unsigned int threads{ 0 };              ///< 0: all; the result does not depend on it
};

/** One step of Newton's method. */
struct EqualMeasureStep
{
  double deviation{ 0.0 }; ///< mean (measure / target - 1)^2 before the step [1]
  int    solverSteps{ 0 }; ///< conjugate-gradient steps
  double fraction{ 1.0 };  ///< of the Newton step that was taken [1]
};

/** What projectOntoEqualMeasure made. */
struct EqualMeasureResult
{
  HexMesh     mesh; ///< the last one; that of the smallest deviation where the tolerance was not met [mm]
  std::size_t nonPositiveCorners{ 0 };  ///< corners of the mesh's cells with det J <= 0
  std::vector<EqualMeasureStep> steps;  ///< of Newton's method, in order
  StepReport                    report; ///< residual: mean (measure / target - 1)^2 of the mesh returned
};

/** Newton's method for "every cell has the measure m*", by the smoothest displacement.
 *
 *   A dx = m* - m(x),   A = dm/dx,    dx = M A^T y,   A M A^T y = m* - m,   M = S (L + sigma)^-1 S
 *
 * L is the graph Laplacian of the node lattice with natural boundary (cosine transforms), S damps the motion of
 * boundary nodes along the surface's normal. The least displacement (M = 1) spoils the shape of the cells and throws
 * nodes off the surface; the smoothest one keeps both. A M A^T has order zero; conjugate gradients are preconditioned
 * by what it is on a uniform lattice,
 *
 *   symbol(a,b,c) = (D_a M_b M_c + M_a D_b M_c + M_a M_b D_c) / (D_a + D_b + D_c + sigma)
 *   D = 2 - 2 cos t,  M = (1 + cos t) / 2,  t = pi (a + 1) / n          (sine transforms)
 *
 * A step that would make more corners of cells non-positive is halved, twice at most, and then taken all the same:
 * equal measures come first here. `nonPositiveCorners` counts them in the mesh returned, and the note says so when they
 * are more than in the mesh given; a caller that cannot use such a mesh makes the cells more equal before
 * (VolumeEqualisation.h).
 *
 * \param target  m* > 0, the same for all cells                                  [unit of the measure]
 * \param phi     of the organ's surface, for its normals [mm]
 * \throws InvalidInput  no n^3 finite nodes, target or an option out of range, no phi
 * \throws Cancelled     by the callback
 * \note Converges quadratically. `converged` is false, and the mesh with the smallest deviation is returned, when the
 * tolerance is not met; the note says so. Deterministic for any number of threads. */
[[nodiscard]] EqualMeasureResult
projectOntoEqualMeasure(const HexMesh &             mesh,
                        const CellMeasure &         measure,
                        double                      target,
                        const SignedDistance &      phi,
                        const EqualMeasureOptions & options = {},
                        const ProgressCallback &    progress = {});

} // namespace moserhex
