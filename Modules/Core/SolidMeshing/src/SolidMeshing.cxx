#include "moserhex/SolidMeshing/SolidMeshing.h"

#include "BoundaryProjection.h"
#include "ExactStage.h"
#include "StageLog.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Parallel.h"
#include "moserhex/LevelSet/MarchingTetrahedra.h"
#include "moserhex/LevelSet/ShellOrdering.h"
#include "moserhex/SolidMeshing/ShellFrames.h"
#include "moserhex/SphericalMap/FrameAlignment.h"

#include <algorithm>
#include <sstream>
#include <utility>

namespace moserhex
{
namespace
{

/** Area ratio rms that is enough of a sphere map that only starts the optimisation [1]. */
constexpr double fastAreaTolerance = 0.05;
/** What it may come to where that is out of reach: what the optimisation makes of it is judged by itself [1]. */
constexpr double fastAreaLimit = 0.5;

/** Parts of the whole run, for progress only. */
constexpr double afterSurfaces = 0.4;
constexpr double afterSphereMaps = 0.8;
constexpr double afterInitialMap = 0.85;
constexpr double afterFlow = 0.9;
constexpr double afterExact = 0.95; ///< with padding

bool
isFast(const SolidMeshingOptions & options)
{
  return options.lastStage == MeshingStage::Exact && options.way == MeshingWay::Fast;
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

/** One run of the chain: what a stage leaves for those after it. */
class Chain
{
public:
  Chain(const LevelSet &            ordering,
        const LevelSet &            orderedPhi,
        const LevelSet &            phi,
        double                      volume,
        const SolidMeshingOptions & options,
        const ProgressCallback &    progress)
    : m_Ordering(ordering)
    , m_OrderedPhi(orderedPhi)
    , m_OrderingAt(ordering)
    , m_OrderedPhiAt(orderedPhi)
    , m_PhiAt(phi)
    , m_Volume(volume)
    , m_Options(options)
    , m_Progress(progress)
    , m_Log(m_Result.stages)
  {}

  [[nodiscard]] SolidMeshingResult
  run()
  {
    extractShells();
    mapShells();
    if (m_Options.frame == LatticeFrame::Ridge)
    {
      turnFrame();
    }
    makeInitialMap();
    const ClosestPointSearch outerSurface(m_Surfaces.back());
    const double             level = isFast(m_Options) ? 0.0 : m_Levels.back();
    const SurfaceProjection  projection = projectionOnto(outerSurface, m_PhiAt, level);
    if (m_Options.lastStage >= MeshingStage::Smoothed && !isFast(m_Options))
    {
      smooth(projection);
    }
    if (m_Options.lastStage >= MeshingStage::Moser && !isFast(m_Options))
    {
      flow(projection);
    }
    if (m_Options.lastStage == MeshingStage::Exact)
    {
      equalise();
    }
    if (m_Options.paddingLayers > 0)
    {
      pad();
    }
    m_Result.boundary = m_Result.simplerSolid
                          ? boundaryDistanceTo(*m_Result.simplerSolid)
                          : boundaryDistance(m_Result.mesh, nearestPointOn(outerSurface, m_PhiAt, level));
    if (m_Options.lastStage == MeshingStage::Exact)
    {
      requireExact(m_Options, m_Result);
    }
    reportProgress(m_Progress, 1.0);
    return std::move(m_Result);
  }

private:
  /** C. Shell surfaces. */
  void
  extractShells()
  {
    ShellSurfaceOptions options = m_Options.surfaces;
    options.threads = m_Options.threads;
    const std::vector<double> fractions =
      m_Options.volumeFractions.empty() ? cubeVolumeFractions(shellsToExtract(m_Options)) : m_Options.volumeFractions;
    std::vector<ShellSurface> shells = extractShellSurfaces(
      m_Ordering, m_OrderedPhi, m_Volume, fractions, options, progressBetween(m_Progress, 0.0, afterSurfaces));
    m_Result.shells = summarizeShells(shells, options);
    std::string note;
    if (isFast(m_Options))
    {
      // These shells only start the optimisation, whose result is judged by itself.
      for (const std::string & warning : m_Result.shells.warnings)
      {
        note += "; " + warning;
      }
    }
    else
    {
      m_Result.warnings = m_Result.shells.warnings;
    }
    for (ShellSurface & shell : shells)
    {
      m_Surfaces.push_back(std::move(shell.mesh));
      m_Levels.push_back(shell.level);
    }
    m_Log.add("shell surfaces", std::to_string(m_Result.shells.triangles) + " triangles" + note);
  }

  /** D, E. Sphere maps, the largest shell first so that threads end together. */
  void
  mapShells()
  {
    const std::size_t count = m_Surfaces.size();
    m_Result.sphereMaps.resize(count);
    m_Maps.resize(count);
    AreaPreservingMapOptions options = m_Options.sphereMap;
    if (isFast(m_Options))
    {
      options.areaTolerance = std::max(options.areaTolerance, fastAreaTolerance);
      options.areaLimit = std::max(options.areaLimit, fastAreaLimit);
    }
    const ProgressCallback ofMaps = progressBetween(m_Progress, afterSurfaces, afterSphereMaps);
    ParallelProgress       shared(ofMaps, count);
    parallelFor(count, m_Options.threads, [&](std::size_t i) {
      const std::size_t         k = count - 1 - i;
      AreaPreservingMapResult & map = m_Result.sphereMaps[k];
      map = areaPreservingSphereMap(m_Surfaces[k], options, shared.callback());
      m_Maps[k] = std::move(map.positions);
      map.positions.clear();
      shared.endPart();
    });
    reportProgress(m_Progress, afterSphereMaps);
    for (std::size_t k = 0; k < count; ++k)
    {
      const std::vector<StepReport> & reports = m_Result.sphereMaps[k].reports;
      if (!reports.empty() && !reports.back().converged)
      {
        m_Result.warnings.push_back("sphere map of shell " + std::to_string(k + 1) + " stopped after " +
                                    std::to_string(reports.back().steps) + " steps, before its minimiser");
      }
    }
    alignShellFramesInPlace(m_Surfaces, m_Maps);
    m_Log.add("sphere maps", describe(m_Result.sphereMaps));
  }

  /** Edge placement. */
  void
  turnFrame()
  {
    FramePlacementOptions options = m_Options.framePlacement;
    options.threads = m_Options.threads;
    m_Result.frame = placeFrame(m_Surfaces.back(), m_Maps.back(), options);
    m_Maps = placed(m_Maps, m_Result.frame->placement);
    std::ostringstream note;
    note << "turned by " << m_Result.frame->angle << " degrees, edge score " << m_Result.frame->before.score << " -> "
         << m_Result.frame->after.score;
    m_Log.add("frame", note.str());
  }

  /** F, G: the cube shells' nodes on the organ's shells, then onto the exact level sets. */
  [[nodiscard]] HexMesh
  initialMapOf(const std::vector<Positions> & maps, unsigned int threads, const ProgressCallback & progress) const
  {
    InitialMapOptions options;
    options.cubeShells = m_Options.cubeShells;
    options.threads = threads;
    const double longestStep = longestNewtonStep(m_OrderedPhi.grid);
    options.projection = [this, longestStep](int shell, const Vector3 & p) {
      const std::size_t k = static_cast<std::size_t>(shell) - 1;
      const bool        isOutermost = k + 1 == m_Levels.size();
      return projectToLevel(
        isOutermost ? m_OrderedPhiAt : m_OrderingAt, p, m_Levels[k], longestStep, projectionIterations);
    };
    return initialMap(m_Surfaces, maps, options, progress);
  }

  void
  makeInitialMap()
  {
    m_Result.mesh =
      initialMapOf(m_Maps, m_Options.threads, progressBetween(m_Progress, afterSphereMaps, afterInitialMap));
    m_Log.add("initial map", m_Result.mesh);
  }

  /** H. Smoothing. */
  void
  smooth(const SurfaceProjection & projection)
  {
    m_Result.mesh = smoothLattice(m_Result.mesh, projection, m_Options.smoothing);
    m_Log.add("smoothing", m_Result.mesh);
  }

  /** I. Volumetric Moser flow. */
  void
  flow(const SurfaceProjection & projection)
  {
    const double              end = m_Options.lastStage == MeshingStage::Exact ? afterFlow : 1.0;
    VolumetricMoserFlowResult flow =
      volumetricMoserFlow(m_Result.mesh, projection, m_Options.flow, progressBetween(m_Progress, afterInitialMap, end));
    m_Result.mesh = std::move(flow.mesh);
    std::ostringstream note;
    note << "pass " << flow.bestPass << " of " << flow.passes.size() - 1 << " is the best";
    m_Log.add("moser flow", m_Result.mesh, note.str());
    if (flow.bestPass == 0)
    {
      m_Result.warnings.emplace_back("the volumetric flow did not improve the mesh; the mesh before it is returned");
    }
  }

  /** J. Equal volumes, no concave cell. */
  void
  equalise()
  {
    ExactStage stage{ m_PhiAt, m_Volume, m_Options, m_Surfaces.back(), m_Maps.back(), {} };
    if (isFast(m_Options))
    {
      stage.turnedStart = [this](const Matrix3 & turn) {
        std::vector<Positions> turned = m_Maps;
        for (Positions & map : turned)
        {
          map = rotated(map, turn);
        }
        return initialMapOf(turned, 1, {});
      };
    }
    const double end = m_Options.paddingLayers > 0 ? afterExact : 1.0;
    makeExact(stage, m_Result, progressBetween(m_Progress, isFast(m_Options) ? afterInitialMap : afterFlow, end));
    std::ostringstream note;
    note << m_Result.equalisation->report.steps << " steps, "
         << (m_Result.equalisation->uncertifiedCells == 0 ? "certified" : "not certified")
         << (m_Result.simplerSolid ? ", of a simpler solid" : "");
    if (m_Result.attempts.size() > 1)
    {
      for (const std::string & attempt : m_Result.attempts)
      {
        note << "; " << attempt;
      }
    }
    m_Log.add("exact", m_Result.mesh, note.str());
    if (!m_Result.turnWarning.empty())
    {
      m_Result.warnings.push_back(m_Result.turnWarning);
    }
  }

  /** J again, with padding. */
  void
  pad()
  {
    const ExactStage  stage{ m_PhiAt, m_Volume, m_Options, m_Surfaces.back(), m_Maps.back(), {} };
    const std::size_t attemptsBefore = m_Result.attempts.size();
    padExactly(stage, m_Result, progressBetween(m_Progress, afterExact, 1.0));
    std::ostringstream note;
    note << m_Options.paddingLayers << (m_Options.paddingLayers == 1 ? " layer, " : " layers, ")
         << m_Result.equalisation->report.steps << " steps, "
         << (m_Result.equalisation->uncertifiedCells == 0 ? "certified" : "not certified");
    for (std::size_t attempt = attemptsBefore; attempt < m_Result.attempts.size(); ++attempt)
    {
      note << "; " << m_Result.attempts[attempt];
    }
    m_Log.add("padding", m_Result.mesh, note.str());
  }

  [[nodiscard]] BoundaryDistance
  boundaryDistanceTo(const LevelSet & phi) const
  {
    const TriangleMesh       surface = marchingTetrahedra(phi, 0.0);
    const ClosestPointSearch search(surface);
    const CubicInterpolator  phiAt(phi);
    return boundaryDistance(m_Result.mesh, nearestPointOn(search, phiAt, 0.0));
  }

  const LevelSet &            m_Ordering;
  const LevelSet &            m_OrderedPhi;
  CubicInterpolator           m_OrderingAt;
  CubicInterpolator           m_OrderedPhiAt;
  CubicInterpolator           m_PhiAt;
  double                      m_Volume;
  const SolidMeshingOptions & m_Options;
  const ProgressCallback &    m_Progress;
  SolidMeshingResult          m_Result;
  StageLog                    m_Log;
  std::vector<TriangleMesh>   m_Surfaces; ///< of the shells, innermost first
  std::vector<double>         m_Levels;   ///< of the ordering; of phi for the outermost
  std::vector<Positions>      m_Maps;     ///< onto the sphere
};

} // namespace

int
shellsToExtract(const SolidMeshingOptions & options)
{
  return isFast(options) ? std::min(options.fastShells, options.shells) : options.shells;
}

Matrix3
latticeTurn(const SolidMeshingResult & result)
{
  return result.frame ? Matrix3(result.fallbackTurn * result.frame->placement.rotation) : result.fallbackTurn;
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
  if (options.density != nullptr && options.lastStage != MeshingStage::Exact)
  {
    throw InvalidInput("a density needs the last stage Exact");
  }
  if (options.refinement.any())
  {
    throw InvalidInput("landmarks and images need a template");
  }
  if (options.paddingLayers < 0 || options.paddingLayers > largestPadding)
  {
    throw InvalidInput(std::to_string(options.paddingLayers) + " layers of padding, need 0 to " +
                       std::to_string(largestPadding));
  }
  if (options.paddingLayers > 0 && options.lastStage != MeshingStage::Exact)
  {
    throw InvalidInput("padding needs the last stage Exact");
  }
  return Chain(ordering, orderedPhi, phi, volume, options, progress).run();
}

} // namespace moserhex
