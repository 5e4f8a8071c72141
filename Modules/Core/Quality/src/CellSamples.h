#pragma once

#include "moserhex/Common/Types.h"
#include "moserhex/LevelSet/VoxelGrid.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace moserhex::detail
{

/** A point of the reference cube: weights of the corners and the derivatives of these. */
struct CellSample
{
  std::array<double, 8>  weight;
  std::array<Vector3, 8> gradient;
};

/** The middles of m x m x m equal parts of the reference cube. */
[[nodiscard]] std::vector<CellSample>
cellSamples(int samplesPerSide);

/** From LPS millimetres to voxels. */
class VoxelCoordinates
{
public:
  explicit VoxelCoordinates(const VoxelGrid & grid)
    : m_Origin(grid.origin), m_ToVoxels(grid.spacing.cwiseInverse().asDiagonal() * grid.direction.transpose())
  {}

  [[nodiscard]] Vector3
  of(const Vector3 & point) const
  {
    return m_ToVoxels * (point - m_Origin);
  }

private:
  Vector3 m_Origin;
  Matrix3 m_ToVoxels;
};

/** Number of the voxel whose centre is nearest to a place in voxel coordinates; nothing beyond the image. */
[[nodiscard]] std::optional<std::size_t>
nearestVoxel(const VoxelGrid & grid, const Vector3 & voxel);

} // namespace moserhex::detail
