#pragma once

#include "moserhex/Geometry/TriangleMesh.h"
#include "moserhex/HexMeshIO/FileErrors.h"
#include "moserhex/HexMeshIO/ReadOptions.h"

#include <string>
#include <vector>

namespace moserhex
{

/** What readSurface made. */
struct SurfaceFile
{
  TriangleMesh             mesh;     ///< closed, oriented outwards, LPS [mm]
  std::vector<std::string> warnings; ///< what was repaired or is doubtful, one line each
};

/** Whether the name ends like a surface this reader takes: .vtk .vtp .stl .obj .ply .off (any case). */
[[nodiscard]] bool
isSurfaceName(const std::string & fileName);

/** Reads the surface of one solid: .vtk .vtp .stl .obj .ply .off, coordinates in LPS millimetres.
 *
 * A legacy .vtk whose second line, or a file of VTK whose field data, says SPACE=RAS is turned into LPS. Vertices with
 * equal coordinates are merged (STL repeats them), unused vertices dropped. With a warning: convex polygons are cut
 * into triangles, repeated and collapsed triangles removed, triangles turned to agree with their neighbours and
 * outwards; handles (genus), cavities and self-intersections are counted and left to the voxels: inside is where the
 * winding number is not zero.
 *
 * A .vtp is read by VTK, in a child process unless options say otherwise; all others by code of ours, here.
 *
 * \throws BadInput  NoInput, Empty, Format, Header, Truncated, Unsupported: missing, damaged or of another kind
 * (triangle strips, concave polygons); SurfaceNaN; SurfaceIndex; Geometry: beyond 1e6 mm; SurfaceOpen;
 *                   SurfaceNonManifold: an edge of more than two triangles, not orientable; SurfaceDegenerate: without
 *                   volume; Topology: several parts, a shell in a shell of the same orientation; SurfaceIntersects: the
 *                   volume covered and the volume by orientation differ by more than 5 %; ReaderFailed: the child died
 * \throws IOError   the file cannot be opened or read */
[[nodiscard]] SurfaceFile
readSurface(const std::string & fileName, const ReadOptions & options = {});

} // namespace moserhex
