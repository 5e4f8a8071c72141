#include "Parcel.h"

#include <stdexcept>

namespace moserhex
{

void
ParcelWriter::put(const VoxelGrid & grid)
{
  for (Eigen::Index axis = 0; axis < 3; ++axis)
  {
    put(grid.size[static_cast<std::size_t>(axis)]);
    put(grid.spacing[axis]);
    put(grid.origin[axis]);
    for (Eigen::Index row = 0; row < 3; ++row)
    {
      put(grid.direction(row, axis));
    }
  }
}

VoxelGrid
ParcelReader::grid()
{
  VoxelGrid grid;
  for (Eigen::Index axis = 0; axis < 3; ++axis)
  {
    grid.size[static_cast<std::size_t>(axis)] = number<int>();
    grid.spacing[axis] = number<double>();
    grid.origin[axis] = number<double>();
    for (Eigen::Index row = 0; row < 3; ++row)
    {
      grid.direction(row, axis) = number<double>();
    }
  }
  return grid;
}

std::size_t
ParcelReader::advance(std::size_t count)
{
  const std::size_t begin = m_Position;
  if (count > m_Bytes.size() - begin)
  {
    throw std::out_of_range("the reader's answer is too short");
  }
  m_Position += count;
  return begin;
}

} // namespace moserhex
