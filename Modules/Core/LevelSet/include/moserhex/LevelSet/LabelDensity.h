#pragma once

#include "moserhex/LevelSet/DensityImage.h"
#include "moserhex/LevelSet/LabelVolume.h"

namespace moserhex
{

/** A density made ready for a label: divided by its mean over the label, so that the mean is 1 and the label's mass is
 * the label's volume. The mass every cell gets is then V_label / (n-1)^3 [mm^3], with or without a density. */
struct LabelDensity
{
  DensityImage density;            ///< mean 1 over the label [1]
  double       meanDensity{ 0.0 }; ///< mean over the label before that [unit of the image]
  double       mass{ 0.0 };        ///< meanDensity * V_label [unit of the image * mm^3]
  double       smallest{ 0.0 };    ///< of the voxels that overlap the label, over meanDensity [1]
  double       largest{ 0.0 };     ///< likewise [1]
};

/** Mean of the density over the voxels of a label: integral of mu over the label / V_label.
 *
 * Every voxel is cut along each axis into ceil(side / side of a density voxel) parts, at most four, with 2 x 2 x 2
 * Gauss points each. For a DensityImage on the label's own grid that is exact, as mu is quadratic in a voxel; for
 * constant and linear densities on every grid. Otherwise a voxel's error is of third order in its size, and those
 * of neighbours cancel.
 *
 * \param densityGrid  the voxels of the density: says how finely the label's have to be cut
 * \throws InvalidInput  invalid or empty label
 * \note The same for any number of threads, bit for bit. */
[[nodiscard]] double
meanDensity(const LabelVolume & label,
            const Density &     density,
            const VoxelGrid &   densityGrid,
            unsigned int        threads = 0);

/** Puts a density image onto a label. The grids may differ in every respect: all is done by position.
 *
 * 1. The label's largest component with its cavities filled is what counts. What conditionLabel repaired is in
 *    ConditionedSolid::label: voxels that a repair added need a density too.
 * 2. Every voxel of it must lie in the image: its box, half a voxel beyond the outer voxel centres.
 * 3. Every density voxel that overlaps the label must be positive and finite. One overlaps when its centre lies in a
 *    voxel of the label, or it holds one of the points of meanDensity; on a common grid these are the label's voxels.
 * 4. What the image holds beside the label never matters (other tissue, or a density masked by its organ): a voxel
 *    there gets the value of the nearest one that overlaps the label, so that the spline, which blends neighbours, and
 *    a mesh whose surface is not that of the voxels see the label's own values only.
 * 5. The density is divided by its mean over the label.
 *
 * \throws InvalidInput  invalid image; image does not cover the label (names the side and by how much); a voxel that
 *                       overlaps the label is not positive and finite, or below 1e-300 of the mean (names the first, in
 *                       the order of the image's voxel numbers, and its value); invalid or empty label */
[[nodiscard]] LabelDensity
densityOnLabel(const ScalarVolume & image, const LabelVolume & label, unsigned int threads = 0);

} // namespace moserhex
