#pragma once

#include "moserhex/Common/Types.h"

namespace moserhex
{

/** Equal-area map of the surface of the cube [-1,1]^3 onto the unit sphere, in closed form.
 *
 * Rosca and Plonka, "Uniform spherical grids via equal area projection from the cube to the sphere", J. Comput. Appl.
 * Math. 236 (2011). A face of the cube goes to the Lambert azimuthal disk region of its sixth of the sphere,
 *
 *   for |y| <= |x|:  alpha = pi y / (12 x),   s = 2^(1/4) / sqrt(sqrt 2 - cos alpha),
 *                    X = s x (sqrt 2 cos alpha - 1),   Y = s x sqrt 2 sin alpha
 *   (x and y exchanged where |y| > |x|),   X^2 + Y^2 = 2 (1 - height above the centre of the sphere),
 *
 * and from there to the sphere by Lambert's inverse projection about the face's axis. Every part of the cube's surface
 * of area a goes to a part of the sphere of area a (4 pi) / 24. The map commutes with the 48 symmetries of the cube,
 * sends edges to great-circle arcs, is continuous, and smooth inside the 24 triangles between a face's centre and its
 * edges.
 *
 * \param point  a point on the cube's surface: largest absolute coordinate 1 within 1e-9
 * \return a unit vector
 * \throws InvalidInput  the point is not on the surface of [-1,1]^3 */
[[nodiscard]] Vector3
cubeToSphere(const Vector3 & point);

/** Inverse of cubeToSphere. The argument is normalised first; its length must be finite and positive.
 *
 * \return the point of the surface of [-1,1]^3, largest absolute coordinate exactly 1
 * \throws InvalidInput  zero or not finite */
[[nodiscard]] Vector3
sphereToCube(const Vector3 & direction);

} // namespace moserhex
