#include "moserhex/Geometry/AffineTransform.h"

#include "moserhex/Geometry/RigidAlignment.h"

#include <Eigen/SVD>

namespace moserhex
{

Matrix3
AffineTransform::rotation() const
{
  const Eigen::JacobiSVD<Matrix3> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return svd.matrixU() * svd.matrixV().transpose();
}

double
AffineTransform::angle() const
{
  SimilarityTransform turn;
  turn.rotation = rotation();
  return turn.angle();
}

} // namespace moserhex
