#pragma once

#include "moserhex/Geometry/TriangleMesh.h"
#include "moserhex/HexMeshIO/ReadOptions.h"

#include <cstddef>
#include <string>

namespace moserhex
{

/** What a file says, nothing welded or turned: finite coordinates, indices in range, possibly open or empty. */
struct RawSurface
{
  TriangleMesh mesh;
  std::size_t  splitPolygons{ 0 }; ///< convex polygons of more than three corners, cut into triangles
  bool         isRas{ false };     ///< the coordinates are RAS instead of LPS
};

constexpr const char * exportSurfaceAgain = "export the surface again";

// One reader per format, each in a file of its own, for a file that is there (requireReadableFile). None trusts a
// count, an index or a number of the file. All throw BadInput: Format for what is not of the format, Header for one
// that contradicts itself, Truncated, Unsupported, Empty, SurfaceNaN, SurfaceIndex.

[[nodiscard]] RawSurface
readStl(const std::string & fileName);

[[nodiscard]] RawSurface
readObj(const std::string & fileName);

[[nodiscard]] RawSurface
readPly(const std::string & fileName);

[[nodiscard]] RawSurface
readOff(const std::string & fileName);

/** Legacy files, versions 1 to 5. */
[[nodiscard]] RawSurface
readVtk(const std::string & fileName);

/** By VTK's reader. */
[[nodiscard]] RawSurface
readVtp(const std::string & fileName);

/** By the name's ending. \throws BadInput as the readers, and when the file is missing or of another kind */
[[nodiscard]] RawSurface
readRawSurface(const std::string & fileName, const ReadOptions & options = {});

} // namespace moserhex
