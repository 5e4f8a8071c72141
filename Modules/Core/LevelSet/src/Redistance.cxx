#include "moserhex/Common/Errors.h"
#include "moserhex/LevelSet/CubicInterpolation.h"
#include "moserhex/LevelSet/SignedDistance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace moserhex
{
namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();

/** Where f changes sign between a node and its six neighbours. */
struct Crossings
{
  bool    any{ false };
  Vector3 nearest{ Vector3::Constant(infinity) }; ///< signed distance to the crossing along each axis [nodes]
};

Crossings
crossingsAround(const LevelSet & f, const RegularGrid::Index & index)
{
  const RegularGrid & grid = f.grid;
  const std::size_t   node = grid.nodeNumber(index[0], index[1], index[2]);
  const double        value = f.values[node];
  Crossings           result;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const int side : { -1, 1 })
    {
      RegularGrid::Index other = index;
      auto &             coordinate = other[static_cast<std::size_t>(axis)];
      coordinate += side;
      if (coordinate < 0 || coordinate >= grid.size[static_cast<std::size_t>(axis)])
      {
        continue;
      }
      const double neighbour = f.values[grid.nodeNumber(other[0], other[1], other[2])];
      if ((neighbour < 0.0) != (value < 0.0))
      {
        const double s = value / (value - neighbour);
        result.any = true;
        if (s < std::abs(result.nearest[axis]))
        {
          result.nearest[axis] = side * s;
        }
      }
    }
  }
  return result;
}

/** Foot of the perpendicular from the node to the plane through the crossings, relative to the node [nodes]. */
Vector3
footOnPlane(const Crossings & crossings)
{
  Vector3 normal = Vector3::Zero();
  for (int axis = 0; axis < 3; ++axis)
  {
    const double s = crossings.nearest[axis];
    if (s == 0.0)
    {
      return Vector3::Zero();
    }
    normal[axis] = std::isfinite(s) ? 1.0 / s : 0.0;
  }
  return normal / normal.squaredNorm();
}

/** Nearest point of {f = 0} to x, from a guess: steps along the gradient to the surface and along the surface towards
 * x. Returns the guess when they do not settle or lead away. */
Vector3
nearestPointOnSurface(const CubicInterpolator & f, const Vector3 & x, const Vector3 & guess)
{
  constexpr int iterations = 12;
  const double  spacing = f.grid().spacing;
  const double  farthest = 1.5 * (guess - x).norm() + spacing;
  Vector3       p = guess;
  for (int iteration = 0; iteration < iterations; ++iteration)
  {
    const ValueAndGradient at = f.at(p);
    const double           squaredSlope = at.gradient.squaredNorm();
    if (!(squaredSlope > 0.0))
    {
      return guess;
    }
    const Vector3 offset = x - p;
    const Vector3 step = offset - ((at.value + offset.dot(at.gradient)) / squaredSlope) * at.gradient;
    p += step;
    if ((p - x).norm() > farthest)
    {
      return guess;
    }
    if (step.norm() < 1e-3 * spacing)
    {
      return p;
    }
  }
  return guess;
}

/** Nearest points of the surface as they spread over the grid, in grid coordinates. */
struct NearestPoints
{
  Positions           point;           ///< [nodes]
  std::vector<double> squaredDistance; ///< [nodes^2]
};

NearestPoints
pointsNearTheSurface(const CubicInterpolator & interpolator, const LevelSet & f)
{
  const RegularGrid & grid = f.grid;
  NearestPoints       nearest{ Positions(grid.nodeCount(), Vector3::Zero()),
                         std::vector<double>(grid.nodeCount(), infinity) };
  bool                any = false;
  for (int k = 0; k < grid.size[2]; ++k)
  {
    for (int j = 0; j < grid.size[1]; ++j)
    {
      for (int i = 0; i < grid.size[0]; ++i)
      {
        const Crossings crossings = crossingsAround(f, { { i, j, k } });
        if (!crossings.any)
        {
          continue;
        }
        any = true;
        const std::size_t node = grid.nodeNumber(i, j, k);
        const Vector3     x = grid.point(i, j, k);
        const Vector3     onPlane = x + grid.direction * (grid.spacing * footOnPlane(crossings));
        nearest.point[node] = grid.continuousIndex(nearestPointOnSurface(interpolator, x, onPlane));
        nearest.squaredDistance[node] = (nearest.point[node] - Vector3(i, j, k)).squaredNorm();
      }
    }
  }
  if (!any)
  {
    throw InvalidInput("redistance: the function has no node inside or no node outside");
  }
  return nearest;
}

/** One Gauss-Seidel sweep in the direction given by three signs: nodes take over the points of the seven neighbours
 * that lie behind (edges and corners too: along the axes alone the points handed on can be two spacings off). */
void
sweep(const RegularGrid & grid, const std::array<int, 3> & direction, NearestPoints & nearest)
{
  const auto position = [&](int step, std::size_t axis) {
    return direction[axis] > 0 ? step : grid.size[axis] - 1 - step;
  };
  std::array<std::ptrdiff_t, 8> behind{};
  for (int m = 1; m < 8; ++m)
  {
    behind[static_cast<std::size_t>(m)] =
      -grid.stride((m & 1) * direction[0], (m >> 1 & 1) * direction[1], (m >> 2) * direction[2]);
  }
  for (int c = 0; c < grid.size[2]; ++c)
  {
    for (int b = 0; b < grid.size[1]; ++b)
    {
      for (int a = 0; a < grid.size[0]; ++a)
      {
        const int         i = position(a, 0);
        const int         j = position(b, 1);
        const int         k = position(c, 2);
        const std::size_t node = grid.nodeNumber(i, j, k);
        const Vector3     x(i, j, k);
        const int         exists = (a > 0 ? 1 : 0) | (b > 0 ? 2 : 0) | (c > 0 ? 4 : 0);
        double            smallest = nearest.squaredDistance[node];
        for (int m = 1; m < 8; ++m)
        {
          const std::size_t neighbour = node + static_cast<std::size_t>(behind[static_cast<std::size_t>(m)]);
          if ((m & exists) != m || nearest.squaredDistance[neighbour] == infinity)
          {
            continue;
          }
          const double squared = (nearest.point[neighbour] - x).squaredNorm();
          if (squared < smallest)
          {
            smallest = squared;
            nearest.point[node] = nearest.point[neighbour];
          }
        }
        nearest.squaredDistance[node] = smallest;
      }
    }
  }
}

void
sweepAllDirections(const RegularGrid & grid, NearestPoints & nearest)
{
  for (const int k : { 1, -1 })
  {
    for (const int j : { 1, -1 })
    {
      for (const int i : { 1, -1 })
      {
        sweep(grid, { { i, j, k } }, nearest);
      }
    }
  }
}

/** Nodes share the points of their neighbours after the sweeps; close to the surface, where that matters, each gets its
 * own. */
void
refineNearTheSurface(const CubicInterpolator & interpolator, NearestPoints & nearest)
{
  const RegularGrid & grid = interpolator.grid();
  constexpr double    bandInNodes = 4.0;
  for (std::size_t node = 0; node < nearest.point.size(); ++node)
  {
    if (nearest.squaredDistance[node] < bandInNodes * bandInNodes)
    {
      const RegularGrid::Index index = grid.indexOf(node);
      const Vector3            guess = grid.origin + grid.direction * (grid.spacing * nearest.point[node]);
      const Vector3            p = nearestPointOnSurface(interpolator, grid.point(node), guess);
      const Vector3            point = grid.continuousIndex(p);
      const double             squared = (point - Vector3(index[0], index[1], index[2])).squaredNorm();
      if (squared < nearest.squaredDistance[node])
      {
        nearest.squaredDistance[node] = squared;
        nearest.point[node] = point;
      }
    }
  }
}

} // namespace

LevelSet
redistance(const LevelSet & f)
{
  requireValid(f, "redistance");
  if (std::find(f.values.begin(), f.values.end(), infinity) != f.values.end())
  {
    throw InvalidInput("redistance: a value is not finite");
  }
  const CubicInterpolator interpolator(f);
  NearestPoints           nearest = pointsNearTheSurface(interpolator, f);
  sweepAllDirections(f.grid, nearest);
  refineNearTheSurface(interpolator, nearest);
  sweepAllDirections(f.grid, nearest);
  const double smallest = 1e-6 * f.grid.spacing; // the sign must survive
  LevelSet     result{ f.grid, std::vector<double>(f.values.size()) };
  for (std::size_t node = 0; node < f.values.size(); ++node)
  {
    const double distance = std::max(f.grid.spacing * std::sqrt(nearest.squaredDistance[node]), smallest);
    result.values[node] = f.values[node] < 0.0 ? -distance : distance;
  }
  return result;
}

} // namespace moserhex
