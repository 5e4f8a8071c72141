#include "moserhex/CubeTransfer/GridSamples.h"

#include "moserhex/Common/Parallel.h"

#include <numeric>

namespace moserhex
{

GridSamples
gridSamples(const CubeMap &            map,
            const HexMesh &            mesh,
            const CubeFunction &       f,
            int                        components,
            const VoxelGrid &          grid,
            const GridSamplesOptions & options)
{
  requireValid(grid, "grid");
  GridSamples result{ FieldVolume{ grid, components, {} }, 0 };
  result.image.values.assign(grid.gridVoxels() * static_cast<std::size_t>(components), options.background);
  const auto               rows = static_cast<std::size_t>(grid.size[1]) * static_cast<std::size_t>(grid.size[2]);
  std::vector<std::size_t> inside(rows, 0);
  parallelForBlocks(rows, 1, options.threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row)
    {
      const int j = static_cast<int>(row % static_cast<std::size_t>(grid.size[1]));
      const int k = static_cast<int>(row / static_cast<std::size_t>(grid.size[1]));
      for (int i = 0; i < grid.size[0]; ++i)
      {
        if (const auto place = map.find(grid.point(i, j, k)))
        {
          f(cubePoint(mesh, *place), result.image.at(grid.voxelNumber(i, j, k)));
          ++inside[row];
        }
      }
    }
  });
  result.inside = std::accumulate(inside.begin(), inside.end(), std::size_t{ 0 });
  return result;
}

} // namespace moserhex
