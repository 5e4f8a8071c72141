#include "moserhex/SolidMeshing/SolidMeshing.h"

#include "TurnedFrames.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Parallel.h"
#include "moserhex/Common/Stopwatch.h"
#include "moserhex/Geometry/ClosestPoint.h"
#include "moserhex/HexMap/MassMeasure.h"
#include "moserhex/LevelSet/CubicInterpolation.h"
#include "moserhex/LevelSet/ShellOrdering.h"
#include "moserhex/SphericalMap/FrameAlignment.h"
#include "moserhex/StructuredGrid/CubeLattice.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <iomanip>
#include <sstream>
#include <tuple>
#include <utility>

namespace moserhex
{
namespace
{

/** Area ratio rms that is enough of a sphere map that only starts the optimisation [1]. */
constexpr double fastAreaTolerance = 0.05;

/** Newton steps that put a point near a level set onto it. */
constexpr int projectionIterations = 4;
/** The same for a point that may be a few grid edges away. */
constexpr int nearestPointIterations = 20;

const double degree = std::acos(-1.0) / 180.0;

/** Turned frames that are tried on a lattice of 6 and of 10 nodes a side. */
constexpr std::size_t turnsOnCoarsestLattice = 24;
constexpr std::size_t turnsOnCoarseLattice = 6;

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

/** Newton from the point itself and from the nearest point of the triangles; the nearer result. Near a crease either
 * may miss the nearest point. */
SurfaceProjection
nearestPointOn(const ClosestPointSearch & search, const CubicInterpolator & phi, double level)
{
  const double maximumStep = 0.5 * phi.grid().spacing;
  return [&search, &phi, level, maximumStep](const Vector3 & p) {
    const Vector3 a = projectToLevel(phi, p, level, maximumStep, nearestPointIterations);
    const Vector3 b = projectToLevel(phi, search.closest(p).point, level, maximumStep, nearestPointIterations);
    const bool    aIsThere = std::abs(phi.value(a) - level) < 1e-3 * phi.grid().spacing;
    return aIsThere && (a - p).squaredNorm() < (b - p).squaredNorm() ? a : b;
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

bool
isFast(const SolidMeshingOptions & options)
{
  return options.lastStage == MeshingStage::Exact && options.way == MeshingWay::Fast;
}

SignedDistance
signedDistance(const CubicInterpolator & phi)
{
  return [&phi](const Vector3 & point, Vector3 & gradient) {
    const ValueAndGradient at = phi.at(point);
    gradient = at.gradient;
    return at.value;
  };
}

EqualisationOptions
equalisationOptions(const SolidMeshingOptions & options)
{
  EqualisationOptions equalisation = options.equalisation;
  equalisation.nodesPerSide = 2 * options.shells;
  equalisation.threads = options.threads;
  return equalisation;
}

/** Stage J: replaces the mesh; what is returned has none. */
EqualisationResult
equalise(HexMesh &                   mesh,
         const CubicInterpolator &   phi,
         double                      volume,
         const SolidMeshingOptions & options,
         const ProgressCallback &    progress)
{
  EqualisationResult result =
    equaliseVolumes(mesh, signedDistance(phi), volume, equalisationOptions(options), progress);
  mesh = std::move(result.mesh);
  result.mesh = {};
  return result;
}

/** Stage J under a density, from a mesh of equal volumes, on which the quadrature is chosen. */
void
equaliseMasses(const CubicInterpolator &   phi,
               double                      volume,
               const SolidMeshingOptions & options,
               SolidMeshingResult &        result,
               const ProgressCallback &    progress)
{
  const MassQuadrature rule =
    chooseMassQuadrature(result.mesh, *options.density, options.densityAccuracy, options.threads);
  const MassMeasure  measure(*options.density, rule.options);
  EqualisationResult masses =
    equaliseMeasures(result.mesh, signedDistance(phi), volume, measure, volume, equalisationOptions(options), progress);
  result.mesh = std::move(masses.mesh);
  masses.mesh = {};
  result.equalisation = std::move(masses);
  result.mass = MassReport{ measureEquality(result.mesh, measure, options.threads).variance,
                            measure.estimateError(result.mesh, options.threads) };
  if (result.mass->quadratureError > options.densityAccuracy)
  {
    std::ostringstream text;
    text << "masses are integrated to " << result.mass->quadratureError << " of the mean mass only, wanted "
         << options.densityAccuracy << ": the density is rougher than the cells";
    result.warnings.push_back(text.str());
  }
}

/** A mesh that was given up before its cells were made equal (EqualisationOptions::hopelessCells). */
bool
isGivenUp(const EqualisationResult & result)
{
  constexpr double equalVariance = 1e-12;
  return result.variance > equalVariance;
}

/** Smaller is better. */
auto
badness(const EqualisationResult & result)
{
  return std::make_tuple(
    !result.exact, isGivenUp(result), result.concaveCells, result.uncertifiedCells, result.largestDistance);
}

/** How far a start led on a coarse lattice; smaller is better. */
struct Prospect
{
  std::size_t uncertifiedCells{ 0 };
  double      smallestScaledJacobian{ 0.0 };
  Matrix3     turn{ Matrix3::Identity() };

  [[nodiscard]] bool
  isBetterThan(const Prospect & other) const
  {
    return std::make_tuple(uncertifiedCells, -smallestScaledJacobian) <
           std::make_tuple(other.uncertifiedCells, -other.smallestScaledJacobian);
  }
};

/** Sorts turns by the meshes they lead to on a coarse lattice, best first, and keeps the best. */
void
keepBestOnLattice(int                                             nodesPerSide,
                  std::size_t                                     count,
                  const std::function<HexMesh(const Matrix3 &)> & turnedStart,
                  const CubicInterpolator &                       phi,
                  double                                          volume,
                  const SolidMeshingOptions &                     options,
                  std::vector<Matrix3> &                          turns)
{
  EqualisationOptions coarse = equalisationOptions(options);
  coarse.nodesPerSide = std::min(nodesPerSide, coarse.nodesPerSide);
  coarse.repairRounds = 0;
  coarse.hopelessCells = 0;
  coarse.threads = 1;
  std::vector<Prospect> prospects(turns.size());
  parallelFor(turns.size(), options.threads, [&](std::size_t t) {
    const EqualisationResult result = equaliseVolumes(turnedStart(turns[t]), signedDistance(phi), volume, coarse);
    prospects[t] = { result.uncertifiedCells, summarizeQuality(result.mesh).scaledJacobian.minimum, turns[t] };
  });
  std::stable_sort(
    prospects.begin(), prospects.end(), [](const Prospect & a, const Prospect & b) { return a.isBetterThan(b); });
  turns.resize(std::min(count, turns.size()));
  for (std::size_t t = 0; t < turns.size(); ++t)
  {
    turns[t] = prospects[t].turn;
  }
}

std::string
describeTurn(const Matrix3 & turn)
{
  const Eigen::AngleAxis<double> rotation(turn);
  std::ostringstream             text;
  text << "the lattice is turned by " << std::round(rotation.angle() / degree) << " degrees about ("
       << std::setprecision(2) << rotation.axis().transpose() << "): its own frame did not lead to an exact mesh";
  return text.str();
}

/** An edge of the cube that crosses a crease cannot have convex cells; a turned cube may avoid it. Judges many turns by
 * where the edges lie on the surface, some of them by meshes on ever finer coarse lattices, meshes the best at full
 * size until one is exact, and keeps the best mesh. Where none is exact an own frame that was given up is worked out.
 */
void
tryTurnedFrames(const std::function<HexMesh(const Matrix3 &)> & turnedStart,
                const TriangleMesh &                            surface,
                const Positions &                               sphereMap,
                const CubicInterpolator &                       phi,
                double                                          volume,
                const SolidMeshingOptions &                     options,
                SolidMeshingResult &                            result,
                const ProgressCallback &                        progress)
{
  const auto wanted = static_cast<std::size_t>(options.turnedFrames);
  if (wanted == 0 || result.equalisation->exact)
  {
    return;
  }
  std::vector<Matrix3> turns = promisingTurns(surface, sphereMap, turnsOnCoarsestLattice, options.threads);
  reportProgress(progress, 0.3);
  keepBestOnLattice(6, turnsOnCoarseLattice, turnedStart, phi, volume, options, turns);
  reportProgress(progress, 0.5);
  keepBestOnLattice(10, wanted, turnedStart, phi, volume, options, turns);
  if (isGivenUp(*result.equalisation))
  {
    turns.emplace_back(Matrix3::Identity());
  }
  for (std::size_t t = 0; t < turns.size() && !result.equalisation->exact; ++t)
  {
    const auto count = static_cast<double>(turns.size());
    HexMesh    mesh = turnedStart(turns[t]);
    auto       equalised =
      equalise(mesh,
               phi,
               volume,
               options,
               progressBetween(
                 progress, 0.6 + 0.4 * static_cast<double>(t) / count, 0.6 + 0.4 * static_cast<double>(t + 1) / count));
    if (badness(equalised) < badness(*result.equalisation))
    {
      result.mesh = std::move(mesh);
      result.equalisation = std::move(equalised);
      result.turnWarning = turns[t].isIdentity() ? "" : describeTurn(turns[t]);
    }
  }
}

void
requireExact(const EqualisationResult &  result,
             const SolidMeshingOptions & options,
             std::vector<std::string> &  warnings)
{
  if (result.exact)
  {
    return;
  }
  std::string all;
  for (const std::string & shortcoming : result.shortcomings)
  {
    all += (all.empty() ? "" : "; ") + shortcoming;
    warnings.push_back("not exact: " + shortcoming);
  }
  if (!options.allowPartial)
  {
    throw NotConverged("not exact: " + all, result.report);
  }
}

} // namespace

int
shellsToExtract(const SolidMeshingOptions & options)
{
  return isFast(options) ? std::min(options.fastShells, options.shells) : options.shells;
}

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
  return meshSolid(ordering, phi, phi, volume, options, progress);
}

SolidMeshingResult
meshSolid(const LevelSet &            ordering,
          const LevelSet &            orderedPhi,
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
    options.volumeFractions.empty() ? cubeVolumeFractions(shellsToExtract(options)) : options.volumeFractions;
  std::vector<ShellSurface> shells = extractShellSurfaces(
    ordering, orderedPhi, volume, fractions, surfaceOptions, progressBetween(progress, 0.0, afterSurfaces));
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
  std::vector<Positions>   maps(count);
  AreaPreservingMapOptions sphereMap = options.sphereMap;
  if (isFast(options))
  {
    sphereMap.areaTolerance = std::max(sphereMap.areaTolerance, fastAreaTolerance);
  }
  parallelFor(count, options.threads, [&](std::size_t i) {
    const std::size_t k = count - 1 - i;
    result.sphereMaps[k] = areaPreservingSphereMap(surfaces[k], sphereMap);
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

  // Edge placement.
  if (options.frame == LatticeFrame::Ridge)
  {
    FramePlacementOptions placement = options.framePlacement;
    placement.threads = options.threads;
    result.frame = placeFrame(surfaces.back(), maps.back(), placement);
    maps = placed(maps, result.frame->placement);
    std::ostringstream note;
    note << "turned by " << result.frame->angle << " degrees, edge score " << result.frame->before.score << " -> "
         << result.frame->after.score;
    log.add("frame", note.str());
  }

  // F, G. Initial map: the cube shells' nodes on the organ's shells, then onto the exact level sets.
  const CubicInterpolator  orderingAt(ordering);
  const CubicInterpolator  orderedPhiAt(orderedPhi);
  const CubicInterpolator  phiAt(phi);
  const ClosestPointSearch outerSurface(surfaces.back());
  const double             maximumStep = 0.5 * orderedPhi.grid.spacing;
  InitialMapOptions        initialOptions;
  initialOptions.cubeShells = options.cubeShells;
  initialOptions.threads = options.threads;
  initialOptions.projection = [&](int shell, const Vector3 & p) {
    const std::size_t k = static_cast<std::size_t>(shell) - 1;
    return projectToLevel(
      k + 1 == count ? orderedPhiAt : orderingAt, p, shells[k].level, maximumStep, projectionIterations);
  };
  result.mesh = initialMap(surfaces, maps, initialOptions, progressBetween(progress, afterSphereMaps, afterInitialMap));
  log.add("initial map", result.mesh);

  // H. Smoothing.
  const double            surfaceLevel = isFast(options) ? 0.0 : shells.back().level;
  const SurfaceProjection projection = projectionOnto(outerSurface, phiAt, surfaceLevel);
  if (options.lastStage != MeshingStage::Initial && !isFast(options))
  {
    result.mesh = smoothLattice(result.mesh, projection, options.smoothing);
    log.add("smoothing", result.mesh);
  }

  // I. Volumetric Moser flow.
  if (options.lastStage >= MeshingStage::Moser && !isFast(options))
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

  // J. Equal volumes, no concave cell.
  if (options.lastStage == MeshingStage::Exact)
  {
    const ProgressCallback toTheEnd = progressBetween(progress, afterInitialMap, 1.0);
    const bool             maybeTurned = isFast(options) && options.turnedFrames > 0;
    SolidMeshingOptions    ownFrame = options;
    if (maybeTurned)
    {
      ownFrame.equalisation.hopelessCells =
        std::min(ownFrame.equalisation.hopelessCells, tangledCells(2 * options.shells));
    }
    result.equalisation = equalise(result.mesh, phiAt, volume, ownFrame, toTheEnd);
    if (!result.equalisation->exact && maybeTurned)
    {
      const auto turnedStart = [&](const Matrix3 & turn) {
        std::vector<Positions> turned = maps;
        for (Positions & map : turned)
        {
          map = rotated(map, turn);
        }
        InitialMapOptions inner = initialOptions;
        inner.threads = 1;
        return initialMap(surfaces, turned, inner);
      };
      tryTurnedFrames(turnedStart, surfaces.back(), maps.back(), phiAt, volume, options, result, toTheEnd);
    }
    if (options.density != nullptr)
    {
      equaliseMasses(phiAt, volume, options, result, toTheEnd);
    }
    std::ostringstream note;
    note << result.equalisation->report.steps << " steps, "
         << (result.equalisation->uncertifiedCells == 0 ? "certified" : "not certified");
    log.add("exact", result.mesh, note.str());
    if (!result.turnWarning.empty())
    {
      result.warnings.push_back(result.turnWarning);
    }
    requireExact(*result.equalisation, options, result.warnings);
  }
  result.boundary = boundaryDistance(result.mesh, nearestPointOn(outerSurface, phiAt, surfaceLevel));
  reportProgress(progress, 1.0);
  return result;
}

} // namespace moserhex
