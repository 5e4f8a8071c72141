#include "Parcel.h"

#include <stdexcept>

namespace moserhex
{
namespace
{

constexpr std::size_t  pointBytes = 3 * sizeof(double);
constexpr const char * tooShort = "the reader's answer is too short";

} // namespace

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

void
ParcelWriter::put(const std::optional<Matrix3> & matrix)
{
  put(matrix ? 1 : 0);
  for (Eigen::Index entry = 0; matrix && entry < matrix->size(); ++entry)
  {
    put(matrix->data()[entry]);
  }
}

void
ParcelWriter::put(const Positions & points)
{
  put(static_cast<std::uint64_t>(points.size()));
  for (const Vector3 & point : points)
  {
    m_Bytes.append(reinterpret_cast<const char *>(point.data()), pointBytes);
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

std::optional<Matrix3>
ParcelReader::matrix()
{
  if (number<int>() == 0)
  {
    return std::nullopt;
  }
  Matrix3 matrix;
  for (Eigen::Index entry = 0; entry < matrix.size(); ++entry)
  {
    matrix.data()[entry] = number<double>();
  }
  return matrix;
}

Positions
ParcelReader::positions()
{
  Positions points(itemCount(pointBytes));
  for (Vector3 & point : points)
  {
    m_Bytes.copy(reinterpret_cast<char *>(point.data()), pointBytes, advance(pointBytes));
  }
  return points;
}

std::size_t
ParcelReader::advance(std::size_t count)
{
  const std::size_t begin = m_Position;
  if (count > m_Bytes.size() - begin)
  {
    throw std::out_of_range(tooShort);
  }
  m_Position += count;
  return begin;
}

std::size_t
ParcelReader::itemCount(std::size_t itemBytes)
{
  const auto items = number<std::uint64_t>();
  if (items > (m_Bytes.size() - m_Position) / itemBytes)
  {
    throw std::out_of_range(tooShort);
  }
  return static_cast<std::size_t>(items);
}

} // namespace moserhex
