#pragma once

#include "moserhex/Common/Types.h"

#include <functional>

namespace moserhex
{

/** Maps a point near the organ's surface to the nearest point on it [mm]. Boundary nodes slide through it: a node is
 * moved freely and then put back. An empty function means "leave the point where it is".
 *
 * Must be a pure function of the point, so that results do not depend on the order of the calls, and safe to call from
 * several threads at once. */
using SurfaceProjection = std::function<Vector3(const Vector3 &)>;

} // namespace moserhex
