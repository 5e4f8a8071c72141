#include "FrameSearch.h"

#include "TurnedFrames.h"
#include "moserhex/Common/Parallel.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <tuple>
#include <utility>
#include <vector>

namespace moserhex
{
namespace
{

const double degree = pi / 180.0;

/** An exact mesh of at least this smallest scaled Jacobian ends the search for a better frame [1]. */
constexpr double ampleScaledJacobian = 0.1;

/** Turned frames that are tried on a lattice of 6 and of 10 nodes a side. */
constexpr std::size_t turnsOnCoarsestLattice = 24;
constexpr std::size_t turnsOnCoarseLattice = 6;

/** Of a coarse lattice in the most promising frame: more cells that are not certified, and no finer lattice was ever
 * seen to become exact [1]. */
constexpr double hopelessFraction = 0.04;

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

std::size_t
cellsOf(int nodesPerSide)
{
  const auto cells = static_cast<std::size_t>(nodesPerSide - 1);
  return cells * cells * cells;
}

/** Sorts turns by the meshes they lead to on a coarse lattice, best first, and keeps the best. Where even the best is
 * far from a mesh, says so. */
std::optional<HopelessShape>
keepBestOnLattice(const ExactStage &        stage,
                  const CubicInterpolator & phi,
                  int                       nodesPerSide,
                  std::size_t               count,
                  std::vector<Matrix3> &    turns)
{
  EqualisationOptions coarse = equalisationOptions(stage.options);
  coarse.nodesPerSide = std::min(nodesPerSide, coarse.nodesPerSide);
  coarse.repairRounds = 0;
  coarse.polishRounds = 0; // polished meshes are all alike
  coarse.hopelessCells = 0;
  coarse.threads = 1;
  std::vector<Prospect> prospects(turns.size());
  parallelFor(turns.size(), stage.options.threads, [&](std::size_t t) {
    const EqualisationResult result =
      equaliseVolumes(stage.turnedStart(turns[t]), signedDistance(phi), stage.volume, coarse, {});
    prospects[t] = { result.uncertifiedCells, result.smallestScaledJacobian, turns[t] };
  });
  std::stable_sort(
    prospects.begin(), prospects.end(), [](const Prospect & a, const Prospect & b) { return a.isBetterThan(b); });
  turns.resize(std::min(count, turns.size()));
  for (std::size_t t = 0; t < turns.size(); ++t)
  {
    turns[t] = prospects[t].turn;
  }
  const std::size_t cells = cellsOf(coarse.nodesPerSide);
  if (prospects.empty() ||
      static_cast<double>(prospects.front().uncertifiedCells) <= hopelessFraction * static_cast<double>(cells))
  {
    return std::nullopt;
  }
  return HopelessShape{ prospects.front().uncertifiedCells, cells, true };
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

} // namespace

EqualisationOptions
equalisationOptions(const SolidMeshingOptions & options)
{
  EqualisationOptions equalisation = options.equalisation;
  equalisation.nodesPerSide = 2 * options.shells;
  equalisation.threads = options.threads;
  return equalisation;
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

bool
isGivenUp(const EqualisationResult & result)
{
  constexpr double equalVariance = 1e-12;
  return result.variance > equalVariance;
}

bool
isBetter(const EqualisationResult & mesh, const EqualisationResult & other)
{
  return badness(mesh) < badness(other);
}

FrameSearchResult
searchTurnedFrames(const ExactStage &         stage,
                   const CubicInterpolator &  phi,
                   const EqualisationResult & best,
                   const ProgressCallback &   progress)
{
  const SolidMeshingOptions & options = stage.options;
  FrameSearchResult           found;
  std::vector<Matrix3> turns = promisingTurns(stage.surface, stage.sphereMap, turnsOnCoarsestLattice, options.threads);
  reportProgress(progress, 0.3);
  found.hopeless = keepBestOnLattice(stage, phi, 6, turnsOnCoarseLattice, turns);
  if (found.hopeless && !options.allowPartial)
  {
    return found;
  }
  reportProgress(progress, 0.5);
  found.hopeless = keepBestOnLattice(stage, phi, 10, static_cast<std::size_t>(options.turnedFrames), turns);
  if (found.hopeless && !options.allowPartial)
  {
    return found;
  }
  const ProgressCallback     atFullSize = progressBetween(progress, 0.6, 1.0);
  const EqualisationResult * present = &best;
  for (std::size_t t = 0; t < turns.size() && !isAmple(*present); ++t)
  {
    EqualisationOptions inFrame = equalisationOptions(options);
    inFrame.hopelessCells = std::min(inFrame.hopelessCells, hopelessCells(inFrame.nodesPerSide, present->exact));
    EqualisationResult equalised = equaliseVolumes(stage.turnedStart(turns[t]),
                                                   signedDistance(phi),
                                                   stage.volume,
                                                   inFrame,
                                                   progressOfPart(atFullSize, t, turns.size()));
    if (isBetter(equalised, *present))
    {
      found.better = std::move(equalised);
      found.turn = describeTurn(turns[t]);
      found.rotation = turns[t];
      present = &*found.better;
    }
  }
  found.hopeless.reset();
  if (isGivenUp(*present))
  {
    found.hopeless = HopelessShape{ present->uncertifiedCells, cellsOf(2 * options.shells), false };
  }
  return found;
}

} // namespace moserhex
