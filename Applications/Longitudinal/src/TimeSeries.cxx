#include "TimeSeries.h"

#include "CommandErrors.h"
#include "MeshRecord.h"
#include "moserhex/HexMeshIO/HexMeshReader.h"
#include "moserhex/HexMeshIO/TransformFile.h"

#include <cmath>
#include <filesystem>
#include <numeric>
#include <sstream>
#include <utility>

namespace moserhex::app
{
namespace
{

void
requireAsMany(const char * option, std::size_t given, std::size_t wanted, const char * what)
{
  if (given != 0 && given != wanted)
  {
    throw UsageError(std::string(option) + " has " + std::to_string(given) + " entries for " + std::to_string(wanted) +
                     " " + what + "; give one for each");
  }
}

void
requireUsable(const CompareCommandOptions & options)
{
  if (options.meshes.size() < 2)
  {
    throw UsageError("one mesh is no comparison; give a baseline and one follow-up or more");
  }
  requireAsMany("--times", options.times.size(), options.meshes.size(), "meshes");
  requireAsMany("--names", options.names.size(), options.meshes.size(), "meshes");
  requireAsMany("--transforms", options.transforms.size(), options.meshes.size() - 1, "follow-ups");
  for (std::size_t time = 0; time < options.times.size(); ++time)
  {
    if (!std::isfinite(options.times[time]) || (time > 0 && !(options.times[time] > options.times[time - 1])))
    {
      throw UsageError("--times must ascend; give the months of the meshes in their order");
    }
  }
}

/** \throws BadInput  another lattice than the baseline's */
void
requireSameLattice(const std::string & file, const HexMesh & mesh, const HexMesh & baseline)
{
  if (mesh.nodesPerSide != baseline.nodesPerSide)
  {
    throw BadInput(ErrorCode::Precondition,
                   file,
                   std::to_string(mesh.nodesPerSide) + " nodes a side, the baseline has " +
                     std::to_string(baseline.nodesPerSide),
                   "mesh both with the same --shells");
  }
  if (mesh.paddingLayers != baseline.paddingLayers)
  {
    throw BadInput(ErrorCode::Precondition,
                   file,
                   std::to_string(mesh.paddingLayers) + " layers of padding, the baseline has " +
                     std::to_string(baseline.paddingLayers),
                   "mesh both with the same --padding");
  }
}

std::string
nameOfTime(const CompareCommandOptions & options, std::size_t time)
{
  return options.names.empty() ? std::filesystem::path(options.meshes[time]).stem().string() : options.names[time];
}

void
takeMesh(const HexMesh & mesh, TimePoint & point)
{
  const std::vector<double> volumes = cellVolumes(mesh);
  point.volume = std::accumulate(volumes.begin(), volumes.end(), 0.0);
  point.lattice = latticePart(mesh);
  point.quality = volumeQuality(point.lattice);
}

std::string
shortNumber(double value)
{
  std::ostringstream text;
  text.precision(2);
  text << value;
  return text.str();
}

/** What the cells of a mesh by itself make doubtful. */
void
addWarningsOfCells(const TimePoint & point, std::vector<std::string> & warnings)
{
  if (point.quality.concaveCells > 0)
  {
    warnings.push_back(fileMessage(point.file.name,
                                   std::to_string(point.quality.concaveCells) + " of " +
                                     std::to_string(point.lattice.cellCount()) + " cells are concave",
                                   "strain and Volumetric of folded cells mean nothing; give an exact mesh"));
  }
  if (isReportedInexact(point.file.name))
  {
    warnings.push_back(fileMessage(
      point.file.name, "its report says that it is not exact", "uneven volumes of its cells are no local growth"));
  }
}

/** Volumes of cells say what has grown only where both meshes were made alike, or the follow-up's volumes were freed.
 */
void
addWarningOfUnevenCells(const TimePoint & baseline, const TimePoint & followUp, std::vector<std::string> & warnings)
{
  if (hasEvenCells(baseline) == hasEvenCells(followUp) || followUp.hasLocalGrowth)
  {
    return;
  }
  const bool        isBaseline = hasEvenCells(followUp);
  const TimePoint & uneven = isBaseline ? baseline : followUp;
  const TimePoint & even = isBaseline ? followUp : baseline;
  warnings.push_back(fileMessage(uneven.file.name,
                                 "its cells are uneven (variance of the volumes " +
                                   shortNumber(uneven.quality.volumeVariance) + "), those of " +
                                   oneLine(even.name, 30) + " are not",
                                 isBaseline ? "Volumetric is no local growth"
                                            : "Volumetric is no local growth, unless it was made with --local-growth"));
}

} // namespace

bool
hasEvenCells(const TimePoint & point)
{
  constexpr double even = 1e-12; // [1]
  return point.quality.volumeVariance <= even;
}

AlignmentKind
alignmentOf(const std::string & align)
{
  if (align == "none")
  {
    return AlignmentKind::None;
  }
  return align == "similarity" ? AlignmentKind::Similarity : AlignmentKind::Rigid;
}

std::string
alignmentName(const CompareCommandOptions & options)
{
  return options.transforms.empty() ? options.align : "file";
}

TimeSeries
readTimeSeries(const CompareCommandOptions & options)
{
  requireUsable(options);
  TimeSeries              series;
  std::vector<TurnOfFile> turns;
  HexMesh                 baseline;
  for (std::size_t time = 0; time < options.meshes.size(); ++time)
  {
    TimePoint point;
    point.file = inputFile(options.meshes[time]);
    HexMeshFile read = readHexMeshFile(point.file.name, { options.sandbox });
    turns.push_back({ point.file.name, turnOfLattice(point.file.name, read.meshArrays) });
    if (time == 0)
    {
      baseline = read.mesh;
    }
    requireSameLattice(point.file.name, read.mesh, baseline);
    takeMesh(read.mesh, point);
    point.name = nameOfTime(options, time);
    if (!options.times.empty())
    {
      point.months = options.times[time];
    }
    point.hasLocalGrowth = hasLocalGrowth(point.file.name, read.meshArrays);
    if (time > 0 && !options.transforms.empty())
    {
      point.transform = inputFile(options.transforms[time - 1]);
      point.alignment = similarityOfFile(point.transform.name, { options.sandbox }).inverse();
    }
    series.points.push_back(std::move(point));
  }
  series.warnings = turnWarnings(turns, "what is measured may be the turn");
  for (const TimePoint & point : series.points)
  {
    addWarningsOfCells(point, series.warnings);
    addWarningOfUnevenCells(series.points.front(), point, series.warnings);
  }
  series.paddingLayers = baseline.paddingLayers;
  if (series.paddingLayers > 0)
  {
    series.warnings.emplace_back(
      "the meshes' padding is left out: strain, surface, thickness and the volumes of regions are those of the "
      "lattice, which ends inside the organ");
  }
  return series;
}

} // namespace moserhex::app
