#include "moserhex/CubeTransfer/CubeAxes.h"

#include <Eigen/SVD>

#include <algorithm>

namespace moserhex
{

Matrix3
rotationPart(const Matrix3 & jacobian)
{
  const Eigen::JacobiSVD<Matrix3> svd(jacobian, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return svd.matrixU() * svd.matrixV().transpose();
}

void
turn(const Matrix3 & rotation, int components, double * values)
{
  if (components == 3)
  {
    Eigen::Map<Vector3> vector(values);
    vector = (rotation * vector).eval();
    return;
  }
  Matrix3 tensor;
  tensor << values[0], values[1], values[2], values[1], values[3], values[4], values[2], values[4], values[5];
  tensor = (rotation * tensor * rotation.transpose()).eval();
  const double turned[6] = { tensor(0, 0), tensor(0, 1), tensor(0, 2), tensor(1, 1), tensor(1, 2), tensor(2, 2) };
  std::copy(turned, turned + 6, values);
}

} // namespace moserhex
