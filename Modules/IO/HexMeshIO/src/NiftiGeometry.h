#pragma once

#include "ImageDescription.h"
#include "NiftiHeader.h"

namespace moserhex
{

/** Sets the grid from the qform, the sform or, with neither, from the voxel sizes alone, in LPS millimetres.
 *
 * Of two the sform counts: its columns carry the voxel sizes to a float's digits. What is in the header twice (voxel
 * sizes, axes, place) must agree: differences beyond rounding are a warning, and a refusal when they exceed 0.1 % of a
 * voxel, 0.005 rad or half a voxel. A quaternion b, c, d stores the rotation by sqrt(1 - b^2 - c^2 - d^2), which loses
 * half of a float's digits near 0: so the axes may differ by 0.001 without a word.
 *
 * \throws BadInput (Geometry)  see above; not finite; sizes not positive; a quaternion longer than 1; an unknown unit
 */
void
setNiftiGeometry(const NiftiHeader & header, ImageDescription & image);

} // namespace moserhex
