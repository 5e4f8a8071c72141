#pragma once

#include "moserhex/Deformation/WeightedDistribution.h"
#include "moserhex/Geometry/TriangleMesh.h"

namespace moserhex
{

struct SurfaceDistanceOptions
{
  double       spacing{ 0.5 }; ///< most between the points of a triangle along its longest side [mm]
  unsigned int threads{ 0 };   ///< as in parallelFor; the result does not depend on it
};

/** Distances of a surface from another, by area: every triangle of `from` is cut into k^2 equal parts, k = ceil(longest
 * side / spacing), and the middle of each counts with its area. Exact where the distance is constant; O(spacing^2)
 * for its mean. \return [mm], weight [mm^2]
 * \throws InvalidInput  spacing <= 0, or a surface without area
 * \note O(points log nF). Deterministic. */
[[nodiscard]] WeightedDistribution
surfaceDistance(const TriangleMesh & from, const TriangleMesh & to, const SurfaceDistanceOptions & options = {});

/** The distances of both from each other, taken together. */
[[nodiscard]] WeightedDistribution
symmetricSurfaceDistance(const TriangleMesh & a, const TriangleMesh & b, const SurfaceDistanceOptions & options = {});

} // namespace moserhex
