#pragma once

#include "moserhex/LevelSet/LabelVolume.h"
#include "moserhex/LevelSet/LevelSet.h"

namespace moserhex::detail
{

/** Axis along which the voxels are longer than `anisotropy` times their smallest side; -1 when there is none. */
[[nodiscard]] int
findSliceAxis(const Vector3 & spacing, double anisotropy);

/** Grid of the given spacing along the image axes, centred on the label's bounding box (outer faces of the voxels),
 * with at least `margin` [mm] around it. */
[[nodiscard]] RegularGrid
gridAround(const LabelVolume & label, double spacing, double margin);

/** Signed distance of a ball-shaped label on the nodes of a grid along the image axes [mm].
 *
 * sliceAxis < 0: distance in three dimensions, trilinear. Otherwise per slice and linear within, slices beyond the ends
 * mirrored, saturated at three slices, Catmull-Rom across slices. The label must carry enough empty voxels around it to
 * cover the grid. */
[[nodiscard]] LevelSet
interpolateShape(const LabelVolume & label, const RegularGrid & grid, int sliceAxis, unsigned int threads);

} // namespace moserhex::detail
