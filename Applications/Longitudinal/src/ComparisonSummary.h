#pragma once

#include "ComparisonFiles.h"

#include <array>
#include <string>

namespace moserhex::app
{

/** Where in the organ the fibres grew most. */
struct LargestStretch
{
  double             stretch{ 1.0 };               ///< growth of the organ removed [1]
  std::array<int, 3> cell{};                       ///< i, j, k
  Vector3            place{ Vector3::Zero() };     ///< centre of the cell in the baseline [mm]
  Vector3            direction{ Vector3::Zero() }; ///< unit, in the baseline [1]
};

/** The first cell of the largest stretch. */
[[nodiscard]] LargestStretch
largestStretchOf(const HexMesh & baseline, const CellDeformation & cells);

/** Whether all cells have grown alike, up to 1e-6: then local growth cannot be seen in volumes. */
[[nodiscard]] bool
isUniformGrowth(const CellDeformation & cells);

/** A measure of the whole organ. \throws InvalidInput  no measure of that name */
[[nodiscard]] const WeightedDistribution &
ofOrgan(const std::vector<RegionRow> & rows, const std::string & measure);

/** summary.json: what was compared and how, with checksums of all files that were read; for each time volume, evenness
 * of the cells, alignment and the measures of the whole organ. \throws IOError */
void
writeComparisonSummary(const std::string & folder, const Comparison & comparison);

/** The table on the screen, with its end of line. */
[[nodiscard]] std::string
describe(const Comparison & comparison);

} // namespace moserhex::app
