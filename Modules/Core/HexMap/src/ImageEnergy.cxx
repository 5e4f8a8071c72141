#include "ImageEnergy.h"

#include <array>

namespace moserhex
{
namespace
{

/** (1 +- 1 / sqrt 3) / 2 */
constexpr std::array<double, 2> gaussPoints{ { 0.21132486540518711775, 0.78867513459481288225 } };

/** N_a at sample q, corners and samples numbered by bits (i, j, k). */
double
sampleWeight(std::size_t q, std::size_t a)
{
  double weight = 1.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double at = gaussPoints[q >> axis & 1U];
    weight *= (a >> axis & 1U) != 0 ? at : 1.0 - at;
  }
  return weight;
}

using SampleWeights = std::array<std::array<double, 8>, latticeSamplesPerCell>;

const SampleWeights &
sampleWeights()
{
  static const SampleWeights all = [] {
    SampleWeights weights;
    for (std::size_t q = 0; q < latticeSamplesPerCell; ++q)
    {
      for (std::size_t a = 0; a < 8; ++a)
      {
        weights[q][a] = sampleWeight(q, a);
      }
    }
    return weights;
  }();
  return all;
}

std::array<Vector3, 8>
cornersOf(const LatticeLayout & layout, const Eigen::VectorXd & x, const CellNodes & nodes)
{
  std::array<Vector3, 8> corners;
  for (std::size_t a = 0; a < nodes.size(); ++a)
  {
    corners[a] = layout.at(x, nodes[a]);
  }
  return corners;
}

Vector3
sampleOf(const std::array<Vector3, 8> & corners, std::size_t q)
{
  Vector3 p = Vector3::Zero();
  for (std::size_t a = 0; a < corners.size(); ++a)
  {
    p += sampleWeights()[q][a] * corners[a];
  }
  return p;
}

/** E of one cell at w = 1; w times its gradient is added. */
double
addCell(const LatticeLayout &   layout,
        const Eigen::VectorXd & x,
        const CellNodes &       nodes,
        const LatticeImage &    image,
        const double *          values,
        double                  weight,
        Eigen::VectorXd &       gradient)
{
  constexpr double             part = 1.0 / static_cast<double>(latticeSamplesPerCell);
  const std::array<Vector3, 8> corners = cornersOf(layout, x, nodes);
  std::array<Vector3, 8>       slopes;
  slopes.fill(Vector3::Zero());
  double energy = 0.0;
  for (std::size_t q = 0; q < latticeSamplesPerCell; ++q)
  {
    const ValueAndGradient found = image.image(sampleOf(corners, q));
    const double           difference = found.value - values[q];
    energy += 0.5 * part * difference * difference;
    for (std::size_t a = 0; a < nodes.size(); ++a)
    {
      slopes[a] += part * difference * sampleWeights()[q][a] * found.gradient;
    }
  }
  for (std::size_t a = 0; a < nodes.size(); ++a)
  {
    layout.add(gradient, nodes[a], weight * slopes[a]);
  }
  return energy;
}

} // namespace

Positions
latticeSamples(const HexMesh & mesh)
{
  requireLattice(mesh);
  const LatticeLayout   layout(mesh.nodesPerSide);
  const Eigen::VectorXd x = latticeVector(layout, mesh.nodes, Vector3::Zero(), 1.0);
  Positions             samples;
  samples.reserve(latticeSamplesPerCell * mesh.cellCount());
  for (std::size_t cell = 0; cell < mesh.cellCount(); ++cell)
  {
    const std::array<Vector3, 8> corners = cornersOf(layout, x, layout.cellNodes(cell));
    for (std::size_t q = 0; q < latticeSamplesPerCell; ++q)
    {
      samples.push_back(sampleOf(corners, q));
    }
  }
  return samples;
}

double
addImageEnergy(const LatticeLayout &   layout,
               const Eigen::VectorXd & x,
               const LatticeImage &    image,
               double                  weight,
               unsigned int            threads,
               Eigen::VectorXd &       gradient)
{
  const auto          n = static_cast<std::size_t>(layout.nodesPerSide);
  std::vector<double> energies(slabCount(layout), 0.0);
  forEachSlab(layout, threads, [&](std::size_t slab, std::size_t begin, std::size_t end) {
    for (std::size_t start = begin; start < end; ++start)
    {
      const std::size_t i = start % n;
      const std::size_t j = start / n % n;
      const std::size_t k = start / (n * n);
      if (i + 1 < n && j + 1 < n)
      {
        const std::size_t cell = i + (n - 1) * (j + (n - 1) * k);
        energies[slab] += addCell(
          layout, x, layout.cellNodes(cell), image, &image.values[latticeSamplesPerCell * cell], weight, gradient);
      }
    }
  });
  double sum = 0.0;
  for (const double energy : energies)
  {
    sum += energy;
  }
  return weight * sum;
}

} // namespace moserhex
