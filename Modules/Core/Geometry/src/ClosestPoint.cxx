#include "moserhex/Geometry/ClosestPoint.h"

#include "TriangleBoxTree.h"
#include "moserhex/Common/Errors.h"

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace moserhex
{
namespace
{

/** Parameter in [0,1] of the point of the segment ab nearest to p; 0 for a segment of no length. */
double
closestParameterOnSegment(const Vector3 & p, const Vector3 & a, const Vector3 & b)
{
  const Vector3 ab = b - a;
  const double  squaredLength = ab.squaredNorm();
  if (!(squaredLength > 0.0))
  {
    return 0.0;
  }
  return std::min(1.0, std::max(0.0, (p - a).dot(ab) / squaredLength));
}

} // namespace

ClosestPointOnTriangle
closestPointOnTriangle(const Vector3 & p, const Vector3 & a, const Vector3 & b, const Vector3 & c)
{
  ClosestPointOnTriangle result;
  const Vector3          ab = b - a;
  const Vector3          ac = c - a;
  const Vector3          normal = ab.cross(ac);
  const double           squaredNormal = normal.squaredNorm();
  if (squaredNormal > 0.0)
  {
    // Barycentric coordinates of the foot of the perpendicular.
    const Vector3 ap = p - a;
    const double  v = ap.cross(ac).dot(normal) / squaredNormal;
    const double  w = ab.cross(ap).dot(normal) / squaredNormal;
    if (v >= 0.0 && w >= 0.0 && v + w <= 1.0)
    {
      result.barycentric = { 1.0 - v - w, v, w };
      result.point = a + v * ab + w * ac;
      const double height = ap.dot(normal);
      result.squaredDistance = height * height / squaredNormal;
      return result;
    }
  }
  // The foot lies outside: the nearest point is on a side.
  const std::array<Vector3, 3> corners{ a, b, c };
  result.squaredDistance = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k)
  {
    const int     next = (k + 1) % 3;
    const double  t = closestParameterOnSegment(p, corners[k], corners[next]);
    const Vector3 q = corners[k] + t * (corners[next] - corners[k]);
    const double  squaredDistance = (p - q).squaredNorm();
    if (squaredDistance < result.squaredDistance)
    {
      result.squaredDistance = squaredDistance;
      result.point = q;
      result.barycentric.setZero();
      result.barycentric[k] = 1.0 - t;
      result.barycentric[next] = t;
    }
  }
  return result;
}

struct ClosestPointSearch::Implementation
{
  TriangleBoxTree tree;
};

ClosestPointSearch::ClosestPointSearch(const TriangleMesh & surface)
{
  if (surface.triangles.empty())
  {
    throw InvalidInput("closest-point search: the surface has 0 triangles, need at least 1");
  }
  m_Implementation = std::make_unique<const Implementation>(Implementation{ TriangleBoxTree(surface) });
}

ClosestPointSearch::~ClosestPointSearch() = default;
ClosestPointSearch::ClosestPointSearch(ClosestPointSearch &&) noexcept = default;
ClosestPointSearch &
ClosestPointSearch::operator=(ClosestPointSearch &&) noexcept = default;

ClosestPointOnSurface
ClosestPointSearch::closest(const Vector3 & p, int guess) const
{
  const TriangleBoxTree & tree = m_Implementation->tree;
  const auto &            nodes = tree.nodes();
  ClosestPointOnSurface   best;
  best.squaredDistance = std::numeric_limits<double>::infinity();
  const auto look = [&](int triangle) {
    const auto &                 corners = tree.corners(triangle);
    const ClosestPointOnTriangle candidate = closestPointOnTriangle(p, corners[0], corners[1], corners[2]);
    if (candidate.squaredDistance < best.squaredDistance ||
        (candidate.squaredDistance == best.squaredDistance && triangle < best.triangle))
    {
      static_cast<ClosestPointOnTriangle &>(best) = candidate;
      best.triangle = triangle;
    }
  };
  if (guess >= 0)
  {
    look(guess);
  }

  // Depth first, nearer child first. Median splits keep the depth below 1 + log2(nF), so 64 entries suffice.
  std::array<std::pair<double, int>, 64> stack;
  int                                    size = 0;
  stack[size++] = { nodes[0].box.squaredDistance(p), 0 };
  while (size > 0)
  {
    const auto [bound, number] = stack[--size];
    if (bound > best.squaredDistance)
    {
      continue;
    }
    const TriangleBoxTree::Node & node = nodes[number];
    if (!node.isLeaf())
    {
      const double left = nodes[node.first].box.squaredDistance(p);
      const double right = nodes[node.first + 1].box.squaredDistance(p);
      const bool   leftIsNearer = left <= right;
      stack[size++] = leftIsNearer ? std::make_pair(right, node.first + 1) : std::make_pair(left, node.first);
      stack[size++] = leftIsNearer ? std::make_pair(left, node.first) : std::make_pair(right, node.first + 1);
      continue;
    }
    for (int i = node.first; i < node.first + node.count; ++i)
    {
      look(tree.order()[i]);
    }
  }
  return best;
}

DistanceSummary
summarizeDistances(const Positions & points, const ClosestPointSearch & search)
{
  DistanceSummary summary;
  if (points.empty())
  {
    return summary;
  }
  summary.smallest = std::numeric_limits<double>::infinity();
  for (const Vector3 & p : points)
  {
    const double distance = std::sqrt(search.closest(p).squaredDistance);
    summary.smallest = std::min(summary.smallest, distance);
    summary.largest = std::max(summary.largest, distance);
    summary.mean += distance;
  }
  summary.mean /= static_cast<double>(points.size());
  return summary;
}

} // namespace moserhex
