#pragma once

namespace moserhex
{

/** How the numbers of an image are kept, and what several of them in a voxel are. */
enum class FieldValues
{
  Numbers,          ///< 64-bit real numbers; of several a vector
  SymmetricTensors, ///< the same: xx, xy, xz, yy, yz, zz
  Labels            ///< one 32-bit integer
};

/** The axes that vectors and tensors of an image are in. */
enum class ValueAxes
{
  Lps,
  Cube,   ///< those of the cube at each place
  Unknown ///< not said
};

} // namespace moserhex
