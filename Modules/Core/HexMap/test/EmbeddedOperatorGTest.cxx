// Round-off: 1e-13 of the largest entry.
#include "EmbeddedOperator.h"

#include "moserhex/Common/Random.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <set>

using namespace moserhex;

namespace
{

/** The operator as a matrix. */
Eigen::MatrixXd
matrixOf(const EmbeddedOperator & op, std::size_t size)
{
  const auto      n = static_cast<Eigen::Index>(size);
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(n, n);
  op.applyInPlace(matrix, 1);
  return matrix;
}

} // namespace

TEST(EmbeddedOperator, PlacesAreInTheLargerLatticeNoneTwice)
{
  for (const int n : { 2, 3, 6 })
  {
    for (const int layers : { 1, 3 })
    {
      const LatticeLayout layout(n, layers);
      const auto          size = static_cast<std::size_t>(n + 2 * layers);
      const auto          nodes = placesOfNodes(layout);
      const auto          cells = placesOfCells(layout);
      EXPECT_EQ(nodes.size(), layout.nodes);
      EXPECT_EQ(cells.size(), layout.latticeCellCount() + layout.pillowCells.size());
      EXPECT_EQ(std::set<std::size_t>(nodes.begin(), nodes.end()).size(), nodes.size());
      EXPECT_EQ(std::set<std::size_t>(cells.begin(), cells.end()).size(), cells.size());
      EXPECT_LT(*std::max_element(nodes.begin(), nodes.end()), size * size * size);
      EXPECT_LT(*std::max_element(cells.begin(), cells.end()), (size - 1) * (size - 1) * (size - 1));
    }
  }
  EXPECT_TRUE(placesOfNodes(LatticeLayout(4)).empty());
  EXPECT_TRUE(placesOfCells(LatticeLayout(4)).empty());
}

TEST(EmbeddedOperator, IsTheLaplaciansInverseBetweenItsPlaces)
{
  const LatticeLayout   layout(3, 1);
  const auto            places = placesOfNodes(layout);
  const Eigen::MatrixXd part = matrixOf(inverseNodeLaplacian(layout, 0.3), layout.nodes);
  const Eigen::MatrixXd whole = matrixOf(inverseNodeLaplacian(LatticeLayout(5), 0.3), 125);
  for (std::size_t a = 0; a < places.size(); ++a)
  {
    for (std::size_t b = 0; b < places.size(); ++b)
    {
      EXPECT_NEAR(part(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)),
                  whole(static_cast<Eigen::Index>(places[a]), static_cast<Eigen::Index>(places[b])),
                  1e-13 / 0.3);
    }
  }
}

TEST(EmbeddedOperator, IsSymmetricPositiveDefinite)
{
  const LatticeLayout   layout(3, 2);
  const Eigen::MatrixXd matrix = matrixOf(inverseNodeLaplacian(layout, 0.3), layout.nodes);
  EXPECT_LT((matrix - matrix.transpose()).cwiseAbs().maxCoeff(), 1e-13 / 0.3);
  EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix).eigenvalues().minCoeff(), 1.0 / 12.3);
}
