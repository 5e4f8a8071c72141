#pragma once

#include "InputFile.h"
#include "moserhex/Deformation/CubeRegions.h"

#include <string>
#include <vector>

namespace moserhex::app
{

/** Regions that belong together. */
struct RegionSet
{
  std::string             name; ///< octants, halves, shells; boxes: of a table
  std::vector<CubeRegion> regions;
  InputFile               table{}; ///< of boxes
};

/** The sets that are asked for by name or by the name of a table, in their order.
 *
 * A table (.csv .tsv, readTextTable) has the columns name, imin, imax, jmin, jmax, kmin, kmax, in any order and with
 * others beside them: a box in cube coordinates, 0 <= min < max <= 1; i leads to the patient's left, j to posterior, k
 * to superior.
 * \throws UsageError  no set of that name, or a set twice
 * \throws BadInput    as readTextTable; Format: a column is missing, a cell is no number, a box is not in the cube, or
 * a name is empty or there twice, with the line's number */
[[nodiscard]] std::vector<RegionSet>
chosenRegions(const std::vector<std::string> & choices, int nodesPerSide);

/** What the array Boxes cannot show: boxes of a table that overlap, and a box that has more than half of no cell. */
[[nodiscard]] std::vector<std::string>
regionWarnings(const std::vector<RegionSet> & sets, int nodesPerSide);

} // namespace moserhex::app
