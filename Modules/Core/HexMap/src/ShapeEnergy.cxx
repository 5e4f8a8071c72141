#include "ShapeEnergy.h"

#include "CellKernels.h"

#include <vector>

namespace moserhex
{
namespace
{

/** Energy of the cells that begin in [begin, end), its gradient added. */
MOSERHEX_KERNEL double
slabEnergy(const LatticeLayout &      layout,
           const double *             x,
           const double *             targetVolumes,
           const ShapeEnergyWeights & weights,
           std::size_t                begin,
           std::size_t                end,
           double *                   gradient)
{
  const Lanes one = allLanes(1.0);
  Lanes       energy{};
  for (std::size_t p = begin; p < end; p += laneCount)
  {
    const LaneMask cells = existing(targetVolumes, p, end);
    LaneVector     corners[8];
    LaneVector     gradients[8];
    loadCorners(layout, x, p, corners);

    volumeGradients(corners, gradients);
    const Lanes target = select(cells, loadLanes(targetVolumes + p), one);
    const Lanes deviation = volumesOf(corners, gradients) / target - one;
    energy += select(cells, 0.5 * weights.volume * deviation * deviation, Lanes{});
    const Lanes pressure = select(cells, weights.volume * deviation / (12.0 * target), Lanes{});
    for (LaneVector & g : gradients)
    {
      g = pressure * g;
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
    }
    addEdgeGradients(edgeGradients, gradients);
    addToCorners(layout, gradient, p, gradients);
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
  layout.clearPadding(gradient);
  double sum = 0.0;
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
  return volumes;
}

Eigen::VectorXd
unitTargetVolumes(const LatticeLayout & layout)
{
  Eigen::VectorXd volumes = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(layout.stride));
  const int       cells = layout.nodesPerSide - 1;
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
