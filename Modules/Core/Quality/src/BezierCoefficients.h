#pragma once

#include "moserhex/Geometry/HexMesh.h"

namespace moserhex
{

/** 64 eps times the product of the lengths of the four edges along each axis, taken as one vector: bounds the rounding
 * of every coefficient, subdivision included. Not a number when a coordinate is not. */
[[nodiscard]] double
roundingOfCoefficients(const HexCorners & x);

} // namespace moserhex
