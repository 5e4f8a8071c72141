#pragma once

#include "TestSolids.h"
#include "moserhex/HexMap/VolumeEqualisation.h"

namespace moserhex::testing
{

inline EqualisationOptions
nodes(int nodesPerSide)
{
  EqualisationOptions options;
  options.nodesPerSide = nodesPerSide;
  return options;
}

/** Options whose three lists of stages are one stage each. */
inline EqualisationOptions
stages(const EqualisationStage & stage)
{
  EqualisationOptions options;
  options.coarseStages = { stage };
  options.finestStages = { stage };
  options.directStages = { stage };
  return options;
}

// Sizes of organs: the ball 40 mm across, the others of about the same volume.
inline const BentEllipsoid ball = ballOfRadius(20.0);
inline const BentEllipsoid slender{ Vector3(58.5, 11.7, 11.7) }; // 5:1
inline const BentEllipsoid banana{ Vector3(32.0, 14.0, 16.0), 0.012 };

} // namespace moserhex::testing
