#pragma once

#include "moserhex/CubeTransfer/ImageFunction.h"
#include "moserhex/Geometry/RigidAlignment.h"

#include <string>

namespace moserhex::python
{

/** \throws InvalidInput (Usage)  negative, or more than 1024 */
[[nodiscard]] unsigned int
threadsFrom(long long threads);

/** "linear" or "nearest". \throws InvalidInput (Usage) */
[[nodiscard]] ImageInterpolation
interpolationFrom(const std::string & name);

/** "none", "rigid" or "similarity". \throws InvalidInput (Usage) */
[[nodiscard]] AlignmentKind
alignmentFrom(const std::string & name);

} // namespace moserhex::python
