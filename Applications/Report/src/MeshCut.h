#pragma once

#include "moserhex/Geometry/HexMesh.h"

#include <array>
#include <map>
#include <vector>

namespace moserhex::app
{

/** A plane across one axis of the patient. */
struct CutPlane
{
  int    axis{ 0 };    ///< 0 sagittal (x), 1 coronal (y), 2 axial (z)
  double place{ 0.0 }; ///< [mm]
};

/** Lines in the plane, the coordinate along the axis left out: (y,z), (x,z) or (x,y) [mm]. */
using PlanePoint = std::array<double, 2>;
using PlaneLine = std::vector<PlanePoint>;

/** Where the faces of a mesh's cells meet a plane. A face is two triangles. */
struct MeshCut
{
  std::vector<PlaneLine>                boundary; ///< faces of one cell only
  std::map<int, std::vector<PlaneLine>> shells;   ///< faces between shells s and s + 1, by s
  std::vector<PlaneLine>                inner;    ///< all other faces
};

/** Lines are chained as far as they go; a closed one ends with its first point. The same mesh gives the same lines. */
[[nodiscard]] MeshCut
cutMesh(const HexMesh & mesh, const CutPlane & plane);

} // namespace moserhex::app
