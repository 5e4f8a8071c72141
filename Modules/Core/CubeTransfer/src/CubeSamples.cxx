#include "moserhex/CubeTransfer/CubeSamples.h"

#include "CubeParts.h"
#include "TrilinearCell.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Parallel.h"
#include "moserhex/CubeTransfer/CubeImage.h"
#include "moserhex/Numerics/GaussLegendre.h"

#include <Eigen/LU>

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

/** Calls visit(point, weight) for the Gauss points of a part of a cell, weights times det J [mm^3]. */
template <typename TVisit>
void
forGaussPoints(const HexMesh &   mesh,
               std::size_t       cell,
               const Vector3 &   lower,
               const Vector3 &   sides,
               const GaussRule & rule,
               const TVisit &    visit)
{
  const double     cells = mesh.nodesPerSide - 1;
  const HexCorners corners = cellCorners(mesh, cell);
  const Vector3    index = cubePoint(mesh, { cell, Vector3::Zero() }).cube * cells;
  for (std::size_t c = 0; c < rule.weights.size(); ++c)
  {
    for (std::size_t b = 0; b < rule.weights.size(); ++b)
    {
      for (std::size_t a = 0; a < rule.weights.size(); ++a)
      {
        const Vector3 xi = lower + sides.cwiseProduct(Vector3(rule.abscissae[a], rule.abscissae[b], rule.abscissae[c]));
        const Matrix3 tangents = trilinearTangents(corners, xi);
        const double  weight =
          rule.weights[a] * rule.weights[b] * rule.weights[c] * sides.prod() * tangents.determinant();
        visit(CubePoint{ (index + xi) / cells, trilinear(corners, xi), tangents * cells }, weight);
      }
    }
  }
}

} // namespace

CubeMeans
cubeMeans(const HexMesh & mesh, const CubeFunction & f, int components, const CubeMeanOptions & wanted)
{
  const CubeMeanOptions options = checked(mesh, wanted, components);
  const GaussRule       rule = gaussLegendre(options.pointsPerAxis);
  CubeMeans             result;
  result.image = FieldVolume{ cubeGrid(CubeSampling::Cells, options.samplesPerAxis), components, {} };
  const int  cells = mesh.nodesPerSide - 1;
  const auto parts = partsInCells(options.samplesPerAxis, cells);
  result.volumes.resize(result.image.gridVoxels());
  result.image.values.resize(result.volumes.size() * static_cast<std::size_t>(components));
  parallelForBlocks(result.volumes.size(), boxesPerBlock, options.threads, [&](std::size_t begin, std::size_t end) {
    std::vector<double> values(static_cast<std::size_t>(components));
    for (std::size_t box = begin; box < end; ++box)
    {
      double * const means = result.image.at(box);
      double         volume = 0.0;
      forPartsOfBox(parts, box, cells, [&](std::size_t cell, const Vector3 & lower, const Vector3 & sides) {
        forGaussPoints(mesh, cell, lower, sides, rule, [&](const CubePoint & point, double weight) {
          f(point, values.data());
          volume += weight;
          std::transform(
            values.begin(), values.end(), means, means, [weight](double v, double sum) { return sum + weight * v; });
        });
      });
      if (!(volume > 0.0))
      {
        throw InvalidInput("cell means: cell " + std::to_string(box) + " has no positive volume");
      }
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
