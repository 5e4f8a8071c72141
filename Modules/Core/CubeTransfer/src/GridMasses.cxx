#include "moserhex/CubeTransfer/GridMasses.h"

#include "CubeParts.h"
#include "TrilinearCell.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Parallel.h"
#include "moserhex/CubeTransfer/CubeImage.h"
#include "moserhex/CubeTransfer/CubeSamples.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace moserhex
{
namespace
{

constexpr int         mostRounds = 100; ///< of balancing
constexpr double      balanced = 1e-3;  ///< of a voxel's volume: what its shares may be off by after balancing [1]
constexpr std::size_t boxesPerBlock = 32;
constexpr std::size_t voxelsPerBlock = 1024;
constexpr std::size_t nowhere = static_cast<std::size_t>(-1); ///< number of the voxel beyond the grid

struct Share
{
  std::size_t voxel;
  double      volume; ///< [mm^3]
};
using Shares = std::vector<Share>;

std::size_t
voxelOf(const VoxelGrid & grid, const Vector3 & index)
{
  int nearest[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const double whole = std::floor(index[axis] + 0.5);
    if (!(whole >= 0.0 && whole < grid.size[static_cast<std::size_t>(axis)]))
    {
      return nowhere;
    }
    nearest[axis] = static_cast<int>(whole);
  }
  return grid.voxelNumber(nearest[0], nearest[1], nearest[2]);
}

/** Sample points along one axis of a part: enough for the longest of its four edges there. */
int
pointsAlong(const HexCorners & part, int axis, double distance)
{
  static constexpr int edges[3][4][2] = { { { 0, 1 }, { 3, 2 }, { 4, 5 }, { 7, 6 } },
                                          { { 0, 3 }, { 1, 2 }, { 4, 7 }, { 5, 6 } },
                                          { { 0, 4 }, { 1, 5 }, { 2, 6 }, { 3, 7 } } };
  constexpr double     most = 256.0;
  double               longest = 0.0;
  for (const auto & edge : edges[axis])
  {
    longest = std::max(longest, (part[edge[1]] - part[edge[0]]).norm());
  }
  return static_cast<int>(std::clamp(std::ceil(longest / distance), 2.0, most));
}

HexCorners
cornersOfPart(const HexCorners & cell, const Vector3 & lower, const Vector3 & sides)
{
  static constexpr int reach[8][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 },
                                       { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };
  HexCorners           part;
  for (std::size_t c = 0; c < part.size(); ++c)
  {
    part[c] = trilinear(cell, lower + sides.cwiseProduct(Vector3(reach[c][0], reach[c][1], reach[c][2])));
  }
  return part;
}

/** Adds the volumes that a part has in voxels; runs of points in one voxel are one share. */
void
addShares(const HexCorners & part, const VoxelGrid & grid, double distance, Shares & shares)
{
  HexCorners inVoxels;
  std::transform(
    part.begin(), part.end(), inVoxels.begin(), [&grid](const Vector3 & p) { return grid.continuousIndex(p); });
  const int    count[3] = { pointsAlong(part, 0, distance),
                            pointsAlong(part, 1, distance),
                            pointsAlong(part, 2, distance) };
  const double weight = grid.voxelVolume() / (static_cast<double>(count[0]) * count[1] * count[2]);
  const double sign = grid.direction.determinant() < 0.0 ? -1.0 : 1.0;
  for (int c = 0; c < count[2]; ++c)
  {
    for (int b = 0; b < count[1]; ++b)
    {
      for (int a = 0; a < count[0]; ++a)
      {
        const Vector3     xi((a + 0.5) / count[0], (b + 0.5) / count[1], (c + 0.5) / count[2]);
        const std::size_t voxel = voxelOf(grid, trilinear(inVoxels, xi));
        const double      volume = sign * weight * trilinearTangents(inVoxels, xi).determinant();
        if (shares.empty() || shares.back().voxel != voxel)
        {
          shares.push_back({ voxel, 0.0 });
        }
        shares.back().volume += volume;
      }
    }
  }
}

/** One share for each voxel, ascending. */
void
merge(Shares & shares)
{
  std::stable_sort(shares.begin(), shares.end(), [](const Share & a, const Share & b) { return a.voxel < b.voxel; });
  std::size_t last = 0;
  for (std::size_t n = 1; n < shares.size(); ++n)
  {
    if (shares[n].voxel == shares[last].voxel)
    {
      shares[last].volume += shares[n].volume;
    }
    else
    {
      shares[++last] = shares[n];
    }
  }
  shares.resize(shares.empty() ? 0 : last + 1);
  shares.shrink_to_fit();
}

/** Of every box. */
std::vector<Shares>
sharesOf(const HexMesh & mesh, int samplesPerAxis, const VoxelGrid & grid, const GridMassOptions & options)
{
  const int           cells = mesh.nodesPerSide - 1;
  const auto          parts = partsInCells(samplesPerAxis, cells);
  const double        distance = grid.spacing.minCoeff() / options.pointsPerVoxel;
  const auto          n = static_cast<std::size_t>(samplesPerAxis);
  std::vector<Shares> shares(n * n * n);
  parallelForBlocks(shares.size(), boxesPerBlock, options.threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t box = begin; box < end; ++box)
    {
      forPartsOfBox(parts, box, cells, [&](std::size_t cell, const Vector3 & lower, const Vector3 & sides) {
        addShares(cornersOfPart(cellCorners(mesh, cell), lower, sides), grid, distance, shares[box]);
      });
      merge(shares[box]);
    }
  });
  return shares;
}

/** Whether the eight corners of a voxel are in the mesh. */
bool
isFull(const CubeMap & map, const VoxelGrid & grid, std::size_t voxel)
{
  const auto    nx = static_cast<std::size_t>(grid.size[0]);
  const auto    ny = static_cast<std::size_t>(grid.size[1]);
  const Vector3 centre =
    grid.point(static_cast<int>(voxel % nx), static_cast<int>(voxel / nx % ny), static_cast<int>(voxel / (nx * ny)));
  for (int corner = 0; corner < 8; ++corner)
  {
    const Vector3 step(corner & 1 ? 0.5 : -0.5, corner & 2 ? 0.5 : -0.5, corner & 4 ? 0.5 : -0.5);
    if (!map.find(centre + grid.direction * grid.spacing.cwiseProduct(step)))
    {
      return false;
    }
  }
  return true;
}

/** Sums the shares of every voxel [mm^3]. */
std::vector<double>
volumesInVoxels(const std::vector<Shares> & shares, std::size_t voxels)
{
  std::vector<double> volumes(voxels, 0.0);
  for (const Shares & ofBox : shares)
  {
    for (const Share & share : ofBox)
    {
      if (share.voxel != nowhere)
      {
        volumes[share.voxel] += share.volume;
      }
    }
  }
  return volumes;
}

/** Scales the shares of every box to its volume. \throws InvalidInput  a box without positive volume */
void
balanceBoxes(const std::vector<double> & volumes, std::vector<Shares> & shares)
{
  for (std::size_t box = 0; box < shares.size(); ++box)
  {
    double sum = 0.0;
    for (const Share & share : shares[box])
    {
      sum += share.volume;
    }
    if (!(sum > 0.0))
    {
      throw InvalidInput("masses: cell " + std::to_string(box) + " has no positive volume");
    }
    for (Share & share : shares[box])
    {
      share.volume *= volumes[box] / sum;
    }
  }
}

/** Scales the shares of every full voxel to its volume, and those of others to at most that.
 * \return the largest factor's distance from 1 */
double
balanceVoxels(const std::vector<char> & full, double voxelVolume, std::vector<Shares> & shares)
{
  std::vector<double> factors = volumesInVoxels(shares, full.size());
  double              largest = 0.0;
  for (std::size_t voxel = 0; voxel < factors.size(); ++voxel)
  {
    const double volume = factors[voxel];
    factors[voxel] = volume > 0.0 && (full[voxel] != 0 || volume > voxelVolume) ? voxelVolume / volume : 1.0;
    largest = std::max(largest, std::abs(factors[voxel] - 1.0));
  }
  for (Shares & ofBox : shares)
  {
    for (Share & share : ofBox)
    {
      share.volume *= share.voxel != nowhere ? factors[share.voxel] : 1.0;
    }
  }
  return largest;
}

/** Both in turn, boxes last. \return what voxels are off by before their last turn */
double
balance(const std::vector<double> & boxVolumes,
        const std::vector<char> &   full,
        double                      voxelVolume,
        std::vector<Shares> &       shares)
{
  balanceBoxes(boxVolumes, shares);
  double off = balanced;
  for (int round = 0; round < mostRounds && off >= balanced; ++round)
  {
    off = balanceVoxels(full, voxelVolume, shares);
    balanceBoxes(boxVolumes, shares);
  }
  return off;
}

/** Which of the voxels that hold a part of the mesh hold nothing else. */
std::vector<char>
fullVoxels(const CubeMap & map, const VoxelGrid & grid, const std::vector<double> & volumes, unsigned int threads)
{
  std::vector<char> full(volumes.size(), 0);
  parallelForBlocks(volumes.size(), voxelsPerBlock, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t voxel = begin; voxel < end; ++voxel)
    {
      full[voxel] = volumes[voxel] > 0.0 && isFull(map, grid, voxel) ? 1 : 0;
    }
  });
  return full;
}

void
requireUsable(const HexMesh & mesh, const FieldVolume & masses, const VoxelGrid & grid, const GridMassOptions & options)
{
  requireLattice(mesh);
  requireValid(masses, "masses");
  requireValid(grid, "grid");
  if (cubeSamplingOf(masses) != CubeSampling::Cells)
  {
    throw InvalidInput("masses: samples at nodes, need those of cells");
  }
  if (!(options.pointsPerVoxel >= 1.0 && options.pointsPerVoxel <= 16.0))
  {
    throw InvalidInput("masses: " + std::to_string(options.pointsPerVoxel) + " points per voxel, need 1 to 16");
  }
}

} // namespace

GridMasses
gridMasses(const CubeMap &         map,
           const HexMesh &         mesh,
           const FieldVolume &     masses,
           const VoxelGrid &       grid,
           const GridMassOptions & options)
{
  requireUsable(mesh, masses, grid, options);
  const std::vector<double> boxVolumes = cubeVolumes(mesh, { masses.size[0], 2, options.threads });
  std::vector<Shares>       shares = sharesOf(mesh, masses.size[0], grid, options);
  const std::vector<double> sampled = volumesInVoxels(shares, grid.gridVoxels());
  const std::vector<char>   full = fullVoxels(map, grid, sampled, options.threads);
  const double              imbalance = balance(boxVolumes, full, grid.voxelVolume(), shares);

  const auto components = static_cast<std::size_t>(masses.components);
  GridMasses result;
  result.imbalance = imbalance;
  result.image = FieldVolume{ grid, masses.components, std::vector<double>(grid.gridVoxels() * components, 0.0) };
  result.outside.assign(components, 0.0);
  for (std::size_t box = 0; box < shares.size(); ++box)
  {
    for (const Share & share : shares[box])
    {
      const bool     isOutside = share.voxel == nowhere;
      double * const into = isOutside ? result.outside.data() : result.image.at(share.voxel);
      const double   part = share.volume / boxVolumes[box] / (isOutside ? 1.0 : grid.voxelVolume());
      for (std::size_t component = 0; component < components; ++component)
      {
        into[component] += part * masses.at(box)[component];
      }
    }
  }
  for (std::size_t voxel = 0; voxel < sampled.size(); ++voxel)
  {
    if (sampled[voxel] == 0.0)
    {
      std::fill_n(result.image.at(voxel), components, options.background);
      continue;
    }
    ++result.reached;
  }
  return result;
}

} // namespace moserhex
