#pragma once

#include "moserhex/Deformation/WeightedDistribution.h"
#include "moserhex/Geometry/ClosestPoint.h"
#include "moserhex/Geometry/TriangleMesh.h"

#include <vector>

namespace moserhex
{

struct SurfaceDistanceOptions
{
  double       spacing{ 0.5 }; ///< most between the points of a triangle along its longest side [mm]
  unsigned int threads{ 0 };   ///< as in parallelFor; the result does not depend on it
};

/** A surface prepared for distances from it and to it: every triangle is cut into k^2 equal parts, k = ceil(longest
 * side / spacing), and the middle of each stands for its area. Queries are const and may run in parallel. */
class SampledSurface
{
public:
  /** \throws InvalidInput  spacing <= 0, or no triangle \note O(nF log nF) */
  explicit SampledSurface(const TriangleMesh & surface, double spacing = SurfaceDistanceOptions{}.spacing);

  [[nodiscard]] const Positions &
  points() const
  {
    return m_Points;
  }

  /** Of every point, their sum is the area of the surface [mm^2]. */
  [[nodiscard]] const std::vector<double> &
  areas() const
  {
    return m_Areas;
  }

  [[nodiscard]] const ClosestPointSearch &
  search() const
  {
    return m_Search;
  }

private:
  void
  addParts(const Vector3 & a, const Vector3 & b, const Vector3 & c, int k);

  Positions           m_Points;
  std::vector<double> m_Areas;
  ClosestPointSearch  m_Search;
};

/** Distances of a surface from another, by area. Exact where the distance is constant; O(spacing^2) for its mean.
 * \return [mm], weight [mm^2]
 * \throws InvalidInput  as SampledSurface, or `from` has no area
 * \note O(points log nF). Deterministic. */
[[nodiscard]] WeightedDistribution
surfaceDistance(const TriangleMesh & from, const TriangleMesh & to, const SurfaceDistanceOptions & options = {});

/** The distances of both from each other, taken together. */
[[nodiscard]] WeightedDistribution
symmetricSurfaceDistance(const TriangleMesh & a, const TriangleMesh & b, const SurfaceDistanceOptions & options = {});

/** The same for prepared surfaces, for many distances from one. */
[[nodiscard]] WeightedDistribution
symmetricSurfaceDistance(const SampledSurface & a, const SampledSurface & b, unsigned int threads = 0);

} // namespace moserhex
