#pragma once

#include "moserhex/Common/Types.h"

#include <functional>

namespace moserhex
{

/** Signed distance to the organ's surface, negative inside [mm], or any function that is close to it near the surface.
 * Positive everywhere outside. Writes the gradient [1], whose length should be near 1 near the surface; elsewhere it
 * may be anything finite.
 *
 * Must be a pure function of the point, and safe to call from several threads at once. */
using SignedDistance = std::function<double(const Vector3 & point, Vector3 & gradient)>;

} // namespace moserhex
