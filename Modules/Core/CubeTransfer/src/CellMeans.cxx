#include "moserhex/CubeTransfer/CellMeans.h"

#include "TrilinearCell.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Parallel.h"
#include "moserhex/Numerics/GaussLegendre.h"

#include <Eigen/LU>

#include <string>

namespace moserhex
{
namespace
{

constexpr std::size_t cellsPerBlock = 32;
constexpr std::size_t nodesPerBlock = 1024;
constexpr int         fewestPoints = 2; // the volume is exact from there on
constexpr int         mostPoints = 48;

double
meanOfCell(const HexCorners & corners, const SpaceFunction & f, const GaussRule & rule)
{
  double sum = 0.0;
  double volume = 0.0;
  for (std::size_t c = 0; c < rule.weights.size(); ++c)
  {
    for (std::size_t b = 0; b < rule.weights.size(); ++b)
    {
      for (std::size_t a = 0; a < rule.weights.size(); ++a)
      {
        const Vector3 xi(rule.abscissae[a], rule.abscissae[b], rule.abscissae[c]);
        const double  weight =
          rule.weights[a] * rule.weights[b] * rule.weights[c] * trilinearTangents(corners, xi).determinant();
        sum += weight * f(trilinear(corners, xi));
        volume += weight;
      }
    }
  }
  return sum / volume;
}

} // namespace

std::vector<double>
cellMeans(const HexMesh & mesh, const SpaceFunction & f, const CellMeanOptions & options)
{
  requireLattice(mesh);
  if (options.pointsPerAxis < fewestPoints || options.pointsPerAxis > mostPoints)
  {
    throw InvalidInput("cell means: " + std::to_string(options.pointsPerAxis) + " points per axis, need " +
                       std::to_string(fewestPoints) + " to " + std::to_string(mostPoints));
  }
  const GaussRule     rule = gaussLegendre(options.pointsPerAxis);
  std::vector<double> means(mesh.cellCount());
  parallelForBlocks(means.size(), cellsPerBlock, options.threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t cell = begin; cell < end; ++cell)
    {
      const HexCorners corners = cellCorners(mesh, cell);
      if (!(hexVolume(corners) > 0.0))
      {
        throw InvalidInput("cell means: cell " + std::to_string(cell) + " has no positive volume");
      }
      means[cell] = meanOfCell(corners, f, rule);
    }
  });
  return means;
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
