#pragma once

#include "moserhex/Analytic/Lattices.h"
#include "moserhex/Common/Random.h"

#include <Eigen/Geometry>

#include <cmath>

namespace moserhex::testing
{

/** A standard normal number, by Box and Muller. */
inline double
normalNumber(Random & random)
{
  const double radius = std::sqrt(-2.0 * std::log(1.0 - random.uniform()));
  return radius * std::cos(2.0 * pi * random.uniform());
}

inline Eigen::MatrixXd
normalMatrix(Eigen::Index rows, Eigen::Index columns, Random & random)
{
  Eigen::MatrixXd result(rows, columns);
  for (Eigen::Index column = 0; column < columns; ++column)
  {
    for (Eigen::Index row = 0; row < rows; ++row)
    {
      result(row, column) = normalNumber(random);
    }
  }
  return result;
}

inline Matrix3
turnOf(double angle, const Vector3 & axis)
{
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

/** A lattice of n^3 nodes in a ball-like solid with semi-axes of some 20 mm, det J > 0. */
inline HexMesh
softCube(int n, const Vector3 & semiAxes = Vector3(24.0, 18.0, 21.0))
{
  return analytic::lattice(n, [&](const Vector3 & index) {
    const Vector3 u = 2.0 * index / (n - 1) - Vector3::Ones();
    // The cube's faces are drawn in towards the ball, but not so far that its edges become flat.
    const Vector3 soft(u[0] * std::sqrt(1.0 - 0.3 * u[1] * u[1] - 0.3 * u[2] * u[2] + 0.15 * u[1] * u[1] * u[2] * u[2]),
                       u[1] * std::sqrt(1.0 - 0.3 * u[0] * u[0] - 0.3 * u[2] * u[2] + 0.15 * u[0] * u[0] * u[2] * u[2]),
                       u[2] *
                         std::sqrt(1.0 - 0.3 * u[0] * u[0] - 0.3 * u[1] * u[1] + 0.15 * u[0] * u[0] * u[1] * u[1]));
    return Vector3(soft.cwiseProduct(semiAxes));
  });
}

} // namespace moserhex::testing
