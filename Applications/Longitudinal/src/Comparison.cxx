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
    const HexMesh & mesh = result.series.points[time].lattice;
    result.times.push_back(time == 0 ? unchanged(baseline, threads)
                                     : compareWithBaseline(baseline, mesh, alignmentOf(align), threads));
    result.rows.push_back(regionRows(baseline, result.times.back(), result.sets));
  }
  return result;
}

} // namespace moserhex::app
