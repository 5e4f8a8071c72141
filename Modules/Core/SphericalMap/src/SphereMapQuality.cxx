#include "moserhex/SphericalMap/SphereMapQuality.h"

#include "moserhex/Common/Errors.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace moserhex
{
namespace
{

constexpr double degrees = 180.0 / pi;

double
angleAt(const Positions & points, const Triangle & t, int corner)
{
  const Vector3 u = points[t[(corner + 1) % 3]] - points[t[corner]];
  const Vector3 v = points[t[(corner + 2) % 3]] - points[t[corner]];
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

/** sigma_1 / sigma_2 of the linear map between two flat triangles: with D its Dirichlet energy and A the image's area,
 * D / (2 A) = (sigma_1 / sigma_2 + sigma_2 / sigma_1) / 2. */
double
singularValueRatio(const Positions & from, const Positions & to, const Triangle & t)
{
  double dirichlet = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    const VertexIndex i = t[(k + 1) % 3];
    const VertexIndex j = t[(k + 2) % 3];
    const Vector3     u = from[i] - from[t[k]];
    const Vector3     v = from[j] - from[t[k]];
    const double      sine = std::max(u.cross(v).norm(), std::numeric_limits<double>::min());
    dirichlet += 0.5 * u.dot(v) / sine * (to[i] - to[j]).squaredNorm();
  }
  const double area = std::max(triangleArea(to[t[0]], to[t[1]], to[t[2]]), std::numeric_limits<double>::min());
  const double mean = std::max(0.5 * dirichlet / area, 1.0);
  // A degenerate triangle has no finite ratio; the cap keeps the mean readable.
  constexpr double largestRatio = 1e3;
  return std::min(mean + std::sqrt(mean * mean - 1.0), largestRatio);
}

double
meanAngleError(const TriangleMesh & surface, const Positions & sphere)
{
  double sum = 0.0;
  for (const Triangle & t : surface.triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      sum += std::abs(angleAt(sphere, t, k) - angleAt(surface.vertices, t, k)) * degrees;
    }
  }
  return sum / static_cast<double>(3 * surface.triangles.size());
}

} // namespace

double
signedSolidAngle(const Vector3 & a, const Vector3 & b, const Vector3 & c)
{
  return 2.0 * std::atan2(a.dot(b.cross(c)), 1.0 + a.dot(b) + b.dot(c) + c.dot(a));
}

int
countFlippedTriangles(const std::vector<Triangle> & triangles, const Positions & sphere)
{
  return static_cast<int>(std::count_if(triangles.begin(), triangles.end(), [&](const Triangle & t) {
    return !(sphere[t[0]].dot(sphere[t[1]].cross(sphere[t[2]])) > 0.0);
  }));
}

std::vector<double>
targetSolidAngles(const TriangleMesh & surface, double relativeFloor)
{
  return targetSolidAngles(triangleAreas(surface), relativeFloor);
}

std::vector<double>
targetSolidAngles(std::vector<double> targets, double relativeFloor)
{
  double area = 0.0;
  for (const double a : targets)
  {
    area += a;
  }
  if (!(area > 0.0) || !std::isfinite(area))
  {
    std::ostringstream message;
    message << "area of the surface = " << area << " mm^2, need positive and finite";
    throw InvalidInput(message.str());
  }
  const double floor = relativeFloor * area / static_cast<double>(targets.size());
  double       sum = 0.0;
  for (double & target : targets)
  {
    target = std::max(target, floor);
    sum += target;
  }
  for (double & target : targets)
  {
    target *= 4.0 * pi / sum;
  }
  return targets;
}

SphereMapQuality
sphereMapQuality(const TriangleMesh & surface, const Positions & sphere, double relativeFloor)
{
  if (surface.vertices.size() != sphere.size())
  {
    std::ostringstream message;
    message << sphere.size() << " positions on the sphere for " << surface.vertices.size() << " vertices";
    throw InvalidInput(message.str());
  }
  const std::vector<double> targets = targetSolidAngles(surface, relativeFloor);
  SphereMapQuality          quality;
  quality.flippedTriangles = countFlippedTriangles(surface.triangles, sphere);
  quality.areaRatioMin = std::numeric_limits<double>::infinity();
  quality.areaRatioMax = -std::numeric_limits<double>::infinity();
  double squares = 0.0;
  for (std::size_t f = 0; f < targets.size(); ++f)
  {
    const Triangle & t = surface.triangles[f];
    const double     solidAngle = signedSolidAngle(sphere[t[0]], sphere[t[1]], sphere[t[2]]);
    const double     ratio = solidAngle / targets[f];
    quality.solidAngleSum += solidAngle;
    quality.areaRatioMin = std::min(quality.areaRatioMin, ratio);
    quality.areaRatioMax = std::max(quality.areaRatioMax, ratio);
    squares += targets[f] * (ratio - 1.0) * (ratio - 1.0);
    quality.quasiConformal += targets[f] * singularValueRatio(surface.vertices, sphere, t) / (4.0 * pi);
  }
  quality.areaRatioRms = std::sqrt(squares / (4.0 * pi));
  quality.meanAngleError = meanAngleError(surface, sphere);
  return quality;
}

bool
isBijective(const SphereMapQuality & quality)
{
  return quality.flippedTriangles == 0 && std::abs(quality.solidAngleSum - 4.0 * pi) < 1e-9;
}

} // namespace moserhex
