// Closed forms: round-off. Taylor remainder: slope fitted, within 0.1 of 2.
#include "LandmarkEnergy.h"

#include "TestEnergies.h"

#include <gtest/gtest.h>

using namespace moserhex;
using namespace moserhex::testing;
using Eigen::VectorXd;

namespace
{

constexpr int n = 5;

/** The middle of the cell's lower face along x, and a node. */
std::vector<LatticeLandmark>
twoLandmarks()
{
  LatticeLandmark onEdge;
  onEdge.nodes = { { 0, 1 } };
  onEdge.weights = { { 0.25, 0.75 } };
  onEdge.position = Vector3(0.75, 0.0, 2.0); // two edges above its place in a lattice of unit cells
  LatticeLandmark onNode;
  onNode.nodes = { { 7 } };
  onNode.weights = { { 1.0 } };
  onNode.position = Vector3(2.0, 1.0, 0.0); // node (2,1,0), where it is
  return { onEdge, onNode };
}

LatticeEnergy
landmarkEnergy(double weight)
{
  const LatticeLayout layout(n);
  return [=](const VectorXd & x, VectorXd & gradient) {
    return addLandmarkEnergy(layout, x, twoLandmarks(), weight, gradient);
  };
}

} // namespace

TEST(LandmarkEnergy, IsHalfTheSquaredDistances)
{
  EXPECT_NEAR(valueAt(landmarkEnergy(3.0), vectorOf(unitCells(n, 0.0, 1))), 0.5 * 3.0 * 4.0, 1e-12);
}

TEST(LandmarkEnergy, PullsTheNodesByTheirWeights)
{
  const VectorXd      pull = gradientAt(landmarkEnergy(3.0), vectorOf(unitCells(n, 0.0, 1)));
  const LatticeLayout layout(n);
  EXPECT_LT((layout.at(pull, 0) - Vector3(0.0, 0.0, -6.0 * 0.25)).norm(), 1e-12);
  EXPECT_LT((layout.at(pull, 1) - Vector3(0.0, 0.0, -6.0 * 0.75)).norm(), 1e-12);
  EXPECT_LT(layout.at(pull, 7).norm(), 1e-12);
}

TEST(LandmarkEnergy, GradientHasTaylorRemainderOfSecondOrder)
{
  EXPECT_NEAR(taylorOrder(landmarkEnergy(2.0), unitCells(n, 0.5, 2), 0.1), 2.0, 0.1);
}
