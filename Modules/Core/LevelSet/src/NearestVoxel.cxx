#include "NearestVoxel.h"

#include "LowerEnvelope.h"
#include "moserhex/Common/Parallel.h"

#include <limits>

namespace moserhex
{
namespace
{

constexpr std::size_t linesPerBlock = 64;

/** Where the nearest marked voxel is, as far as the axes that were looked along tell. */
struct Nearest
{
  std::vector<std::size_t> voxel;
  std::vector<double>      squaredDistance;
};

void
lookAlong(Nearest & nearest, const VoxelGrid & grid, std::size_t axis, unsigned int threads)
{
  const auto        length = static_cast<std::size_t>(grid.size[axis]);
  const std::size_t strides[3] = { 1, grid.voxelNumber(0, 1, 0), grid.voxelNumber(0, 0, 1) };
  const std::size_t stride = strides[axis];
  parallelForBlocks(grid.gridVoxels() / length, linesPerBlock, threads, [&](std::size_t begin, std::size_t end) {
    LowerEnvelope            envelope(length, grid.spacing[static_cast<int>(axis)]);
    std::vector<std::size_t> voxels(length); // as they were
    for (std::size_t line = begin; line < end; ++line)
    {
      const std::size_t first = line % stride + line / stride * stride * length;
      envelope.clear();
      for (std::size_t q = 0; q < length; ++q)
      {
        voxels[q] = nearest.voxel[first + q * stride];
        envelope.add(static_cast<int>(q), nearest.squaredDistance[first + q * stride]);
      }
      envelope.evaluate(0, static_cast<int>(length), [&](int q, int apex, double value) {
        const std::size_t voxel = first + static_cast<std::size_t>(q) * stride;
        nearest.voxel[voxel] = voxels[static_cast<std::size_t>(apex)];
        nearest.squaredDistance[voxel] = value;
      });
    }
  });
}

} // namespace

std::vector<std::size_t>
nearestMarkedVoxel(const VoxelGrid & grid, const std::vector<std::uint8_t> & marks, unsigned int threads)
{
  Nearest nearest;
  for (std::size_t voxel = 0; voxel < marks.size(); ++voxel)
  {
    nearest.voxel.push_back(voxel);
    nearest.squaredDistance.push_back(marks[voxel] != 0 ? 0.0 : std::numeric_limits<double>::infinity());
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    lookAlong(nearest, grid, axis, threads);
  }
  return nearest.voxel;
}

} // namespace moserhex
