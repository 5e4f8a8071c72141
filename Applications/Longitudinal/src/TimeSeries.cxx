#include "TimeSeries.h"

#include "CommandErrors.h"
#include "MeshRecord.h"
#include "moserhex/HexMeshIO/HexMeshReader.h"
#include "moserhex/HexMeshIO/TransformFile.h"

#include <cmath>
#include <filesystem>

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

} // namespace

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
    const std::string & file = options.meshes[time];
    const HexMeshFile   read = readHexMeshFile(file, { options.sandbox });
    const HexMesh &     mesh = read.mesh;
    if (time == 0)
    {
      baseline = mesh;
    }
    requireSameLattice(file, mesh, baseline);
    TimePoint point;
    point.file = file;
    point.name = options.names.empty() ? std::filesystem::path(file).stem().string() : options.names[time];
    if (!options.times.empty())
    {
      point.months = options.times[time];
    }
    point.lattice = latticePart(mesh);
    if (time > 0 && !options.transforms.empty())
    {
      point.alignment = similarityOfFile(options.transforms[time - 1], { options.sandbox }).inverse();
    }
    series.points.push_back(point);
    turns.push_back({ file, turnOfLattice(file, read.meshArrays) });
  }
  series.warnings = turnWarnings(turns, "what is measured may be the turn");
  series.paddingLayers = baseline.paddingLayers;
  if (series.paddingLayers > 0)
  {
    series.warnings.emplace_back(
      "the meshes' padding is left out: surface and thickness are those of the lattice, which "
      "ends inside the organ");
  }
  return series;
}

} // namespace moserhex::app
