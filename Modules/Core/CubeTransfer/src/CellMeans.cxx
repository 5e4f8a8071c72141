#include "moserhex/CubeTransfer/CellMeans.h"

#include "moserhex/Common/Parallel.h"
#include "moserhex/CubeTransfer/CubeSamples.h"

namespace moserhex
{
namespace
{

constexpr std::size_t nodesPerBlock = 1024;

} // namespace

std::vector<double>
cellMeans(const HexMesh & mesh, const SpaceFunction & f, const CellMeanOptions & options)
{
  const auto    ofPosition = [&f](const CubePoint & point, double * value) { *value = f(point.position); };
  constexpr int ownCells = 0;
  return cubeMeans(mesh, ofPosition, 1, { ownCells, options.pointsPerAxis, options.threads }).image.values;
}

std::vector<double>
nodeSamples(const HexMesh & mesh, const SpaceFunction & f, unsigned int threads)
{
  requireLattice(mesh);
  std::vector<double> samples(mesh.nodes.size());
  parallelForBlocks(samples.size(), nodesPerBlock, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t node = begin; node < end; ++node)
    {
      samples[node] = f(mesh.nodes[node]);
    }
  });
  return samples;
}

} // namespace moserhex
