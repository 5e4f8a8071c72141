#include "ExactStage.h"

#include "TurnedFrames.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Parallel.h"
#include "moserhex/HexMap/MassMeasure.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <tuple>
#include <utility>

namespace moserhex
{
namespace
{

const double degree = std::acos(-1.0) / 180.0;

/** An exact mesh of at least this smallest scaled Jacobian ends the search for a better frame [1]. */
constexpr double ampleScaledJacobian = 0.1;

/** Turned frames that are tried on a lattice of 6 and of 10 nodes a side. */
constexpr std::size_t turnsOnCoarsestLattice = 24;
constexpr std::size_t turnsOnCoarseLattice = 6;

/** Of a coarse lattice in the most promising frame: more cells that are not certified, and no finer lattice was ever
 * seen to become exact [1]. */
constexpr double hopelessFraction = 0.04;

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

EqualisationResult
equalise(const ExactStage &          stage,
         const EqualisationOptions & options,
         const HexMesh &             start,
         const ProgressCallback &    progress)
{
  return equaliseVolumes(start, signedDistance(stage.phi), stage.volume, options, progress);
}

void
keep(EqualisationResult && equalised, SolidMeshingResult & result)
{
  result.mesh = std::move(equalised.mesh);
  equalised.mesh = {};
  result.equalisation = std::move(equalised);
}

/** Equal masses, from a mesh of equal volumes, on which the quadrature is chosen. */
void
equaliseMasses(const ExactStage & stage, SolidMeshingResult & result, const ProgressCallback & progress)
{
  const SolidMeshingOptions &      options = stage.options;
  std::optional<CubicInterpolator> smoother;
  if (result.smootherSolid)
  {
    smoother.emplace(*result.smootherSolid);
  }
  const MassQuadrature rule =
    chooseMassQuadrature(result.mesh, *options.density, options.densityAccuracy, options.threads);
  const MassMeasure measure(*options.density, rule.options);
  keep(equaliseMeasures(result.mesh,
                        signedDistance(smoother ? *smoother : stage.phi),
                        stage.volume,
                        measure,
                        stage.volume,
                        equalisationOptions(options),
                        progress),
       result);
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
  return std::make_tuple(!result.exact,
                         isGivenUp(result),
                         result.concaveCells,
                         result.uncertifiedCells,
                         -std::min(result.smallestScaledJacobian, ampleScaledJacobian),
                         result.largestDistance);
}

bool
isAmple(const EqualisationResult & result)
{
  return result.exact && result.smallestScaledJacobian >= ampleScaledJacobian;
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

[[noreturn]] void
refuseShape(std::size_t uncertifiedCells, double cells, const std::string & lattice)
{
  std::ostringstream text;
  text << "too thin, bent or sharp for a cube's lattice: in the best of all frames " << uncertifiedCells << " of "
       << cells << " cells" << lattice << " are not positive";
  throw NotConverged(ErrorCode::Shape, text.str(), {});
}

/** Gives up where even the best of all frames is far from a mesh on a coarse lattice. */
void
requireProspects(const ExactStage & stage, const Prospect & best, int nodesPerSide)
{
  const double cells = std::pow(nodesPerSide - 1, 3);
  if (!stage.options.allowPartial && static_cast<double>(best.uncertifiedCells) > hopelessFraction * cells)
  {
    refuseShape(best.uncertifiedCells, cells, " of a coarse one");
  }
}

/** Sorts turns by the meshes they lead to on a coarse lattice, best first, and keeps the best. */
void
keepBestOnLattice(const ExactStage & stage, int nodesPerSide, std::size_t count, std::vector<Matrix3> & turns)
{
  EqualisationOptions coarse = equalisationOptions(stage.options);
  coarse.nodesPerSide = std::min(nodesPerSide, coarse.nodesPerSide);
  coarse.repairRounds = 0;
  coarse.polishRounds = 0; // polished meshes are all alike
  coarse.hopelessCells = 0;
  coarse.threads = 1;
  std::vector<Prospect> prospects(turns.size());
  parallelFor(turns.size(), stage.options.threads, [&](std::size_t t) {
    const EqualisationResult result = equalise(stage, coarse, stage.turnedStart(turns[t]), {});
    prospects[t] = { result.uncertifiedCells, result.smallestScaledJacobian, turns[t] };
  });
  std::stable_sort(
    prospects.begin(), prospects.end(), [](const Prospect & a, const Prospect & b) { return a.isBetterThan(b); });
  if (!prospects.empty())
  {
    requireProspects(stage, prospects.front(), coarse.nodesPerSide);
  }
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

/** Uncertified cells of a minimised mesh above which no attempt in a turned frame ever became exact; fewer are allowed
 * to one that could only better an exact mesh. */
std::size_t
hopelessCells(int nodesPerSide, bool hasExactMesh)
{
  const std::size_t tangled = tangledCells(nodesPerSide);
  return hasExactMesh ? tangled / 3 : 2 * tangled;
}

/** An edge of the cube that crosses a crease cannot have convex cells; a turned cube may avoid it. Judges many turns by
 * where the edges lie on the surface, some of them by meshes on ever finer coarse lattices, meshes the best at full
 * size until one is exact with room to spare, and keeps the best mesh. Where none is exact and a partial mesh will do,
 * an own frame that was given up is worked out. */
void
tryTurnedFrames(const ExactStage & stage, SolidMeshingResult & result, const ProgressCallback & progress)
{
  const SolidMeshingOptions & options = stage.options;
  std::vector<Matrix3> turns = promisingTurns(stage.surface, stage.sphereMap, turnsOnCoarsestLattice, options.threads);
  reportProgress(progress, 0.3);
  keepBestOnLattice(stage, 6, turnsOnCoarseLattice, turns);
  reportProgress(progress, 0.5);
  keepBestOnLattice(stage, 10, static_cast<std::size_t>(options.turnedFrames), turns);
  const ProgressCallback atFullSize = progressBetween(progress, 0.6, 1.0);
  const std::size_t      parts = turns.size() + 1;
  const bool             wasGivenUp = isGivenUp(*result.equalisation);
  const auto             workOut = [&](const Matrix3 & turn, std::size_t part, std::size_t hopeless) {
    EqualisationOptions inFrame = equalisationOptions(options);
    inFrame.hopelessCells = std::min(inFrame.hopelessCells, hopeless);
    EqualisationResult equalised =
      equalise(stage, inFrame, stage.turnedStart(turn), progressOfPart(atFullSize, part, parts));
    if (badness(equalised) < badness(*result.equalisation))
    {
      keep(std::move(equalised), result);
      result.turnWarning = turn.isIdentity() ? "" : describeTurn(turn);
    }
  };
  for (std::size_t t = 0; t < turns.size() && !isAmple(*result.equalisation); ++t)
  {
    workOut(turns[t], t, hopelessCells(2 * options.shells, result.equalisation->exact));
  }
  const EqualisationResult & best = *result.equalisation;
  if (!options.allowPartial && isGivenUp(best))
  {
    refuseShape(best.uncertifiedCells, static_cast<double>(result.mesh.cellCount()), "");
  }
  if (options.allowPartial && wasGivenUp && !best.exact)
  {
    workOut(Matrix3::Identity(), turns.size(), equalisationOptions(options).hopelessCells);
  }
}

/** The start on the surface of a smoother solid, in its own frame. */
void
trySmootherSolid(const ExactStage &          stage,
                 const EqualisationOptions & options,
                 const HexMesh &             start,
                 SolidMeshingResult &        result,
                 const ProgressCallback &    progress)
{
  std::optional<LevelSet> smoother = stage.options.smootherSolid();
  if (!smoother)
  {
    return;
  }
  const CubicInterpolator phi(*smoother);
  try
  {
    EqualisationResult equalised = equaliseVolumes(start, signedDistance(phi), stage.volume, options, progress);
    if (equalised.exact)
    {
      keep(std::move(equalised), result);
      result.smootherSolid = std::move(smoother);
    }
  }
  catch (const InvalidInput &)
  {
    // The start lies too far from the smoother surface: an attempt that failed, as one that is not exact.
  }
}

} // namespace

void
makeExact(const ExactStage & stage, SolidMeshingResult & result, const ProgressCallback & progress)
{
  const SolidMeshingOptions & options = stage.options;
  const bool                  maybeTurned = stage.turnedStart && options.turnedFrames > 0;
  const bool                  hasDensity = options.density != nullptr;
  const ProgressCallback      ofVolumes = progressBetween(progress, 0.0, hasDensity ? 0.5 : 1.0);
  EqualisationOptions         ownFrame = equalisationOptions(options);
  if (maybeTurned)
  {
    ownFrame.hopelessCells = std::min(ownFrame.hopelessCells, tangledCells(ownFrame.nodesPerSide));
  }
  const HexMesh start = result.mesh;
  keep(equalise(stage, ownFrame, start, progressBetween(ofVolumes, 0.0, maybeTurned ? 0.2 : 1.0)), result);
  if (options.smootherSolid && !result.equalisation->exact)
  {
    trySmootherSolid(stage, ownFrame, start, result, progressBetween(ofVolumes, 0.2, 0.3));
  }
  if (maybeTurned && !result.equalisation->exact)
  {
    tryTurnedFrames(stage, result, progressBetween(ofVolumes, 0.3, 1.0));
  }
  if (hasDensity)
  {
    equaliseMasses(stage, result, progressBetween(progress, 0.5, 1.0));
  }
}

void
requireExact(const SolidMeshingOptions & options, SolidMeshingResult & result)
{
  EqualisationResult & equalisation = *result.equalisation;
  const double         tolerance = options.equalisation.surfaceTolerance;
  if (equalisation.largestDistance <= tolerance && !(result.boundary.maximum <= tolerance))
  {
    std::ostringstream text;
    text << "boundary measured up to " << result.boundary.maximum << " mm off the surface, must be at most "
         << tolerance;
    equalisation.shortcomings.push_back(text.str());
    equalisation.exact = false;
    equalisation.report.converged = false;
  }
  std::string all;
  for (const std::string & shortcoming : equalisation.shortcomings)
  {
    all += (all.empty() ? "" : "; ") + shortcoming;
    result.warnings.push_back("not exact: " + shortcoming);
  }
  if (!equalisation.exact && !options.allowPartial)
  {
    throw NotConverged(ErrorCode::NotExact, "not exact: " + all, equalisation.report);
  }
}

} // namespace moserhex
