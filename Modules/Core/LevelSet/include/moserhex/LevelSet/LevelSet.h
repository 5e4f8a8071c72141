#pragma once

#include "moserhex/LevelSet/RegularGrid.h"

#include <string>
#include <vector>

namespace moserhex
{

/** A scalar function on the nodes of a grid. Inside is where the value is below the level asked for; for the level-set
 * function phi of an organ that is phi < 0. Values may be +infinity ("outside, whatever the level"), never NaN. */
struct LevelSet
{
  RegularGrid         grid;   ///< where the values are
  std::vector<double> values; ///< nodeCount() entries, in the order of the node numbers
};

/** \throws InvalidInput for an invalid grid, a wrong number of values, a NaN or a -infinity (names the node). */
void
requireValid(const LevelSet & levelSet, const std::string & what);

} // namespace moserhex
