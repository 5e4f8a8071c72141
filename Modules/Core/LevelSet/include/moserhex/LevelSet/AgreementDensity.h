#pragma once

#include "moserhex/LevelSet/DensityImage.h"
#include "moserhex/LevelSet/LabelVolume.h"

#include <vector>

namespace moserhex
{

/** Options of agreementDensity. */
struct AgreementOptions
{
  double disputed{ 0.1 };  ///< density where not all labels are, in (0, 1] [1]
  double smoothing{ 2.0 }; ///< standard deviation of a Gaussian, >= 0; 0: none [mm]
};

/** What agreementDensity found. */
struct AgreementDensity
{
  ScalarVolume density;               ///< in [disputed, 1] [1]
  double       agreedVolume{ 0.0 };   ///< of the voxels that all hold [mm^3]
  double       disputedVolume{ 0.0 }; ///< of those that only some hold [mm^3]
};

/** The density of what several segmentations of one organ agree on: 1 in voxels that all of them hold, `disputed` in
 * those that some hold, averaged in their union U with the weights of a Gaussian,
 *
 *   mu(x) = sum over y in U of G(x - y) d(y) / sum over y in U of G(x - y),      1 outside U.
 *
 * Cells of equal mass under it hardly count what only one of the segmentations has, so that nodes elsewhere need not
 * make room for it: what is disputed gets few and large cells.
 *
 * \param labels  at least two, one organ in one space; a voxel of the image is in a label when its centre is in a voxel
 * of it. Grids may differ
 * \return the density on the first one's grid, cut or continued to the box around all of them and a voxel more
 * \throws InvalidInput  fewer than two labels, an invalid one, labels without a common voxel, an option out of range */
[[nodiscard]] AgreementDensity
agreementDensity(const std::vector<LabelVolume> & labels, const AgreementOptions & options = {});

} // namespace moserhex
