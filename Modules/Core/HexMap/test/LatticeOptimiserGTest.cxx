// Taylor remainder: slope fitted, within 0.1 of 2. Round-off: 1e-12. Threads: bit for bit.
#include "LatticeOptimiser.h"
#include "SurfacePoints.h"

#include "ShapeEnergy.h"
#include "TestEnergies.h"
#include "TestSolids.h"
#include "moserhex/HexMap/CellMeasure.h"
#include "moserhex/Quality/JacobianBounds.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace moserhex;
using namespace moserhex::testing;

namespace
{
using Eigen::VectorXd;

const EqualisationStage stage{ 0.05, 50.0, 80.0, 60, 1 };

/** The ball of as many unit volumes as the lattice has cells. */
BentEllipsoid
ballOfCells(int n)
{
  const double volume = (n - 1.0) * (n - 1.0) * (n - 1.0);
  return ballOfRadius(std::cbrt(volume / ballOfRadius(1.0).volume()));
}

LatticeOptimiser
optimiserOfBall(int n, unsigned int threads)
{
  const BentEllipsoid ball = ballOfCells(n);
  const HexMesh       cubes =
    mappedLattice(n, [n](const Vector3 & x) { return Vector3((n - 1.0) * (x - Vector3::Constant(0.5))); });
  const double volume = (n - 1.0) * (n - 1.0) * (n - 1.0);
  return { LatticeLayout(n),
           ball.distance(),
           surfacePoints(cubes.nodes, ball.distance(), volume, 2000, threads),
           volume,
           threads };
}
} // namespace

TEST(LatticeOptimiser, GradientHasTaylorRemainderOfSecondOrder)
{
  LatticeOptimiser optimiser = optimiserOfBall(6, 1);
  const HexMesh    mesh = shaken(ballOfCells(6).lattice(3), 0.6, 1);
  optimiser.attraction().freeze(vectorOf(mesh));
  optimiser.updateLevel(vectorOf(mesh));
  optimiser.setBarrier({ 0, 62 }, 0.8, 2000.0);
  const auto energy = [&](const VectorXd & x, VectorXd & gradient) { return optimiser.energy(x, stage, gradient); };
  EXPECT_NEAR(taylorOrder(energy, mesh, 1e-5), 2.0, 0.1);
}

TEST(LatticeOptimiser, EnergyIsTheSumOfItsParts)
{
  LatticeOptimiser optimiser = optimiserOfBall(6, 1);
  const VectorXd   x = vectorOf(shaken(ballOfCells(6).lattice(3), 0.6, 2));
  optimiser.attraction().freeze(x);
  const auto value = [&](double volumeWeight, double surfaceWeight) {
    VectorXd gradient(x.size());
    return optimiser.energy(x, { 0.05, volumeWeight, surfaceWeight, 1, 1 }, gradient);
  };
  const double shape = value(0.0, 0.0);
  EXPECT_GT(shape, 0.0);
  EXPECT_NEAR(
    value(50.0, 80.0), shape + (value(50.0, 0.0) - shape) + (value(0.0, 80.0) - shape), 1e-12 * value(50, 80));
  const double weightless = value(50.0, 80.0);
  optimiser.setBarrier({ 0 }, 10.0, 0.0);
  EXPECT_EQ(value(50.0, 80.0), weightless);
  optimiser.setBarrier({ 0 }, 10.0, 1.0);
  EXPECT_GT(value(50.0, 80.0), weightless);
}

TEST(LatticeOptimiser, MinimiseLowersTheEnergyAndUntangles)
{
  LatticeOptimiser optimiser = optimiserOfBall(8, 1);
  HexMesh          mesh = shaken(ballOfCells(8).lattice(4), 1.0, 3);
  VectorXd         x = vectorOf(mesh);
  EXPECT_GT(certifyCells(mesh).notPositive, 0u);
  optimiser.attraction().freeze(x);
  VectorXd     gradient(x.size());
  const double before = optimiser.energy(x, stage, gradient);
  const auto   result = optimiser.minimise(x, stage, 1e-5, {});
  EXPECT_LT(result.value, before);
  EXPECT_EQ(result.value, optimiser.energy(x, stage, gradient));
  mesh.nodes = latticePositions(optimiser.layout(), x, Vector3::Zero(), 1.0);
  EXPECT_EQ(certifyCells(mesh).notPositive, 0u);
}

TEST(LatticeOptimiser, TargetVolumesAreThoseOfTheCellsInTheirOrder)
{
  // Without surface and shape to speak of, cells take the volumes they are told to.
  const int           n = 4;
  LatticeOptimiser    optimiser = optimiserOfBall(n, 1);
  std::vector<double> targets;
  for (int cell = 0; cell < 27; ++cell)
  {
    targets.push_back(1.0 + 0.02 * (cell - 13));
  }
  optimiser.setTargetVolumes(targets);
  VectorXd x = vectorOf(unitCells(n, 0.0, 1));
  optimiser.attraction().freeze(x);
  (void)optimiser.minimise(x, { 0.05, 1e5, 0.0, 200, 1 }, 1e-12, {});
  const HexMesh             mesh{ n, latticePositions(optimiser.layout(), x, Vector3::Zero(), 1.0) };
  const std::vector<double> volumes = cellVolumes(mesh);
  for (std::size_t cell = 0; cell < targets.size(); ++cell)
  {
    EXPECT_NEAR(volumes[cell], targets[cell], 1e-3) << cell;
  }
}

TEST(LatticeOptimiser, LevelIsWhereTheVolumeFits)
{
  LatticeOptimiser optimiser = optimiserOfBall(10, 1);
  HexMesh          mesh = ballOfCells(10).lattice(5);
  VectorXd         x = vectorOf(mesh);
  optimiser.attraction().freeze(x);
  optimiser.updateLevel(x);
  const double level = optimiser.attraction().level();
  EXPECT_GT(level, 0.0);  // chords lie inside the sphere
  EXPECT_LT(level, 0.05); // of a cell's edge
  const double enclosed = measureEquality(mesh, VolumeMeasure()).total;
  EXPECT_NEAR(level, optimiser.attraction().levelOfVolume(x, 729.0, enclosed), 1e-12);
}

TEST(LatticeOptimiser, MinimisationIsTheSameForAnyNumberOfThreads)
{
  const VectorXd start = vectorOf(shaken(ballOfCells(16).lattice(8), 0.6, 4));
  VectorXd       results[2];
  for (const unsigned int threads : { 1u, 3u })
  {
    LatticeOptimiser optimiser = optimiserOfBall(16, threads);
    VectorXd &       x = results[threads / 2];
    x = start;
    optimiser.attraction().freeze(x);
    optimiser.updateLevel(x);
    (void)optimiser.minimise(x, { 0.05, 50.0, 80.0, 10, 1 }, 1e-5, {});
  }
  EXPECT_TRUE(results[0] == results[1]);
}
