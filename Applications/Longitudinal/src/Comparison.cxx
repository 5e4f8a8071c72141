#include "Comparison.h"

#include "CommandErrors.h"
#include "moserhex/Common/Errors.h"

#include <cmath>
#include <utility>

namespace moserhex::app
{
namespace
{

/** \throws BadInput  names the point's file */
TimeComparison
comparisonAt(const TimeSeries & series, std::size_t time, const std::string & align, unsigned int threads)
{
  const HexMesh &   baseline = series.points.front().lattice;
  const TimePoint & point = series.points[time];
  try
  {
    if (time == 0)
    {
      return unchanged(baseline, threads);
    }
    const SimilarityTransform alignment =
      point.alignment ? *point.alignment : latticeAlignment(point.lattice, baseline, alignmentOf(align));
    return compareWithBaseline(baseline, point.lattice, alignment, threads);
  }
  catch (const InvalidInput & error)
  {
    throw BadInput(ErrorCode::Precondition, point.file.name, error.what(), "give an exact mesh");
  }
}

/** A patient does not lie so differently at two visits, but a lattice that was turned does. */
void
addWarningOfTurn(const TimePoint &          point,
                 const TimeComparison &     found,
                 const HexMesh &            baseline,
                 const std::string &        align,
                 std::vector<std::string> & warnings)
{
  constexpr double plausible = 20.0; // [degree]
  const bool       isSought = !point.alignment && alignmentOf(align) != AlignmentKind::None;
  const double     angle =
    (isSought ? found.alignment : latticeAlignment(found.mesh, baseline, AlignmentKind::Rigid)).angle();
  if (angle > plausible)
  {
    warnings.push_back(
      fileMessage(point.file.name,
                  "its nodes lie turned by " + std::to_string(std::lround(angle)) + " degrees against the baseline's",
                  "its lattice may be turned: mesh it with --template BASELINE"));
  }
}

} // namespace

Comparison
compareSeries(TimeSeries series, const std::string & align, std::vector<RegionSet> sets, unsigned int threads)
{
  Comparison      result{ std::move(series), align, std::move(sets), {}, {} };
  const HexMesh & baseline = result.series.points.front().lattice;
  for (const std::string & warning : regionWarnings(result.sets, baseline.nodesPerSide))
  {
    result.series.warnings.push_back(warning);
  }
  for (std::size_t time = 0; time < result.series.points.size(); ++time)
  {
    result.times.push_back(comparisonAt(result.series, time, align, threads));
    if (time > 0)
    {
      addWarningOfTurn(result.series.points[time], result.times.back(), baseline, align, result.series.warnings);
    }
    result.rows.push_back(regionRows(baseline, result.times.back(), result.sets));
  }
  return result;
}

double
volumeChange(const TimeSeries & series, std::size_t time)
{
  return 100.0 * (series.points[time].volume / series.points.front().volume - 1.0);
}

} // namespace moserhex::app
