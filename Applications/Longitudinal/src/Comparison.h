#pragma once

#include "RegionMeasures.h"

#include <string>
#include <vector>

namespace moserhex::app
{

/** All that compare has found. */
struct Comparison
{
  TimeSeries                          series;
  std::string                         align; ///< rigid | similarity | none | file
  std::vector<RegionSet>              sets;
  std::vector<TimeComparison>         times; ///< of each point of the series, the baseline with itself first
  std::vector<std::vector<RegionRow>> rows;  ///< of each point
};

/** Aligns and measures every point of the series, and adds to its warnings what that makes doubtful: regions (see
 * regionWarnings), a lattice that lies turned against the baseline's by more than patients do, and an organ that lies
 * elsewhere after a transform, or without an alignment; of a transform also if its inverse fits much better.
 * \throws BadInput (Precondition)  a mesh cannot be compared, see the functions of the module Deformation: a cell
 * without volume; names its file */
[[nodiscard]] Comparison
compareSeries(TimeSeries series, const std::string & align, std::vector<RegionSet> sets, unsigned int threads);

/** Change of the organ's volume, padding included, against the baseline [%]. */
[[nodiscard]] double
volumeChange(const TimeSeries & series, std::size_t time);

} // namespace moserhex::app
