#include "Comparison.h"

#include "CommandErrors.h"
#include "moserhex/Common/Errors.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <numeric>
#include <sstream>
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

std::string
millimetres(double length)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << length << " mm";
  return text.str();
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

double
medianDistance(const SurfaceMotion & surface)
{
  std::vector<double> distances;
  for (const double distance : surface.signedDistance)
  {
    distances.push_back(std::abs(distance));
  }
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return *middle;
}

/** Where nothing was sought, a wrong transform, or none, is no growth. */
void
addWarningOfPlace(const TimePoint &          point,
                  const TimeComparison &     found,
                  const HexMesh &            baseline,
                  const std::string &        align,
                  unsigned int               threads,
                  std::vector<std::string> & warnings)
{
  constexpr double nearby = 0.05;    // of the radius: a distance below which no direction is worth a word [1]
  constexpr double farAway = 0.25;   // of the radius: a distance that is doubtful [1]
  constexpr double muchNearer = 0.5; // the inverse of a transform counts as the right one below this part [1]
  if (!point.alignment && align != "none")
  {
    return;
  }
  const std::vector<double> volumes = cellVolumes(baseline);
  const double              radius = std::cbrt(0.75 * std::accumulate(volumes.begin(), volumes.end(), 0.0) / pi);
  const double              distance = medianDistance(found.surface);
  if (point.alignment && distance > nearby * radius)
  {
    const HexMesh theOtherWay = transformed(point.lattice, point.alignment->inverse());
    const double  ofInverse = medianDistance(surfaceMotion(baseline, theOtherWay, threads));
    if (ofInverse < muchNearer * distance)
    {
      warnings.push_back(fileMessage(point.transform.name,
                                     "its inverse brings the surfaces to " + millimetres(ofInverse) + " instead of " +
                                       millimetres(distance) + " of each other (median)",
                                     "give the transform from the baseline's space to the follow-up's"));
      return;
    }
  }
  if (distance > farAway * radius)
  {
    warnings.push_back(fileMessage(point.file.name,
                                   "its surface lies " + millimetres(distance) +
                                     " from the baseline's (median), whose radius is " + millimetres(radius),
                                   point.alignment ? "is it the transform of these visits?"
                                                   : "are the visits registered? else align them"));
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
      addWarningOfPlace(
        result.series.points[time], result.times.back(), baseline, align, threads, result.series.warnings);
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
