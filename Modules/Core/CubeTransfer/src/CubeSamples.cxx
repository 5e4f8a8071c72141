#include "moserhex/CubeTransfer/CubeSamples.h"

#include "BoxIntegrator.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Parallel.h"
#include "moserhex/CubeTransfer/CubeImage.h"

#include <algorithm>
#include <string>

namespace moserhex
{
namespace
{

constexpr std::size_t boxesPerBlock = 32;
constexpr std::size_t nodesPerBlock = 1024;
constexpr int         fewestPoints = 2; // the volume is exact from there on
constexpr int         mostPoints = 48;

CubeMeanOptions
checked(const HexMesh & mesh, const CubeMeanOptions & options, int components)
{
  requireLattice(mesh);
  if (components < 1)
  {
    throw InvalidInput("cell means: " + std::to_string(components) + " components");
  }
  if (options.pointsPerAxis < fewestPoints || options.pointsPerAxis > mostPoints)
  {
    throw InvalidInput("cell means: " + std::to_string(options.pointsPerAxis) + " points per axis, need " +
                       std::to_string(fewestPoints) + " to " + std::to_string(mostPoints));
  }
  CubeMeanOptions result = options;
  result.samplesPerAxis = options.samplesPerAxis == 0 ? mesh.nodesPerSide - 1 : options.samplesPerAxis;
  return result;
}

} // namespace

CubeMeans
cubeMeans(const HexMesh & mesh, const CubeFunction & f, int components, const CubeMeanOptions & wanted)
{
  const CubeMeanOptions options = checked(mesh, wanted, components);
  const GaussRule       rule = gaussLegendre(options.pointsPerAxis);
  CubeMeans             result;
  result.image = FieldVolume{ cubeGrid(CubeSampling::Cells, options.samplesPerAxis), components, {} };
  const BoxIntegrator integrator(mesh, f, components, options.samplesPerAxis);
  result.volumes.resize(result.image.gridVoxels());
  result.image.values.resize(result.volumes.size() * static_cast<std::size_t>(components));
  parallelForBlocks(result.volumes.size(), boxesPerBlock, options.threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t box = begin; box < end; ++box)
    {
      double * const means = result.image.at(box);
      const double   volume = integrator.addIntegral(box, rule, means);
      result.volumes[box] = volume;
      std::for_each(means, means + components, [volume](double & mean) { mean /= volume; });
    }
  });
  return result;
}

std::vector<double>
cubeVolumes(const HexMesh & mesh, const CubeMeanOptions & options)
{
  CubeMeanOptions exact = options;
  exact.pointsPerAxis = fewestPoints;
  return cubeMeans(
           mesh, [](const CubePoint &, double * values) { *values = 1.0; }, 1, exact)
    .volumes;
}

FieldVolume
cubeNodeSamples(const HexMesh & mesh, const CubeFunction & f, int components, unsigned int threads)
{
  (void)checked(mesh, {}, components);
  const CubeMap map(mesh);
  FieldVolume   result{ cubeGrid(CubeSampling::Nodes, mesh.nodesPerSide), components, {} };
  result.values.resize(mesh.nodes.size() * static_cast<std::size_t>(components));
  const auto   n = static_cast<std::size_t>(mesh.nodesPerSide);
  const double cells = mesh.nodesPerSide - 1;
  parallelForBlocks(mesh.nodes.size(), nodesPerBlock, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t node = begin; node < end; ++node)
    {
      const Vector3 index(
        static_cast<double>(node % n), static_cast<double>(node / n % n), static_cast<double>(node / (n * n)));
      f(cubePoint(mesh, map.place(index / cells)), result.at(node));
    }
  });
  return result;
}

} // namespace moserhex
