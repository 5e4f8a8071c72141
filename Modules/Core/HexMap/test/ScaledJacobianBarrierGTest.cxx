// Against the scaled Jacobians of the Quality module: round-off (1e-12). Taylor remainders: slope within 0.1 of 2.
#include "ScaledJacobianBarrier.h"

#include "TestEnergies.h"
#include "moserhex/Quality/HexQuality.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace moserhex;
using namespace moserhex::testing;

namespace
{
using Eigen::VectorXd;

LatticeEnergy
barrier(int n, const std::vector<std::size_t> & cells, double goal, double weight)
{
  return [=](const VectorXd & x, VectorXd & gradient) {
    return addScaledJacobianBarrier(LatticeLayout(n), x, cells, goal, weight, gradient);
  };
}

/** The box cell [0,1]^3 sheared along x by the slope: every corner has the scaled Jacobian 1 / sqrt(1 + slope^2). */
HexMesh
shearedCell(double slope)
{
  return mappedLattice(2, [slope](const Vector3 & x) { return Vector3(x[0] + slope * x[1], x[1], x[2]); });
}
} // namespace

TEST(ScaledJacobianBarrier, VanishesOnALatticeOfBoxes)
{
  const HexMesh  mesh = mappedLattice(4, [](const Vector3 & x) { return Vector3(3 * x[0], 60 * x[1], 0.3 * x[2]); });
  const VectorXd x = vectorOf(mesh);
  const auto     energy = barrier(4, { 0, 3, 13, 26 }, 0.999, 1000.0);
  EXPECT_EQ(valueAt(energy, x), 0.0);
  EXPECT_EQ(gradientAt(energy, x), VectorXd::Zero(x.size()));
}

TEST(ScaledJacobianBarrier, ShearedCellHasItsClosedForm)
{
  for (const double slope : { 0.5, 2.0, -10.0 })
  {
    const double scaledJacobian = 1.0 / std::sqrt(1.0 + slope * slope);
    const double goal = 0.95;
    const double expected = 0.5 * 7.0 * 8 * std::pow(std::max(0.0, 1.0 - scaledJacobian / goal), 2);
    EXPECT_NEAR(valueAt(barrier(2, { 0 }, goal, 7.0), vectorOf(shearedCell(slope))), expected, 1e-12) << slope;
  }
}

TEST(ScaledJacobianBarrier, WorstCornerIsThatOfTheQualityModule)
{
  // With the goal just above the smallest scaled Jacobian of a cell only that corner counts.
  for (const double amplitude : { 0.1, 0.2, 0.25 })
  {
    const HexMesh mesh = unitCells(5, amplitude, 1);
    for (const std::size_t cell : { 0u, 7u, 30u, 63u })
    {
      const double smallest = hexCellQuality(cellCorners(mesh, cell)).scaledJacobian;
      ASSERT_GT(smallest, 0.0);
      const VectorXd x = vectorOf(mesh);
      EXPECT_EQ(valueAt(barrier(5, { cell }, smallest * (1.0 - 1e-12), 1.0), x), 0.0);
      EXPECT_NEAR(valueAt(barrier(5, { cell }, smallest * (1.0 + 1e-6), 1.0), x), 0.5e-12, 1e-17);
    }
  }
}

TEST(ScaledJacobianBarrier, GradientHasTaylorRemainderOfSecondOrder)
{
  for (const double amplitude : { 0.3, 1.0 }) // from 0.3 on some corners are inverted, from 1 on most
  {
    const auto energy = barrier(5, { 1, 7, 8, 30, 63 }, 0.8, 100.0);
    EXPECT_NEAR(taylorOrder(energy, unitCells(5, amplitude, 2), 1e-3), 2.0, 0.1) << amplitude;
  }
}

TEST(ScaledJacobianBarrier, DoesNotSeeSizeNorPlace)
{
  const HexMesh  mesh = unitCells(4, 0.3, 5);
  const VectorXd x = vectorOf(mesh);
  const auto     energy = barrier(4, { 0, 5, 13, 26 }, 0.9, 3.0);
  const double   value = valueAt(energy, x);
  ASSERT_GT(value, 0.0);
  EXPECT_NEAR(valueAt(energy, 1e6 * x), value, 1e-12 * value);
  const VectorXd gradient = gradientAt(energy, x);
  EXPECT_NEAR(gradient.dot(x), 0.0, 1e-12 * gradient.norm() * x.norm());
  const LatticeLayout layout(4);
  Vector3             force = Vector3::Zero();
  for (std::size_t node = 0; node < layout.nodes; ++node)
  {
    force += layout.at(gradient, node);
  }
  EXPECT_LT(force.norm(), 1e-12 * gradient.norm());
}

TEST(ScaledJacobianBarrier, OtherCellsFeelNothing)
{
  const HexMesh       mesh = unitCells(4, 0.3, 3);
  const LatticeLayout layout(4);
  const VectorXd      gradient = gradientAt(barrier(4, { 13 }, 0.999, 1.0), vectorOf(mesh));
  const auto          corners = mesh.cellNodes(13);
  for (std::size_t node = 0; node < layout.nodes; ++node)
  {
    const bool isCorner = std::find(corners.begin(), corners.end(), node) != corners.end();
    EXPECT_EQ(layout.at(gradient, node) != Vector3::Zero(), isCorner) << node;
  }
}

TEST(ScaledJacobianBarrier, CornersWithAnEdgeOfNoLengthAreLeftAlone)
{
  HexMesh mesh = shearedCell(3.0);
  mesh.nodes[1] = mesh.nodes[0]; // six corners are left
  const auto   energy = barrier(2, { 0 }, 1.0, 1.0);
  const double value = valueAt(energy, vectorOf(mesh));
  EXPECT_TRUE(std::isfinite(value) && value > 0.0);
  EXPECT_TRUE(gradientAt(energy, vectorOf(mesh)).allFinite());
}
