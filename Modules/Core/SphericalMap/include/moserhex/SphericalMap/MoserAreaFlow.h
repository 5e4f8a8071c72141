#pragma once

#include "moserhex/Common/StepReport.h"
#include "moserhex/Geometry/TriangleMesh.h"

namespace moserhex
{

/** Options of moserAreaFlow and moserAreaFlowPass. */
struct MoserAreaFlowOptions
{
  double tolerance{ 0.01 };   ///< stop when the area ratio rms over triangles is below this [1]
  int    maximumPasses{ 40 }; ///< the flow is repeated with the density measured again
  int    stepsPerPass{ 8 };   ///< Runge-Kutta steps over t in [0,1]; doubled when a pass has to stop early
  bool   localBrake{ true }; ///< vertices of flipped triangles go half-way back; false: the pass stops, as in the paper
  double relativeFloor{ 1e-3 }; ///< see targetSolidAngles
};

/** What moserAreaFlow and moserAreaFlowPass made. */
struct MoserAreaFlowResult
{
  Positions  positions; ///< never with more flipped triangles than the start
  StepReport report;    ///< steps: passes; residual: area ratio rms over triangles [1]
};

/** One pass of the flow, for a given density: moves every vertex along
 *
 *   Lap theta = 1 - mu,   Y_t = -grad theta / ((1-t) mu + t),   dw/dt = Y_t(w),   t in [0,1]        (the paper)
 *
 * so that w pushes the measure mu dA to the uniform one: det Dw = mu. Finite elements on the triangulated sphere,
 * classical Runge-Kutta through the field of the start with point location.
 *
 * \param triangles, sphere  triangulation of the unit sphere without flips
 * \param density            mu at the vertices, positive; scaled to mean 1                             nV [1]
 * \throws InvalidInput  a density is not positive, or the sphere has flipped triangles
 * \throws NotConverged  the linear system could not be solved
 * \note mu = 1 + a z gives z' = z + a (z^2 - 1) / 2. Order 1.5 (rms) in mesh size, 4 in the time step. */
[[nodiscard]] MoserAreaFlowResult
moserAreaFlowPass(const std::vector<Triangle> & triangles,
                  const Positions &             sphere,
                  const std::vector<double> &   density,
                  const MoserAreaFlowOptions &  options = {});

/** Passes with mu_i = (target / present) solid angle of vertex i, repeated until options.tolerance or no gain.
 *
 * A density at the vertices cannot see single triangles, so the rms over triangles stalls at 1 to 3 percent: this is
 * the paper's own stage, kept for comparison and as a start for AreaBarrier on long shapes.
 *
 * \throws InvalidInput  sizes differ, or the start has flipped triangles
 * \throws NotConverged  a linear system could not be solved. A stall is not thrown: report.converged is false */
[[nodiscard]] MoserAreaFlowResult
moserAreaFlow(const TriangleMesh & surface, const Positions & sphere, const MoserAreaFlowOptions & options = {});

} // namespace moserhex
