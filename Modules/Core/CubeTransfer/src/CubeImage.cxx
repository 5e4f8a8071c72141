#include "moserhex/CubeTransfer/CubeImage.h"

#include "moserhex/Common/Errors.h"

#include <string>

namespace moserhex
{
namespace
{

constexpr int mostSamples = 1000;

bool
isSameGrid(const VoxelGrid & a, const VoxelGrid & b)
{
  constexpr double tolerance = 1e-6;
  return a.size == b.size && (a.spacing - b.spacing).cwiseAbs().maxCoeff() <= tolerance * b.spacing.minCoeff() &&
         (a.origin - b.origin).cwiseAbs().maxCoeff() <= tolerance * b.spacing.minCoeff() &&
         (a.direction - b.direction).cwiseAbs().maxCoeff() <= tolerance;
}

} // namespace

VoxelGrid
cubeGrid(CubeSampling sampling, int samplesPerAxis)
{
  const int fewest = sampling == CubeSampling::Nodes ? 2 : 1;
  if (samplesPerAxis < fewest || samplesPerAxis > mostSamples)
  {
    throw InvalidInput("image of the cube: " + std::to_string(samplesPerAxis) + " samples per axis, need " +
                       std::to_string(fewest) + " to " + std::to_string(mostSamples));
  }
  VoxelGrid grid;
  grid.size = { { samplesPerAxis, samplesPerAxis, samplesPerAxis } };
  if (sampling == CubeSampling::Nodes)
  {
    grid.spacing.setConstant(1.0 / (samplesPerAxis - 1));
    return grid;
  }
  grid.spacing.setConstant(1.0 / samplesPerAxis);
  grid.origin.setConstant(0.5 / samplesPerAxis);
  return grid;
}

CubeSampling
cubeSamplingOf(const VoxelGrid & grid)
{
  const int samples = grid.size[0];
  for (const CubeSampling sampling : { CubeSampling::Cells, CubeSampling::Nodes })
  {
    const int fewest = sampling == CubeSampling::Nodes ? 2 : 1;
    if (samples >= fewest && samples <= mostSamples && isSameGrid(grid, cubeGrid(sampling, samples)))
    {
      return sampling;
    }
  }
  throw InvalidInput("not an image of the cube: need N x N x N voxels that fill [0,1]^3, axes along LPS");
}

} // namespace moserhex
