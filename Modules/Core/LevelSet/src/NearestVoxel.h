#pragma once

#include "moserhex/LevelSet/VoxelGrid.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace moserhex
{

/** For every voxel the number of the marked voxel whose centre is nearest [mm]; its own number where it is marked, and
 * where none is. One of those equally near, the same for any number of threads. O(voxels), anisotropic spacing
 * included. \param marks  1 for each marked voxel of the grid, else 0 */
[[nodiscard]] std::vector<std::size_t>
nearestMarkedVoxel(const VoxelGrid & grid, const std::vector<std::uint8_t> & marks, unsigned int threads = 0);

} // namespace moserhex
