#pragma once

#include "moserhex/Geometry/TriangleMesh.h"

namespace moserhex
{

/** Signed solid angle of the spherical triangle (a, b, c) with unit corners [sr]:
 *
 *   Omega = 2 atan2(N, D),   N = a . (b x c),   D = 1 + a.b + b.c + c.a        (Van Oosterom and Strackee)
 *
 * Positive when counter-clockwise seen from outside. */
[[nodiscard]] double
signedSolidAngle(const Vector3 & a, const Vector3 & b, const Vector3 & c);

/** Triangles with a . (b x c) <= 0, or not finite. */
[[nodiscard]] int
countFlippedTriangles(const std::vector<Triangle> & triangles, const Positions & sphere);

/** Solid angle every triangle should take: in proportion to its area, sum 4 pi, nF [sr].
 *
 * No triangle is asked for less than relativeFloor of the mean: a triangle of zero area would have to vanish.
 * \throws InvalidInput when the surface has no area or a position is not finite */
[[nodiscard]] std::vector<double>
targetSolidAngles(const TriangleMesh & surface, double relativeFloor = 1e-3);

/** The same for areas given directly. */
[[nodiscard]] std::vector<double>
targetSolidAngles(std::vector<double> areas, double relativeFloor);

/** How good a map of a closed surface to the unit sphere is. Area ratio r_f = solid angle / target solid angle. */
struct SphereMapQuality
{
  int    flippedTriangles{ 0 }; ///< determinant of the corners not positive
  double solidAngleSum{ 0.0 };  ///< 4 pi when the map covers the sphere once [sr]
  double areaRatioRms{ 0.0 };   ///< sqrt(sum T_f (r_f - 1)^2 / 4 pi) over triangles [1]
  double areaRatioMin{ 0.0 };   ///< [1]
  double areaRatioMax{ 0.0 };   ///< [1]
  double meanAngleError{ 0.0 }; ///< mean over corners of |angle on the sphere's chords - angle on the surface| [deg]
  double quasiConformal{ 0.0 }; ///< area-weighted mean of sigma_1 / sigma_2 of the map, 1 when conformal [1]
};

/** relativeFloor: see targetSolidAngles. \throws InvalidInput when the sizes differ or the surface has no area */
[[nodiscard]] SphereMapQuality
sphereMapQuality(const TriangleMesh & surface, const Positions & sphere, double relativeFloor = 1e-3);

/** No flipped triangle and solid angles that sum to 4 pi within 1e-9: one-to-one onto the sphere. */
[[nodiscard]] bool
isBijective(const SphereMapQuality & quality);

} // namespace moserhex
