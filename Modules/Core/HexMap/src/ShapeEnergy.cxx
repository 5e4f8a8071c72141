#include "ShapeEnergy.h"

#include "CellKernels.h"

#include <vector>

namespace moserhex
{
namespace
{

/** w (1 - q)^2 of a corner, w by lanes; its gradient with respect to the edges is added. */
MOSERHEX_INLINE Lanes
addAngleGradients(const CornerFrame & J,
                  const CornerEdges & at,
                  Lanes               determinant,
                  Lanes               weight,
                  CellEdges &         edgeGradients)
{
  constexpr double leastSquare = 1e-30; // of an edge: none divides by 0
  const Lanes      a = 1.0 / (dot(J.a, J.a) + leastSquare);
  const Lanes      b = 1.0 / (dot(J.b, J.b) + leastSquare);
  const Lanes      c = 1.0 / (dot(J.c, J.c) + leastSquare);
  const Lanes      inverseLengths = squareRoot(a * b * c);
  const Lanes      scaledJacobian = determinant * inverseLengths;
  const Lanes      shortfall = 1.0 - scaledJacobian;
  const Lanes      slope = -2.0 * weight * shortfall;
  const Lanes      alongCofactors = slope * inverseLengths;
  const Lanes      alongEdges = -slope * scaledJacobian;
  edgeGradients.i[at.i] += alongCofactors * J.bc + (alongEdges * a) * J.a;
  edgeGradients.j[at.j] += alongCofactors * J.ca + (alongEdges * b) * J.b;
  edgeGradients.k[at.k] += alongCofactors * J.ab + (alongEdges * c) * J.c;
  return weight * shortfall * shortfall;
}

/** Energy of eight cells by lanes, and its gradients with respect to their corners; 0 where the mask has none.
 * \param corners  relative to the first \param target  their volumes wanted */
MOSERHEX_INLINE Lanes
cellEnergies(const LaneVector *         corners,
             LaneMask                   cells,
             Lanes                      target,
             const ShapeEnergyWeights & weights,
             LaneVector *               gradients)
{
  const Lanes one = allLanes(1.0);
  volumeGradients(corners, gradients);
  const Lanes deviation = volumesOf(corners, gradients) / target - one;
  Lanes       energy = select(cells, 0.5 * weights.volume * deviation * deviation, Lanes{});
  const Lanes pressure = select(cells, weights.volume * deviation / (12.0 * target), Lanes{});
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    gradients[corner] = pressure * gradients[corner];
  }

  CellEdges edges;
  edgesOf(corners, edges);
  CellEdges   edgeGradients{};
  const Lanes share = select(cells, allLanes(0.125), Lanes{});
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    const CornerEdges at = edgesAt(corner);
    const CornerFrame J(edges, at);

    const Lanes                  determinant = select(cells, dot(J.a, J.bc), one);
    const RegularisedDeterminant regular = regularised(determinant, weights.regularisation);
    const Lanes                  root = inverseCubeRoot(regular.chi);
    const Lanes                  chiPower = root * root; // chi^(-2/3)
    const Lanes                  meanRatio = (dot(J.a, J.a) + dot(J.b, J.b) + dot(J.c, J.c)) * chiPower * (1.0 / 3.0);
    Lanes                        slope = share; // f^(p-1) / 8
    for (int factor = 1; factor < weights.power; ++factor)
    {
      slope *= meanRatio;
    }
    energy += slope * meanRatio;
    slope *= static_cast<double>(weights.power);

    const Lanes alongEdges = slope * chiPower * (2.0 / 3.0);
    const Lanes alongCofactors = slope * meanRatio / regular.r * (-2.0 / 3.0);
    edgeGradients.i[at.i] += alongEdges * J.a + alongCofactors * J.bc;
    edgeGradients.j[at.j] += alongEdges * J.b + alongCofactors * J.ca;
    edgeGradients.k[at.k] += alongEdges * J.c + alongCofactors * J.ab;
    if (weights.angle > 0.0)
    {
      energy += addAngleGradients(J, at, determinant, weights.angle * share, edgeGradients);
    }
  }
  addEdgeGradients(edgeGradients, gradients);
  return energy;
}

/** Energy of the lattice's cells that begin in [begin, end), its gradient added. */
MOSERHEX_KERNEL double
slabEnergy(const LatticeLayout &      layout,
           const double *             x,
           const double *             targetVolumes,
           const ShapeEnergyWeights & weights,
           std::size_t                begin,
           std::size_t                end,
           double *                   gradient)
{
  Lanes energy{};
  for (std::size_t p = begin; p < end; p += laneCount)
  {
    const LaneMask cells = existing(targetVolumes, p, end);
    const Lanes    target = select(cells, loadLanes(targetVolumes + p), allLanes(1.0));
    LaneVector     corners[8];
    LaneVector     gradients[8];
    loadCorners(layout, x, p, corners);
    energy += cellEnergies(corners, cells, target, weights, gradients);
    addToCorners(layout, gradient, p, gradients);
  }
  return sumOfLanes(energy);
}

/** The same of the pillow cells. */
MOSERHEX_KERNEL double
pillowEnergy(const LatticeLayout &      layout,
             const double *             x,
             const double *             targetVolumes,
             const ShapeEnergyWeights & weights,
             double *                   gradient)
{
  const std::size_t end = layout.stride + layout.pillowCells.size();
  Lanes             energy{};
  for (std::size_t slot = layout.stride; slot < end; slot += laneCount)
  {
    const LaneMask cells = existing(targetVolumes, slot, end);
    const Lanes    target = select(cells, loadLanes(targetVolumes + slot), allLanes(1.0));
    LaneVector     corners[8];
    LaneVector     gradients[8];
    gatherCorners(layout, x, slot - layout.stride, corners);
    energy += cellEnergies(corners, cells, target, weights, gradients);
    scatterToCorners(layout, gradient, slot - layout.stride, gradients);
  }
  return sumOfLanes(energy);
}

MOSERHEX_KERNEL void
slabVolumes(const LatticeLayout & layout,
            const double *        x,
            const double *        exists,
            std::size_t           begin,
            std::size_t           end,
            double *              volumes)
{
  for (std::size_t p = begin; p < end; p += laneCount)
  {
    const LaneMask cells = existing(exists, p, end);
    LaneVector     corners[8];
    LaneVector     gradients[8];
    loadCorners(layout, x, p, corners);
    volumeGradients(corners, gradients);
    addLanes(volumes + p, select(cells, volumesOf(corners, gradients), Lanes{}));
  }
}

MOSERHEX_KERNEL void
pillowVolumes(const LatticeLayout & layout, const double * x, double * volumes)
{
  for (std::size_t pillow = 0; pillow < layout.pillowCells.size(); pillow += laneCount)
  {
    LaneVector corners[8];
    LaneVector gradients[8];
    gatherCorners(layout, x, pillow, corners);
    volumeGradients(corners, gradients);
    const Lanes volumesOfLanes = volumesOf(corners, gradients);
    for (std::size_t lane = 0; lane < laneCount && pillow + lane < layout.pillowCells.size(); ++lane)
    {
      volumes[layout.stride + pillow + lane] = volumesOfLanes[lane];
    }
  }
}

} // namespace

double
addShapeEnergy(const LatticeLayout &      layout,
               const Eigen::VectorXd &    x,
               const Eigen::VectorXd &    targetVolumes,
               const ShapeEnergyWeights & weights,
               unsigned int               threads,
               Eigen::VectorXd &          gradient)
{
  std::vector<double> energies(slabCount(layout));
  forEachSlab(layout, threads, [&](std::size_t slab, std::size_t begin, std::size_t end) {
    energies[slab] = slabEnergy(layout, x.data(), targetVolumes.data(), weights, begin, end, gradient.data());
  });
  double sum = pillowEnergy(layout, x.data(), targetVolumes.data(), weights, gradient.data());
  layout.clearPadding(gradient);
  for (const double energy : energies)
  {
    sum += energy;
  }
  return sum;
}

Eigen::VectorXd
latticeVolumes(const LatticeLayout & layout, const Eigen::VectorXd & x, unsigned int threads)
{
  const Eigen::VectorXd exists = unitTargetVolumes(layout);
  Eigen::VectorXd       volumes = Eigen::VectorXd::Zero(exists.size());
  forEachSlab(layout, threads, [&](std::size_t, std::size_t begin, std::size_t end) {
    slabVolumes(layout, x.data(), exists.data(), begin, end, volumes.data());
  });
  pillowVolumes(layout, x.data(), volumes.data());
  return volumes;
}

Eigen::VectorXd
unitTargetVolumes(const LatticeLayout & layout)
{
  Eigen::VectorXd volumes = Eigen::VectorXd::Zero(layout.slotCount());
  volumes.segment(static_cast<Eigen::Index>(layout.stride), static_cast<Eigen::Index>(layout.pillowCells.size()))
    .setOnes();
  const int cells = layout.nodesPerSide - 1;
  for (int k = 0; k < cells; ++k)
  {
    for (int j = 0; j < cells; ++j)
    {
      volumes.segment(static_cast<Eigen::Index>(layout.node(0, j, k)), cells).setOnes();
    }
  }
  return volumes;
}

} // namespace moserhex
