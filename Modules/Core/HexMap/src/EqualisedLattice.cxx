#include "EqualisedLattice.h"

#include "LatticeRefinement.h"
#include "moserhex/Quality/HexQuality.h"
#include "moserhex/Quality/JacobianBounds.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace moserhex
{
namespace
{

/** phi is not quite a distance away from the surface: what is aimed at, part of the tolerance. */
constexpr double aimedPartOfTolerance = 0.95;
/** Where the smallest scaled Jacobian is below this, the mesh is repaired, too, though it may be exact [1]. */
constexpr double aimedScaledJacobian = 0.035;
/** A cell below this part of the mean volume has no density to speak of. */
constexpr double smallestSoundVolume = 0.1;

double
smallestScaledJacobian(const HexMesh & mesh)
{
  double smallest = 1.0;
  for (std::size_t cell = 0; cell < mesh.cellCount(); ++cell)
  {
    smallest = std::min(smallest, hexCellQuality(cellCorners(mesh, cell)).scaledJacobian);
  }
  return smallest;
}

} // namespace

EqualisedLattice::EqualisedLattice(const HexMesh & start, const EqualisationProblem & problem)
  : m_Problem(problem), m_State{ start, 0.0 }
{
  m_Origin.setZero();
  for (const Vector3 & node : start.nodes)
  {
    m_Origin += node / static_cast<double>(start.nodes.size());
  }
}

void
EqualisedLattice::resample(int nodesPerSide)
{
  HexMesh & mesh = m_State.mesh;
  if (nodesPerSide != mesh.nodesPerSide)
  {
    mesh.nodes = interpolateLattice(mesh.nodes, mesh.nodesPerSide, nodesPerSide);
    mesh.nodesPerSide = nodesPerSide;
  }
}

LatticeOptimiser
EqualisedLattice::makeOptimiser() const
{
  const double  edge = unit();
  const Vector3 origin = m_Origin;
  const auto    scaled = [edge, origin, &phi = m_Problem.phi](const Vector3 & p, Vector3 & gradient) {
    return phi(origin + edge * p, gradient) / edge;
  };
  Positions surfacePoints = m_Problem.surface;
  for (Vector3 & point : surfacePoints)
  {
    point = (point - origin) / edge;
  }
  LatticeOptimiser optimiser(LatticeLayout(mesh().nodesPerSide, mesh().paddingLayers),
                             scaled,
                             std::move(surfacePoints),
                             static_cast<double>(mesh().cellCount()),
                             m_Problem.options.threads);
  optimiser.attraction().setLevel(m_State.level / edge);
  if (m_Problem.options.ties.any())
  {
    optimiser.setTies(TieEnergy(optimiser.layout(), m_Problem.options.ties, m_Origin, edge));
  }
  return optimiser;
}

Eigen::VectorXd
EqualisedLattice::vector(const LatticeLayout & layout) const
{
  return latticeVector(layout, mesh().nodes, m_Origin, unit());
}

void
EqualisedLattice::take(const LatticeOptimiser & optimiser, const Eigen::VectorXd & x)
{
  m_State.mesh.nodes = latticePositions(optimiser.layout(), x, m_Origin, unit());
  m_State.level = optimiser.attraction().level() * unit();
}

double
EqualisedLattice::unit() const
{
  return std::cbrt(m_Problem.volume / static_cast<double>(mesh().cellCount()));
}

double
EqualisedLattice::target() const
{
  return m_Problem.total / static_cast<double>(mesh().cellCount());
}

std::vector<double>
EqualisedLattice::targetVolumes() const
{
  std::vector<double> measures;
  m_Problem.measure.evaluate(mesh(), m_Problem.options.threads, measures);
  std::vector<double> volumes = cellVolumes(mesh());
  const double        cellVolume = m_Problem.volume / static_cast<double>(volumes.size());
  const double        meanDensity = m_Problem.total / m_Problem.volume;
  double              sum = 0.0;
  for (std::size_t cell = 0; cell < volumes.size(); ++cell)
  {
    const bool   isSound = volumes[cell] > smallestSoundVolume * cellVolume && measures[cell] > 0.0;
    const double density = isSound ? measures[cell] / volumes[cell] : meanDensity;
    volumes[cell] = meanDensity / density;
    sum += volumes[cell];
  }
  for (double & volume : volumes)
  {
    volume *= static_cast<double>(volumes.size()) / sum;
  }
  return volumes;
}

double
EqualisedLattice::deviation() const
{
  std::vector<double> measures;
  m_Problem.measure.evaluate(mesh(), m_Problem.options.threads, measures);
  double sum = 0.0;
  for (const double measure : measures)
  {
    sum += std::pow(measure / target() - 1.0, 2);
  }
  return sum / static_cast<double>(measures.size());
}

bool
EqualisedLattice::isEqual() const
{
  return deviation() <= largestExactVariance;
}

std::size_t
EqualisedLattice::uncertifiedCells() const
{
  return mesh().cellCount() - certifyCells(mesh(), {}, m_Problem.options.threads).positive;
}

double
EqualisedLattice::meanScaledJacobian() const
{
  const std::size_t cells = mesh().cellCount();
  double            sum = 0.0;
  for (std::size_t cell = 0; cell < cells; ++cell)
  {
    sum += hexCellQuality(cellCorners(mesh(), cell)).scaledJacobian;
  }
  return sum / static_cast<double>(cells);
}

EqualisationFlaws
EqualisedLattice::flaws(LatticeOptimiser & optimiser) const
{
  const Eigen::VectorXd x = vector(optimiser.layout());
  optimiser.coverage().associate(x);
  EqualisationFlaws flaws;
  flaws.uncertified = uncertifiedCells();
  flaws.distance = optimiser.attraction().largestDistance(x);
  flaws.uncovered = optimiser.coverage().largestDistance();
  flaws.scaledJacobian = smallestScaledJacobian(mesh());
  return flaws;
}

FlawLimits
EqualisedLattice::flawLimits() const
{
  return { aimedPartOfTolerance * m_Problem.options.surfaceTolerance / unit(),
           aimedPartOfTolerance * largestUncoveredDistance() / unit(),
           aimedScaledJacobian };
}

double
EqualisedLattice::largestUncoveredDistance() const
{
  return std::max(m_Problem.options.surfaceTolerance, m_Problem.options.coverageTolerance * unit());
}

} // namespace moserhex
