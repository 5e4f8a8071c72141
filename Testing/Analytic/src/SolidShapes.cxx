#include "moserhex/Analytic/SolidShapes.h"

#include "moserhex/Common/Errors.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <complex>

namespace moserhex::analytic
{
namespace
{

void
requirePositive(const char * what, double value)
{
  if (!(value > 0.0))
  {
    throw InvalidInput(std::string(what) + " = " + std::to_string(value) + ", need > 0");
  }
}

BoundingBox
boxAboutOrigin(const Vector3 & halfExtent)
{
  return { -halfExtent, halfExtent };
}

} // namespace

Solid
ball(double radius)
{
  requirePositive("ball: radius", radius);
  return { "ball",
           [radius](const Vector3 & p) { return p.norm() - radius; },
           boxAboutOrigin(Vector3::Constant(radius)),
           4.0 / 3.0 * pi * radius * radius * radius };
}

Solid
ellipsoid(const Vector3 & semiAxes)
{
  requirePositive("ellipsoid: smallest semi-axis", semiAxes.minCoeff());
  const double smallest = semiAxes.minCoeff();
  return { "ellipsoid",
           [semiAxes, smallest](const Vector3 & p) { return smallest * (p.cwiseQuotient(semiAxes).norm() - 1.0); },
           boxAboutOrigin(semiAxes),
           4.0 / 3.0 * pi * semiAxes.prod() };
}

Solid
bumpyBall(double radius, double amplitude)
{
  requirePositive("bumpyBall: radius", radius);
  if (!(amplitude >= 0.0 && amplitude < 0.5))
  {
    throw InvalidInput("bumpyBall: amplitude = " + std::to_string(amplitude) + ", need 0 <= amplitude < 0.5");
  }
  // sin^5 cos is largest where tan^2 = 5.
  const double scale = 1.0 / (std::pow(5.0 / 6.0, 2.5) * std::sqrt(1.0 / 6.0));
  const auto   harmonic = [scale](const Vector3 & n) {
    return scale * std::pow(std::complex<double>(n.x(), n.y()), 5).real() * n.z();
  };
  // V = R^3/3 integral (1 + a Y)^3 over the sphere; Y and Y^3 integrate to 0, and
  // integral Y^2 = scale^2 pi B(3/2, 6), B the Euler beta function.
  const double squared = scale * scale * pi * std::tgamma(1.5) * std::tgamma(6.0) / std::tgamma(7.5);
  const double volume = std::pow(radius, 3) / 3.0 * (4.0 * pi + 3.0 * amplitude * amplitude * squared);
  return { "bumpyBall",
           [radius, amplitude, harmonic](const Vector3 & p) {
             const double distance = p.norm();
             const double y = distance > 0.0 ? harmonic(p / distance) : 0.0;
             return distance - radius * (1.0 + amplitude * y);
           },
           boxAboutOrigin(Vector3::Constant(radius * (1.0 + amplitude))),
           volume };
}

Solid
banana(double arcRadius, double thickness, double taper)
{
  requirePositive("banana: thickness", thickness);
  if (!(arcRadius > 1.5 * thickness) || !(std::abs(taper) < 0.9))
  {
    throw InvalidInput("banana: arcRadius = " + std::to_string(arcRadius) + ", taper = " + std::to_string(taper) +
                       ", need arcRadius > 1.5 thickness and |taper| < 0.9");
  }
  constexpr double halfArc = 1.2;
  // Squared radius of the cross section at u = angle / halfArc, negative beyond the ends.
  const auto squaredRadius = [thickness, taper](double u) {
    return thickness * thickness * (1.0 - u * u) * std::max(1.0 + taper * u, 0.1);
  };
  const auto centre = [arcRadius](double angle) {
    return Vector3(arcRadius * std::sin(angle), 0.0, arcRadius * (std::cos(angle) - 1.0));
  };
  const auto function = [=](const Vector3 & p) {
    const double angle = std::atan2(p.x(), p.z() + arcRadius);
    const double squaredDistance = (p - centre(angle)).squaredNorm();
    return (squaredDistance - squaredRadius(angle / halfArc)) / (2.0 * thickness);
  };
  BoundingBox   box{ Vector3::Zero(), Vector3::Zero() };
  constexpr int samples = 2000;
  for (int i = 0; i <= samples; ++i)
  {
    const double  u = 2.0 * i / samples - 1.0;
    const double  radius = std::sqrt(squaredRadius(u));
    const double  angle = u * halfArc;
    const Vector3 reach = radius * Vector3(std::abs(std::sin(angle)), 1.0, std::abs(std::cos(angle)));
    box.lower = box.lower.cwiseMin(centre(angle) - reach);
    box.upper = box.upper.cwiseMax(centre(angle) + reach);
  }
  box.lower.array() -= 0.1;
  box.upper.array() += 0.1;
  // Pappus: circular sections centred on the arc, V = integral pi r^2 ds; the odd taper term integrates to 0.
  return { "banana", function, box, 4.0 / 3.0 * pi * thickness * thickness * arcRadius * halfArc };
}

Solid
dumbbell()
{
  constexpr double halfLength = 30.0;
  // Squared radius (L^2 - x^2)(a + b x^2): neck 5 mm at x = 0, lobes 12.0 mm at x = 20.7.
  constexpr double a = 25.0 / (halfLength * halfLength);
  constexpr double b = 6.48e-4;
  const auto       function = [](const Vector3 & p) {
    const double squaredX = p.x() * p.x();
    const double squaredRadius = (halfLength * halfLength - squaredX) * (a + b * squaredX);
    return (p.y() * p.y() + p.z() * p.z() - squaredRadius) / 24.0;
  };
  const double volume = pi * (4.0 / 3.0 * a * std::pow(halfLength, 3) + 4.0 / 15.0 * b * std::pow(halfLength, 5));
  return { "dumbbell", function, boxAboutOrigin(Vector3(halfLength, 12.1, 12.1)), volume };
}

Solid
cube(double side)
{
  requirePositive("cube: side", side);
  const double half = 0.5 * side;
  return { "cube",
           [half](const Vector3 & p) {
             const Vector3 beyond = p.cwiseAbs() - Vector3::Constant(half);
             return beyond.cwiseMax(0.0).norm() + std::min(beyond.maxCoeff(), 0.0);
           },
           boxAboutOrigin(Vector3::Constant(half)),
           side * side * side };
}

std::vector<Solid>
solids()
{
  return { ball(), ellipsoid(), bumpyBall(), banana(), dumbbell(), cube() };
}

LabelVolume
labelVolume(const Solid & solid, const GridPlacement & placement)
{
  requirePositive("labelVolume: smallest spacing", placement.spacing.minCoeff());
  const Matrix3 toImage = placement.direction.transpose();
  Vector3       lower = Vector3::Constant(std::numeric_limits<double>::max());
  Vector3       upper = -lower;
  for (int corner = 0; corner < 8; ++corner)
  {
    const Vector3 p((corner & 1) ? solid.box.upper.x() : solid.box.lower.x(),
                    (corner & 2) ? solid.box.upper.y() : solid.box.lower.y(),
                    (corner & 4) ? solid.box.upper.z() : solid.box.lower.z());
    lower = lower.cwiseMin(toImage * p);
    upper = upper.cwiseMax(toImage * p);
  }

  LabelVolume label;
  label.spacing = placement.spacing;
  label.direction = placement.direction;
  Vector3 first;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double extent = upper[axis] - lower[axis] + 2.0 * placement.margin;
    const int    steps = static_cast<int>(std::ceil(extent / placement.spacing[axis]));
    label.size[static_cast<std::size_t>(axis)] = steps + 1;
    first[axis] = 0.5 * (lower[axis] + upper[axis] - steps * placement.spacing[axis]);
  }
  label.origin = placement.direction * first;

  const auto [sizeX, sizeY, sizeZ] = label.size;
  label.inside.reserve(static_cast<std::size_t>(sizeX) * static_cast<std::size_t>(sizeY) *
                       static_cast<std::size_t>(sizeZ));
  for (int k = 0; k < sizeZ; ++k)
  {
    for (int j = 0; j < sizeY; ++j)
    {
      for (int i = 0; i < sizeX; ++i)
      {
        label.inside.push_back(solid.signedFunction(label.point(i, j, k)) < 0.0 ? 1 : 0);
      }
    }
  }
  return label;
}

double
volumeOfVoxels(const LabelVolume & label)
{
  return static_cast<double>(voxelCount(label)) * label.voxelVolume();
}

Matrix3
obliqueDirection()
{
  return (Eigen::AngleAxisd(0.35, Vector3::UnitX()) * Eigen::AngleAxisd(-0.2, Vector3::UnitY()) *
          Eigen::AngleAxisd(0.6, Vector3::UnitZ()))
    .toRotationMatrix();
}

} // namespace moserhex::analytic
