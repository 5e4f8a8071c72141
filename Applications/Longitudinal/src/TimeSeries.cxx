#include "TimeSeries.h"

#include "CommandErrors.h"
#include "moserhex/HexMeshIO/HexMeshReader.h"
#include "moserhex/HexMeshIO/TransformFile.h"

#include <algorithm>
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
  if (!options.transforms.empty() && options.align)
  {
    throw UsageError("both --transforms and --align; a transform is taken as it is");
  }
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
requireSameLattice(const TimedMesh & followUp, const TimedMesh & baseline)
{
  if (followUp.mesh.paddingLayers != baseline.mesh.paddingLayers)
  {
    throw BadInput(ErrorCode::Precondition,
                   followUp.file.name,
                   std::to_string(followUp.mesh.paddingLayers) + " layers of padding, the baseline has " +
                     std::to_string(baseline.mesh.paddingLayers),
                   "mesh both with the same --padding");
  }
  if (followUp.mesh.nodesPerSide != baseline.mesh.nodesPerSide)
  {
    throw BadInput(ErrorCode::Precondition,
                   followUp.file.name,
                   std::to_string(followUp.mesh.nodesPerSide) + " nodes a side, the baseline has " +
                     std::to_string(baseline.mesh.nodesPerSide),
                   "mesh both with the same --shells");
  }
}

TimePoint
pointOf(const TimedMesh & timed)
{
  TimePoint                 point;
  const std::vector<double> volumes = cellVolumes(timed.mesh);
  point.file = timed.file;
  point.volume = std::accumulate(volumes.begin(), volumes.end(), 0.0);
  point.lattice = latticePart(timed.mesh);
  point.quality = volumeQuality(point.lattice);
  point.cells = cellRecordOf(timed.reportBeside, timed.meshArrays);
  point.turn = turnOfLattice(timed.reportBeside, timed.meshArrays);
  point.record = recordOf(timed.reportBeside, timed.meshArrays);
  return point;
}

/** Of each file its name without ending, with its folder where another one is called the same. */
std::vector<std::string>
namesOf(const std::vector<std::string> & files)
{
  std::vector<std::string> names;
  for (const std::string & file : files)
  {
    const std::filesystem::path path(file);
    const auto                  isAlike = [&path](const std::string & other) {
      return std::filesystem::path(other).stem() == path.stem();
    };
    const bool isOnly = std::count_if(files.begin(), files.end(), isAlike) == 1;
    names.push_back(isOnly ? path.stem().string() : (path.parent_path().filename() / path.stem()).string());
  }
  return names;
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
  const auto warn = [&](const std::string & what, const char * consequence) {
    warnings.push_back(fileMessage(point.file.name, what, consequence));
  };
  if (point.quality.concaveCells > 0)
  {
    warn(std::to_string(point.quality.concaveCells) + " of " + std::to_string(point.lattice.cellCount()) +
           " cells are concave",
         "strain and Volumetric of folded cells mean nothing; give an exact mesh");
  }
  if (point.cells.isInexact)
  {
    warn("it was not made exact, or fell short of it", "uneven volumes of its cells are no local growth");
  }
  if (point.cells.hasDensity)
  {
    warn("its cells hold equal masses of a density",
         "their volumes follow it: Volumetric is growth only where mass was kept");
  }
}

/** Volumes of cells say what has grown only where the follow-up's were freed. */
void
addWarningOfUnevenCells(const TimePoint & baseline, const TimePoint & followUp, std::vector<std::string> & warnings)
{
  const auto isExplained = [](const TimePoint & point) {
    return point.cells.isInexact || point.cells.hasDensity || point.quality.concaveCells > 0;
  };
  const bool areEven = hasEvenCells(baseline) && hasEvenCells(followUp);
  if (areEven || followUp.cells.hasLocalGrowth || isExplained(baseline) || isExplained(followUp))
  {
    return;
  }
  const bool        isOfFollowUp = !hasEvenCells(followUp);
  const TimePoint & uneven = isOfFollowUp ? followUp : baseline;
  const TimePoint & other = isOfFollowUp ? baseline : followUp;
  warnings.push_back(fileMessage(uneven.file.name,
                                 "its cells are uneven (variance of the volumes " +
                                   shortNumber(uneven.quality.volumeVariance) + "), those of " +
                                   oneLine(other.name, 30) + (hasEvenCells(other) ? " are not" : ", too"),
                                 isOfFollowUp ? "Volumetric is no local growth, unless it was made with --local-growth"
                                              : "Volumetric is no local growth"));
}

void
addWarnings(TimeSeries & series)
{
  std::vector<TurnOfFile> turns;
  for (const TimePoint & point : series.points)
  {
    turns.push_back({ point.file.name, point.turn });
  }
  series.warnings = turnWarnings(turns, "what is measured may be the turn");
  for (std::size_t time = 0; time < series.points.size(); ++time)
  {
    addWarningsOfCells(series.points[time], series.warnings);
    if (time > 0)
    {
      addWarningOfUnevenCells(series.points.front(), series.points[time], series.warnings);
    }
  }
  if (series.paddingLayers > 0)
  {
    series.warnings.emplace_back(
      "the meshes' padding is left out: strain, surface, thickness and the volumes of regions are those of the "
      "lattice, which ends inside the organ");
  }
}

/** Without the warnings. */
TimeSeries
measuredSeries(const std::vector<TimedMesh> & meshes)
{
  TimeSeries series;
  for (const TimedMesh & timed : meshes)
  {
    requireSameLattice(timed, meshes.front());
    series.points.push_back(pointOf(timed));
  }
  series.paddingLayers = meshes.front().mesh.paddingLayers;
  return series;
}

} // namespace

bool
hasEvenCells(const TimePoint & point)
{
  constexpr double even = 1e-8; // [1], coordinates of 32 bits far from the origin stay below
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
  return options.transforms.empty() ? options.align.value_or("rigid") : "file";
}

TimeSeries
timeSeriesOf(const std::vector<TimedMesh> & meshes)
{
  TimeSeries series = measuredSeries(meshes);
  for (TimePoint & point : series.points)
  {
    point.name = point.file.name;
  }
  addWarnings(series);
  return series;
}

TimeSeries
readTimeSeries(const CompareCommandOptions & options)
{
  requireUsable(options);
  std::vector<TimedMesh> meshes;
  for (const std::string & name : options.meshes)
  {
    const InputFile file = inputFile(name);
    HexMeshFile     read = readHexMeshFile(name, { options.sandbox });
    meshes.push_back({ file, std::move(read.mesh), std::move(read.meshArrays), name });
  }
  TimeSeries                     series = measuredSeries(meshes);
  const std::vector<std::string> names = options.names.empty() ? namesOf(options.meshes) : options.names;
  for (std::size_t time = 0; time < series.points.size(); ++time)
  {
    TimePoint & point = series.points[time];
    point.name = names[time];
    if (!options.times.empty())
    {
      point.months = options.times[time];
    }
    if (time > 0 && !options.transforms.empty())
    {
      point.transform = inputFile(options.transforms[time - 1]);
      point.alignment = similarityOfFile(point.transform.name, { options.sandbox }).inverse();
    }
  }
  addWarnings(series);
  return series;
}

} // namespace moserhex::app
