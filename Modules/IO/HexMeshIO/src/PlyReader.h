#pragma once

#include "moserhex/Geometry/TriangleMesh.h"

#include <string>

namespace moserhex
{

/** Reads the triangles of a PLY file: ASCII, binary little endian or big endian; properties and elements it has no use
 * for are passed over. VTK 9.1's own reader overruns memory on damaged files.
 * \throws BadInput  not PLY, cut off, a number that is none, polygons other than triangles */
[[nodiscard]] TriangleMesh
readPly(const std::string & fileName);

} // namespace moserhex
