#pragma once

#include "moserhex/LevelSet/VoxelGrid.h"

namespace moserhex
{

/** Where the voxels of an image are; its largest possible region begins at index 0. */
template <typename TImage>
[[nodiscard]] VoxelGrid
voxelGridOf(const TImage & image)
{
  VoxelGrid grid;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    grid.size[axis] = static_cast<int>(image.GetLargestPossibleRegion().GetSize(axis));
    grid.spacing[axis] = image.GetSpacing()[axis];
    grid.origin[axis] = image.GetOrigin()[axis];
    for (unsigned int row = 0; row < 3; ++row)
    {
      grid.direction(row, axis) = image.GetDirection()(row, axis);
    }
  }
  return grid;
}

/** An image with these voxels, their values not yet set. */
template <typename TImage>
[[nodiscard]] typename TImage::Pointer
imageOnGrid(const VoxelGrid & grid)
{
  typename TImage::SizeType      size;
  typename TImage::SpacingType   spacing;
  typename TImage::PointType     origin;
  typename TImage::DirectionType direction;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    size[axis] = static_cast<itk::SizeValueType>(grid.size[axis]);
    spacing[axis] = grid.spacing[axis];
    origin[axis] = grid.origin[axis];
    for (unsigned int row = 0; row < 3; ++row)
    {
      direction(row, axis) = grid.direction(row, axis);
    }
  }
  auto image = TImage::New();
  image->SetRegions(size);
  image->SetSpacing(spacing);
  image->SetOrigin(origin);
  image->SetDirection(direction);
  image->Allocate();
  return image;
}

} // namespace moserhex
