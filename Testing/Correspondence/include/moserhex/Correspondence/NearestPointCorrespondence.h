#pragma once

#include "moserhex/Common/StepReport.h"
#include "moserhex/Geometry/TriangleMesh.h"

#include <vector>

namespace moserhex
{

/** The subject whose root mean square distances to all others sum up to least; the first among equals.
 * \param subjects  corresponding points, aligned to each other [mm]
 * \throws InvalidInput  no subject, or other numbers of points \note O(N^2 points) */
[[nodiscard]] std::size_t
medoidOf(const std::vector<Positions> & subjects);

struct NearestPointOptions
{
  double tolerance{ 1e-3 };   ///< done when no point moves farther in a step [mm]
  int    maximumSteps{ 500 }; ///< of the alignment
};

struct NearestPointResult
{
  Positions  points; ///< on the surface, as many as were given [mm]
  StepReport report; ///< of the alignment; residual: last move of a point [mm]
};

/** The simple correspondence that others are compared with: points of one subject are brought rigidly to another's
 * surface by iterated closest points [besl1992], and each then takes the point of the surface that is nearest to it.
 *
 *   T <- argmin over rigid T of sum |T p_a - q_a|^2,   q_a the point of the surface nearest to T p_a,   T = id at first
 *
 * Nothing keeps points apart: where the surfaces differ, many may go to one place and none to another.
 *
 * \param points   of one subject, roughly aligned to the other [mm]
 * \param surface  of the other [mm]
 * \throws InvalidInput  no triangle, or as rigidAlignment \note `converged` is false when the tolerance is not met.
 * Deterministic. */
[[nodiscard]] NearestPointResult
nearestPointCorrespondence(const Positions &           points,
                           const TriangleMesh &        surface,
                           const NearestPointOptions & options = {});

} // namespace moserhex
