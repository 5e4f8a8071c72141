#pragma once

#include "moserhex/LevelSet/VoxelGrid.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace moserhex
{

/** One label of an image as a binary mask on its own voxels. */
struct LabelVolume : VoxelGrid
{
  std::vector<std::uint8_t> inside; ///< 1 in the label, 0 elsewhere; in the order of the voxel numbers
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
