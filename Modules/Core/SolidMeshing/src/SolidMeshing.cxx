#include "moserhex/SolidMeshing/SolidMeshing.h"

#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Parallel.h"
#include "moserhex/Common/Stopwatch.h"
#include "moserhex/Geometry/ClosestPoint.h"
#include "moserhex/LevelSet/CubicInterpolation.h"
#include "moserhex/LevelSet/ShellOrdering.h"
#include "moserhex/SphericalMap/FrameAlignment.h"
#include "moserhex/StructuredGrid/CubeLattice.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace moserhex
{
namespace
{

/** Newton steps that put a point near a level set onto it. */
constexpr int projectionIterations = 4;

/** Parts of the whole run, for progress only. */
constexpr double afterSurfaces = 0.4;
constexpr double afterSphereMaps = 0.8;
constexpr double afterInitialMap = 0.85;

/** Within half a grid edge of the surface phi is a distance and Newton along its gradient finds the nearest point;
 * farther out the nearest point of the triangles comes first. */
SurfaceProjection
projectionOnto(const ClosestPointSearch & search, const CubicInterpolator & phi, double level)
{
  const double maximumStep = 0.5 * phi.grid().spacing;
  return [&search, &phi, level, maximumStep](const Vector3 & p) {
    const bool    isNear = std::abs(phi.value(p) - level) <= maximumStep;
    const Vector3 start = isNear ? p : search.closest(p).point;
    return projectToLevel(phi, start, level, maximumStep, projectionIterations);
  };
}

BoundaryDistance
boundaryDistance(const HexMesh & mesh, const SurfaceProjection & projection)
{
  const CubeLattice lattice(mesh.nodesPerSide / 2);
  BoundaryDistance  result;
  double            squares = 0.0;
  std::size_t       count = 0;
  const auto        add = [&](const Vector3 & p) {
    const double squared = (projection(p) - p).squaredNorm();
    squares += squared;
    ++count;
    result.maximum = std::max(result.maximum, std::sqrt(squared));
  };
  for (const std::size_t node : lattice.nodesOfShell(lattice.shells()))
  {
    add(mesh.nodes[node]);
  }
  result.maximumOfNodes = result.maximum;
  for (const Quad & quad : lattice.quadsOfShell(lattice.shells()))
  {
    add(0.25 * (mesh.nodes[quad[0]] + mesh.nodes[quad[1]] + mesh.nodes[quad[2]] + mesh.nodes[quad[3]]));
  }
  result.rms = std::sqrt(squares / static_cast<double>(count));
  return result;
}

std::string
describe(const std::vector<AreaPreservingMapResult> & maps)
{
  int    flips = 0;
  double rms = 0.0;
  for (const AreaPreservingMapResult & map : maps)
  {
    flips += map.quality.flippedTriangles;
    rms = std::max(rms, map.quality.areaRatioRms);
  }
  std::ostringstream text;
  text << flips << " flipped triangles, area ratio rms at most " << rms;
  return text.str();
}

/** Keeps the time and the mesh quality of the stages. */
class StageLog
{
public:
  explicit StageLog(std::vector<MeshingStageReport> & stages) : m_Stages(stages)
  {}

  void
  add(const std::string & name, const std::string & note = {})
  {
    m_Stages.push_back({ name, m_Stopwatch.seconds(), {}, note });
    m_Stopwatch = {};
  }

  void
  add(const std::string & name, const HexMesh & mesh, const std::string & note = {})
  {
    const double seconds = m_Stopwatch.seconds();
    m_Stages.push_back({ name, seconds, summarizeQuality(mesh), note });
    m_Stopwatch = {};
  }

private:
  std::vector<MeshingStageReport> & m_Stages;
  Stopwatch                         m_Stopwatch;
};

} // namespace

void
alignShellFramesInPlace(const std::vector<TriangleMesh> & shells, std::vector<Positions> & maps)
{
  if (shells.size() != maps.size())
  {
    throw InvalidInput(std::to_string(shells.size()) + " shells but " + std::to_string(maps.size()) + " maps");
  }
  for (std::size_t k = shells.size(); k-- > 1;)
  {
    const TriangleMesh &     outer = shells[k];
    const TriangleMesh &     inner = shells[k - 1];
    const ClosestPointSearch search(outer);
    Positions                reference;
    reference.reserve(inner.vertices.size());
    for (const Vector3 & vertex : inner.vertices)
    {
      const ClosestPointOnSurface closest = search.closest(vertex);
      const Triangle &            t = outer.triangles[closest.triangle];
      const Vector3 direction = closest.barycentric[0] * maps[k][t[0]] + closest.barycentric[1] * maps[k][t[1]] +
                                closest.barycentric[2] * maps[k][t[2]];
      reference.push_back(direction.normalized());
    }
    maps[k - 1] = rotated(maps[k - 1], referenceFrameRotation(inner, maps[k - 1], reference));
  }
}

SolidMeshingResult
meshSolid(const LevelSet &            ordering,
          const LevelSet &            phi,
          double                      volume,
          const SolidMeshingOptions & options,
          const ProgressCallback &    progress)
{
  SolidMeshingResult result;
  StageLog           log(result.stages);

  // C. Shell surfaces.
  ShellSurfaceOptions surfaceOptions = options.surfaces;
  surfaceOptions.threads = options.threads;
  const std::vector<double> fractions =
    options.volumeFractions.empty() ? cubeVolumeFractions(options.shells) : options.volumeFractions;
  std::vector<ShellSurface> shells = extractShellSurfaces(
    ordering, phi, volume, fractions, surfaceOptions, progressBetween(progress, 0.0, afterSurfaces));
  result.shells = summarizeShells(shells, surfaceOptions);
  result.warnings = result.shells.warnings;
  std::vector<TriangleMesh> surfaces;
  for (ShellSurface & shell : shells)
  {
    surfaces.push_back(std::move(shell.mesh));
  }
  log.add("shell surfaces", std::to_string(result.shells.triangles) + " triangles");

  // D, E. Sphere maps, the largest shell first so that threads end together.
  const std::size_t count = surfaces.size();
  result.sphereMaps.resize(count);
  std::vector<Positions> maps(count);
  parallelFor(count, options.threads, [&](std::size_t i) {
    const std::size_t k = count - 1 - i;
    result.sphereMaps[k] = areaPreservingSphereMap(surfaces[k], options.sphereMap);
    maps[k] = std::move(result.sphereMaps[k].positions);
    result.sphereMaps[k].positions.clear();
  });
  reportProgress(progress, afterSphereMaps);
  for (std::size_t k = 0; k < count; ++k)
  {
    const std::vector<StepReport> & reports = result.sphereMaps[k].reports;
    if (!reports.empty() && !reports.back().converged)
    {
      result.warnings.push_back("sphere map of shell " + std::to_string(k + 1) + " stopped after " +
                                std::to_string(reports.back().steps) + " steps, before its minimiser");
    }
  }
  alignShellFramesInPlace(surfaces, maps);
  log.add("sphere maps", describe(result.sphereMaps));

  // F, G. Initial map: the cube shells' nodes on the organ's shells, then onto the exact level sets.
  const CubicInterpolator  orderingAt(ordering);
  const CubicInterpolator  phiAt(phi);
  const ClosestPointSearch outerSurface(surfaces.back());
  const double             maximumStep = 0.5 * phi.grid.spacing;
  InitialMapOptions        initialOptions;
  initialOptions.cubeShells = options.cubeShells;
  initialOptions.threads = options.threads;
  initialOptions.projection = [&](int shell, const Vector3 & p) {
    const std::size_t k = static_cast<std::size_t>(shell) - 1;
    return projectToLevel(k + 1 == count ? phiAt : orderingAt, p, shells[k].level, maximumStep, projectionIterations);
  };
  result.mesh = initialMap(surfaces, maps, initialOptions, progressBetween(progress, afterSphereMaps, afterInitialMap));
  log.add("initial map", result.mesh);

  // H. Smoothing.
  const SurfaceProjection projection = projectionOnto(outerSurface, phiAt, shells.back().level);
  if (options.lastStage != MeshingStage::Initial)
  {
    result.mesh = smoothLattice(result.mesh, projection, options.smoothing);
    log.add("smoothing", result.mesh);
  }

  // I. Volumetric Moser flow.
  if (options.lastStage == MeshingStage::Moser)
  {
    VolumetricMoserFlowResult flow =
      volumetricMoserFlow(result.mesh, projection, options.flow, progressBetween(progress, afterInitialMap, 1.0));
    result.mesh = std::move(flow.mesh);
    std::ostringstream note;
    note << "pass " << flow.bestPass << " of " << flow.passes.size() - 1 << " is the best";
    log.add("moser flow", result.mesh, note.str());
    if (flow.bestPass == 0)
    {
      result.warnings.emplace_back("the volumetric flow did not improve the mesh; the mesh before it is returned");
    }
  }
  result.boundary = boundaryDistance(result.mesh, projection);
  reportProgress(progress, 1.0);
  return result;
}

} // namespace moserhex
