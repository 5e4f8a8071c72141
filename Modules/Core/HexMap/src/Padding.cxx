#include "moserhex/HexMap/Padding.h"

#include "LatticeNodes.h"
#include "moserhex/Common/Errors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace moserhex
{
namespace
{

/** Mean over the cells of a minimised mesh at which it is left at that. What makes the mesh exact takes up to 0.01 of
 * it [1]. */
constexpr double enoughScaledJacobian = 0.91;

/** The lattice's map at a point of [0, n-1]^3. */
Vector3
positionAt(const HexMesh & lattice, const Vector3 & point)
{
  std::array<int, 3> first;
  Vector3            part;
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto a = static_cast<std::size_t>(axis);
    first[a] = std::min(std::max(static_cast<int>(std::floor(point[axis])), 0), lattice.nodesPerSide - 2);
    part[axis] = point[axis] - first[a];
  }
  Vector3 position = Vector3::Zero();
  for (int corner = 0; corner < 8; ++corner)
  {
    const std::array<int, 3> step{ corner & 1, corner >> 1 & 1, corner >> 2 };
    double                   weight = 1.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      weight *= step[static_cast<std::size_t>(axis)] == 1 ? part[axis] : 1.0 - part[axis];
    }
    position += weight * lattice.nodes[lattice.nodeNumber(first[0] + step[0], first[1] + step[1], first[2] + step[2])];
  }
  return position;
}

} // namespace

HexMesh
padded(const HexMesh & lattice, int layers)
{
  requireLattice(lattice);
  if (layers < 0)
  {
    throw InvalidInput("padding: " + std::to_string(layers) + " layers, need at least 0");
  }
  const int     n = lattice.nodesPerSide;
  HexMesh       mesh{ n, {}, layers };
  const Vector3 centre = Vector3::Constant(0.5 * (n - 1));
  const auto    cells = static_cast<double>(mesh.cellCount());
  mesh.nodes.reserve(nodeCount(n, layers));
  for (int layer = 0; layer <= layers; ++layer)
  {
    const double scale = std::cbrt(static_cast<double>(HexMesh{ n, {}, layer }.cellCount()) / cells);
    lattice::forEachNode(n, [&](const lattice::Index3 & at, std::size_t) {
      if (layer == 0 || lattice::isBoundary(n, at))
      {
        mesh.nodes.push_back(positionAt(lattice, centre + scale * (Vector3(at[0], at[1], at[2]) - centre)));
      }
    });
  }
  return mesh;
}

EqualisationOptions
paddingOptions(EqualisationOptions options, PaddingAngles angles)
{
  const bool              isStrong = angles == PaddingAngles::Strong;
  const EqualisationStage settling{ 0.02, 50.0, 80.0, 90, 1, isStrong ? 40.0 : 20.0 };
  options.nodesPerSide = 0;
  options.directStages = { { 0.05, 20.0, 80.0, 60, 1, 0.0 }, settling };
  if (isStrong)
  {
    EqualisationStage longer = settling;
    longer.maximumSteps = 400;
    longer.enoughScaledJacobian = enoughScaledJacobian;
    options.directStages.insert(options.directStages.end(), { longer, longer });
  }
  options.angleWeight = isStrong ? 60.0 : 0.0;
  options.polishRounds = 16;
  options.narrowScaledJacobian = 0.3;
  return options;
}

} // namespace moserhex
