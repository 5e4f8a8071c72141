#pragma once

#include "moserhex/LevelSet/LabelVolume.h"

namespace moserhex
{

/** A prostate-like solid made from formulas, with known size and place, for demonstrations and tests.
 *
 * About 54 x 43 x 47 mm (left-right, front-back, up-down) and 51 mL; the bladder dents the base, the rectum flattens
 * the posterior wall and leaves a shallow groove, the apex is narrow. Genus 0. */
struct SampleProstate
{
  LabelVolume gland;    ///< 1 in the gland
  LabelVolume zones;    ///< 1 peripheral zone, 2 transition zone
  LabelVolume followUp; ///< 1 in the gland at a later visit: 15 % larger, with a bulge on its left posterior side
};

/** Voxels of 0.5 x 0.5 x 3 mm on an oblique grid, the same for the three images. */
[[nodiscard]] SampleProstate
makeSampleProstate();

} // namespace moserhex
