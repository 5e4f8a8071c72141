#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Parallel.h"
#include "moserhex/LevelSet/CubicInterpolation.h"
#include "moserhex/LevelSet/SignedDistance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace moserhex
{
namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();

/** Nodes closer than this to the surface find their own nearest point [nodes]. */
constexpr int bandInNodes = 4;

/** Nodes that a thread takes at a time. */
constexpr std::size_t nodesPerBlock = 4096;

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

/** The nearest point of the surface that a node knows of, in grid coordinates. */
struct NearestPoint
{
  Vector3 point{ Vector3::Constant(infinity) }; ///< [nodes]; infinitely far: none yet
  double  squaredDistance{ infinity };          ///< [nodes^2]
};
using NearestPoints = std::vector<NearestPoint>;

NearestPoints
pointsNearTheSurface(const CubicInterpolator & interpolator, const LevelSet & f, unsigned int threads)
{
  const RegularGrid & grid = f.grid;
  NearestPoints       nearest(grid.nodeCount());
  parallelForBlocks(nearest.size(), nodesPerBlock, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t node = begin; node < end; ++node)
    {
      const RegularGrid::Index index = grid.indexOf(node);
      const Crossings          crossings = crossingsAround(f, index);
      if (crossings.any)
      {
        const Vector3  x = grid.point(node);
        const Vector3  onPlane = x + grid.direction * (grid.spacing * footOnPlane(crossings));
        NearestPoint & own = nearest[node];
        own.point = grid.continuousIndex(nearestPointOnSurface(interpolator, x, onPlane));
        own.squaredDistance = (own.point - Vector3(index[0], index[1], index[2])).squaredNorm();
      }
    }
  });
  if (std::all_of(nearest.begin(), nearest.end(), [](const NearestPoint & p) { return p.squaredDistance == infinity; }))
  {
    throw InvalidInput("redistance: the function has no node inside or no node outside");
  }
  return nearest;
}

/** 1 for the nodes within bandInNodes steps, along all three axes at once, of a node that has a point. */
std::vector<std::uint8_t>
nodesAround(const RegularGrid & grid, const NearestPoints & nearest)
{
  std::vector<std::uint8_t> marked(nearest.size());
  std::transform(nearest.begin(), nearest.end(), marked.begin(), [](const NearestPoint & p) {
    return static_cast<std::uint8_t>(p.squaredDistance < infinity ? 1 : 0);
  });
  const std::array<std::size_t, 3> strides{ { 1, grid.nodeNumber(0, 1, 0), grid.nodeNumber(0, 0, 1) } };
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::vector<std::uint8_t> before = marked;
    const auto                      last = static_cast<std::size_t>(grid.size[axis]) - 1;
    for (std::size_t reach = 1; reach <= std::min<std::size_t>(bandInNodes, last); ++reach)
    {
      const std::size_t slab = strides[axis] * (last + 1);
      const std::size_t shift = strides[axis] * reach;
      for (std::size_t first = 0; first < marked.size(); first += slab)
      {
        for (std::size_t node = first; node + shift < first + slab; ++node)
        {
          marked[node] |= before[node + shift];
          marked[node + shift] |= before[node];
        }
      }
    }
  }
  return marked;
}

/** The 13 neighbours with a smaller node number. Their negatives come later in the order of the numbers. */
std::array<RegularGrid::Index, 13>
precedingOffsets()
{
  std::array<RegularGrid::Index, 13> offsets{};
  for (int n = 0; n < 13; ++n)
  {
    offsets[static_cast<std::size_t>(n)] = { { n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1 } };
  }
  return offsets;
}

/** Hands points on to the chosen neighbours: one scan in the order of the node numbers and one against it. A path from
 * a node to any other is made of steps to neighbours in one cone of directions; those of the first scan come first. */
void
scanForthAndBack(const RegularGrid & grid, const std::vector<std::uint8_t> & chosen, NearestPoints & nearest)
{
  const auto                     offsets = precedingOffsets();
  std::array<std::ptrdiff_t, 13> strides{};
  std::transform(offsets.begin(), offsets.end(), strides.begin(), [&](const RegularGrid::Index & offset) {
    return grid.stride(offset[0], offset[1], offset[2]);
  });
  const auto exists = [&](int coordinate, std::size_t axis) { return coordinate >= 0 && coordinate < grid.size[axis]; };
  const auto visit = [&](std::size_t node, int i, int j, int k, int side) {
    if (chosen[node] == 0)
    {
      return;
    }
    const Vector3  x(i, j, k);
    NearestPoint & own = nearest[node];
    const auto     takeFrom = [&](std::size_t n) {
      const Vector3 & point = nearest[node + static_cast<std::size_t>(side * strides[n])].point;
      const double    squared = (point - x).squaredNorm();
      if (squared < own.squaredDistance)
      {
        own = { point, squared };
      }
    };
    const bool border = grid.isBorder(i, j, k);
    for (std::size_t n = 0; n < offsets.size(); ++n)
    {
      if (!border || (exists(i + side * offsets[n][0], 0) && exists(j + side * offsets[n][1], 1) &&
                      exists(k + side * offsets[n][2], 2)))
      {
        takeFrom(n);
      }
    }
  };
  std::size_t node = 0;
  for (int k = 0; k < grid.size[2]; ++k)
  {
    for (int j = 0; j < grid.size[1]; ++j)
    {
      for (int i = 0; i < grid.size[0]; ++i, ++node)
      {
        visit(node, i, j, k, 1);
      }
    }
  }
  for (int k = grid.size[2] - 1; k >= 0; --k)
  {
    for (int j = grid.size[1] - 1; j >= 0; --j)
    {
      for (int i = grid.size[0] - 1; i >= 0; --i)
      {
        visit(--node, i, j, k, -1);
      }
    }
  }
}

/** Nodes share the points of their neighbours after the scans; close to the surface, where that matters, each gets its
 * own. */
void
refineNearTheSurface(const CubicInterpolator & interpolator, NearestPoints & nearest, unsigned int threads)
{
  const RegularGrid & grid = interpolator.grid();
  parallelForBlocks(nearest.size(), nodesPerBlock, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t node = begin; node < end; ++node)
    {
      NearestPoint & own = nearest[node];
      if (own.squaredDistance < bandInNodes * bandInNodes)
      {
        const RegularGrid::Index index = grid.indexOf(node);
        const Vector3            guess = grid.origin + grid.direction * (grid.spacing * own.point);
        const Vector3            p = nearestPointOnSurface(interpolator, grid.point(node), guess);
        const Vector3            point = grid.continuousIndex(p);
        const double             squared = (point - Vector3(index[0], index[1], index[2])).squaredNorm();
        if (squared < own.squaredDistance)
        {
          own = { point, squared };
        }
      }
    }
  });
}

} // namespace

LevelSet
redistance(const LevelSet & f, unsigned int threads)
{
  requireValid(f, "redistance");
  if (std::find(f.values.begin(), f.values.end(), infinity) != f.values.end())
  {
    throw InvalidInput("redistance: a value is not finite");
  }
  const CubicInterpolator         interpolator(f);
  NearestPoints                   nearest = pointsNearTheSurface(interpolator, f, threads);
  const std::vector<std::uint8_t> all(nearest.size(), 1);
  scanForthAndBack(f.grid, nodesAround(f.grid, nearest), nearest);
  refineNearTheSurface(interpolator, nearest, threads);
  scanForthAndBack(f.grid, all, nearest);
  scanForthAndBack(f.grid, all, nearest);        // halves the error of one scan far away
  const double smallest = 1e-6 * f.grid.spacing; // the sign must survive
  LevelSet     result{ f.grid, std::vector<double>(f.values.size()) };
  for (std::size_t node = 0; node < f.values.size(); ++node)
  {
    const double distance = std::max(f.grid.spacing * std::sqrt(nearest[node].squaredDistance), smallest);
    result.values[node] = f.values[node] < 0.0 ? -distance : distance;
  }
  return result;
}

} // namespace moserhex
