#pragma once

#include "moserhex/Geometry/TriangleMesh.h"
#include "moserhex/Geometry/UnstructuredHexMesh.h"

#include <vector>

namespace moserhex
{

/** Quadrilaterals as four triangles each around the mean of their corners. Vertices 5 q to 5 q + 3 are the corners of
 * quadrilateral q and 5 q + 4 is their mean, so neighbours share none; triangle 4 q + s has the corners s and s + 1
 * (modulo 4) and the mean. \param positionOf  (std::size_t node) -> Vector3 */
template <typename TPositionOf>
[[nodiscard]] TriangleMesh
quadFans(const std::vector<Quadrilateral> & quads, const TPositionOf & positionOf)
{
  TriangleMesh surface;
  for (const Quadrilateral & quad : quads)
  {
    const auto first = static_cast<VertexIndex>(surface.vertices.size());
    Vector3    mean = Vector3::Zero();
    for (const std::size_t node : quad)
    {
      surface.vertices.push_back(positionOf(node));
      mean += 0.25 * surface.vertices.back();
    }
    surface.vertices.push_back(mean);
    for (VertexIndex side = 0; side < 4; ++side)
    {
      surface.triangles.push_back({ first + side, first + (side + 1) % 4, first + 4 });
    }
  }
  return surface;
}

} // namespace moserhex
