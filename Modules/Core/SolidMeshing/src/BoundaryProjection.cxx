#include "BoundaryProjection.h"

#include "moserhex/Geometry/HexMeshNumbering.h"

#include <algorithm>
#include <cmath>

namespace moserhex
{
namespace
{
/** For a point that may be a few grid edges away. */
constexpr int nearestPointIterations = 20;
} // namespace

double
longestNewtonStep(const RegularGrid & grid)
{
  return 0.5 * grid.spacing;
}

SurfaceProjection
projectionOnto(const ClosestPointSearch & search, const CubicInterpolator & phi, double level)
{
  const double maximumStep = longestNewtonStep(phi.grid());
  return [&search, &phi, level, maximumStep](const Vector3 & p) {
    const bool    isNear = std::abs(phi.value(p) - level) <= maximumStep;
    const Vector3 start = isNear ? p : search.closest(p).point;
    return projectToLevel(phi, start, level, maximumStep, projectionIterations);
  };
}

SurfaceProjection
nearestPointOn(const ClosestPointSearch & search, const CubicInterpolator & phi, double level)
{
  const double maximumStep = longestNewtonStep(phi.grid());
  return [&search, &phi, level, maximumStep](const Vector3 & p) {
    const Vector3 a = projectToLevel(phi, p, level, maximumStep, nearestPointIterations);
    const Vector3 b = projectToLevel(phi, search.closest(p).point, level, maximumStep, nearestPointIterations);
    const bool    aIsThere = std::abs(phi.value(a) - level) < 1e-3 * phi.grid().spacing;
    return aIsThere && (a - p).squaredNorm() < (b - p).squaredNorm() ? a : b;
  };
}

BoundaryDistance
boundaryDistance(const HexMesh & mesh, const SurfaceProjection & projection)
{
  BoundaryDistance result;
  double           squares = 0.0;
  std::size_t      count = 0;
  const auto       add = [&](const Vector3 & p) {
    const double squared = (projection(p) - p).squaredNorm();
    squares += squared;
    ++count;
    result.maximum = std::max(result.maximum, std::sqrt(squared));
  };
  for (const std::size_t node : boundaryNodes(mesh))
  {
    add(mesh.nodes[node]);
  }
  result.maximumOfNodes = result.maximum;
  for (const Quadrilateral & quad : boundaryQuads(mesh))
  {
    add(0.25 * (mesh.nodes[quad[0]] + mesh.nodes[quad[1]] + mesh.nodes[quad[2]] + mesh.nodes[quad[3]]));
  }
  result.rms = std::sqrt(squares / static_cast<double>(count));
  return result;
}

} // namespace moserhex
