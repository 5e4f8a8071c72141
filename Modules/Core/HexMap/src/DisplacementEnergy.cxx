#include "DisplacementEnergy.h"

#include "moserhex/Common/Parallel.h"

#include <vector>

namespace moserhex
{
namespace
{

/** Half the energy of the edges at the nodes of layer k, and that of its boundary nodes; their gradient is added. */
double
addLayer(const LatticeLayout &       layout,
         const Eigen::VectorXd &     u,
         const DisplacementWeights & weights,
         int                         k,
         Eigen::VectorXd &           gradient)
{
  const int  n = layout.nodesPerSide;
  const auto isOuter = [n](int index) { return index == 0 || index == n - 1; };
  double     bending = 0.0;
  double     boundary = 0.0;
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      const Vector3 at = layout.at(u, layout.node(i, j, k));
      Vector3       sum = Vector3::Zero();
      const auto    addEdge = [&](int i2, int j2, int k2) {
        const Vector3 difference = at - layout.at(u, layout.node(i2, j2, k2));
        sum += difference;
        bending += 0.25 * difference.squaredNorm(); // each edge is met from both ends
      };
      i > 0 ? addEdge(i - 1, j, k) : void();
      i + 1 < n ? addEdge(i + 1, j, k) : void();
      j > 0 ? addEdge(i, j - 1, k) : void();
      j + 1 < n ? addEdge(i, j + 1, k) : void();
      k > 0 ? addEdge(i, j, k - 1) : void();
      k + 1 < n ? addEdge(i, j, k + 1) : void();
      sum *= weights.bending;
      if (isOuter(i) || isOuter(j) || isOuter(k))
      {
        sum += weights.boundary * at;
        boundary += 0.5 * at.squaredNorm();
      }
      layout.add(gradient, layout.node(i, j, k), sum);
    }
  }
  return weights.bending * bending + weights.boundary * boundary;
}

} // namespace

double
addDisplacementEnergy(const LatticeLayout &       layout,
                      const Eigen::VectorXd &     x,
                      const Eigen::VectorXd &     reference,
                      const DisplacementWeights & weights,
                      unsigned int                threads,
                      Eigen::VectorXd &           gradient)
{
  const Eigen::VectorXd u = x - reference;
  std::vector<double>   energies(static_cast<std::size_t>(layout.nodesPerSide));
  parallelFor(energies.size(), threads, [&](std::size_t k) {
    energies[k] = addLayer(layout, u, weights, static_cast<int>(k), gradient);
  });
  double sum = 0.0;
  for (const double energy : energies)
  {
    sum += energy;
  }
  return sum;
}

} // namespace moserhex
