#include "Comparison.h"

#include <utility>

namespace moserhex::app
{

Comparison
compareSeries(TimeSeries series, const std::string & align, std::vector<RegionSet> sets, unsigned int threads)
{
  Comparison      result{ std::move(series), align, std::move(sets), {}, {} };
  const HexMesh & baseline = result.series.points.front().lattice;
  for (std::size_t time = 0; time < result.series.points.size(); ++time)
  {
    const TimePoint & point = result.series.points[time];
    if (time == 0)
    {
      result.times.push_back(unchanged(baseline, threads));
    }
    else
    {
      const SimilarityTransform alignment =
        point.alignment ? *point.alignment : latticeAlignment(point.lattice, baseline, alignmentOf(align));
      result.times.push_back(compareWithBaseline(baseline, point.lattice, alignment, threads));
    }
    result.rows.push_back(regionRows(baseline, result.times.back(), result.sets));
  }
  return result;
}

} // namespace moserhex::app
