#pragma once

#include "SurfaceFormats.h"
#include "moserhex/HexMeshIO/SurfaceReader.h"

#include <string>

namespace moserhex
{

/** A file's triangles as the boundary of one solid in LPS, outwards: welded, rid of repetitions, its triangles turned
 * to agree; every change is a warning. \throws BadInput  as readSurface about what cannot be repaired */
[[nodiscard]] SurfaceFile
checkedSurface(const std::string & fileName, RawSurface raw);

} // namespace moserhex
