#pragma once

#include "moserhex/Geometry/TriangleMesh.h"
#include "moserhex/HexMeshIO/FileErrors.h"

#include <string>

namespace moserhex
{

/** Whether the name ends like a surface this reader takes: .vtk .vtp .stl .obj .ply .off (any case). */
[[nodiscard]] bool
isSurfaceName(const std::string & fileName);

/** Reads a closed triangle surface: .vtk .vtp .stl .obj .ply .off, coordinates in LPS millimetres.
 *
 * A legacy .vtk whose second line, or a .vtp whose field data, says SPACE=RAS is turned into LPS. Vertices with equal
 * coordinates are merged (STL repeats them), unused vertices dropped. A surface that is closed and consistently
 * oriented inwards is turned outwards.
 *
 * \throws BadInput  missing or damaged file; polygons other than triangles; non-finite coordinates; an index out of
 *                   range; open, non-manifold or inconsistently oriented; empty or without volume
 * \throws IOError   the file cannot be opened or read */
[[nodiscard]] TriangleMesh
readSurface(const std::string & fileName);

} // namespace moserhex
