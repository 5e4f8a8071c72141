#pragma once

#include "moserhex/LevelSet/VoxelGrid.h"

#include <string>
#include <vector>

namespace moserhex
{

/** An image of one or several numbers per voxel: a scalar, a vector, a symmetric tensor (xx, xy, xz, yy, yz, zz). */
struct FieldVolume : VoxelGrid
{
  int                 components{ 1 }; ///< numbers per voxel, >= 1
  std::vector<double> values; ///< gridVoxels() times components, in the order of the voxel numbers, components fastest

  /** First of the numbers of a voxel. */
  [[nodiscard]] const double *
  at(std::size_t voxel) const
  {
    return values.data() + voxel * static_cast<std::size_t>(components);
  }

  /** First of the numbers of a voxel, to be changed. */
  [[nodiscard]] double *
  at(std::size_t voxel)
  {
    return values.data() + voxel * static_cast<std::size_t>(components);
  }
};

/** \throws InvalidInput  invalid grid, no component, or a number of values that is not voxels times components */
void
requireValid(const FieldVolume & image, const std::string & what);

} // namespace moserhex
