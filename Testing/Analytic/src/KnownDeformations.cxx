#include "moserhex/Analytic/KnownDeformations.h"

#include <Eigen/LU>

#include <cmath>

namespace moserhex::analytic
{
namespace
{

constexpr double radiusOfBend = 90.0;   // [mm]
constexpr double heightOfBulge = 4.0;   // [mm]
constexpr double widthOfBulge = 12.0;   // [mm]
constexpr int    stepsOfInversion = 60; // the bulge is flatter than steep: each more than halves the error

Vector3
bulged(const Vector3 & p)
{
  const Vector3 place(20.0, 9.0, 4.0);
  const double  decay = std::exp(-(p - place).squaredNorm() / (widthOfBulge * widthOfBulge));
  return p + heightOfBulge * decay * place.normalized();
}

} // namespace

KnownDeformation
shear()
{
  const Matrix3 F = (Matrix3() << 1.0, 0.0, 0.25, 0.0, 1.0, 0.0, 0.0, 0.1, 1.0).finished();
  const Matrix3 inverse = F.inverse();
  return { "shear",
           [F](const Vector3 & p) { return Vector3(F * p); },
           [inverse](const Vector3 & p) { return Vector3(inverse * p); } };
}

KnownDeformation
bend()
{
  return { "bend",
           [](const Vector3 & p) {
             const double angle = p.x() / radiusOfBend;
             const double r = radiusOfBend - p.y();
             return Vector3(r * std::sin(angle), radiusOfBend - r * std::cos(angle), p.z());
           },
           [](const Vector3 & p) {
             const double angle = std::atan2(p.x(), radiusOfBend - p.y());
             return Vector3(radiusOfBend * angle, radiusOfBend - std::hypot(p.x(), radiusOfBend - p.y()), p.z());
           } };
}

KnownDeformation
bulge()
{
  return { "bulge", bulged, [](const Vector3 & p) {
            Vector3 q = p;
            for (int step = 0; step < stepsOfInversion; ++step)
            {
              q += p - bulged(q);
            }
            return q;
          } };
}

std::vector<KnownDeformation>
knownDeformations()
{
  return { bend(), bulge(), shear() };
}

Solid
pearShapedSolid()
{
  Solid      solid = ellipsoid({ 26.0, 20.0, 16.0 });
  const auto round = solid.signedFunction;
  solid.name = "pear";
  solid.signedFunction = [round](const Vector3 & p) {
    return round(Vector3(p.x(), p.y() * (1.0 + 0.004 * p.x()), p.z() * (1.0 - 0.006 * p.y())));
  };
  solid.box = { Vector3(-40.0, -36.0, -30.0), Vector3(40.0, 36.0, 30.0) };
  solid.volume = 0.0;
  return solid;
}

Solid
deformed(const Solid & solid, const KnownDeformation & deformation)
{
  Solid      result = solid;
  const auto before = solid.signedFunction;
  const auto inverse = deformation.inverse;
  result.name += ", " + deformation.name;
  result.signedFunction = [before, inverse](const Vector3 & p) { return before(inverse(p)); };
  result.volume = 0.0;
  return result;
}

} // namespace moserhex::analytic
