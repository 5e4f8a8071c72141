#include "moserhex/Geometry/RigidAlignment.h"

#include "moserhex/Common/Errors.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>

#include <cmath>
#include <string>

namespace moserhex
{
namespace
{

/** Below this part of the largest singular value the rotation hangs on rounding [1]. */
constexpr double undetermined = 1e-12;

void
requirePairs(const Positions & moving, const Positions & fixed)
{
  if (moving.size() != fixed.size() || moving.empty())
  {
    throw InvalidInput("alignment: " + std::to_string(moving.size()) + " points to " + std::to_string(fixed.size()) +
                       ", need as many, and at least three");
  }
  for (std::size_t a = 0; a < moving.size(); ++a)
  {
    if (!moving[a].allFinite() || !fixed[a].allFinite())
    {
      throw InvalidInput("alignment: pair " + std::to_string(a) + " has a coordinate that is not finite");
    }
  }
}

Vector3
meanOf(const Positions & points)
{
  Vector3 sum = Vector3::Zero();
  for (const Vector3 & point : points)
  {
    sum += point;
  }
  return sum / static_cast<double>(points.size());
}

/** The best rotation, and the scale that goes with it. */
SimilarityTransform
align(const Positions & moving, const Positions & fixed, bool withScale)
{
  requirePairs(moving, fixed);
  const Vector3 from = meanOf(moving);
  const Vector3 to = meanOf(fixed);
  Matrix3       covariance = Matrix3::Zero();
  double        spread = 0.0;
  for (std::size_t a = 0; a < moving.size(); ++a)
  {
    covariance += (fixed[a] - to) * (moving[a] - from).transpose();
    spread += (moving[a] - from).squaredNorm();
  }
  const Eigen::JacobiSVD<Matrix3> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Vector3                   singular = svd.singularValues();
  const double                    sign = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
  const Vector3                   signs(1.0, 1.0, sign);
  if (!(singular[1] + sign * singular[2] > undetermined * singular[0]))
  {
    throw InvalidInput("alignment: the rotation of " + std::to_string(moving.size()) +
                       " points is not determined, need three that are not on a line, and no mirror image");
  }
  SimilarityTransform result;
  result.rotation = svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
  result.scale = withScale ? singular.dot(signs) / spread : 1.0;
  result.translation = to - result.scale * (result.rotation * from);
  return result;
}

} // namespace

SimilarityTransform
SimilarityTransform::inverse() const
{
  SimilarityTransform back;
  back.scale = 1.0 / scale;
  back.rotation = rotation.transpose();
  back.translation = -back.scale * (back.rotation * translation);
  return back;
}

double
SimilarityTransform::angle() const
{
  return Eigen::AngleAxis<double>(rotation).angle() * 180.0 / pi;
}

SimilarityTransform
rigidAlignment(const Positions & moving, const Positions & fixed)
{
  return align(moving, fixed, false);
}

SimilarityTransform
similarityAlignment(const Positions & moving, const Positions & fixed)
{
  return align(moving, fixed, true);
}

Positions
transformed(const Positions & points, const SimilarityTransform & transform)
{
  Positions result;
  result.reserve(points.size());
  for (const Vector3 & point : points)
  {
    result.push_back(transform(point));
  }
  return result;
}

} // namespace moserhex
