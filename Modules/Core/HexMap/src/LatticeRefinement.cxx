#include "LatticeRefinement.h"

#include <Eigen/Core>

#include <algorithm>

namespace moserhex
{
namespace
{
/** Row i holds the weights of the coarse samples at the fine sample i. */
Eigen::MatrixXd
lagrangeMatrix(int coarse, int fine)
{
  Eigen::MatrixXd weights = Eigen::MatrixXd::Zero(fine, coarse);
  const int       used = std::min(4, coarse);
  for (int i = 0; i < fine; ++i)
  {
    const double at = static_cast<double>(i) * (coarse - 1) / (fine - 1);
    const int    first = std::min(std::max(static_cast<int>(at) - 1, 0), coarse - used);
    for (int a = 0; a < used; ++a)
    {
      double weight = 1.0;
      for (int b = 0; b < used; ++b)
      {
        weight *= b == a ? 1.0 : (at - first - b) / (a - b);
      }
      weights(i, first + a) = weight;
    }
  }
  return weights;
}
} // namespace

Positions
interpolateLattice(const Positions & nodes, int nodesPerSide, int finerNodesPerSide)
{
  using Plane = Eigen::MatrixXd;
  using Row = Eigen::Map<const Eigen::Matrix<double, 3, Eigen::Dynamic>>;
  const Eigen::Index    coarse = nodesPerSide;
  const Eigen::Index    fine = finerNodesPerSide;
  const Eigen::MatrixXd weights = lagrangeMatrix(nodesPerSide, finerNodesPerSide).transpose(); // coarse x fine

  // Along i, then j, then k; a column holds one point.
  Plane alongI(3, fine * coarse * coarse);
  for (Eigen::Index row = 0; row < coarse * coarse; ++row)
  {
    alongI.middleCols(row * fine, fine).noalias() =
      Row(nodes[static_cast<std::size_t>(row * coarse)].data(), 3, coarse) * weights;
  }
  Plane alongJ = Plane::Zero(3, fine * fine * coarse);
  for (Eigen::Index k = 0; k < coarse; ++k)
  {
    for (Eigen::Index j = 0; j < fine; ++j)
    {
      for (Eigen::Index from = 0; from < coarse; ++from)
      {
        alongJ.middleCols((k * fine + j) * fine, fine) +=
          weights(from, j) * alongI.middleCols((k * coarse + from) * fine, fine);
      }
    }
  }
  Plane alongK = Plane::Zero(3, fine * fine * fine);
  for (Eigen::Index k = 0; k < fine; ++k)
  {
    for (Eigen::Index from = 0; from < coarse; ++from)
    {
      if (weights(from, k) != 0.0)
      {
        alongK.middleCols(k * fine * fine, fine * fine) +=
          weights(from, k) * alongJ.middleCols(from * fine * fine, fine * fine);
      }
    }
  }
  Positions result(static_cast<std::size_t>(fine * fine * fine));
  for (std::size_t node = 0; node < result.size(); ++node)
  {
    result[node] = alongK.col(static_cast<Eigen::Index>(node));
  }
  return result;
}

std::vector<int>
refinementLevels(int coarse, int fine)
{
  std::vector<int> levels{ fine };
  while (levels.back() > 2 * coarse)
  {
    levels.push_back((levels.back() + 3) / 4 * 2);
  }
  if (levels.back() != coarse)
  {
    levels.push_back(coarse);
  }
  std::reverse(levels.begin(), levels.end());
  return levels;
}

} // namespace moserhex
