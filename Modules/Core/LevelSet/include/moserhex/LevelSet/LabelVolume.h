#pragma once

#include "moserhex/Common/Types.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace moserhex
{

/** One label of an image as a binary mask on its own voxels.
 *
 * Voxel (i,j,k) has the number i + size[0] (j + size[1] k) and its centre at
 *   origin + direction * (spacing * (i,j,k))      componentwise product                                 [mm, LPS] */
struct LabelVolume
{
  std::array<int, 3>        size{ { 0, 0, 0 } };
  Vector3                   spacing{ Vector3::Ones() };       ///< voxel sides, may differ [mm]
  Vector3                   origin{ Vector3::Zero() };        ///< centre of voxel (0,0,0) [mm]
  Matrix3                   direction{ Matrix3::Identity() }; ///< image axes: orthonormal columns, either handedness
  std::vector<std::uint8_t> inside;                           ///< 1 in the label, 0 elsewhere

  [[nodiscard]] std::size_t
  voxelNumber(int i, int j, int k) const
  {
    const auto nx = static_cast<std::size_t>(size[0]);
    const auto ny = static_cast<std::size_t>(size[1]);
    return static_cast<std::size_t>(i) + nx * (static_cast<std::size_t>(j) + ny * static_cast<std::size_t>(k));
  }

  [[nodiscard]] double
  voxelVolume() const
  {
    return spacing.prod();
  }

  [[nodiscard]] Vector3
  point(int i, int j, int k) const
  {
    return origin + direction * spacing.cwiseProduct(Vector3(i, j, k));
  }
};

/** Number of voxels in the label. */
[[nodiscard]] std::size_t
voxelCount(const LabelVolume & label);

/** \throws InvalidInput unless sizes are positive and match the mask, the spacing is positive and finite, the direction
 * orthonormal within 1e-6 and at least one voxel inside. The message begins with `what`. */
void
requireValid(const LabelVolume & label, const std::string & what);

/** Cuts out the bounding box of the inside voxels and surrounds it by margin[axis] empty voxels on both sides (also
 * beyond the image). Same positions in space. */
[[nodiscard]] LabelVolume
cropAndPad(const LabelVolume & label, const std::array<int, 3> & margin);

} // namespace moserhex
