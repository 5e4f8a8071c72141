#include "moserhex/Quality/CellLabels.h"

#include "CellSamples.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Parallel.h"

#include <algorithm>
#include <map>
#include <string>

namespace moserhex
{
namespace
{

constexpr int samplesPerSide = 3;

/** The commonest, of equally common ones the smallest; 0 when there is none. */
std::int32_t
commonest(const std::map<std::int32_t, int> & counts)
{
  const auto most =
    std::max_element(counts.begin(), counts.end(), [](const auto & a, const auto & b) { return a.second < b.second; });
  return most == counts.end() ? 0 : most->first;
}

std::int32_t
labelOfCell(const HexCorners &                      corners,
            const std::vector<detail::CellSample> & samples,
            const LabelValues &                     labels,
            const detail::VoxelCoordinates &        coordinates)
{
  std::map<std::int32_t, int> counts;
  for (const detail::CellSample & sample : samples)
  {
    Vector3 point = Vector3::Zero();
    for (std::size_t corner = 0; corner < corners.size(); ++corner)
    {
      point += sample.weight[corner] * corners[corner];
    }
    const auto voxel = detail::nearestVoxel(labels, coordinates.of(point));
    if (voxel && labels.values[*voxel] != 0)
    {
      ++counts[labels.values[*voxel]];
    }
  }
  return commonest(counts);
}

} // namespace

std::vector<std::int32_t>
labelsOfCells(const HexMesh & mesh, const LabelValues & labels, unsigned int threads)
{
  requireValid(mesh);
  requireValid(labels, "labels of cells");
  if (labels.values.size() != labels.gridVoxels())
  {
    throw InvalidInput("labels of cells: " + std::to_string(labels.values.size()) + " values for " +
                       std::to_string(labels.gridVoxels()) + " voxels");
  }
  const std::vector<detail::CellSample> samples = detail::cellSamples(samplesPerSide);
  const detail::VoxelCoordinates        coordinates(labels);
  std::vector<std::int32_t>             result(mesh.cellCount());
  parallelForBlocks(result.size(), 64, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t cell = begin; cell < end; ++cell)
    {
      result[cell] = labelOfCell(cellCorners(mesh, cell), samples, labels, coordinates);
    }
  });
  return result;
}

} // namespace moserhex
