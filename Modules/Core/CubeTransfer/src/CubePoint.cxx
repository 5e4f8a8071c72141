#include "moserhex/CubeTransfer/CubePoint.h"

#include "TrilinearCell.h"

namespace moserhex
{

CubePoint
cubePoint(const HexMesh & mesh, const CubePlace & place)
{
  const auto       m = static_cast<std::size_t>(mesh.nodesPerSide - 1);
  const Vector3    index(static_cast<double>(place.cell % m),
                      static_cast<double>(place.cell / m % m),
                      static_cast<double>(place.cell / (m * m)));
  const auto       cells = static_cast<double>(m);
  const HexCorners corners = cellCorners(mesh, place.cell);
  return { (index + place.local) / cells,
           trilinear(corners, place.local),
           trilinearTangents(corners, place.local) * cells };
}

} // namespace moserhex
