#include "DepthOrder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

namespace moserhex::app
{
namespace
{

/** Overlaps of a smaller part of a facet than this are rounding errors of a common edge [1]. */
constexpr double smallestOverlap = 1e-6;

double
cross(const Point2 & a, const Point2 & b)
{
  return a[0] * b[1] - a[1] * b[0];
}

/** A triangle in the picture, counter-clockwise, and its plane. */
struct Triangle2
{
  std::array<Point2, 3> corners;
  std::array<double, 3> nearness;
  double                doubleArea;

  [[nodiscard]] double
  nearnessAt(const Point2 & p) const
  {
    double sum = 0.0;
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      const Point2 & a = corners[(corner + 1) % 3];
      const Point2 & b = corners[(corner + 2) % 3];
      sum += nearness[corner] * cross(b - a, p - a);
    }
    return sum / doubleArea;
  }
};

struct Shape
{
  std::vector<Triangle2> triangles;
  Point2                 lower;
  Point2                 upper;
  double                 doubleArea{ 0.0 };
  double                 nearness{ 0.0 }; ///< mean of the corners
};

Shape
shapeOf(const SeenFacet & facet)
{
  Shape shape;
  shape.lower = shape.upper = facet.outline.front();
  for (std::size_t corner = 0; corner < facet.outline.size(); ++corner)
  {
    shape.lower = shape.lower.cwiseMin(facet.outline[corner]);
    shape.upper = shape.upper.cwiseMax(facet.outline[corner]);
    shape.nearness += facet.nearness[corner] / static_cast<double>(facet.outline.size());
  }
  for (std::size_t corner = 2; corner < facet.outline.size(); ++corner)
  {
    Triangle2 triangle{ { facet.outline[0], facet.outline[corner - 1], facet.outline[corner] },
                        { facet.nearness[0], facet.nearness[corner - 1], facet.nearness[corner] },
                        0.0 };
    triangle.doubleArea = cross(triangle.corners[1] - triangle.corners[0], triangle.corners[2] - triangle.corners[0]);
    if (triangle.doubleArea < 0.0)
    {
      std::swap(triangle.corners[1], triangle.corners[2]);
      std::swap(triangle.nearness[1], triangle.nearness[2]);
      triangle.doubleArea = -triangle.doubleArea;
    }
    if (triangle.doubleArea > 0.0)
    {
      shape.doubleArea += triangle.doubleArea;
      shape.triangles.push_back(triangle);
    }
  }
  return shape;
}

/** The part of a convex polygon on the left of the line from a to b. */
std::vector<Point2>
clipped(const std::vector<Point2> & polygon, const Point2 & a, const Point2 & b)
{
  std::vector<Point2> result;
  for (std::size_t corner = 0; corner < polygon.size(); ++corner)
  {
    const Point2 & p = polygon[corner];
    const Point2 & q = polygon[(corner + 1) % polygon.size()];
    const double   sideOfP = cross(b - a, p - a);
    const double   sideOfQ = cross(b - a, q - a);
    if (sideOfP >= 0.0)
    {
      result.push_back(p);
    }
    if ((sideOfP > 0.0 && sideOfQ < 0.0) || (sideOfP < 0.0 && sideOfQ > 0.0))
    {
      result.emplace_back(p + sideOfP / (sideOfP - sideOfQ) * (q - p));
    }
  }
  return result;
}

/** Where two triangles overlap: twice the area, and the integral of how much nearer the first is. */
struct Overlap
{
  double doubleArea{ 0.0 };
  double nearer{ 0.0 };
};

void
addOverlap(const Triangle2 & first, const Triangle2 & second, Overlap & overlap)
{
  std::vector<Point2> common(first.corners.begin(), first.corners.end());
  for (std::size_t corner = 0; corner < 3 && !common.empty(); ++corner)
  {
    common = clipped(common, second.corners[corner], second.corners[(corner + 1) % 3]);
  }
  for (std::size_t corner = 2; corner < common.size(); ++corner)
  {
    const double area = cross(common[corner - 1] - common[0], common[corner] - common[0]);
    const Point2 middle = (common[0] + common[corner - 1] + common[corner]) / 3.0;
    overlap.doubleArea += area;
    overlap.nearer += area * (first.nearnessAt(middle) - second.nearnessAt(middle));
  }
}

/** > 0 when the first covers the second, < 0 when the second covers the first, 0 when neither does. */
double
coverage(const Shape & first, const Shape & second)
{
  if ((first.lower.array() >= second.upper.array()).any() || (second.lower.array() >= first.upper.array()).any())
  {
    return 0.0;
  }
  Overlap overlap;
  for (const Triangle2 & a : first.triangles)
  {
    for (const Triangle2 & b : second.triangles)
    {
      addOverlap(a, b, overlap);
    }
  }
  return overlap.doubleArea > smallestOverlap * std::min(first.doubleArea, second.doubleArea) ? overlap.nearer : 0.0;
}

/** Squares over the picture and the facets whose boxes meet them. */
class Bins
{
public:
  explicit Bins(const std::vector<Shape> & shapes)
  {
    m_Lower = shapes.front().lower;
    Point2 upper = shapes.front().upper;
    for (const Shape & shape : shapes)
    {
      m_Lower = m_Lower.cwiseMin(shape.lower);
      upper = upper.cwiseMax(shape.upper);
    }
    m_PerSide = std::clamp(static_cast<int>(std::sqrt(static_cast<double>(shapes.size()))), 1, 512);
    m_Size = ((upper - m_Lower) / m_PerSide).cwiseMax(1e-9);
    m_Members.resize(static_cast<std::size_t>(m_PerSide) * static_cast<std::size_t>(m_PerSide));
    for (std::size_t number = 0; number < shapes.size(); ++number)
    {
      forEach(shapes[number], [number](std::vector<std::size_t> & members) { members.push_back(number); });
    }
  }

  /** Facets with a smaller number whose boxes may meet that of this one, ascending. */
  [[nodiscard]] std::vector<std::size_t>
  candidates(const Shape & shape, std::size_t number)
  {
    std::vector<std::size_t> found;
    forEach(shape, [number, &found](const std::vector<std::size_t> & members) {
      found.insert(found.end(), members.begin(), std::lower_bound(members.begin(), members.end(), number));
    });
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

private:
  [[nodiscard]] int
  binOf(double value, int axis) const
  {
    return std::clamp(static_cast<int>((value - m_Lower[axis]) / m_Size[axis]), 0, m_PerSide - 1);
  }

  template <typename TVisit>
  void
  forEach(const Shape & shape, const TVisit & visit)
  {
    for (int y = binOf(shape.lower[1], 1); y <= binOf(shape.upper[1], 1); ++y)
    {
      for (int x = binOf(shape.lower[0], 0); x <= binOf(shape.upper[0], 0); ++x)
      {
        visit(m_Members[static_cast<std::size_t>(x + m_PerSide * y)]);
      }
    }
  }

  Point2                                m_Lower;
  Point2                                m_Size;
  int                                   m_PerSide;
  std::vector<std::vector<std::size_t>> m_Members;
};

} // namespace

std::vector<std::size_t>
drawingOrder(const std::vector<SeenFacet> & facets)
{
  std::vector<Shape> shapes;
  std::transform(facets.begin(), facets.end(), std::back_inserter(shapes), shapeOf);
  std::vector<std::vector<std::size_t>> covering(facets.size());  // those that must come later
  std::vector<std::size_t>              behind(facets.size(), 0); // how many must come before
  if (!shapes.empty())
  {
    Bins bins(shapes);
    for (std::size_t second = 0; second < shapes.size(); ++second)
    {
      for (const std::size_t first : bins.candidates(shapes[second], second))
      {
        const double nearer = coverage(shapes[first], shapes[second]);
        if (nearer != 0.0)
        {
          covering[nearer > 0.0 ? second : first].push_back(nearer > 0.0 ? first : second);
          ++behind[nearer > 0.0 ? first : second];
        }
      }
    }
  }

  using Place = std::pair<double, std::size_t>;
  std::set<Place>          ready;   // farthest first
  std::set<Place>          waiting; // the same
  std::vector<std::size_t> order;
  for (std::size_t facet = 0; facet < facets.size(); ++facet)
  {
    (behind[facet] == 0 ? ready : waiting).emplace(shapes[facet].nearness, facet);
  }
  while (!ready.empty() || !waiting.empty())
  {
    std::set<Place> & source = ready.empty() ? waiting : ready; // waiting: facets that cover each other in a circle
    const std::size_t facet = source.begin()->second;
    source.erase(source.begin());
    order.push_back(facet);
    for (const std::size_t next : covering[facet])
    {
      const Place place(shapes[next].nearness, next);
      if (--behind[next] == 0 && waiting.erase(place) == 1)
      {
        ready.insert(place);
      }
    }
  }
  return order;
}

} // namespace moserhex::app
