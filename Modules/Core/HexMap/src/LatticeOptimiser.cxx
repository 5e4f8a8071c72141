#include "LatticeOptimiser.h"

#include "BezierBarrier.h"
#include "ScaledJacobianBarrier.h"
#include "ShapeEnergy.h"

#include <algorithm>
#include <utility>

namespace moserhex
{
namespace
{
/** Nearest points are looked for again after so many steps while the surface may drain. */
constexpr int stepsBetweenAssociations = 20;

/** Added to the lattice Laplacian, whose constants it leaves at zero [1]. */
constexpr double laplacianShift = 0.3;
} // namespace

LatticeOptimiser::LatticeOptimiser(LatticeLayout  layout,
                                   SignedDistance phi,
                                   Positions      surfacePoints,
                                   double         volume,
                                   unsigned int   threads)
  : m_Layout(std::move(layout))
  , m_Attraction(m_Layout, std::move(phi), threads)
  , m_Coverage(m_Layout, std::move(surfacePoints), threads)
  , m_InverseLaplacian(inverseNodeLaplacian(m_Layout, laplacianShift))
  , m_Volume(volume)
  , m_Threads(threads)
  , m_TargetVolumes(unitTargetVolumes(m_Layout))
{
  m_TargetVolumes *= volume / m_TargetVolumes.sum();
}

void
LatticeOptimiser::setTargetVolumes(const std::vector<double> & volumes)
{
  for (std::size_t cell = 0; cell < volumes.size(); ++cell)
  {
    m_TargetVolumes[static_cast<Eigen::Index>(m_Layout.slot(cell))] = volumes[cell];
  }
}

void
LatticeOptimiser::updateLevel(const Eigen::VectorXd & x)
{
  const double enclosed = latticeVolumes(m_Layout, x, m_Threads).sum();
  m_Attraction.setLevel(m_Attraction.levelOfVolume(x, m_Volume, enclosed));
}

void
LatticeOptimiser::setBarrier(std::vector<std::size_t> cells, double margin, double weight)
{
  m_BarrierCells = std::move(cells);
  m_BarrierMargin = margin;
  m_BarrierWeight = weight;
}

void
LatticeOptimiser::setCornerBarrier(std::vector<std::size_t> cells, double goal, double weight)
{
  m_CornerCells = std::move(cells);
  m_CornerGoal = goal;
  m_CornerWeight = weight;
}

void
LatticeOptimiser::setTies(TieEnergy ties)
{
  m_Ties = std::move(ties);
}

double
LatticeOptimiser::energy(const Eigen::VectorXd & x, const EqualisationStage & stage, Eigen::VectorXd & gradient) const
{
  gradient.setZero(m_Layout.size());
  const ShapeEnergyWeights weights{ stage.regularisation, stage.volumeWeight, stage.power, stage.angleWeight };
  double                   value = addShapeEnergy(m_Layout, x, m_TargetVolumes, weights, m_Threads, gradient);
  value += m_Attraction.addEnergy(x, stage.surfaceWeight, gradient);
  value += m_Coverage.addEnergy(x, stage.surfaceWeight, gradient);
  value += m_Ties.add(m_Layout, x, m_Threads, gradient);
  if (m_RestGradient.size() > 0)
  {
    value -= m_RestGradient.dot(x);
    gradient -= m_RestGradient;
  }
  if (m_BarrierWeight > 0.0)
  {
    value += addBezierBarrier(m_Layout, x, m_BarrierCells, m_BarrierMargin, m_BarrierWeight, gradient);
  }
  if (m_CornerWeight > 0.0)
  {
    value += addScaledJacobianBarrier(m_Layout, x, m_CornerCells, m_CornerGoal, m_CornerWeight, gradient);
  }
  return value;
}

void
LatticeOptimiser::updateRestGradient(const EqualisationStage & stage)
{
  if (m_Ties.rest().size() == 0)
  {
    return;
  }
  const ShapeEnergyWeights shapes{ stage.regularisation, 0.0, stage.power, stage.angleWeight };
  m_RestGradient.setZero(m_Layout.size());
  (void)addShapeEnergy(m_Layout, m_Ties.rest(), m_TargetVolumes, shapes, m_Threads, m_RestGradient);
}

LimitedMemoryBfgsResult
LatticeOptimiser::minimise(Eigen::VectorXd &         x,
                           const EqualisationStage & stage,
                           double                    smallestDecrease,
                           const ProgressCallback &  progress)
{
  const auto function = [&](const Eigen::VectorXd & at, Eigen::VectorXd & gradient) {
    return energy(at, stage, gradient);
  };
  updateRestGradient(stage);
  const auto precondition = [this](Eigen::VectorXd & v) {
    m_InverseLaplacian.applyInPlace(componentsOf(m_Layout, v), m_Threads);
  };
  LimitedMemoryBfgsOptions options;
  options.smallestDecrease = smallestDecrease;
  options.threads = m_Threads;
  LimitedMemoryBfgsResult total;
  while (total.report.steps < stage.maximumSteps && !total.report.converged)
  {
    m_Coverage.associate(x);
    const int left = stage.maximumSteps - total.report.steps;
    options.maximumSteps = m_Coverage.isInDoubt() ? std::min(left, stepsBetweenAssociations) : left;
    const auto                    allSteps = static_cast<double>(stage.maximumSteps);
    const double                  done = total.report.steps / allSteps;
    const LimitedMemoryBfgsResult part = minimiseByLimitedMemoryBfgs(
      function, x, precondition, options, progressBetween(progress, done, done + options.maximumSteps / allSteps));
    total.value = part.value;
    total.gradientNorm = part.gradientNorm;
    total.evaluations += part.evaluations;
    total.report.steps += part.report.steps;
    total.report.seconds += part.report.seconds;
    total.report.residual = part.report.residual;
    total.report.converged = part.report.converged || part.report.steps == 0;
  }
  return total;
}

} // namespace moserhex
