// Closed forms: round-off. Taylor remainder: slope fitted, within 0.1 of 2. Threads: bit for bit.
#include "DisplacementEnergy.h"

#include "TestEnergies.h"

#include <gtest/gtest.h>

using namespace moserhex;
using namespace moserhex::testing;
using Eigen::VectorXd;

namespace
{

constexpr int n = 6;

LatticeEnergy
displacementEnergy(const HexMesh & reference, const DisplacementWeights & weights, unsigned int threads = 1)
{
  const LatticeLayout layout(n);
  return [=, at = vectorOf(reference)](const VectorXd & x, VectorXd & gradient) {
    return addDisplacementEnergy(layout, x, at, weights, threads, gradient);
  };
}

} // namespace

TEST(DisplacementEnergy, IsThatOfItsEdges)
{
  HexMesh             moved = unitCells(n, 0.2, 1);
  const LatticeEnergy energy = displacementEnergy(moved, { 3.0, 0.0 });
  for (Vector3 & node : moved.nodes)
  {
    node += Vector3(1.0, -2.0, 0.5);
  }
  EXPECT_NEAR(valueAt(energy, vectorOf(moved)), 0.0, 1e-12); // a translation is free
  moved.nodes[moved.nodeNumber(2, 2, 2)] += Vector3(0.3, 0.0, 0.4);
  EXPECT_NEAR(valueAt(energy, vectorOf(moved)), 0.5 * 3.0 * 6 * 0.25, 1e-12); // six edges, |u|^2 = 1/4
  moved.nodes[moved.nodeNumber(0, 0, 0)] += Vector3(0.0, 0.5, 0.0);
  EXPECT_NEAR(valueAt(energy, vectorOf(moved)), 0.5 * 3.0 * 9 * 0.25, 1e-12); // and three at a corner
}

TEST(DisplacementEnergy, OnlyNodesOfTheBoundaryAreDrawnToTheirPlaces)
{
  HexMesh             moved = unitCells(n, 0.2, 1);
  const LatticeEnergy energy = displacementEnergy(moved, { 0.0, 3.0 });
  for (Vector3 & node : moved.nodes)
  {
    node += Vector3(0.3, 0.0, 0.4);
  }
  EXPECT_NEAR(valueAt(energy, vectorOf(moved)), 0.5 * 3.0 * (n * n * n - (n - 2) * (n - 2) * (n - 2)) * 0.25, 1e-12);
}

TEST(DisplacementEnergy, StretchingCostsTheSameInEveryEdgeAlongIt)
{
  const HexMesh reference = unitCells(n, 0.2, 1);
  HexMesh       stretched = reference;
  for (int k = 0; k < n; ++k)
  {
    for (int j = 0; j < n; ++j)
    {
      for (int i = 0; i < n; ++i)
      {
        stretched.nodes[stretched.nodeNumber(i, j, k)] += Vector3(0.1 * i, 0.0, 0.0);
      }
    }
  }
  EXPECT_NEAR(
    valueAt(displacementEnergy(reference, { 1.0, 0.0 }), vectorOf(stretched)), 0.5 * (n - 1) * n * n * 0.01, 1e-12);
}

TEST(DisplacementEnergy, GradientHasTaylorRemainderOfSecondOrder)
{
  EXPECT_NEAR(taylorOrder(displacementEnergy(unitCells(n, 0.0, 1), { 2.0, 3.0 }), unitCells(n, 0.5, 2), 0.1), 2.0, 0.1);
}

TEST(DisplacementEnergy, IsTheSameForAnyNumberOfThreads)
{
  const VectorXd x = vectorOf(unitCells(n, 0.5, 2));
  const HexMesh  reference = unitCells(n, 0.0, 1);
  EXPECT_EQ(valueAt(displacementEnergy(reference, { 1.0, 2.0 }, 1), x),
            valueAt(displacementEnergy(reference, { 1.0, 2.0 }, 3), x));
  EXPECT_EQ(gradientAt(displacementEnergy(reference, { 1.0, 2.0 }, 1), x),
            gradientAt(displacementEnergy(reference, { 1.0, 2.0 }, 3), x));
}
