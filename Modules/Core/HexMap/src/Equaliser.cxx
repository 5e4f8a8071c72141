#include "Equaliser.h"

#include "moserhex/Quality/HexQuality.h"

#include <array>
#include <sstream>
#include <utility>

namespace moserhex
{
namespace
{

/** Relative decrease over ten steps at which a minimisation ends [1]. */
constexpr double smallestDecrease = 1e-5;
/** Above this mean square deviation the projection is not tried. */
constexpr double roughDeviation = 1e-3;
/** Springs longer than this part of the tolerance are made stiffer. */
constexpr double safePartOfTolerance = 0.8;
constexpr int    settlingRounds = 5;
constexpr int    settlingSteps = 60;
/** Of coarse lattices that the ordinary stages leave tangled. */
constexpr std::array<EqualisationStage, 2> untanglingStages{ { { 0.02, 0.0, 80.0, 60, 1 },
                                                               { 0.005, 0.0, 80.0, 60, 1 } } };

std::vector<std::string>
shortcomingsOf(const EqualisationResult & result, double largestDistance, double largestUncoveredDistance)
{
  std::vector<std::string> lines;
  const auto               add = [&lines](const auto &... parts) {
    std::ostringstream line;
    (line << ... << parts);
    lines.push_back(line.str());
  };
  const std::size_t cells = result.mesh.cellCount();
  if (!(result.variance <= largestExactVariance))
  {
    add("cells are not equal: variance ", result.variance, ", must be at most ", largestExactVariance);
  }
  if (result.concaveCells > 0)
  {
    add(result.concaveCells, " of ", cells, " cells are concave");
  }
  if (result.uncertifiedCells > result.concaveCells)
  {
    add(result.uncertifiedCells, " of ", cells, " cells are not certified positive inside");
  }
  if (!(result.largestDistance <= largestDistance))
  {
    add("boundary up to ", result.largestDistance, " mm off the surface, must be at most ", largestDistance);
  }
  if (!(result.uncoveredDistance <= largestUncoveredDistance))
  {
    add("surface up to ", result.uncoveredDistance, " mm off the boundary, must be at most ", largestUncoveredDistance);
  }
  return lines;
}

} // namespace

void
Equaliser::minimise(const std::vector<EqualisationStage> & stages, Boundary boundary, const ProgressCallback & progress)
{
  LatticeOptimiser optimiser = m_Lattice.makeOptimiser();
  Eigen::VectorXd  x = m_Lattice.vector(optimiser.layout());
  if (boundary == Boundary::OnLevel)
  {
    optimiser.attraction().moveNodesToLevel(x);
    m_Lattice.take(optimiser, x);
  }
  for (std::size_t s = 0; s < stages.size(); ++s)
  {
    if (stages[s].enoughScaledJacobian <= 1.0 && m_Lattice.meanScaledJacobian() >= stages[s].enoughScaledJacobian)
    {
      continue;
    }
    const Stopwatch stopwatch;
    optimiser.attraction().freeze(x);
    if (boundary == Boundary::OnLevel || s > 0)
    {
      optimiser.updateLevel(x);
    }
    optimiser.setTargetVolumes(m_Lattice.targetVolumes());
    const LimitedMemoryBfgsResult result =
      optimiser.minimise(x, stages[s], smallestDecrease, progressOfPart(progress, s, stages.size()));
    m_Lattice.take(optimiser, x);
    log("minimise", result.report.steps, result.evaluations, stopwatch, optimiser);
  }
  optimiser.updateLevel(x);
  m_Lattice.take(optimiser, x);
}

void
Equaliser::untangle(const EqualisationStage & lastStage, const ProgressCallback & progress)
{
  if (m_Lattice.uncertifiedCells() == 0)
  {
    return;
  }
  EqualisedLattice::State tangled = m_Lattice.state();
  minimise({ untanglingStages[0], untanglingStages[1], lastStage }, Boundary::AsItIs, progress);
  if (m_Lattice.uncertifiedCells() > 0)
  {
    m_Lattice.setState(std::move(tangled));
  }
}

void
Equaliser::settle(EqualisationStage stage, double goal, const ProgressCallback & progress)
{
  stage.maximumSteps = settlingSteps;
  stage.enoughScaledJacobian = EqualisationStage{}.enoughScaledJacobian;
  for (std::size_t round = 0; round < settlingRounds && m_Lattice.deviation() > goal; ++round)
  {
    stage.volumeWeight *= settlingGrowth;
    minimise({ stage }, Boundary::AsItIs, progressOfPart(progress, round, settlingRounds));
  }
}

EqualisationFlaws
Equaliser::project(LatticeOptimiser & optimiser, const ProgressCallback & progress, int maximumSteps)
{
  const EqualisationProblem & problem = m_Lattice.problem();
  const Stopwatch             stopwatch;
  EqualMeasureOptions         options = problem.options.projection;
  options.threads = problem.options.threads;
  options.maximumSteps = std::min(options.maximumSteps, maximumSteps);
  EqualMeasureResult result =
    projectOntoEqualMeasure(m_Lattice.mesh(), problem.measure, m_Lattice.target(), problem.phi, options, progress);
  m_Lattice.setMesh(std::move(result.mesh));
  int solverSteps = 0;
  for (const EqualMeasureStep & step : result.steps)
  {
    solverSteps += step.solverSteps;
  }
  EqualisationFlaws flaws = log("project", result.report.steps, solverSteps, stopwatch, optimiser);
  flaws.unequal = !m_Lattice.isEqual();
  return flaws;
}

void
Equaliser::finish(const EqualisationStage & lastStage, const ProgressCallback & progress)
{
  const auto isHopeless = [this] { return m_Lattice.uncertifiedCells() > m_Lattice.problem().options.hopelessCells; };
  if (isHopeless())
  {
    return;
  }
  settle(lastStage, roughDeviation, progressBetween(progress, 0.0, 0.2));
  if (isHopeless())
  {
    return;
  }
  const FlawLimits        limits = m_Lattice.flawLimits();
  EqualisationFlaws       first;
  EqualisedLattice::State projected;
  const bool              isProjected = m_Lattice.uncertifiedCells() <= tangledCells(m_Lattice.mesh().nodesPerSide);
  if (isProjected)
  {
    EqualisedLattice::State minimised = m_Lattice.state();
    LatticeOptimiser        optimiser = m_Lattice.makeOptimiser();
    const EqualisationFlaws before = m_Lattice.flaws(optimiser);
    const bool              isLifted =
      before.uncertified == 0 && lift(optimiser, before.scaledJacobian, progressBetween(progress, 0.2, 0.23));
    first = project(optimiser, progressBetween(progress, 0.23, 0.27));
    if (isLifted && !first.none(limits))
    {
      m_Lattice.setState(minimised);
      first = project(optimiser, progressBetween(progress, 0.27, 0.3));
    }
    if (first.none(limits))
    {
      return;
    }
    projected = m_Lattice.state();
    m_Lattice.setState(std::move(minimised));
  }
  settle(lastStage, readyDeviation, progressBetween(progress, 0.3, 0.5));
  LatticeOptimiser        optimiser = m_Lattice.makeOptimiser();
  const EqualisationFlaws second = project(optimiser, progressBetween(progress, 0.5, 0.6));
  const EqualisationFlaws last = repair(optimiser, second, progressBetween(progress, 0.6, 1.0));
  if (isProjected && first.fewerThan(last, limits))
  {
    m_Lattice.setState(std::move(projected));
  }
}

void
Equaliser::prepareRound(LatticeOptimiser & optimiser, const Eigen::VectorXd & x, double growth) const
{
  const FlawLimits limits = m_Lattice.flawLimits();
  optimiser.attraction().strengthen(x, safePartOfTolerance * limits.distance, growth);
  optimiser.coverage().strengthen(safePartOfTolerance * limits.uncovered, growth);
  optimiser.attraction().freeze(x);
  optimiser.updateLevel(x);
  optimiser.setTargetVolumes(m_Lattice.targetVolumes());
}

EqualisationResult
Equaliser::result() const
{
  LatticeOptimiser        optimiser = m_Lattice.makeOptimiser();
  const EqualisationFlaws flaws = m_Lattice.flaws(optimiser);
  EqualisationResult      result;
  result.mesh = m_Lattice.mesh();
  result.level = m_Lattice.state().level;
  result.variance = m_Lattice.deviation();
  result.concaveCells = volumeQuality(result.mesh).concaveCells;
  result.uncertifiedCells = flaws.uncertified;
  result.smallestScaledJacobian = flaws.scaledJacobian;
  result.meanScaledJacobian = m_Lattice.meanScaledJacobian();
  result.largestDistance = flaws.distance * m_Lattice.unit();
  result.uncoveredDistance = flaws.uncovered * m_Lattice.unit();
  result.steps = m_Steps;
  result.shortcomings =
    shortcomingsOf(result, m_Lattice.problem().options.surfaceTolerance, m_Lattice.largestUncoveredDistance());
  result.exact = result.shortcomings.empty();
  return result;
}

EqualisationFlaws
Equaliser::log(const std::string & name,
               int                 iterations,
               int                 evaluations,
               const Stopwatch &   time,
               LatticeOptimiser &  optimiser)
{
  EqualisationStep step;
  step.seconds = time.seconds();
  const EqualisationFlaws flaws = m_Lattice.flaws(optimiser);
  step.name = name;
  step.nodesPerSide = m_Lattice.mesh().nodesPerSide;
  step.iterations = iterations;
  step.evaluations = evaluations;
  step.variance = m_Lattice.deviation();
  step.uncertified = flaws.uncertified;
  step.distance = flaws.distance * m_Lattice.unit();
  step.uncovered = flaws.uncovered * m_Lattice.unit();
  m_Steps.push_back(step);
  return flaws;
}

} // namespace moserhex
