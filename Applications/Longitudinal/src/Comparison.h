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

/** Aligns and measures every point of the series. \throws InvalidInput  as the functions of the module Deformation */
[[nodiscard]] Comparison
compareSeries(TimeSeries series, const std::string & align, std::vector<RegionSet> sets, unsigned int threads);

} // namespace moserhex::app
