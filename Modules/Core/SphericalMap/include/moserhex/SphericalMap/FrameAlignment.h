#pragma once

#include "moserhex/Geometry/TriangleMesh.h"

namespace moserhex
{

/** The rotation R that maximises sum_i w_i (R from_i) . to_i (Kabsch). det R = +1 always.
 * \throws InvalidInput when the sizes differ, nothing is given, or a number is not finite */
[[nodiscard]] Matrix3
bestRotation(const Positions & from, const Positions & to, const std::vector<double> & weights);

/** The rotation that makes directions on the sphere match directions in the body in the least-squares sense:
 * `from` are the centres of the spherical triangles, `to` the directions of the triangles from the surface's centroid,
 * weights the triangles' areas on the surface. So a rotated body has the same map, rotated.
 * \throws InvalidInput when the sizes differ */
[[nodiscard]] Matrix3
bodyFrameRotation(const TriangleMesh & surface, const Positions & sphere);

/** The rotation that makes a shell's map match a reference map (the next shell's): `referenceDirections` holds, for
 * each vertex of `surface`, the direction that the reference map gives to the corresponding place. Weights: lumped
 * areas. \throws InvalidInput when the sizes differ */
[[nodiscard]] Matrix3
referenceFrameRotation(const TriangleMesh & surface, const Positions & sphere, const Positions & referenceDirections);

/** R s for every position, scaled back to length 1. */
[[nodiscard]] Positions
rotated(const Positions & sphere, const Matrix3 & rotation);

} // namespace moserhex
