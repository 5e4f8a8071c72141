#pragma once

#include "TimeSeries.h"
#include "moserhex/Deformation/CellDeformation.h"
#include "moserhex/Deformation/SurfaceMotion.h"

namespace moserhex::app
{

/** A time point against the baseline. */
struct TimeComparison
{
  SimilarityTransform alignment;    ///< of the follow-up onto the baseline
  HexMesh             mesh;         ///< the follow-up, aligned [mm]
  Positions           displacement; ///< aligned follow-up minus baseline, n^3 [mm]
  CellDeformation     cells;
  SurfaceMotion       surface;
  Positions           thickness;       ///< of the aligned follow-up along i, j, k, n^3, see latticeLineLengths [mm]
  Positions           thicknessChange; ///< n^3 [mm]
  double              latticeVolume{ 0.0 };       ///< of the follow-up's lattice as it was read, without padding [mm^3]
  double              latticeVolumeChange{ 0.0 }; ///< of it, against the baseline's [%]
};

/** \param alignment  of the follow-up onto the baseline \param threads  as in parallelFor
 * \throws InvalidInput  as the functions of the module Deformation */
[[nodiscard]] TimeComparison
compareWithBaseline(const HexMesh &             baseline,
                    const HexMesh &             followUp,
                    const SimilarityTransform & alignment,
                    unsigned int                threads);

/** The same with latticeAlignment. */
[[nodiscard]] TimeComparison
compareWithBaseline(const HexMesh & baseline, const HexMesh & followUp, AlignmentKind align, unsigned int threads);

/** The baseline with itself: no deformation, to the last bit. \throws InvalidInput  as compareWithBaseline */
[[nodiscard]] TimeComparison
unchanged(const HexMesh & baseline, unsigned int threads);

} // namespace moserhex::app
