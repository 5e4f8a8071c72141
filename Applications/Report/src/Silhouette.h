#pragma once

#include "moserhex/Geometry/HexMesh.h"

#include <string>

namespace moserhex::app
{

/** The outline of a mesh seen from the front, as "x,z x,z ...": a closed polygon of LPS coordinates in mm, rounded to
 * 0.1, of some dozen points. It is right within a fiftieth of the mesh's larger extent; holes in the picture are left
 * out, and so are parts that are thinner than a hundredth of it. Empty where nothing is left. The same mesh gives the
 * same text. */
[[nodiscard]] std::string
silhouette(const HexMesh & mesh);

} // namespace moserhex::app
