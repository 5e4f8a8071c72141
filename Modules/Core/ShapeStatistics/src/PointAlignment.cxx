#include "moserhex/ShapeStatistics/PointAlignment.h"

#include "moserhex/Common/Errors.h"

#include <Eigen/LU>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <string>

namespace moserhex
{
namespace
{

/** Of the largest singular value: below it the best rotation is not the only one. */
constexpr double smallestGap = 1e-9;

void
requireCorresponding(const Positions & moving, const Positions & fixed)
{
  if (moving.size() != fixed.size() || moving.size() < 3)
  {
    throw InvalidInput("alignment: " + std::to_string(moving.size()) + " and " + std::to_string(fixed.size()) +
                       " points, need as many of both and at least 3");
  }
  for (const Positions * points : { &moving, &fixed })
  {
    const auto bad = std::find_if(points->begin(), points->end(), [](const Vector3 & p) { return !p.allFinite(); });
    if (bad != points->end())
    {
      throw InvalidInput("alignment: point " + std::to_string(bad - points->begin()) + " is not finite");
    }
  }
}

} // namespace

Positions
transformed(const SimilarityTransform & transform, const Positions & points)
{
  Positions result;
  result.reserve(points.size());
  std::transform(points.begin(), points.end(), std::back_inserter(result), transform);
  return result;
}

Vector3
centroidOf(const Positions & points)
{
  if (points.empty())
  {
    throw InvalidInput("centroid: no point");
  }
  Vector3 sum = Vector3::Zero();
  for (const Vector3 & p : points)
  {
    sum += p;
  }
  return sum / static_cast<double>(points.size());
}

double
centroidSize(const Positions & points)
{
  const Vector3 centroid = centroidOf(points);
  double        sum = 0.0;
  for (const Vector3 & p : points)
  {
    sum += (p - centroid).squaredNorm();
  }
  return std::sqrt(sum);
}

SimilarityTransform
alignPoints(const Positions & moving, const Positions & fixed, AlignmentKind kind)
{
  requireCorresponding(moving, fixed);
  if (kind == AlignmentKind::None)
  {
    return {};
  }
  const Vector3 fromCentroid = centroidOf(moving);
  const Vector3 toCentroid = centroidOf(fixed);
  Matrix3       correlation = Matrix3::Zero();
  double        squaredSize = 0.0;
  for (std::size_t a = 0; a < moving.size(); ++a)
  {
    const Vector3 from = moving[a] - fromCentroid;
    correlation += (fixed[a] - toCentroid) * from.transpose();
    squaredSize += from.squaredNorm();
  }
  const Eigen::JacobiSVD<Matrix3> svd(correlation, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double  handedness = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
  const Vector3 signs(1.0, 1.0, handedness);
  const Vector3 values = svd.singularValues();
  if (!(values[1] + handedness * values[2] > smallestGap * values[0]))
  {
    throw InvalidInput("alignment: the points lie on a line or are symmetric, so that no rotation is the best one");
  }
  SimilarityTransform result;
  result.rotation = svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
  result.scale = kind == AlignmentKind::Similarity ? values.dot(signs) / squaredSize : 1.0;
  result.translation = toCentroid - result.scale * (result.rotation * fromCentroid);
  return result;
}

} // namespace moserhex
