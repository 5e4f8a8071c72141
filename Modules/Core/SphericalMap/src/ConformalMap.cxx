#include "moserhex/SphericalMap/ConformalMap.h"

#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Stopwatch.h"
#include "moserhex/DiscreteCalculus/TriangleOperators.h"
#include "moserhex/Numerics/SparseCholesky.h"
#include "moserhex/SphericalMap/SphereMapQuality.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace moserhex
{
namespace
{

Vector3
centreOf(const TriangleMesh & surface, const Triangle & t)
{
  return (surface.vertices[t[0]] + surface.vertices[t[1]] + surface.vertices[t[2]]) / 3.0;
}

/** Area over the sum of squared edges: largest for the equilateral triangle. */
double
regularity(const TriangleMesh & surface, const Triangle & t)
{
  const Vector3 & a = surface.vertices[t[0]];
  const Vector3 & b = surface.vertices[t[1]];
  const Vector3 & c = surface.vertices[t[2]];
  const double    squares = (a - b).squaredNorm() + (b - c).squaredNorm() + (c - a).squaredNorm();
  return squares > 0.0 ? triangleArea(a, b, c) / squares : 0.0;
}

/** The paper's a and b as columns, nV x 2 [1/mm]; each sums to zero. */
Eigen::MatrixXd
boundaryTerms(const TriangleMesh & surface, const Triangle & removed)
{
  const Vector3 & A = surface.vertices[removed[0]];
  const Vector3 & B = surface.vertices[removed[1]];
  const Vector3 & C = surface.vertices[removed[2]];
  const double    lengthAB = (B - A).norm();
  const double    theta = (B - A).dot(C - A) / (lengthAB * lengthAB);
  const double    height = (C - (A + theta * (B - A))).norm();
  if (!(lengthAB > 0.0) || !(height > 0.0) || !std::isfinite(theta))
  {
    std::ostringstream message;
    message << "the triangle to remove is degenerate: side " << lengthAB << " mm, height " << height
            << " mm, need both positive";
    throw InvalidInput(message.str());
  }
  Eigen::MatrixXd terms = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(surface.vertices.size()), 2);
  terms(removed[0], 0) = -1.0 / lengthAB;
  terms(removed[1], 0) = 1.0 / lengthAB;
  terms(removed[0], 1) = (1.0 - theta) / height;
  terms(removed[1], 1) = theta / height;
  terms(removed[2], 1) = -1.0 / height;
  return terms;
}

double
median(std::vector<double> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/** Plane coordinates about their medians, in units of the median radius. */
void
normalisePlane(Eigen::MatrixXd & plane)
{
  for (Eigen::Index axis = 0; axis < 2; ++axis)
  {
    const double * begin = plane.col(axis).data();
    plane.col(axis).array() -= median({ begin, begin + plane.rows() });
  }
  std::vector<double> radii(static_cast<std::size_t>(plane.rows()));
  for (Eigen::Index v = 0; v < plane.rows(); ++v)
  {
    radii[static_cast<std::size_t>(v)] = plane.row(v).norm();
  }
  plane /= std::max(median(radii), std::numeric_limits<double>::min());
}

/** x + iy -> (2x, 2y, r^2 - 1) / (1 + r^2): the paper's projection. */
Positions
inverseStereographic(const Eigen::MatrixXd & plane)
{
  Positions sphere(static_cast<std::size_t>(plane.rows()));
  for (Eigen::Index v = 0; v < plane.rows(); ++v)
  {
    const double  squaredRadius = plane.row(v).squaredNorm();
    const Vector3 s(2.0 * plane(v, 0), 2.0 * plane(v, 1), squaredRadius - 1.0);
    sphere[static_cast<std::size_t>(v)] = (s / (1.0 + squaredRadius)).normalized();
  }
  return sphere;
}

} // namespace

int
triangleTowards(const TriangleMesh & surface, const Vector3 & direction)
{
  constexpr double cosineMargin = 0.03; // 14 degrees when a triangle lies exactly in the direction
  const Vector3    centroid = surfaceCentroid(surface);
  const Vector3    unit = direction.normalized();
  const auto alignment = [&](const Triangle & t) { return (centreOf(surface, t) - centroid).normalized().dot(unit); };
  double     nearest = -2.0;
  for (const Triangle & t : surface.triangles)
  {
    nearest = std::max(nearest, alignment(t));
  }
  int    best = 0;
  double bestRegularity = -1.0;
  for (std::size_t f = 0; f < surface.triangles.size(); ++f)
  {
    const Triangle & t = surface.triangles[f];
    if (alignment(t) >= nearest - cosineMargin && regularity(surface, t) > bestRegularity)
    {
      bestRegularity = regularity(surface, t);
      best = static_cast<int>(f);
    }
  }
  return best;
}

int
triangleNear(const TriangleMesh & surface, const Vector3 & point)
{
  int    best = 0;
  double bestSquaredDistance = std::numeric_limits<double>::infinity();
  for (std::size_t f = 0; f < surface.triangles.size(); ++f)
  {
    const double squaredDistance = (centreOf(surface, surface.triangles[f]) - point).squaredNorm();
    if (squaredDistance < bestSquaredDistance)
    {
      bestSquaredDistance = squaredDistance;
      best = static_cast<int>(f);
    }
  }
  return best;
}

ConformalMapResult
conformalSphereMap(const TriangleMesh & surface, const ConformalMapOptions & options)
{
  const Stopwatch watch;
  requireSphere(surface, "conformal map");
  if (!options.removedDirection.allFinite() || !(options.removedDirection.norm() > 0.0))
  {
    throw InvalidInput("direction of the triangle to remove is zero or not finite");
  }
  const TriangleTopology    topology = triangleTopology(surface);
  const bool                clamped = options.weights == LaplacianWeights::ClampedCotangent;
  const std::vector<double> weights =
    clamped ? clampedCotanWeights(surface, topology, options.smallestWeight, options.largestWeight)
            : cotanWeights(surface, topology);

  ConformalMapResult result;
  result.removedTriangle = options.removedNearPoint ? triangleNear(surface, *options.removedNearPoint)
                                                    : triangleTowards(surface, options.removedDirection);
  const Triangle &      removed = surface.triangles[result.removedTriangle];
  const Eigen::MatrixXd terms = boundaryTerms(surface, removed);
  SparseMatrix          D = weightedLaplacian(topology, weights, surface.vertices.size());
  D.coeffRef(removed[0], removed[0]) += 1.0;
  SparseCholesky cholesky;
  cholesky.compute(D);
  Eigen::MatrixXd plane = cholesky.solve(terms);
  result.report.residual = relativeResidual(D, plane, terms);

  normalisePlane(plane);
  result.positions = inverseStereographic(plane);
  result.flippedTriangles = countFlippedTriangles(surface.triangles, result.positions);
  if (result.flippedTriangles > static_cast<int>(surface.triangles.size() / 2))
  {
    for (Vector3 & s : result.positions)
    {
      s[0] = -s[0];
    }
    result.flippedTriangles = countFlippedTriangles(surface.triangles, result.positions);
  }
  result.report.converged = plane.allFinite() && result.report.residual < 1e-8;
  result.report.steps = 1;
  result.report.seconds = watch.seconds();
  result.report.note = clamped ? "conformal, clamped weights" : "conformal";
  if (!result.report.converged)
  {
    std::ostringstream message;
    message << "conformal map: relative residual " << result.report.residual << ", need 1e-8 and a finite map";
    throw NotConverged(message.str(), result.report);
  }
  return result;
}

} // namespace moserhex
