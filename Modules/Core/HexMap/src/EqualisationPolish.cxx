#include "Equaliser.h"
#include "moserhex/Quality/HexQuality.h"

#include <algorithm>
#include <utility>

namespace moserhex
{
namespace
{

/** Corners are lifted towards twice the smallest scaled Jacobian there is, between these: a goal out of reach pushes
 * the boundary off the surface. The largest, in terms of what is asked for, is above it, as the projection takes some
 * of it back [1]. */
constexpr double lowestGoal = 0.06;
constexpr double highestGoalPart = 1.28;
/** Cells up to this many times the goal are held as well, lest they pay for the others. */
constexpr double watchedPartOfGoal = 1.3;
/** Where a round leads too far, its first half is tried, and so on down to this part; the next round begins with twice
 * the part that did well. */
constexpr double smallestPart = 0.125;
/** Newton steps of a projection. A mesh that needs more is too far from equal for its corners to survive. */
constexpr int    projectionSteps = 6;
constexpr double weight = 100.0;
/** Few steps: the mesh is good already but for some corners, and only these are to move. */
constexpr EqualisationStage polishStage{ 0.02, 1000.0, 80.0, 10, 1 };
constexpr double            smallestDecrease = 1e-7;

/** Cells with a scaled Jacobian below the bound. */
std::vector<std::size_t>
cellsBelow(double bound, const HexMesh & mesh)
{
  std::vector<std::size_t> cells;
  for (std::size_t cell = 0; cell < mesh.cellCount(); ++cell)
  {
    if (hexCellQuality(cellCorners(mesh, cell)).scaledJacobian < bound)
    {
      cells.push_back(cell);
    }
  }
  return cells;
}

/** The nodes that part of the way from one state to another, at the level of the other. */
EqualisedLattice::State
between(const EqualisedLattice::State & from, const EqualisedLattice::State & to, double part)
{
  EqualisedLattice::State state = to;
  for (std::size_t node = 0; node < state.mesh.nodes.size(); ++node)
  {
    state.mesh.nodes[node] = (1.0 - part) * from.mesh.nodes[node] + part * to.mesh.nodes[node];
  }
  return state;
}

} // namespace

bool
Equaliser::lift(LatticeOptimiser & optimiser, double smallestScaledJacobian, const ProgressCallback & progress)
{
  const EqualisationOptions & options = m_Lattice.problem().options;
  if (options.polishRounds == 0 || smallestScaledJacobian >= options.narrowScaledJacobian)
  {
    return false;
  }
  const Stopwatch stopwatch;
  const double    highestGoal = highestGoalPart * options.narrowScaledJacobian;
  const double    goal = std::min(std::max(lowestGoal, 2.0 * smallestScaledJacobian), highestGoal);
  Eigen::VectorXd x = m_Lattice.vector(optimiser.layout());
  optimiser.setCornerBarrier(cellsBelow(watchedPartOfGoal * goal, m_Lattice.mesh()), goal, weight);
  prepareRound(optimiser, x, springGrowth);
  EqualisationStage stage = polishStage;
  stage.angleWeight = options.angleWeight;
  const LimitedMemoryBfgsResult result = optimiser.minimise(x, stage, smallestDecrease, progress);
  m_Lattice.take(optimiser, x);
  log("polish", result.report.steps, result.evaluations, stopwatch, optimiser);
  return true;
}

void
Equaliser::polish(const ProgressCallback & progress)
{
  const EqualisationOptions & options = m_Lattice.problem().options;
  const auto                  rounds = static_cast<std::size_t>(options.polishRounds);
  const FlawLimits            limits = m_Lattice.flawLimits();
  const FlawLimits            ofExact{ options.surfaceTolerance / m_Lattice.unit(),
                            m_Lattice.largestUncoveredDistance() / m_Lattice.unit(),
                            0.0 };
  const FlawLimits            best{ limits.distance, limits.uncovered, 1.0 }; // any larger scaled Jacobian counts
  LatticeOptimiser            optimiser = m_Lattice.makeOptimiser();
  EqualisationFlaws           fewest = m_Lattice.flaws(optimiser);
  fewest.unequal = !m_Lattice.isEqual();
  if (!fewest.none(ofExact))
  {
    return;
  }
  EqualisedLattice::State kept = m_Lattice.state();
  bool                    isRising = true;
  double                  firstPart = 1.0;
  for (std::size_t round = 0; round < rounds && isRising; ++round)
  {
    const ProgressCallback ofRound = progressOfPart(progress, round, rounds);
    if (!lift(optimiser, fewest.scaledJacobian, progressBetween(ofRound, 0.0, 0.5)))
    {
      break;
    }
    const EqualisedLattice::State polished = m_Lattice.state();
    isRising = false;
    for (double part = firstPart; part >= smallestPart && !isRising; part *= 0.5)
    {
      m_Lattice.setState(between(kept, polished, part));
      const EqualisationFlaws present =
        project(optimiser, progressBetween(ofRound, 1.0 - 0.5 * part, 1.0 - 0.25 * part), projectionSteps);
      isRising = present.scaledJacobian > fewest.scaledJacobian && present.fewerThan(fewest, best);
      if (isRising)
      {
        fewest = present;
        kept = m_Lattice.state();
        firstPart = std::min(1.0, 2.0 * part);
      }
    }
  }
  m_Lattice.setState(std::move(kept));
}

} // namespace moserhex
