#pragma once

#include "moserhex/Geometry/HexMesh.h"
#include "moserhex/SolidMeshing/TemplateRefinement.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace moserhex
{

/** Boundary nodes of a lattice, evenly many apart in the order of boundaryNodes, and where a deformation takes them:
 * what an expert who makes no mistakes would mark.
 * \throws InvalidInput  as boundaryNodes; count 0, or more than there are boundary nodes */
[[nodiscard]] std::vector<CorrespondingPoints>
boundaryLandmarks(const HexMesh &                                   baseline,
                  const std::function<Vector3(const Vector3 & p)> & deformation,
                  std::size_t                                       count = 60);

} // namespace moserhex
