#pragma once

#include "moserhex/Geometry/TriangleMesh.h"

#include <string>

namespace moserhex
{

/** Reads the triangles of an ASCII OFF file; colours and normals behind the numbers of a line are passed over.
 * \throws BadInput  not OFF, cut off, a number that is none, polygons other than triangles */
[[nodiscard]] TriangleMesh
readOff(const std::string & fileName);

} // namespace moserhex
