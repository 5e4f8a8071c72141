// Distances with a closed form: round-off (1e-12). Taylor remainder: slope fitted, within 0.1 of 2. Threads: bit for
// bit.
#include "SurfaceCoverage.h"
#include "SurfacePoints.h"

#include "TestEnergies.h"
#include "TestSolids.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace moserhex;
using namespace moserhex::testing;

namespace
{
using Eigen::VectorXd;

const BentEllipsoid organ{ Vector3(4.0, 2.0, 2.5), 0.05 };

/** The organ's lattice, shrunk: the surface lies beyond the tips. */
HexMesh
drained(int shells, double scale)
{
  HexMesh mesh = organ.lattice(shells);
  for (Vector3 & node : mesh.nodes)
  {
    node *= scale;
  }
  return mesh;
}

Positions
pointsOfOrgan()
{
  return surfacePoints(organ.lattice(2).nodes, organ.distance(), organ.volume(), 1500, 1);
}

LatticeEnergy
energyOf(const SurfaceCoverage & coverage, double weight)
{
  return
    [&coverage, weight](const VectorXd & x, VectorXd & gradient) { return coverage.addEnergy(x, weight, gradient); };
}
} // namespace

TEST(SurfaceCoverage, DistanceIsThatOfTheFarthestPointToTheBoundary)
{
  // The cube [0,3]^3: beyond a face, an edge and a corner.
  const VectorXd x = vectorOf(unitCells(4, 0.0, 1));
  const auto     distance = [&x](const Positions & points) {
    SurfaceCoverage coverage(LatticeLayout(4), points, 1);
    coverage.associate(x);
    return coverage.largestDistance();
  };
  EXPECT_NEAR(distance({ Vector3(1.2, 1.7, 3.7) }), 0.7, 1e-12);
  EXPECT_NEAR(distance({ Vector3(3.3, -0.4, 1.1) }), 0.5, 1e-12);
  EXPECT_NEAR(distance({ Vector3(-1.0, -2.0, 5.0) }), 3.0, 1e-12);
  EXPECT_NEAR(distance({ Vector3(1.5, 1.5, 1.5), Vector3(0.1, 1.5, 1.5) }), 1.5, 1e-12); // from inside, too
  EXPECT_NEAR(distance({ Vector3(0.0, 1.2, 1.7), Vector3(3.0, 3.0, 3.0) }), 0.0, 1e-12);
  EXPECT_EQ(distance({}), 0.0);
}

TEST(SurfaceCoverage, LatticeThatCoversTheSurfaceIsFree)
{
  const HexMesh   mesh = organ.lattice(4);
  SurfaceCoverage coverage(LatticeLayout(8), pointsOfOrgan(), 1);
  coverage.associate(vectorOf(mesh));
  EXPECT_FALSE(coverage.isInDoubt());
  EXPECT_EQ(valueAt(energyOf(coverage, 1.0), vectorOf(mesh)), 0.0);
  EXPECT_EQ(gradientAt(energyOf(coverage, 1.0), vectorOf(mesh)), VectorXd::Zero(LatticeLayout(8).size()));
}

TEST(SurfaceCoverage, SpringsPullBeyondHalfACell)
{
  // One point above the middle of a quadrilateral of [0,3]^3, which has its centre there.
  const VectorXd x = vectorOf(unitCells(4, 0.0, 1));
  for (const double height : { 0.4, 0.5, 0.8, 1.5 })
  {
    SurfaceCoverage coverage(LatticeLayout(4), { Vector3(1.5, 1.5, 3.0 + height) }, 1);
    coverage.associate(x);
    EXPECT_TRUE(coverage.isInDoubt());
    const double excess = std::max(0.0, height - 0.5);
    EXPECT_NEAR(valueAt(energyOf(coverage, 6.0), x), 3.0 * excess * excess, 1e-12) << height;
  }
}

TEST(SurfaceCoverage, GradientHasTaylorRemainderOfSecondOrder)
{
  const HexMesh   mesh = drained(3, 0.6);
  SurfaceCoverage coverage(LatticeLayout(6), pointsOfOrgan(), 1);
  coverage.associate(vectorOf(mesh));
  ASSERT_TRUE(coverage.isInDoubt());
  EXPECT_GT(valueAt(energyOf(coverage, 80.0), vectorOf(mesh)), 0.0);
  EXPECT_NEAR(taylorOrder(energyOf(coverage, 80.0), mesh, 1e-2), 2.0, 0.1);
}

namespace
{
/** Of weight 2, of the points below. */
double
energyOfStiffness(double lowest, double middle, double highest)
{
  return lowest * 0.3 * 0.3 + middle * 1.0 + highest * 2.0 * 2.0;
}

/** Points 0.8, 1.5 and 2.5 above the middles of three quadrilaterals of the cube [0,3]^3, x. */
struct ThreePointsAboveACube
{
  ThreePointsAboveACube()
  {
    coverage.associate(x);
  }

  [[nodiscard]] double
  energy() const
  {
    return valueAt(energyOf(coverage, 2.0), x);
  }

  VectorXd        x{ vectorOf(unitCells(4, 0.0, 1)) };
  SurfaceCoverage coverage{ LatticeLayout(4),
                            { Vector3(0.5, 0.5, 3.8), Vector3(1.5, 1.5, 4.5), Vector3(2.5, 2.5, 5.5) },
                            1 };
};
} // namespace

TEST(SurfaceCoverage, OnlySpringsOfPointsBeyondTheToleranceAreStrengthened)
{
  ThreePointsAboveACube three;
  EXPECT_NEAR(three.energy(), energyOfStiffness(1.0, 1.0, 1.0), 1e-12);
  EXPECT_EQ(three.coverage.strengthen(2.6, 4.0), 0u);
  EXPECT_NEAR(three.energy(), energyOfStiffness(1.0, 1.0, 1.0), 1e-12);
  EXPECT_EQ(three.coverage.strengthen(2.0, 4.0), 1u);
  EXPECT_NEAR(three.energy(), energyOfStiffness(1.0, 1.0, 4.0), 1e-12);
  EXPECT_EQ(three.coverage.strengthen(1.0, 3.0), 2u);
  EXPECT_NEAR(three.energy(), energyOfStiffness(1.0, 3.0, 12.0), 1e-12);
}

TEST(SurfaceCoverage, StrengthenedSpringsStayStiffWhenAssociatedAgain)
{
  ThreePointsAboveACube three;
  EXPECT_EQ(three.coverage.strengthen(1.0, 4.0), 2u);
  three.coverage.associate(2.0 * three.x);
  three.coverage.associate(three.x);
  EXPECT_NEAR(three.energy(), energyOfStiffness(1.0, 4.0, 4.0), 1e-12);
}

TEST(SurfaceCoverage, GradientOfStrengthenedSpringsHasTaylorRemainderOfSecondOrder)
{
  const HexMesh   mesh = drained(3, 0.6);
  SurfaceCoverage coverage(LatticeLayout(6), pointsOfOrgan(), 1);
  coverage.associate(vectorOf(mesh));
  const double before = valueAt(energyOf(coverage, 80.0), vectorOf(mesh));
  EXPECT_GT(coverage.strengthen(0.8 * coverage.largestDistance(), 4.0), 0u);
  EXPECT_GT(valueAt(energyOf(coverage, 80.0), vectorOf(mesh)), 1.01 * before); // else nothing is tested
  EXPECT_NEAR(taylorOrder(energyOf(coverage, 80.0), mesh, 1e-2), 2.0, 0.1);
}

TEST(SurfaceCoverage, ManyPointsPullTogetherAsTwoThousandDo)
{
  const VectorXd x = vectorOf(unitCells(4, 0.0, 1));
  const auto     energyOfCopies = [&x](std::size_t count) {
    SurfaceCoverage coverage(LatticeLayout(4), Positions(count, Vector3(1.5, 1.5, 4.0)), 1);
    coverage.associate(x);
    return valueAt(energyOf(coverage, 2.0), x);
  };
  EXPECT_NEAR(energyOfCopies(2000), 2000.0 * 0.25, 1e-8);
  EXPECT_NEAR(energyOfCopies(5000), 2000.0 * 0.25, 1e-8);
  EXPECT_NEAR(energyOfCopies(500), 500.0 * 0.25, 1e-8);
}

TEST(SurfaceCoverage, IsTheSameForAnyNumberOfThreads)
{
  const VectorXd  x = vectorOf(drained(4, 0.7));
  const Positions points = pointsOfOrgan();
  SurfaceCoverage one(LatticeLayout(8), points, 1);
  SurfaceCoverage three(LatticeLayout(8), points, 3);
  one.associate(x);
  three.associate(x);
  EXPECT_EQ(one.largestDistance(), three.largestDistance());
  EXPECT_EQ(valueAt(energyOf(one, 1.0), x), valueAt(energyOf(three, 1.0), x));
  EXPECT_TRUE(gradientAt(energyOf(one, 1.0), x) == gradientAt(energyOf(three, 1.0), x));
}
