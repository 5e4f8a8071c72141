#include "SampleProstate.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace moserhex
{
namespace
{

// All lengths in mm, in the gland's own frame: x Left, y Posterior, z Superior, origin at its middle.

/** max(a, b) with its kink rounded over `width`. */
double
smoothMaximum(double a, double b, double width)
{
  const double h = std::clamp(0.5 + 0.5 * (a - b) / width, 0.0, 1.0);
  return a * h + b * (1.0 - h) + width * h * (1.0 - h);
}

/** Negative inside the gland; about a distance near its surface. */
double
glandFunction(const Vector3 & p)
{
  const Vector3 semiAxes(26.7, 23.3, 26.6);
  const double  exponent = 1.73;
  const double  taper = 1.0 + 0.2 * p.z() / semiAxes.z(); // narrow apex, wide base
  const double  power = std::pow(std::abs(p.x()) / (semiAxes.x() * taper), exponent) +
                       std::pow(std::abs(p.y()) / (semiAxes.y() * taper), exponent) +
                       std::pow(std::abs(p.z()) / semiAxes.z(), exponent);
  const double body = semiAxes.y() * (std::pow(power, 1.0 / exponent) - 1.0);

  const double bladder = 18.0 - (p - Vector3(0.0, -3.0, 29.0)).norm();
  const double groove = 1.5 * std::exp(-std::pow(p.x() / 6.0, 2));
  const double rectum = p.y() - 19.8 + groove;
  const double rounding = 4.0;
  return smoothMaximum(smoothMaximum(body, bladder, rounding), rectum, rounding);
}

/** Negative inside the transition zone: an ellipsoid in the upper front of the gland. */
double
transitionZoneFunction(const Vector3 & p)
{
  const Vector3 centre(0.0, -4.0, 2.0);
  const Vector3 semiAxes(17.0, 13.0, 17.0);
  return (p - centre).cwiseQuotient(semiAxes).norm() - 1.0;
}

/** Negative inside the gland at the later visit: grown about its middle, and a bulge pushed out on the left. */
double
followUpFunction(const Vector3 & p)
{
  const double  growth = 1.039;
  const Vector3 bulgeCentre(21.0, 12.0, -2.0);
  const double  bulge = 5.0 * std::exp(-(p - bulgeCentre).squaredNorm() / (2.0 * 7.5 * 7.5));
  return growth * glandFunction(p / growth) - bulge;
}

/** The empty grid all three images share, and the gland's frame in it. */
struct Scanner
{
  LabelVolume grid;
  Vector3     glandCentre{ 3.0, -21.0, 14.0 };

  [[nodiscard]] Vector3
  toGland(const Vector3 & point) const
  {
    return point - glandCentre;
  }
};

Scanner
makeScanner()
{
  Scanner scanner;
  scanner.grid.size = { 148, 132, 22 };
  scanner.grid.spacing = Vector3(0.5, 0.5, 3.0);
  // Slices tilted towards the gland's long axis, as they are planned in practice.
  scanner.grid.direction = (Eigen::AngleAxisd(-0.30, Vector3::UnitX()) * Eigen::AngleAxisd(0.06, Vector3::UnitY()) *
                            Eigen::AngleAxisd(-0.04, Vector3::UnitZ()))
                             .toRotationMatrix();
  const Vector3 middle(0.5 * 147, 0.5 * 131, 0.5 * 21);
  scanner.grid.origin = scanner.glandCentre - scanner.grid.direction * scanner.grid.spacing.cwiseProduct(middle);
  return scanner;
}

template <typename TLabelOf>
LabelVolume
scan(const Scanner & scanner, const TLabelOf & labelOf)
{
  LabelVolume image = scanner.grid;
  for (int k = 0; k < image.size[2]; ++k)
  {
    for (int j = 0; j < image.size[1]; ++j)
    {
      for (int i = 0; i < image.size[0]; ++i)
      {
        image.inside.push_back(static_cast<std::uint8_t>(labelOf(scanner.toGland(image.point(i, j, k)))));
      }
    }
  }
  return image;
}

} // namespace

SampleProstate
makeSampleProstate()
{
  const Scanner  scanner = makeScanner();
  SampleProstate sample;
  sample.gland = scan(scanner, [](const Vector3 & p) { return glandFunction(p) < 0.0 ? 1 : 0; });
  sample.followUp = scan(scanner, [](const Vector3 & p) { return followUpFunction(p) < 0.0 ? 1 : 0; });
  sample.zones = scan(scanner, [](const Vector3 & p) {
    if (glandFunction(p) >= 0.0)
    {
      return 0;
    }
    return transitionZoneFunction(p) < 0.0 ? 2 : 1;
  });
  return sample;
}

} // namespace moserhex
