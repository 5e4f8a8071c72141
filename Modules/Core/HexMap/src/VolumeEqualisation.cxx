#include "moserhex/HexMap/VolumeEqualisation.h"

#include "Equaliser.h"
#include "LatticeRefinement.h"
#include "SurfacePoints.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Stopwatch.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace moserhex
{
namespace
{

/** Points of the surface whose distance from the boundary is watched: as many as boundary quadrilaterals, but enough
 * to see the tips that coarse lattices drain from. */
std::size_t
surfacePointsFor(int nodesPerSide)
{
  constexpr std::size_t fewest = 2000;
  const auto            cells = static_cast<std::size_t>(nodesPerSide - 1);
  return std::max(fewest, 6 * cells * cells);
}

/** n of the lattice a tangled mesh is taken back to. */
constexpr int coarsestNodesPerSide = 6;

void
require(bool holds, const std::string & what)
{
  if (!holds)
  {
    throw InvalidInput("equalisation: " + what);
  }
}

void
requireStages(const std::vector<EqualisationStage> & stages)
{
  require(!stages.empty(), "at least one stage is needed on every lattice");
  for (const EqualisationStage & stage : stages)
  {
    require(stage.regularisation > 0.0 && std::isfinite(stage.regularisation), "regularisation must be positive");
    require(stage.volumeWeight >= 0.0 && std::isfinite(stage.volumeWeight) && stage.surfaceWeight >= 0.0 &&
              std::isfinite(stage.surfaceWeight),
            "weights must be finite and not negative");
    require(stage.maximumSteps >= 0, "number of steps must not be negative");
    require(stage.power >= 1 && stage.power <= 8, "power must be in 1..8");
    require(stage.angleWeight >= 0.0 && std::isfinite(stage.angleWeight), "weights must be finite and not negative");
  }
}

void
requireTies(const LatticeTies & ties, const HexMesh & start)
{
  require(ties.reference.empty() || ties.reference.size() == start.nodes.size(),
          "a reference must have as many nodes as the start");
  require(ties.rest.empty() || ties.rest.size() == start.nodes.size(),
          "a lattice at rest must have as many nodes as the start");
  require(ties.referenceWeight >= 0.0 && ties.boundaryWeight >= 0.0 && ties.landmarkWeight >= 0.0 &&
            ties.imageWeight >= 0.0,
          "the weights of ties must not be negative");
  require(!ties.image || ties.image->values.size() == latticeSamplesPerCell * start.latticeCellCount(),
          "an image must have a value wanted at every sample of the lattice");
  for (const LatticeLandmark & landmark : ties.landmarks)
  {
    require(std::all_of(landmark.nodes.begin(),
                        landmark.nodes.end(),
                        [&start](std::size_t node) { return node < start.nodes.size(); }),
            "a landmark lies on a node that does not exist");
    require(landmark.position.allFinite(), "a landmark belongs at a point that is not finite");
  }
}

int
wantedNodesPerSide(const HexMesh & start, const EqualisationOptions & options)
{
  return options.nodesPerSide == 0 ? start.nodesPerSide : options.nodesPerSide;
}

void
requireProblem(const HexMesh &             start,
               const SignedDistance &      phi,
               double                      volume,
               double                      total,
               const EqualisationOptions & options)
{
  requireValid(start);
  require(volume > 0.0 && std::isfinite(volume), "the volume must be positive and finite");
  require(total > 0.0 && std::isfinite(total), "the total must be positive and finite");
  require(static_cast<bool>(phi), "a surface is needed");
  requireStages(options.coarseStages);
  requireStages(options.finestStages);
  requireStages(options.directStages);
  require(options.repairRounds >= 0 && options.repairMargin > 0.0, "repair options out of range");
  require(options.narrowScaledJacobian >= 0.0 && options.angleWeight >= 0.0, "polish options out of range");
  require(options.polishRounds >= 0, "number of polish rounds must not be negative");
  require(options.surfaceTolerance > 0.0 && options.coverageTolerance >= 0.0, "the tolerances must be positive");
  const int  n = wantedNodesPerSide(start, options);
  const bool isPadded = start.paddingLayers > 0;
  require(n >= start.nodesPerSide, "the lattice wanted is coarser than the one given");
  require(!isPadded || n == start.nodesPerSide, "a mesh with padding is not refined");
  require(!options.ties.any() || (!isPadded && n == start.nodesPerSide),
          "a mesh that is tied is neither padded nor refined");
  requireTies(options.ties, start);
}

/** Ties that an exact start may not have followed yet. */
bool
draws(const LatticeTies & ties, const HexMesh & start)
{
  return !ties.landmarks.empty() || ties.image || (!ties.reference.empty() && ties.reference != start.nodes);
}

/** Smaller is better. */
auto
badness(const EqualisationResult & result, double tolerance)
{
  return std::make_tuple(!result.exact,
                         result.concaveCells,
                         result.uncertifiedCells,
                         std::max(tolerance, result.largestDistance),
                         result.uncoveredDistance,
                         result.variance);
}

EqualisationResult
equalisedDirectly(const HexMesh & start, const EqualisationProblem & problem, const ProgressCallback & progress)
{
  const std::vector<EqualisationStage> & stages = problem.options.directStages;
  Equaliser                              equaliser(start, problem);
  equaliser.minimise(stages, Equaliser::Boundary::AsItIs, progressBetween(progress, 0.0, 0.4));
  equaliser.finish(stages.back(), progressBetween(progress, 0.4, 0.9));
  equaliser.polish(progressBetween(progress, 0.9, 1.0));
  return equaliser.result();
}

/** \param levels  n of the lattices, the wanted one last */
EqualisationResult
equalisedFromCoarse(const HexMesh &             start,
                    const EqualisationProblem & problem,
                    const std::vector<int> &    levels,
                    const ProgressCallback &    progress)
{
  const EqualisationOptions & options = problem.options;
  const ProgressCallback      ofLevels = progressBetween(progress, 0.0, 0.4);
  Equaliser                   equaliser(start, problem);
  for (std::size_t l = 0; l < levels.size(); ++l)
  {
    const ProgressCallback ofLevel = progressOfPart(ofLevels, l, levels.size());
    const bool             isFinest = l + 1 == levels.size();
    equaliser.resample(levels[l]);
    equaliser.minimise(isFinest ? options.finestStages : options.coarseStages,
                       l == 0 ? Equaliser::Boundary::AsItIs : Equaliser::Boundary::OnLevel,
                       progressBetween(ofLevel, 0.0, 0.6));
    if (!isFinest)
    {
      equaliser.untangle(options.coarseStages.back(), progressBetween(ofLevel, 0.6, 1.0));
    }
  }
  equaliser.finish(options.finestStages.back(), progressBetween(progress, 0.4, 0.9));
  equaliser.polish(progressBetween(progress, 0.9, 1.0));
  return equaliser.result();
}

} // namespace

std::size_t
tangledCells(int nodesPerSide)
{
  return static_cast<std::size_t>(std::max(2, nodesPerSide / 3));
}

EqualisationResult
equaliseMeasures(const HexMesh &             start,
                 const SignedDistance &      phi,
                 double                      volume,
                 const CellMeasure &         measure,
                 double                      total,
                 const EqualisationOptions & options,
                 const ProgressCallback &    progress)
{
  requireProblem(start, phi, volume, total, options);
  const int                 n = wantedNodesPerSide(start, options);
  const bool                keepsSize = start.paddingLayers > 0 || options.ties.any();
  const Stopwatch           stopwatch;
  const EqualisationProblem problem{
    phi, volume, measure, total, options, surfacePoints(start.nodes, phi, volume, surfacePointsFor(n), options.threads)
  };
  const int          coarse = std::min(n, coarsestNodesPerSide);
  EqualisationResult result = Equaliser(start, problem).result();
  const auto         keepBetter = [&](EqualisationResult && other) {
    other.steps.insert(other.steps.begin(), result.steps.begin(), result.steps.end());
    if (result.mesh.nodesPerSide != n ||
        badness(other, options.surfaceTolerance) < badness(result, options.surfaceTolerance))
    {
      result = std::move(other);
      return;
    }
    result.steps = std::move(other.steps);
  };
  const bool isDrawn = draws(options.ties, start);
  if (isDrawn)
  {
    result = equalisedDirectly(start, problem, progress);
  }
  else if (n == start.nodesPerSide && !result.exact)
  {
    keepBetter(equalisedDirectly(start, problem, progressBetween(progress, 0.0, keepsSize ? 1.0 : 0.5)));
  }
  if (n > start.nodesPerSide || (!result.exact && n > coarse && !keepsSize))
  {
    const std::vector<int> levels = refinementLevels(n > start.nodesPerSide ? start.nodesPerSide : coarse, n);
    const double           begin = n > start.nodesPerSide ? 0.0 : 0.5;
    keepBetter(equalisedFromCoarse(start, problem, levels, progressBetween(progress, begin, 1.0)));
  }
  result.report.converged = result.exact;
  result.report.steps = static_cast<int>(result.steps.size());
  result.report.residual = result.variance;
  result.report.seconds = stopwatch.seconds();
  reportProgress(progress, 1.0);
  return result;
}

HexMesh
minimisedLattice(const HexMesh &             start,
                 const SignedDistance &      phi,
                 double                      volume,
                 const CellMeasure &         measure,
                 const EqualisationOptions & options,
                 const ProgressCallback &    progress)
{
  requireProblem(start, phi, volume, volume, options);
  const int n = start.nodesPerSide;
  require(wantedNodesPerSide(start, options) == n, "a lattice is minimised in its own size");
  const EqualisationProblem problem{
    phi, volume, measure, volume, options, surfacePoints(start.nodes, phi, volume, surfacePointsFor(n), options.threads)
  };
  Equaliser equaliser(start, problem);
  equaliser.minimise(options.directStages, Equaliser::Boundary::AsItIs, progress);
  return equaliser.mesh();
}

EqualisationResult
equaliseVolumes(const HexMesh &             start,
                const SignedDistance &      phi,
                double                      volume,
                const EqualisationOptions & options,
                const ProgressCallback &    progress)
{
  return equaliseMeasures(start, phi, volume, VolumeMeasure(), volume, options, progress);
}

} // namespace moserhex
