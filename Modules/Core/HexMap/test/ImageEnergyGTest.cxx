// Closed forms: round-off; mean over the Gauss points of a quadratic is its mean over the cell. Taylor remainder: slope
// fitted, within 0.1 of 2. Threads: bit for bit.
#include "ImageEnergy.h"

#include "TestEnergies.h"

#include <gtest/gtest.h>

using namespace moserhex;
using namespace moserhex::testing;
using Eigen::VectorXd;

namespace
{

/** Larger than the smallest lattice that more than one thread works on. */
constexpr int n = 15;

ValueAndGradient
linear(const Vector3 & p)
{
  const Vector3 slope(0.5, -1.0, 2.0);
  return { slope.dot(p), slope };
}

ValueAndGradient
wavy(const Vector3 & p)
{
  return { std::sin(p.x()) * p.y() + p.z() * p.z(), Vector3(std::cos(p.x()) * p.y(), std::sin(p.x()), 2.0 * p.z()) };
}

/** The function and its own values at the mesh's samples. */
LatticeImage
imageOf(ValueAndGradient (*function)(const Vector3 &), const HexMesh & mesh)
{
  LatticeImage image;
  image.image = function;
  for (const Vector3 & point : latticeSamples(mesh))
  {
    image.values.push_back(function(point).value);
  }
  return image;
}

LatticeEnergy
imageEnergy(const LatticeImage & image, double weight, unsigned int threads = 1)
{
  const LatticeLayout layout(n);
  return [=](const VectorXd & x, VectorXd & gradient) {
    return addImageEnergy(layout, x, image, weight, threads, gradient);
  };
}

} // namespace

TEST(LatticeSamples, AreTheGaussPointsOfTheCells)
{
  const Positions samples = latticeSamples(unitCells(3, 0.0, 1));
  ASSERT_EQ(samples.size(), 64u);
  const double low = 0.5 - 0.5 / std::sqrt(3.0);
  EXPECT_LT((samples[0] - Vector3(low, low, low)).norm(), 1e-15);
  EXPECT_LT((samples[1] - Vector3(1.0 - low, low, low)).norm(), 1e-15);
  EXPECT_LT((samples[4] - Vector3(low, low, 1.0 - low)).norm(), 1e-15);
  EXPECT_LT((samples[8] - Vector3(1.0 + low, low, low)).norm(), 1e-15);
  EXPECT_LT((samples[63] - Vector3(2.0 - low, 2.0 - low, 2.0 - low)).norm(), 1e-15);
}

TEST(ImageEnergy, IsZeroWhereTheImageIsAsWanted)
{
  const HexMesh mesh = unitCells(n, 0.3, 1);
  EXPECT_EQ(valueAt(imageEnergy(imageOf(wavy, mesh), 2.0), vectorOf(mesh)), 0.0);
}

TEST(ImageEnergy, OfAMovedLinearImageIsTheSquareOfItsRise)
{
  const HexMesh rest = unitCells(n, 0.0, 1);
  HexMesh       moved = rest;
  for (Vector3 & node : moved.nodes)
  {
    node += Vector3(0.0, 0.0, 0.1); // rises by 0.2
  }
  const double cells = (n - 1.0) * (n - 1.0) * (n - 1.0);
  EXPECT_NEAR(valueAt(imageEnergy(imageOf(linear, rest), 3.0), vectorOf(moved)), 0.5 * 3.0 * cells * 0.04, 1e-9);
}

TEST(ImageEnergy, GradientHasTaylorRemainderOfSecondOrder)
{
  const LatticeImage image = imageOf(wavy, unitCells(n, 0.0, 1));
  EXPECT_NEAR(taylorOrder(imageEnergy(image, 2.0), unitCells(n, 0.4, 2), 0.1), 2.0, 0.1);
}

TEST(ImageEnergy, IsTheSameForAnyNumberOfThreads)
{
  const VectorXd     x = vectorOf(unitCells(n, 0.5, 2));
  const LatticeImage image = imageOf(wavy, unitCells(n, 0.0, 1));
  EXPECT_EQ(valueAt(imageEnergy(image, 1.0, 1), x), valueAt(imageEnergy(image, 1.0, 3), x));
  EXPECT_EQ(gradientAt(imageEnergy(image, 1.0, 1), x), gradientAt(imageEnergy(image, 1.0, 3), x));
}
