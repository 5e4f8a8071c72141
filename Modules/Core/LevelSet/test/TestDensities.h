#pragma once

#include "moserhex/LevelSet/DensityImage.h"

#include <Eigen/Geometry>

namespace moserhex::test
{

/** An oblique, left-handed grid of 8 x 7 x 6 anisotropic voxels. */
inline VoxelGrid
obliqueVoxels()
{
  VoxelGrid grid;
  grid.size = { { 8, 7, 6 } };
  grid.spacing = Vector3(0.4, 0.7, 2.5);
  grid.direction =
    Eigen::AngleAxisd(0.5, Vector3(0.2, 1, -0.6).normalized()).toRotationMatrix() * Vector3(1, 1, -1).asDiagonal();
  grid.origin = Vector3(3, -8, 1);
  return grid;
}

/** An image of a function of the voxel's position [mm]; called in the order of the voxel numbers. */
template <typename TFunction>
ScalarVolume
imageOf(const VoxelGrid & grid, TFunction function)
{
  ScalarVolume image{ grid, {} };
  for (int k = 0; k < grid.size[2]; ++k)
  {
    for (int j = 0; j < grid.size[1]; ++j)
    {
      for (int i = 0; i < grid.size[0]; ++i)
      {
        image.values.push_back(function(grid.point(i, j, k)));
      }
    }
  }
  return image;
}

} // namespace moserhex::test
