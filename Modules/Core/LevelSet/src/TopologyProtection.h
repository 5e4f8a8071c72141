#pragma once

#include "moserhex/LevelSet/LevelSet.h"

#include <cstddef>

namespace moserhex::detail
{

struct ProtectionResult
{
  std::size_t cut{ 0 };    ///< nodes that went outside
  std::size_t filled{ 0 }; ///< nodes that went inside
};

/** Makes {f < 0} a ball: growth from the deepest node, or shrinking of the box where that moves fewer nodes. Nodes that
 * change side get +-0.3 spacings; then their surroundings are smoothed, nodes changing side only while simple.
 * Does nothing where {f < 0} can be grown as it is. */
ProtectionResult
makeBallInPlace(LevelSet & f);

/** Changes a distance function with one ball {f < 0} where needed so that {f < c} is a ball for every |c| < band. */
void
makeLevelsSphericalInPlace(LevelSet & f, double band);

/** Node of the smallest value, the first of them. */
[[nodiscard]] std::size_t
deepestNode(const LevelSet & f);

} // namespace moserhex::detail
