#pragma once

#include "moserhex/Geometry/AffineTransform.h"
#include "moserhex/HexMeshIO/FileErrors.h"

#include <string>

namespace moserhex
{

/** Whether the name ends like a transform that can be written: .tfm .txt (any case). */
[[nodiscard]] bool
isWrittenTransformName(const std::string & fileName);

/** Writes ITK's text of an affine transform of double precision, complete or not at all: transformedByFile() takes a
 * point to transform(point), to rounding. \throws BadInput (Usage)  another ending; IOError */
void
writeTransform(const std::string & fileName, const AffineTransform & transform);

} // namespace moserhex
