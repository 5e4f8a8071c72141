#pragma once

#include "moserhex/CubeTransfer/CubeMap.h"
#include "moserhex/LevelSet/FieldVolume.h"

namespace moserhex
{

/** Options of gridMasses. */
struct GridMassOptions
{
  double       pointsPerVoxel{ 4.0 }; ///< sample points along a voxel's shortest side, 1 to 16 [1]
  double       background{ 0.0 };     ///< of voxels that no part of the mesh reaches
  unsigned int threads{ 0 };          ///< 0: all of the machine's
};

/** What gridMasses made. */
struct GridMasses
{
  FieldVolume         image;        ///< densities: mass over the volume of the whole voxel
  std::vector<double> outside;      ///< mass of each component that lies beyond the grid, in no voxel
  std::size_t         reached{ 0 }; ///< voxels that hold a part of the mesh
  double imbalance{ 0.0 };          ///< largest part of a voxel by which its shares are off, at most 1e-3 when fitted
};

/** Masses of the boxes of a cube, spread over the voxels that their images in the mesh overlap.
 *
 *   density(v) = sum_b mass_b (S_bv / |b|) / |v|,      sum_v S_bv = |b|,      sum_b S_bv <= |v|, = |v| where v is in
 * the mesh
 *
 * S_bv, the volume that box b's image has in voxel v, is summed over sample points in the box with weights det J; then
 * the shares of every voxel are scaled to these sums and those of every box to its own, |b|, in turn (iterative
 * proportional fitting) until voxels are within 1e-3, at most 100 times, which takes out the noise of sampling where
 * the sums are known. As the boxes come last,
 *
 *   sum_v density(v) |v| + outside = sum_b mass_b        to round-off, whatever the sampling
 *
 * A voxel that the surface cuts holds the mass of its part in the mesh, over its whole volume. Of a constant density
 * the noise in full voxels is within half a percent, and no voxel is above it by more.
 *
 * \param map     of `mesh`
 * \param masses  of N^3 boxes, on cubeGrid(Cells, N): integrals over each, [density unit mm^3]
 * \note The same for any number of threads. Some 16 bytes for each pair of a box and a voxel that overlap.
 * \throws InvalidInput  as requireLattice(mesh) and requireValid of both grids; not an image of the cube's cells;
 * points out of range; a box without positive volume */
[[nodiscard]] GridMasses
gridMasses(const CubeMap &         map,
           const HexMesh &         mesh,
           const FieldVolume &     masses,
           const VoxelGrid &       grid,
           const GridMassOptions & options = {});

} // namespace moserhex
