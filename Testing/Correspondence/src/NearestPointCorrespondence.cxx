#include "moserhex/Correspondence/NearestPointCorrespondence.h"

#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Stopwatch.h"
#include "moserhex/Correspondence/LandmarkErrors.h"
#include "moserhex/Geometry/ClosestPoint.h"
#include "moserhex/Geometry/RigidAlignment.h"

#include <algorithm>
#include <cmath>

namespace moserhex
{
namespace
{

double
rootMeanSquareDistance(const Positions & a, const Positions & b)
{
  double sum = 0.0;
  for (const double distance : pointDistances(a, b))
  {
    sum += distance * distance;
  }
  return std::sqrt(sum / static_cast<double>(a.size()));
}

/** \param triangles  where each point's nearest one was found last; brought up to date */
Positions
nearestPoints(const Positions & points, const ClosestPointSearch & search, std::vector<int> & triangles)
{
  Positions nearest(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const ClosestPointOnSurface found = search.closest(points[i], triangles[i]);
    nearest[i] = found.point;
    triangles[i] = found.triangle;
  }
  return nearest;
}

} // namespace

std::size_t
medoidOf(const std::vector<Positions> & subjects)
{
  if (subjects.empty())
  {
    throw InvalidInput("medoid: no subject");
  }
  std::vector<double> sums(subjects.size(), 0.0);
  for (std::size_t a = 0; a < subjects.size(); ++a)
  {
    for (std::size_t b = a + 1; b < subjects.size(); ++b)
    {
      const double distance = rootMeanSquareDistance(subjects[a], subjects[b]);
      sums[a] += distance;
      sums[b] += distance;
    }
  }
  return static_cast<std::size_t>(std::min_element(sums.begin(), sums.end()) - sums.begin());
}

NearestPointResult
nearestPointCorrespondence(const Positions & points, const TriangleMesh & surface, const NearestPointOptions & options)
{
  const Stopwatch          stopwatch;
  const ClosestPointSearch search(surface);
  std::vector<int>         triangles(points.size(), -1);
  NearestPointResult       result;
  Positions                moved = points;
  result.points = nearestPoints(moved, search, triangles);
  while (!result.report.converged && result.report.steps < options.maximumSteps)
  {
    const Positions           next = transformed(points, rigidAlignment(points, result.points));
    const std::vector<double> moves = pointDistances(moved, next);
    moved = next;
    result.points = nearestPoints(moved, search, triangles);
    result.report.residual = *std::max_element(moves.begin(), moves.end());
    result.report.converged = result.report.residual < options.tolerance;
    ++result.report.steps;
  }
  result.report.seconds = stopwatch.seconds();
  return result;
}

} // namespace moserhex
