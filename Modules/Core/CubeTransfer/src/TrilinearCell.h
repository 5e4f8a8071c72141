#pragma once

#include "moserhex/Geometry/HexMesh.h"

#include <optional>

namespace moserhex
{

/** x(xi) = sum_a N_a(xi) x_a. Blended along xi, then eta, then zeta, so that the corners, and what two cells say of a
 * common face, are the same to the last bit. */
[[nodiscard]] Vector3
trilinear(const HexCorners & corners, const Vector3 & xi);

/** dx/dxi, dx/deta, dx/dzeta in the columns. */
[[nodiscard]] Matrix3
trilinearTangents(const HexCorners & corners, const Vector3 & xi);

/** Where in [0,1]^3 a point lies in a cell; see CubeMap::find. Nothing when it is farther than `tolerance` [mm] away
 * from every point of the cell that was found. */
[[nodiscard]] std::optional<Vector3>
trilinearInverse(const HexCorners & corners, const Vector3 & p, double tolerance);

} // namespace moserhex
