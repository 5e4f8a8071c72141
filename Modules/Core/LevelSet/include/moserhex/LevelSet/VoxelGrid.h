#pragma once

#include "moserhex/Common/Types.h"

#include <array>
#include <cstddef>
#include <string>

namespace moserhex
{

/** Where the voxels of an image are.
 *
 * Voxel (i,j,k) has the number i + size[0] (j + size[1] k) and its centre at
 *   origin + direction * (spacing * (i,j,k))      componentwise product                                 [mm, LPS] */
struct VoxelGrid
{
  std::array<int, 3> size{ { 0, 0, 0 } };              ///< voxels along each axis
  Vector3            spacing{ Vector3::Ones() };       ///< voxel sides, may differ [mm]
  Vector3            origin{ Vector3::Zero() };        ///< centre of voxel (0,0,0) [mm]
  Matrix3            direction{ Matrix3::Identity() }; ///< image axes: orthonormal columns, either handedness

  /** Product of the sizes. */
  [[nodiscard]] std::size_t
  gridVoxels() const
  {
    return static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]) * static_cast<std::size_t>(size[2]);
  }

  /** i + size[0] (j + size[1] k). */
  [[nodiscard]] std::size_t
  voxelNumber(int i, int j, int k) const
  {
    const auto nx = static_cast<std::size_t>(size[0]);
    const auto ny = static_cast<std::size_t>(size[1]);
    return static_cast<std::size_t>(i) + nx * (static_cast<std::size_t>(j) + ny * static_cast<std::size_t>(k));
  }

  /** Product of the voxel sides [mm^3]. */
  [[nodiscard]] double
  voxelVolume() const
  {
    return spacing.prod();
  }

  /** Centre of voxel (i,j,k) [mm, LPS]. */
  [[nodiscard]] Vector3
  point(int i, int j, int k) const
  {
    return origin + direction * spacing.cwiseProduct(Vector3(i, j, k));
  }

  /** Inverse of point(): where an LPS point lies among the voxel centres [voxels]. */
  [[nodiscard]] Vector3
  continuousIndex(const Vector3 & p) const
  {
    return (direction.transpose() * (p - origin)).cwiseQuotient(spacing);
  }
};

/** \throws InvalidInput unless sizes are positive, the spacing positive and finite, the direction orthonormal within
 * 1e-6 and the origin finite. The message begins with `what`. */
void
requireValid(const VoxelGrid & grid, const std::string & what);

} // namespace moserhex
