#include "ExactResults.h"

#include "GmshMesh.h"
#include "MeshNumbers.h"
#include "ResultsRun.h"

#include "itkLevelSetConversion.h"

#include "moserhex/Analytic/ObservedOrder.h"
#include "moserhex/Common/Stopwatch.h"
#include "moserhex/Geometry/ClosestPoint.h"
#include "moserhex/HexMeshIO/HexMeshWriter.h"
#include "moserhex/LevelSet/ShellSurfaces.h"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <optional>
#include <sstream>

namespace moserhex::results
{
namespace
{

/** Reading, meshing and writing of one file. */
struct TimedRun
{
  Run    run;
  double seconds{ 0.0 };
};

TimedRun
runWithFiles(const std::filesystem::path & file, const RunOptions & options)
{
  const std::string output =
    (std::filesystem::temp_directory_path() / ("moserhex_results_" + caseName(file) + ".vtu")).string();
  const Stopwatch  stopwatch;
  const LabelImage image = readLabelImage(file.string());
  TimedRun         timed{ runPipeline(image, options), 0.0 };
  writeHexMesh(output, timed.run.pipeline->GetHexMesh());
  timed.seconds = stopwatch.seconds();
  std::filesystem::remove(output);
  return timed;
}

MeshNumbers
numbersOfRun(const Run & run, double seconds)
{
  const MeshingStageReport & last = run.pipeline->GetStages().back();
  MeshNumbers                numbers = numbersOf(*last.quality, run.pipeline->GetLabelVolume());
  numbers.boundary = run.pipeline->GetResult().boundary.maximum;
  numbers.seconds = seconds;
  return numbers;
}

std::string
joined(const std::vector<std::string> & parts)
{
  std::string text;
  for (const std::string & part : parts)
  {
    text += (text.empty() ? "" : "; ") + part;
  }
  return text;
}

/** What of the contract was missed, and whether the cube had to be turned. */
std::string
noteOf(const SolidMeshingResult & result)
{
  std::vector<std::string> parts;
  if (result.equalisation && !result.equalisation->exact)
  {
    parts.push_back("not exact: " + joined(result.equalisation->shortcomings));
  }
  if (!result.turnWarning.empty())
  {
    parts.push_back(result.turnWarning.substr(0, result.turnWarning.find(':')));
  }
  return joined(parts);
}

/** Numbers of one case, or a line that says why there are none. */
using Measurement = std::function<MeshNumbers(const ExactCase &, std::string & note)>;

/** A row a case; refused ones have no numbers and do not count. */
std::vector<MeshNumbers>
writeCases(std::ostream & os, const std::vector<ExactCase> & cases, const Measurement & measure)
{
  std::vector<MeshNumbers> rows;
  writeHeading(os, "case", "note");
  for (const ExactCase & one : cases)
  {
    std::cerr << one.name << std::endl;
    std::string note;
    try
    {
      rows.push_back(measure(one, note));
      writeRow(os, one.name, rows.back(), note);
    }
    catch (const itk::ExceptionObject & error)
    {
      writeRefusal(os, one.name, error.GetDescription());
    }
    catch (const std::exception & error)
    {
      writeRefusal(os, one.name, error.what());
    }
  }
  writeRow(os, "**median**", medianOf(rows));
  writeRow(os, "**worst**", worstOf(rows));
  return rows;
}

/** The stages one after the other, the two ways to the exact mesh, and padding. */
struct AblationStep
{
  const char * name;
  MeshingStage lastStage;
  MeshingWay   way;
  int          paddingLayers{ 0 };
};
constexpr AblationStep ablationSteps[] = {
  { "initial", MeshingStage::Initial, MeshingWay::Faithful },
  { "smoothed", MeshingStage::Smoothed, MeshingWay::Faithful },
  { "moser", MeshingStage::Moser, MeshingWay::Faithful },
  { "exact, faithful way", MeshingStage::Exact, MeshingWay::Faithful },
  { "exact, fast way", MeshingStage::Exact, MeshingWay::Fast },
  { "exact, 1 layer of padding", MeshingStage::Exact, MeshingWay::Fast, 1 },
  { "exact, 2 layers of padding", MeshingStage::Exact, MeshingWay::Fast, 2 },
};

/** The surface that encloses the label's volume, as the chain cuts it out. */
TriangleMesh
outerSurface(const LabelImage & image, int shells, double & volume)
{
  const auto conditioning = Pipeline::ConditioningFilterType::New();
  conditioning->SetInput(image.image);
  conditioning->SetLabel(chooseLabel(image, std::nullopt).value);
  conditioning->SetNodesPerSide(2 * shells);
  conditioning->Update();
  volume = conditioning->GetLabelVolume();
  const LevelSet phi = itk::LevelSetFromImage(conditioning->GetOutput());
  return extractShellSurfaces(phi, phi, volume, std::vector<double>{ 1.0 }).back().mesh;
}

/** Of boundary nodes and centres of boundary faces to the surface [mm]. */
double
boundaryDistance(const UnstructuredHexMesh & mesh, const TriangleMesh & surface)
{
  const ClosestPointSearch search(surface);
  double                   squared = 0.0;
  const auto look = [&](const Vector3 & p) { squared = std::max(squared, search.closest(p).squaredDistance); };
  for (const Quadrilateral & face : boundaryFaces(mesh))
  {
    Vector3 centre = Vector3::Zero();
    for (const std::size_t node : face)
    {
      look(mesh.nodes[node]);
      centre += 0.25 * mesh.nodes[node];
    }
    look(centre);
  }
  return std::sqrt(squared);
}

/** Largest resident memory of this process so far [GiB]. */
double
peakMemory()
{
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / (1024.0 * 1024.0);
}

} // namespace

void
writeExact(std::ostream & os, const std::vector<ExactCase> & cases)
{
  writeCases(os, cases, [](const ExactCase & one, std::string & note) {
    RunOptions options;
    options.shells = one.shells;
    options.lastStage = MeshingStage::Exact;
    options.way = MeshingWay::Fast;
    const TimedRun timed = runWithFiles(one.file, options);
    note = noteOf(timed.run.pipeline->GetResult());
    return numbersOfRun(timed.run, timed.seconds);
  });
}

void
writeAblation(std::ostream & os, const std::vector<ExactCase> & cases)
{
  os << "\n### Stage by stage\n\n"
        "The chain stopped after each stage, all shells; then the fast way (default), alone and with padding. Medians, "
        "then\n"
        "worst cases. A row has a case only if it gave a mesh. Times without reading and writing.\n\n";
  writeHeading(os, "chain ends after", "meshes, of them exact");
  std::ostringstream worst;
  for (const AblationStep & step : ablationSteps)
  {
    std::vector<MeshNumbers> rows;
    int                      exact = 0;
    for (const ExactCase & one : cases)
    {
      std::cerr << step.name << ' ' << one.name << std::endl;
      RunOptions options;
      options.shells = one.shells;
      options.lastStage = step.lastStage;
      options.way = step.way;
      options.paddingLayers = step.paddingLayers;
      try
      {
        const Run run = runPipeline(readLabelImage(one.file.string()), options);
        rows.push_back(numbersOfRun(run, run.seconds));
        const auto & equalisation = run.pipeline->GetResult().equalisation;
        exact += equalisation && equalisation->exact ? 1 : 0;
      }
      catch (const std::exception & error)
      {
        std::cerr << error.what() << std::endl;
      }
    }
    const std::string count = std::to_string(rows.size()) +
                              (step.lastStage == MeshingStage::Exact ? ", " + std::to_string(exact) : std::string());
    writeRow(os, std::string(step.name) + ", median", medianOf(rows), count);
    writeRow(worst, std::string(step.name) + ", worst", worstOf(rows));
  }
  os << worst.str();
}

void
writeGmsh(std::ostream & os, const std::vector<ExactCase> & cases)
{
  os << "\n### gmsh's hexahedra in the same surfaces\n\n"
        "The outer surface as STL, remeshed by gmsh to about as many cells; tetrahedra cut into four hexahedra each\n"
        "(`Mesh.SubdivisionAlgorithm = 2`, and `Mesh.SecondOrderLinear = 1`, without which some cells turn over). Not "
        "a\n"
        "lattice. Time of the process alone, without our conditioning.\n\n";
  if (!hasGmsh())
  {
    os << "Not measured: no `gmsh` executable.\n";
    return;
  }
  writeCases(os, cases, [](const ExactCase & one, std::string & /*note*/) {
    double             volume = 0.0;
    const TriangleMesh surface = outerSurface(readLabelImage(one.file.string()), one.shells, volume);
    const GmshMesh     gmsh = gmshHexahedra(surface, volume, std::pow(2.0 * one.shells - 1.0, 3));
    MeshNumbers        numbers = numbersOf(summarizeQuality(gmsh.mesh), volume);
    numbers.boundary = boundaryDistance(gmsh.mesh, surface);
    numbers.seconds = gmsh.seconds;
    return numbers;
  });
}

void
writeGrowth(std::ostream & os, const std::filesystem::path & file)
{
  os << "\n### Growth\n\nThe whole default run of " << caseName(file)
     << ", reading and writing included, over the number of shells.\n\n";
  writeHeading(os, "N", "of it exact (s); peak memory (GiB)");
  std::vector<double> cells;
  std::vector<double> seconds;
  for (const int shells : { 10, 15, 20, 32 })
  {
    std::cerr << "N = " << shells << std::endl;
    RunOptions options;
    options.shells = shells;
    options.lastStage = MeshingStage::Exact;
    options.way = MeshingWay::Fast;
    const TimedRun timed = runWithFiles(file, options);
    cells.push_back(static_cast<double>(timed.run.pipeline->GetHexMesh().cellCount()));
    seconds.push_back(timed.seconds);
    const std::string note = noteOf(timed.run.pipeline->GetResult());
    writeRow(os,
             std::to_string(shells),
             numbersOfRun(timed.run, timed.seconds),
             fixed(stageOf(timed.run, "exact").seconds, 2) + "; " + fixed(peakMemory(), 2) +
               (note.empty() ? "" : "; " + note));
  }
  os << "\nFitted: time ~ cells^" << fixed(analytic::observedOrder(cells, seconds), 2) << ".\n";
}

} // namespace moserhex::results
