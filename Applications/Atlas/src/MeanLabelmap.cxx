#include "MeanLabelmap.h"

#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Parallel.h"
#include "moserhex/CubeTransfer/CubeMap.h"
#include "moserhex/Geometry/TriangleMesh.h"

#include <cmath>
#include <string>

namespace moserhex::app
{
namespace
{

constexpr int margin = 2;
constexpr int mostVoxels = 1024;

LabelVolume
gridAround(const HexMesh & mesh, double spacing)
{
  const BoundingBox box = boundingBox(mesh.nodes);
  LabelVolume       grid;
  grid.spacing.setConstant(spacing);
  for (Eigen::Index axis = 0; axis < 3; ++axis)
  {
    const double first = std::floor(box.lower[axis] / spacing) - margin; // centres at multiples of the spacing
    const double last = std::ceil(box.upper[axis] / spacing) + margin;
    if (!(last - first < mostVoxels))
    {
      throw InvalidInput("labelmap of the mean: more than " + std::to_string(mostVoxels) + " voxels along an axis");
    }
    grid.origin[axis] = first * spacing;
    grid.size[static_cast<std::size_t>(axis)] = static_cast<int>(last - first) + 1;
  }
  grid.inside.assign(grid.gridVoxels(), 0);
  return grid;
}

} // namespace

LabelVolume
voxelised(const HexMesh & mesh, double spacing, unsigned int threads)
{
  const CubeMap map(mesh);
  LabelVolume   labels = gridAround(mesh, spacing);
  parallelFor(static_cast<std::size_t>(labels.size[2]), threads, [&](std::size_t slice) {
    const int k = static_cast<int>(slice);
    for (int j = 0; j < labels.size[1]; ++j)
    {
      for (int i = 0; i < labels.size[0]; ++i)
      {
        labels.inside[labels.voxelNumber(i, j, k)] = map.find(labels.point(i, j, k)) ? 1 : 0;
      }
    }
  });
  return labels;
}

} // namespace moserhex::app
