#include "Equaliser.h"
#include "moserhex/Quality/HexQuality.h"

#include <utility>

namespace moserhex
{
namespace
{

/** A mesh with a smaller scaled Jacobian than this is polished [1]. */
constexpr double narrowScaledJacobian = 0.18;
/** Corners are lifted towards this: above what is asked for, as the projection takes some of it back [1]. */
constexpr double goal = 0.23;
/** Cells next to the goal are held as well, lest they pay for the others. */
constexpr double watchedScaledJacobian = 1.3 * goal;
constexpr double weight = 100.0;
/** Few steps: the mesh is good already but for some corners, and only these are to move. */
constexpr EqualisationStage stage{ 0.02, 1000.0, 80.0, 10, 1 };
constexpr double            smallestDecrease = 1e-7;

/** First nodes of the cells with a scaled Jacobian below watchedScaledJacobian. */
std::vector<std::size_t>
watchedCells(const HexMesh & mesh, const LatticeLayout & layout)
{
  std::vector<std::size_t> firstNodes;
  for (std::size_t cell = 0; cell < mesh.cellCount(); ++cell)
  {
    if (hexCellQuality(cellCorners(mesh, cell)).scaledJacobian < watchedScaledJacobian)
    {
      firstNodes.push_back(layout.firstNode(cell));
    }
  }
  return firstNodes;
}

} // namespace

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
  for (std::size_t round = 0; round < rounds && fewest.scaledJacobian < narrowScaledJacobian; ++round)
  {
    const Stopwatch        stopwatch;
    const ProgressCallback ofRound = progressOfPart(progress, round, rounds);
    Eigen::VectorXd        x = m_Lattice.vector(optimiser.layout());
    optimiser.setCornerBarrier(watchedCells(m_Lattice.mesh(), optimiser.layout()), goal, weight);
    prepareRound(optimiser, x, springGrowth);
    const LimitedMemoryBfgsResult result =
      optimiser.minimise(x, stage, smallestDecrease, progressBetween(ofRound, 0.0, 0.5));
    m_Lattice.take(optimiser, x);
    log("polish", result.report.steps, result.evaluations, stopwatch, optimiser);
    const EqualisationFlaws present = project(optimiser, progressBetween(ofRound, 0.5, 1.0));
    if (present.scaledJacobian > fewest.scaledJacobian && present.fewerThan(fewest, best))
    {
      fewest = present;
      kept = m_Lattice.state();
    }
  }
  m_Lattice.setState(std::move(kept));
}

} // namespace moserhex
