#include "moserhex/SolidMeshing/ShellFrames.h"

#include "moserhex/Common/Errors.h"
#include "moserhex/Geometry/ClosestPoint.h"
#include "moserhex/SphericalMap/FrameAlignment.h"

#include <string>

namespace moserhex
{

void
alignShellFramesInPlace(const std::vector<TriangleMesh> & shells, std::vector<Positions> & maps)
{
  if (shells.size() != maps.size())
  {
    throw InvalidInput(std::to_string(shells.size()) + " shells but " + std::to_string(maps.size()) + " maps");
  }
  for (std::size_t k = shells.size(); k-- > 1;)
  {
    const TriangleMesh &     outer = shells[k];
    const TriangleMesh &     inner = shells[k - 1];
    const ClosestPointSearch search(outer);
    Positions                reference;
    reference.reserve(inner.vertices.size());
    for (const Vector3 & vertex : inner.vertices)
    {
      const ClosestPointOnSurface closest = search.closest(vertex);
      const Triangle &            t = outer.triangles[closest.triangle];
      const Vector3 direction = closest.barycentric[0] * maps[k][t[0]] + closest.barycentric[1] * maps[k][t[1]] +
                                closest.barycentric[2] * maps[k][t[2]];
      reference.push_back(direction.normalized());
    }
    maps[k - 1] = rotated(maps[k - 1], referenceFrameRotation(inner, maps[k - 1], reference));
  }
}

} // namespace moserhex
