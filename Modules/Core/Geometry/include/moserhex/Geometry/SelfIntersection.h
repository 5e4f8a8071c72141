#pragma once

#include "moserhex/Geometry/TriangleMesh.h"

#include <array>
#include <cstddef>
#include <vector>

namespace moserhex
{

using TriangleCorners = std::array<Vector3, 3>; ///< corners of a triangle, in any unit of length

/** Whether two triangles have a point in common. Exactly coplanar pairs are decided in their plane. No tolerance: a
 * pair that touches within round-off may be called either way. */
[[nodiscard]] bool
trianglesIntersect(const TriangleCorners & first, const TriangleCorners & second);

using TrianglePair = std::array<int, 2>; ///< numbers of two triangles, the smaller first

/** Pairs of triangles of one surface that meet outside what they share.
 *
 * Pairs without a common vertex are tested whole; pairs with one common vertex count when the side opposite to it
 * cuts the other triangle; pairs with a common side are skipped. By a tree of bounding boxes, O(nF log nF) for an even
 * mesh. \param mostPairs  the search ends with so many \return in ascending order */
[[nodiscard]] std::vector<TrianglePair>
findSelfIntersections(const TriangleMesh & surface, std::size_t mostPairs);

/** The number of all such pairs. */
[[nodiscard]] std::size_t
countSelfIntersections(const TriangleMesh & surface);

/** Number of pairs (triangle of first, triangle of second) that have a point in common; 0 means disjoint surfaces. */
[[nodiscard]] std::size_t
countIntersections(const TriangleMesh & first, const TriangleMesh & second);

/** How often a closed, outward surface winds around p: 1 inside, 0 outside, by the sum of signed solid angles over
 * 4 pi [1]. O(nF). */
[[nodiscard]] double
windingNumber(const TriangleMesh & surface, const Vector3 & p);

/** Whether `inner` lies strictly inside `outer`: no intersection, and its first vertex has winding number 1. */
[[nodiscard]] bool
isNestedInside(const TriangleMesh & inner, const TriangleMesh & outer);

} // namespace moserhex
