#pragma once

#include "moserhex/Geometry/HexMesh.h"
#include "moserhex/HexMeshIO/FileErrors.h"

#include <cstdint>
#include <string>
#include <vector>

namespace moserhex
{

/** What is written beside the mesh. LatticeIndex (node), Shell and VolumeRatio (cell) are always there. */
struct HexMeshFields
{
  std::vector<double> scaledJacobian;  ///< per cell, written as ScaledJacobian; empty: left out
  Positions           cubeCoordinates; ///< per node on [-1,1]^3, written as CubeCoordinate; empty: left out

  std::vector<std::int32_t> label; ///< per cell, written as Label; empty: left out
};

struct HexMeshWriterOptions
{
  bool spaceTag{ true }; ///< .vtu only: field array SPACE = "LPS", which Slicer wants and meshio does not read
};

/** Whether the name ends with .vtu or .vtk (any case). */
[[nodiscard]] bool
isHexMeshName(const std::string & fileName);

/** Writes a mesh as .vtu (appended, zlib) or legacy .vtk (version 4.2, binary, SPACE=LPS in its second line, neither
 * METADATA nor string arrays), complete or not at all.
 *
 * Point data: LatticeIndex (i,j,k). Cell data: Shell (N outermost), VolumeRatio, and what `fields` adds. Coordinates
 * are doubles in LPS millimetres. The file is read back and compared (nodes, connectivity, coordinates to the last
 * bit) before it gets its name. The same mesh gives the same bytes.
 *
 * \throws InvalidInput  sizes do not fit, a coordinate is not finite, or the mean cell volume is not positive
 * \throws BadInput      the name ends with neither .vtu nor .vtk
 * \throws IOError       the file cannot be written (disk full, no permission) or reads back differently */
void
writeHexMesh(const std::string &          fileName,
             const HexMesh &              mesh,
             const HexMeshFields &        fields = {},
             const HexMeshWriterOptions & options = {});

} // namespace moserhex
