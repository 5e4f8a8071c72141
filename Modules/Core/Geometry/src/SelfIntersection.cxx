#include "moserhex/Geometry/SelfIntersection.h"

#include "TriangleBoxTree.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace moserhex
{
namespace
{

/** Six times the signed volume of the tetrahedron abcd. */
double
orientation(const Vector3 & a, const Vector3 & b, const Vector3 & c, const Vector3 & d)
{
  return (b - a).cross(c - a).dot(d - a);
}

/** Whether the segment pq crosses or touches the triangle, the two not in one plane. */
bool
segmentMeetsTriangle(const Vector3 & p, const Vector3 & q, const TriangleCorners & t)
{
  const double atP = orientation(t[0], t[1], t[2], p);
  const double atQ = orientation(t[0], t[1], t[2], q);
  if ((atP > 0.0 && atQ > 0.0) || (atP < 0.0 && atQ < 0.0) || (atP == 0.0 && atQ == 0.0))
  {
    return false;
  }
  const double u = orientation(p, q, t[0], t[1]);
  const double v = orientation(p, q, t[1], t[2]);
  const double w = orientation(p, q, t[2], t[0]);
  return (u >= 0.0 && v >= 0.0 && w >= 0.0) || (u <= 0.0 && v <= 0.0 && w <= 0.0);
}

using Point2 = Eigen::Vector2d;

double
orientation2(const Point2 & a, const Point2 & b, const Point2 & c)
{
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

bool
onSegment(const Point2 & a, const Point2 & b, const Point2 & p)
{
  return (p - a).dot(p - b) <= 0.0;
}

bool
segmentsMeet(const Point2 & a, const Point2 & b, const Point2 & c, const Point2 & d)
{
  const double c1 = orientation2(a, b, c);
  const double d1 = orientation2(a, b, d);
  const double a1 = orientation2(c, d, a);
  const double b1 = orientation2(c, d, b);
  if (((c1 > 0.0 && d1 < 0.0) || (c1 < 0.0 && d1 > 0.0)) && ((a1 > 0.0 && b1 < 0.0) || (a1 < 0.0 && b1 > 0.0)))
  {
    return true;
  }
  return (c1 == 0.0 && onSegment(a, b, c)) || (d1 == 0.0 && onSegment(a, b, d)) || (a1 == 0.0 && onSegment(c, d, a)) ||
         (b1 == 0.0 && onSegment(c, d, b));
}

using Corners2 = std::array<Point2, 3>;

bool
contains(const Corners2 & t, const Point2 & p)
{
  const double u = orientation2(t[0], t[1], p);
  const double v = orientation2(t[1], t[2], p);
  const double w = orientation2(t[2], t[0], p);
  return (u >= 0.0 && v >= 0.0 && w >= 0.0) || (u <= 0.0 && v <= 0.0 && w <= 0.0);
}

/** Overlap of two triangles of one plane, seen along the largest component of its normal. */
bool
coplanarTrianglesIntersect(const TriangleCorners & first, const TriangleCorners & second, const Vector3 & normal)
{
  int axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  const auto flatten = [axis](const TriangleCorners & t) {
    Corners2 flat;
    for (int k = 0; k < 3; ++k)
    {
      flat[k] = { t[k][(axis + 1) % 3], t[k][(axis + 2) % 3] };
    }
    return flat;
  };
  const Corners2 a = flatten(first);
  const Corners2 b = flatten(second);
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      if (segmentsMeet(a[i], a[(i + 1) % 3], b[j], b[(j + 1) % 3]))
      {
        return true;
      }
    }
  }
  return contains(a, b[0]) || contains(b, a[0]);
}

/** Calls visit(s, t) for all pairs of triangles, s of the first and t of the second tree, whose leaf boxes overlap,
 * until it returns false. */
template <typename TVisitor>
void
forEachOverlappingPair(const TriangleBoxTree & first, const TriangleBoxTree & second, TVisitor && visit)
{
  std::vector<std::pair<int, int>> stack{ { 0, 0 } };
  while (!stack.empty())
  {
    const auto [s, t] = stack.back();
    stack.pop_back();
    const TriangleBoxTree::Node & p = first.nodes()[s];
    const TriangleBoxTree::Node & q = second.nodes()[t];
    if (!p.box.overlaps(q.box))
    {
      continue;
    }
    if (p.isLeaf() && q.isLeaf())
    {
      for (int i = p.first; i < p.first + p.count; ++i)
      {
        for (int j = q.first; j < q.first + q.count; ++j)
        {
          if (!visit(first.order()[i], second.order()[j]))
          {
            return;
          }
        }
      }
    }
    else if (q.isLeaf() || (!p.isLeaf() && (p.box.upper - p.box.lower).sum() >= (q.box.upper - q.box.lower).sum()))
    {
      stack.emplace_back(p.first, t);
      stack.emplace_back(p.first + 1, t);
    }
    else
    {
      stack.emplace_back(s, q.first);
      stack.emplace_back(s, q.first + 1);
    }
  }
}

TriangleBoxTree::Box
boxOf(const TriangleCorners & t)
{
  TriangleBoxTree::Box box;
  for (const Vector3 & p : t)
  {
    box.include(p);
  }
  return box;
}

/** Intersection of two triangles of one surface, outside what they share. */
bool
meetOutsideSharedParts(const TriangleMesh & surface, const TriangleBoxTree & tree, int s, int t)
{
  const Triangle & a = surface.triangles[s];
  const Triangle & b = surface.triangles[t];
  int              shared = 0;
  int              cornerOfA = 0;
  int              cornerOfB = 0;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      if (a[i] == b[j])
      {
        ++shared;
        cornerOfA = i;
        cornerOfB = j;
      }
    }
  }
  const TriangleCorners & p = tree.corners(s);
  const TriangleCorners & q = tree.corners(t);
  if (shared > 1 || !boxOf(p).overlaps(boxOf(q)))
  {
    return false;
  }
  if (shared == 0)
  {
    return trianglesIntersect(p, q);
  }
  return segmentMeetsTriangle(p[(cornerOfA + 1) % 3], p[(cornerOfA + 2) % 3], q) ||
         segmentMeetsTriangle(q[(cornerOfB + 1) % 3], q[(cornerOfB + 2) % 3], p);
}

} // namespace

bool
trianglesIntersect(const TriangleCorners & first, const TriangleCorners & second)
{
  bool coplanar = true;
  for (const Vector3 & p : second)
  {
    coplanar = coplanar && orientation(first[0], first[1], first[2], p) == 0.0;
  }
  if (coplanar)
  {
    return coplanarTrianglesIntersect(first, second, (first[1] - first[0]).cross(first[2] - first[0]));
  }
  for (int k = 0; k < 3; ++k)
  {
    if (segmentMeetsTriangle(first[k], first[(k + 1) % 3], second) ||
        segmentMeetsTriangle(second[k], second[(k + 1) % 3], first))
    {
      return true;
    }
  }
  return false;
}

std::vector<TrianglePair>
findSelfIntersections(const TriangleMesh & surface, std::size_t mostPairs)
{
  std::vector<TrianglePair> pairs;
  if (surface.triangles.empty())
  {
    return pairs;
  }
  const TriangleBoxTree tree(surface);
  forEachOverlappingPair(tree, tree, [&](int s, int t) {
    if (s < t && meetOutsideSharedParts(surface, tree, s, t))
    {
      pairs.push_back({ s, t });
    }
    return pairs.size() < mostPairs;
  });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::size_t
countSelfIntersections(const TriangleMesh & surface)
{
  if (surface.triangles.empty())
  {
    return 0;
  }
  const TriangleBoxTree tree(surface);
  std::size_t           count = 0;
  forEachOverlappingPair(tree, tree, [&](int s, int t) {
    count += s < t && meetOutsideSharedParts(surface, tree, s, t) ? 1 : 0;
    return true;
  });
  return count;
}

std::size_t
countIntersections(const TriangleMesh & first, const TriangleMesh & second)
{
  if (first.triangles.empty() || second.triangles.empty())
  {
    return 0;
  }
  const TriangleBoxTree tree(first);
  const TriangleBoxTree other(second);
  std::size_t           count = 0;
  forEachOverlappingPair(tree, other, [&](int s, int t) {
    const TriangleCorners & p = tree.corners(s);
    const TriangleCorners & q = other.corners(t);
    count += boxOf(p).overlaps(boxOf(q)) && trianglesIntersect(p, q) ? 1 : 0;
    return true;
  });
  return count;
}

double
windingNumber(const TriangleMesh & surface, const Vector3 & p)
{
  // Van Oosterom and Strackee: tan(omega / 2) = det(a, b, c) / (|a||b||c| + (a.b)|c| + (b.c)|a| + (c.a)|b|).
  double halfAngles = 0.0;
  for (const Triangle & t : surface.triangles)
  {
    const Vector3 a = surface.vertices[t[0]] - p;
    const Vector3 b = surface.vertices[t[1]] - p;
    const Vector3 c = surface.vertices[t[2]] - p;
    const double  la = a.norm();
    const double  lb = b.norm();
    const double  lc = c.norm();
    halfAngles += std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return halfAngles / (2 * pi);
}

bool
isNestedInside(const TriangleMesh & inner, const TriangleMesh & outer)
{
  return !inner.triangles.empty() && countIntersections(inner, outer) == 0 &&
         windingNumber(outer, inner.vertices[inner.triangles[0][0]]) > 0.5;
}

} // namespace moserhex
