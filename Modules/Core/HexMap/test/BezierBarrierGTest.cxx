// Against the coefficients of the Quality module: round-off (1e-12). Taylor remainders: slope fitted, within 0.1 of 2.
#include "BezierBarrier.h"

#include "TestEnergies.h"
#include "moserhex/Quality/JacobianBounds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace moserhex;
using namespace moserhex::testing;

namespace
{
using Eigen::VectorXd;

LatticeEnergy
barrier(int n, std::vector<std::size_t> cells, double margin, double weight)
{
  return [=](const VectorXd & x, VectorXd & gradient) {
    return addBezierBarrier(LatticeLayout(n), x, cells, margin, weight, gradient);
  };
}

double
referenceEnergy(const HexMesh & mesh, const std::vector<std::size_t> & cells, double margin, double weight)
{
  double sum = 0.0;
  for (const std::size_t cell : cells)
  {
    for (const double coefficient : bezierJacobianCoefficients(cellCorners(mesh, cell)))
    {
      sum += std::pow(std::max(0.0, margin - coefficient), 2);
    }
  }
  return 0.5 * weight * sum;
}
} // namespace

TEST(BezierBarrier, VanishesOnALatticeOfBoxes)
{
  const HexMesh  mesh = mappedLattice(4, [](const Vector3 & x) { return Vector3(3 * x[0], 6 * x[1], 1.8 * x[2]); });
  const VectorXd x = vectorOf(mesh); // det J = 1.2
  const auto     energy = barrier(4, { 0, 3, 13, 26 }, 1.199, 1000.0);
  EXPECT_EQ(valueAt(energy, x), 0.0);
  EXPECT_EQ(gradientAt(energy, x), VectorXd::Zero(x.size()));
  const double expected = 0.5 * 4 * 27 * 0.01; // all of them 0.1 short
  EXPECT_NEAR(valueAt(barrier(4, { 0, 3, 13, 26 }, 1.3, 1.0), x), expected, 1e-12);
}

TEST(BezierBarrier, CoefficientsAreThoseOfTheQualityModule)
{
  const std::vector<std::size_t> cells{ 1, 7, 8, 30, 63 };
  for (const double amplitude : { 0.1, 0.3, 1.0 })
  {
    for (const double margin : { -0.5, 0.03, 1.0 })
    {
      const HexMesh mesh = unitCells(5, amplitude, 1);
      const double  expected = referenceEnergy(mesh, cells, margin, 7.0);
      EXPECT_NEAR(valueAt(barrier(5, cells, margin, 7.0), vectorOf(mesh)), expected, 1e-12 * std::max(1.0, expected))
        << amplitude << " " << margin;
    }
  }
}

TEST(BezierBarrier, GradientHasTaylorRemainderOfSecondOrder)
{
  for (const double amplitude : { 0.3, 1.0 })
  {
    const auto energy = barrier(5, { 1, 7, 8, 30, 63 }, 0.8, 2000.0);
    EXPECT_NEAR(taylorOrder(energy, unitCells(5, amplitude, 2), 1e-3), 2.0, 0.1) << amplitude;
  }
}

TEST(BezierBarrier, OtherCellsFeelNothing)
{
  const HexMesh       mesh = unitCells(4, 1.0, 3);
  const LatticeLayout layout(4);
  const VectorXd      gradient = gradientAt(barrier(4, { 13 }, 0.5, 1.0), vectorOf(mesh));
  const auto          corners = mesh.cellNodes(13);
  for (std::size_t node = 0; node < layout.nodes; ++node)
  {
    const bool isCorner = std::find(corners.begin(), corners.end(), node) != corners.end();
    EXPECT_EQ(layout.at(gradient, node) != Vector3::Zero(), isCorner) << node;
  }
  EXPECT_EQ(valueAt(barrier(4, {}, 0.5, 1.0), vectorOf(mesh)), 0.0);
}

TEST(BezierBarrier, ExertsNoForceOnTheWhole)
{
  const HexMesh       mesh = unitCells(3, 1.0, 4);
  const LatticeLayout layout(3);
  const VectorXd      gradient = gradientAt(barrier(3, { 0, 1, 2, 3, 4, 5, 6, 7 }, 0.5, 1.0), vectorOf(mesh));
  Vector3             force = Vector3::Zero();
  for (std::size_t node = 0; node < layout.nodes; ++node)
  {
    force += layout.at(gradient, node);
  }
  EXPECT_LT(force.norm(), 1e-12 * gradient.cwiseAbs().maxCoeff() * 27.0);
}
