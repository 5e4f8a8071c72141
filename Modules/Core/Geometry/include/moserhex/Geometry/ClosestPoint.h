#pragma once

#include "moserhex/Geometry/TriangleMesh.h"

#include <memory>

namespace moserhex
{

/** The point of a triangle that is nearest to a given one. */
struct ClosestPointOnTriangle
{
  Vector3 point{ Vector3::Zero() };       ///< [mm]
  Vector3 barycentric{ Vector3::Zero() }; ///< weights of the corners, each >= 0, sum 1 [1]
  double  squaredDistance{ 0.0 };         ///< [mm^2]
};

/** Nearest point of the triangle abc to p, by Voronoi regions of its corners, sides and interior.
 * Degenerate triangles (segments, points) are allowed. */
[[nodiscard]] ClosestPointOnTriangle
closestPointOnTriangle(const Vector3 & p, const Vector3 & a, const Vector3 & b, const Vector3 & c);

/** The point of a surface that is nearest to a given one. */
struct ClosestPointOnSurface : ClosestPointOnTriangle
{
  int triangle{ -1 }; ///< number of the triangle that holds the point; the smallest number among equals
};

/** Answers nearest-point queries on a surface by a tree of bounding boxes: O(nF log nF) to build, O(log nF) typically
 * per query. Copies what it needs; queries are const and may run in parallel. */
class ClosestPointSearch
{
public:
  /** \throws InvalidInput when the surface has no triangle. */
  explicit ClosestPointSearch(const TriangleMesh & surface);
  ~ClosestPointSearch();
  /** What was moved from may only be assigned to or destroyed. */
  ClosestPointSearch(ClosestPointSearch &&) noexcept;
  /** What was moved from may only be assigned to or destroyed. */
  ClosestPointSearch &
  operator=(ClosestPointSearch &&) noexcept;

  /** \param guess  a triangle that may be near, which shortens the search; the answer does not depend on it. Negative:
   * none. */
  [[nodiscard]] ClosestPointOnSurface
  closest(const Vector3 & p, int guess = -1) const;

private:
  struct Implementation;
  std::unique_ptr<const Implementation> m_Implementation;
};

/** Smallest, mean and largest of a set of distances [mm]. */
struct DistanceSummary
{
  double smallest{ 0.0 }; ///< [mm]
  double mean{ 0.0 };     ///< [mm]
  double largest{ 0.0 };  ///< [mm]
};

/** Distances of `points` to the surface behind `search`; zeros when there is no point. */
[[nodiscard]] DistanceSummary
summarizeDistances(const Positions & points, const ClosestPointSearch & search);

} // namespace moserhex
