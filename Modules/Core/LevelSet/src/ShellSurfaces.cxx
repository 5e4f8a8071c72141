#include "moserhex/LevelSet/ShellSurfaces.h"

#include "ShellCutting.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Parallel.h"
#include "moserhex/Geometry/SelfIntersection.h"
#include "moserhex/LevelSet/ShellOrdering.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace moserhex
{
namespace
{

std::string
shellName(std::size_t k, std::size_t count)
{
  std::ostringstream name;
  name << "shell " << k << " of " << count;
  return name.str();
}

/** Triangles wanted for a shell that encloses this fraction of the volume. The cube shell that does has sides of
 * (2N-1) fraction^(1/3) cells, 2k-1 for shell k, and six times its square quadrilaterals. */
double
wantedTriangles(double fraction, std::size_t shells, const ShellSurfaceOptions & options)
{
  const double side = (2.0 * static_cast<double>(shells) - 1.0) * std::cbrt(fraction);
  return std::max(options.fewestTriangles, options.trianglesPerQuad * 6.0 * side * side);
}

void
requireUsable(const LevelSet &            ordering,
              const LevelSet &            phi,
              double                      volume,
              const std::vector<double> & fractions,
              const ShellSurfaceOptions & options)
{
  std::ostringstream message;
  message << "shell surfaces: ";
  const auto   start = message.str().size();
  const double tolerance = 1e-9 * phi.grid.spacing;
  if (ordering.grid.size != phi.grid.size || std::abs(ordering.grid.spacing - phi.grid.spacing) > tolerance ||
      !(ordering.grid.origin - phi.grid.origin).isZero(tolerance) ||
      !ordering.grid.direction.isApprox(phi.grid.direction, 1e-9))
  {
    message << "ordering and phi have different grids";
  }
  else if (!(volume > 0.0))
  {
    message << "volume = " << volume << " mm^3, need > 0";
  }
  else if (fractions.empty() || fractions.back() != 1.0)
  {
    message << "the last volume fraction must be 1";
  }
  else if (!(fractions.front() > 0.0) || std::adjacent_find(fractions.begin(), fractions.end(), [](double a, double b) {
                                           return !(a < b);
                                         }) != fractions.end())
  {
    message << "the volume fractions must increase strictly from above 0";
  }
  else if (!(options.trianglesPerQuad > 0.0) || !(options.fewestTriangles >= 20.0) ||
           !(options.volumeTolerance > 0.0) || !(options.acceptedVolumeError > 0.0) || options.maximumVolumeShifts < 0)
  {
    message << "trianglesPerQuad = " << options.trianglesPerQuad
            << " (need > 0), fewestTriangles = " << options.fewestTriangles
            << " (need >= 20), volumeTolerance = " << options.volumeTolerance
            << " (need > 0), acceptedVolumeError = " << options.acceptedVolumeError
            << " (need > 0), maximumVolumeShifts = " << options.maximumVolumeShifts << " (need >= 0)";
  }
  if (message.str().size() > start)
  {
    throw InvalidInput(message.str());
  }
}

DistanceSummary
gapBetween(const TriangleMesh &       outer,
           const ClosestPointSearch & outerSearch,
           const TriangleMesh &       inner,
           const ClosestPointSearch & innerSearch)
{
  const DistanceSummary inwards = summarizeDistances(outer.vertices, innerSearch);
  const DistanceSummary outwards = summarizeDistances(inner.vertices, outerSearch);
  DistanceSummary       gap = inwards; // the mean over the larger shell, as its vertices see it
  gap.smallest = std::min(inwards.smallest, outwards.smallest);
  gap.largest = std::max(inwards.largest, outwards.largest);
  return gap;
}

/** Gaps, self-intersections, nesting: shell by shell, each writes only its own numbers. */
void
measureShells(std::vector<ShellSurface> & shells,
              const ShellSurfaceOptions & options,
              const ProgressCallback &    progress)
{
  ParallelProgress                shared(progress, shells.size());
  std::vector<ClosestPointSearch> searches;
  searches.reserve(shells.size());
  for (const ShellSurface & shell : shells)
  {
    searches.emplace_back(shell.mesh);
  }
  parallelFor(shells.size(), options.threads, [&](std::size_t i) {
    const std::size_t k = shells.size() - 1 - i; // the largest first: better balance
    ShellSurface &    shell = shells[k];
    shell.quality = summarizeSurfaceQuality(shell.mesh);
    shell.selfIntersections = options.checkIntersections ? countSelfIntersections(shell.mesh) : 0;
    if (k > 0)
    {
      const TriangleMesh & inner = shells[k - 1].mesh;
      shell.gap = gapBetween(shell.mesh, searches[k], inner, searches[k - 1]);
      shell.nested = !options.checkIntersections || isNestedInside(inner, shell.mesh);
    }
    shared.endPart();
  });
}

} // namespace

std::vector<ShellSurface>
extractShellSurfaces(const LevelSet &            ordering,
                     const LevelSet &            phi,
                     double                      volume,
                     const std::vector<double> & volumeFractions,
                     const ShellSurfaceOptions & options,
                     const ProgressCallback &    progress)
{
  requireUsable(ordering, phi, volume, volumeFractions, options);
  reportProgress(progress, 0.0);
  const ShellFunction       inside(ordering);
  const ShellFunction       boundary(phi);
  const std::size_t         count = volumeFractions.size();
  std::vector<ShellSurface> shells(count);
  const ProgressCallback    ofCutting = progressBetween(progress, 0.0, 0.8);
  ParallelProgress          shared(ofCutting, count);
  parallelFor(count, options.threads, [&](std::size_t i) {
    const std::size_t     k = count - i; // the largest first: better balance
    const ShellFunction & f = k == count ? boundary : inside;
    const double          fraction = volumeFractions[k - 1];
    shells[k - 1] =
      cutShell(f, volume * fraction, wantedTriangles(fraction, count, options), shellName(k, count), options);
    shared.endPart();
  });
  measureShells(shells, options, progressBetween(progress, 0.8, 1.0));
  reportProgress(progress, 1.0);
  return shells;
}

std::vector<ShellSurface>
extractShellSurfaces(const LevelSet &            ordering,
                     const LevelSet &            phi,
                     double                      volume,
                     int                         shells,
                     const ShellSurfaceOptions & options,
                     const ProgressCallback &    progress)
{
  return extractShellSurfaces(ordering, phi, volume, cubeVolumeFractions(shells), options, progress);
}

ShellSurfacesSummary
summarizeShells(const std::vector<ShellSurface> & shells, const ShellSurfaceOptions & options)
{
  ShellSurfacesSummary summary;
  summary.minimumAngle = shells.empty() ? 0.0 : 180.0;
  for (std::size_t i = 0; i < shells.size(); ++i)
  {
    const ShellSurface & shell = shells[i];
    summary.triangles += shell.mesh.triangles.size();
    summary.worstVolumeError = std::max(summary.worstVolumeError, std::abs(shell.volume / shell.targetVolume - 1.0));
    summary.minimumAngle = std::min(summary.minimumAngle, shell.quality.minimumAngle);
    summary.negativeCotangents += shell.quality.negativeCotangents;
    summary.selfIntersections += shell.selfIntersections;
    summary.notNested += shell.nested ? 0 : 1;
    if (i > 0)
    {
      summary.smallestGap = i == 1 ? shell.gap.smallest : std::min(summary.smallestGap, shell.gap.smallest);
      summary.largestGap = std::max(summary.largestGap, shell.gap.largest);
      summary.meanGap += shell.gap.mean / static_cast<double>(shells.size() - 1);
    }
  }
  const auto warn = [&](bool condition, auto &&... parts) {
    if (condition)
    {
      std::ostringstream message;
      (message << ... << parts);
      summary.warnings.push_back(message.str());
    }
  };
  warn(shells.size() > 1 && summary.smallestRelativeGap() < options.smallestRelativeGap,
       "smallest gap between shells is ",
       summary.smallestRelativeGap(),
       " of the mean, wanted ",
       options.smallestRelativeGap);
  warn(summary.selfIntersections > 0, summary.selfIntersections, " pairs of triangles of the shells intersect");
  warn(summary.notNested > 0, summary.notNested, " shells do not enclose the next smaller one");
  warn(summary.negativeCotangents > 0, summary.negativeCotangents, " sides have a negative cotangent weight");
  return summary;
}

} // namespace moserhex
