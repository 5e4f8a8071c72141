#pragma once

#include "moserhex/Common/StepReport.h"
#include "moserhex/Geometry/TriangleTopology.h"

#include <memory>

namespace moserhex
{

/** Options of AreaBarrier::minimise. */
struct AreaBarrierOptions
{
  double shapeWeight{ 1e-3 };     ///< eps of the energy that is minimised at the end [1]
  double startShapeWeight{ 0.1 }; ///< the continuation starts here and divides by ten [1]
  double stepTolerance{ 1e-6 };   ///< converged: rms over vertices of the last Newton step [rad]
  double stopAtRms{ 0.0 };        ///< when > 0: stop as soon as the area ratio rms is below (coarse levels only) [1]
  int    maximumSteps{ 200 };     ///< factorisations
};

/** What AreaBarrier::minimise found. */
struct AreaBarrierResult
{
  Positions  positions;           ///< nV, |s| = 1, no flipped triangle
  double     areaRatioRms{ 0.0 }; ///< over triangles [1]
  StepReport report;              ///< steps: factorisations; residual: rms length of the last Newton step [rad]
};

/** Moves the vertices of a triangulation of the sphere so that triangle f takes the solid angle T_f:
 *
 *   E(s) = sum_f T_f (r_f + 1/r_f - 2) / 2 + (eps/2) sum_ij w_ij (2 tan(angle_ij / 2))^2,      r_f = Omega_f(s) / T_f
 *
 * The first term is infinite at r = 0, so a map that starts without flips keeps none. The second decides the shape
 * where areas do not: for short edges it is the Dirichlet energy (eps/2) sum w |s_i - s_j|^2 of the map with the
 * weights of the surface, and it is infinite for an edge of half a great circle, where solid angles are not defined.
 * The minimiser at a fixed eps depends on the surface only, not on the start: the map forgets the triangle removed in
 * the conformal stage.
 *
 * Minimised by Gauss-Newton steps with eps going down tenfold, then by Newton steps with all second derivatives and a
 * Levenberg term, to quadratic convergence. */
class AreaBarrier
{
public:
  /** \param targets  T, sum 4 pi, positive                                                          nF [sr]
   *  \param edgeWeights  w, positive, in the order of topology.edges                               nE [1] */
  AreaBarrier(const std::vector<Triangle> & triangles,
              const TriangleTopology &      topology,
              const std::vector<double> &   targets,
              const std::vector<double> &   edgeWeights);
  ~AreaBarrier();

  /** E; infinity when a triangle is flipped. \throws InvalidInput when the sizes differ */
  [[nodiscard]] double
  energy(const Positions & sphere, double shapeWeight) const;

  /** \throws InvalidInput  the start has flipped triangles, or sizes differ
   *  \throws Cancelled
   *  Does not throw when it stops early: report.converged is false. */
  [[nodiscard]] AreaBarrierResult
  minimise(const Positions & start, const AreaBarrierOptions & options = {}, const ProgressCallback & progress = {});

private:
  struct Implementation;
  std::unique_ptr<Implementation> m_Implementation;
};

} // namespace moserhex
