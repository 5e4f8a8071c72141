#pragma once

#include "moserhex/Common/StepReport.h"
#include "moserhex/LevelSet/LevelSet.h"

#include <cstddef>

namespace moserhex
{

/** Options of eikonalArrival. */
struct EikonalArrivalOptions
{
  double sourceRadius{ 2.0 };        ///< nodes this near to the seed get the time of a constant speed [nodes]
  double relativeTolerance{ 1e-10 }; ///< stop when no time changed by more than this part of itself in 8 sweeps [1]
  int    maximumSweeps{ 400 };       ///< [1]
};

/** What eikonalArrival found. */
struct EikonalArrivalResult
{
  LevelSet   levelSet; ///< T: 0 at the seed, +infinity outside the organ and where the front cannot go
  StepReport report;   ///< steps: sweeps; residual: largest relative change of the last 8 sweeps [1]
};

/** Time at which a front of speed w that starts at the seed passes each node inside the organ:
 *
 *   |grad T| w = 1 in {phi < 0},   T(seed) = 0
 *
 * with lengths in nodes. Godunov's upwind scheme, Gauss-Seidel sweeps in the eight directions in turn (fast sweeping).
 * It is the limit of a Chan-Vese front without curvature.
 *
 * \param phi     negative inside                                   [mm]
 * \param weight  speed w, positive at the nodes inside             [nodes per unit of time]
 * \param seed    number of a node inside
 * \throws InvalidInput  grids differ, seed not inside, a speed inside that is not positive and finite, options
 * \throws NotConverged  tolerance not met; carries the report
 * \note Order 1 in the spacing. Deterministic, serial. */
[[nodiscard]] EikonalArrivalResult
eikonalArrival(const LevelSet &              phi,
               const LevelSet &              weight,
               std::size_t                   seed,
               const EikonalArrivalOptions & options = {});

} // namespace moserhex
