#pragma once

#include "moserhex/Common/Types.h"

namespace moserhex
{

/** The rotation part R of a Jacobian J = dx/dc = R U, U symmetric and positive (polar decomposition): the cube's axes
 * as they stand in a place of the mesh, apart from its stretching and shearing. \pre det J > 0 */
[[nodiscard]] Matrix3
rotationPart(const Matrix3 & jacobian);

/** Whether an image of so many components can be turned: vectors (3), symmetric tensors (6). */
[[nodiscard]] constexpr bool
canBeTurned(int components)
{
  return components == 3 || components == 6;
}

/** A vector or a symmetric tensor (xx, xy, xz, yy, yz, zz), turned in place: R v, or R T R^T. With R = rotationPart(J)
 * from the cube's axes to LPS, with its transpose from LPS to the cube's axes. \pre canBeTurned(components) */
void
turn(const Matrix3 & rotation, int components, double * values);

} // namespace moserhex
