#include "Equaliser.h"
#include "moserhex/Quality/JacobianBounds.h"

#include <algorithm>
#include <utility>

namespace moserhex
{
namespace
{

constexpr double smallestDecrease = 1e-7;
/** Cells with a Bezier coefficient below this (det J of a mean cell = 1) are watched. */
constexpr double doubtfulCoefficient = 0.2;
/** Of the barrier in round r: weight 2000 2^r, margin times 1.3^r. */
constexpr double            firstWeight = 2000.0;
constexpr double            weightGrowth = 2.0;
constexpr double            marginGrowth = 1.3;
constexpr double            largestMargin = 0.15;
constexpr EqualisationStage firstStage{ 0.02, 1000.0, 80.0, 60, 1 };
/** After so many projections in a row that led to nothing better the repair is over. */
constexpr int    patience = 2;
constexpr double springGrowthOfTangled = 2.0; // lest springs outgrow the barrier of cells that are not yet positive

/** The cells that have been doubtful once. */
class WatchedCells
{
public:
  /** Adds the cells that are doubtful now; returns all. */
  [[nodiscard]] std::vector<std::size_t>
  update(const HexMesh & mesh, double meanVolume, unsigned int threads)
  {
    const std::vector<double> smallest = smallestBezierCoefficients(mesh, threads);
    m_IsWatched.resize(smallest.size(), false);
    for (std::size_t cell = 0; cell < smallest.size(); ++cell)
    {
      if (smallest[cell] < doubtfulCoefficient * meanVolume)
      {
        m_IsWatched[cell] = true;
      }
    }
    std::vector<std::size_t> cells;
    for (std::size_t cell = 0; cell < m_IsWatched.size(); ++cell)
    {
      if (m_IsWatched[cell])
      {
        cells.push_back(cell);
      }
    }
    return cells;
  }

private:
  std::vector<bool> m_IsWatched;
};

} // namespace

EqualisationFlaws
Equaliser::repair(LatticeOptimiser & optimiser, EqualisationFlaws present, const ProgressCallback & progress)
{
  const EqualisationOptions & options = m_Lattice.problem().options;
  const FlawLimits            limits = m_Lattice.flawLimits();
  const auto                  rounds = static_cast<std::size_t>(options.repairRounds);
  const double            meanVolume = m_Lattice.problem().volume / static_cast<double>(m_Lattice.mesh().cellCount());
  WatchedCells            watched;
  EqualisationFlaws       fewest = present;
  EqualisedLattice::State best = m_Lattice.state();
  EqualisationStage       stage = firstStage;
  stage.angleWeight = options.angleWeight;
  double margin = options.repairMargin;
  double weight = firstWeight;
  int    uselessProjections = 0;
  for (std::size_t round = 0; round < rounds && uselessProjections < patience && !present.none(limits); ++round)
  {
    const Stopwatch         stopwatch;
    const ProgressCallback  ofRound = progressOfPart(progress, round, rounds);
    const EqualisationFlaws before = present;
    Eigen::VectorXd         x = m_Lattice.vector(optimiser.layout());
    optimiser.setBarrier(watched.update(m_Lattice.mesh(), meanVolume, options.threads), margin, weight);
    const double growth = before.uncertified > 0 ? springGrowthOfTangled : springGrowth;
    prepareRound(optimiser, x, growth);
    const LimitedMemoryBfgsResult result =
      optimiser.minimise(x, stage, smallestDecrease, progressBetween(ofRound, 0.0, 0.5));
    m_Lattice.take(optimiser, x);
    present = log("repair", result.report.steps, result.evaluations, stopwatch, optimiser);
    if (m_Steps.back().variance > readyDeviation)
    {
      stage.volumeWeight *= settlingGrowth;
    }
    if (present.none(limits) || !present.worthwhileAfter(before, limits) || round + 1 == rounds)
    {
      present = project(optimiser, progressBetween(ofRound, 0.5, 1.0));
      uselessProjections = present.worthwhileAfter(fewest, limits) ? 0 : uselessProjections + 1;
      if (present.fewerThan(fewest, limits))
      {
        fewest = present;
        best = m_Lattice.state();
      }
    }
    margin = std::min(marginGrowth * margin, largestMargin);
    weight *= weightGrowth;
  }
  m_Lattice.setState(std::move(best));
  return fewest;
}

} // namespace moserhex
