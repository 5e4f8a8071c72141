#pragma once

#include "moserhex/LevelSet/VoxelGrid.h"

namespace moserhex
{

/** What the voxels of an image of the cube are. */
enum class CubeSampling
{
  Cells, ///< N^3 equal boxes of side 1/N, which fill [0,1]^3: voxel (i,j,k) has its centre at (i+1/2, j+1/2, k+1/2) / N
  Nodes  ///< N^3 points from face to face: voxel (i,j,k) is the point (i,j,k) / (N-1)
};

/** The grid of an image of the cube, in cube coordinates [1]: its "millimetres" are edges of the cube, its axes those
 * of the lattice, i towards Left, j Posterior, k Superior. \param samplesPerAxis  N \throws InvalidInput  N not in 1 to
 * 1000 (Cells) or 2 to 1000 (Nodes): files hold no voxels below 1/1000 */
[[nodiscard]] VoxelGrid
cubeGrid(CubeSampling sampling, int samplesPerAxis);

/** Which of the two grids this one is, within 1e-6 of a voxel.
 * \throws InvalidInput  neither: not the image of a cube */
[[nodiscard]] CubeSampling
cubeSamplingOf(const VoxelGrid & grid);

} // namespace moserhex
