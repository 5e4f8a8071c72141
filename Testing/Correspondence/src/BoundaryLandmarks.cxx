#include "moserhex/Correspondence/BoundaryLandmarks.h"

#include "moserhex/Common/Errors.h"
#include "moserhex/Geometry/HexMeshNumbering.h"

#include <string>

namespace moserhex
{

std::vector<CorrespondingPoints>
boundaryLandmarks(const HexMesh &                                   baseline,
                  const std::function<Vector3(const Vector3 & p)> & deformation,
                  std::size_t                                       count)
{
  const std::vector<std::size_t> nodes = boundaryNodes(baseline);
  if (count == 0 || count > nodes.size())
  {
    throw InvalidInput("boundary landmarks: " + std::to_string(count) + " of " + std::to_string(nodes.size()) +
                       " boundary nodes");
  }
  std::vector<CorrespondingPoints> landmarks;
  for (std::size_t l = 0; l < count; ++l)
  {
    const Vector3 & place = baseline.nodes[nodes[(2 * l + 1) * nodes.size() / (2 * count)]];
    landmarks.push_back({ place, deformation(place) });
  }
  return landmarks;
}

} // namespace moserhex
