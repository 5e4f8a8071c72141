#include "moserhex/StructuredGrid/CubeToSphere.h"

#include "moserhex/Common/Errors.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace moserhex
{
namespace
{
const double     root2 = std::sqrt(2.0);
constexpr double surfaceTolerance = 1e-9;

/** Axis of the largest absolute component; the first one on ties. */
Eigen::Index
dominantAxis(const Vector3 & v)
{
  Eigen::Index axis = 0;
  v.cwiseAbs().maxCoeff(&axis);
  return axis;
}

/** Square [-1,1]^2 -> Lambert disk. `major` is the coordinate of larger absolute value. */
void
squareToLambert(double major, double minor, double & lambertMajor, double & lambertMinor)
{
  if (major == 0.0)
  {
    lambertMajor = lambertMinor = 0.0;
    return;
  }
  const double alpha = pi * minor / (12.0 * major);
  const double scale = std::pow(2.0, 0.25) * major / std::sqrt(root2 - std::cos(alpha));
  lambertMajor = scale * (root2 * std::cos(alpha) - 1.0);
  lambertMinor = scale * root2 * std::sin(alpha);
}

/** Inverse of squareToLambert. With tan psi = Y / X the first map says sqrt 2 sin(psi - alpha) = sin psi. */
void
lambertToSquare(double lambertMajor, double lambertMinor, double & major, double & minor)
{
  if (lambertMajor == 0.0)
  {
    major = minor = 0.0;
    return;
  }
  const double psi = std::atan(lambertMinor / lambertMajor);
  const double alpha = psi - std::asin(std::sin(psi) / root2);
  major = lambertMajor * std::sqrt(root2 - std::cos(alpha)) / (std::pow(2.0, 0.25) * (root2 * std::cos(alpha) - 1.0));
  minor = major * 12.0 * alpha / pi;
}
} // namespace

Vector3
cubeToSphere(const Vector3 & point)
{
  if (!(std::abs(point.cwiseAbs().maxCoeff() - 1.0) <= surfaceTolerance))
  {
    throw InvalidInput("largest absolute coordinate " + std::to_string(point.cwiseAbs().maxCoeff()) +
                       ", must be 1: the point is not on the surface of the cube [-1,1]^3");
  }
  const Eigen::Index axis = dominantAxis(point);
  const Eigen::Index first = (axis + 1) % 3;
  const Eigen::Index second = (axis + 2) % 3;

  double u = 0.0;
  double v = 0.0;
  if (std::abs(point[first]) >= std::abs(point[second]))
  {
    squareToLambert(point[first], point[second], u, v);
  }
  else
  {
    squareToLambert(point[second], point[first], v, u);
  }

  // Lambert's azimuthal equal-area projection: |(u,v)|^2 = 2 (1 - height).
  const double squaredRadius = u * u + v * v;
  const double stretch = std::sqrt(1.0 - 0.25 * squaredRadius);
  Vector3      direction;
  direction[first] = stretch * u;
  direction[second] = stretch * v;
  direction[axis] = std::copysign(1.0 - 0.5 * squaredRadius, point[axis]);
  return direction.normalized();
}

Vector3
sphereToCube(const Vector3 & direction)
{
  const double length = direction.norm();
  if (!(length > 0.0) || !std::isfinite(length))
  {
    throw InvalidInput("direction of length " + std::to_string(length) + ", must be positive and finite");
  }
  const Vector3      unit = direction / length;
  const Eigen::Index axis = dominantAxis(unit);
  const Eigen::Index first = (axis + 1) % 3;
  const Eigen::Index second = (axis + 2) % 3;

  const double stretch = std::sqrt(2.0 / (1.0 + std::abs(unit[axis])));
  const double u = stretch * unit[first];
  const double v = stretch * unit[second];
  double       x = 0.0;
  double       y = 0.0;
  if (std::abs(u) >= std::abs(v))
  {
    lambertToSquare(u, v, x, y);
  }
  else
  {
    lambertToSquare(v, u, y, x);
  }

  Vector3 point;
  point[first] = std::clamp(x, -1.0, 1.0);
  point[second] = std::clamp(y, -1.0, 1.0);
  point[axis] = std::copysign(1.0, unit[axis]);
  return point;
}

} // namespace moserhex
