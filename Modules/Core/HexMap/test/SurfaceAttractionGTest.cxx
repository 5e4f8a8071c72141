// Closed forms on planes and spheres: round-off (1e-12). Taylor remainders and orders: slope fitted, within 0.1 of
// theory.
#include "SurfaceAttraction.h"

#include "ShapeEnergy.h"
#include "TestEnergies.h"
#include "TestSolids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace moserhex;
using namespace moserhex::testing;

namespace
{
using Eigen::VectorXd;

/** phi = slope z. */
SignedDistance
plane(double slope)
{
  return [slope](const Vector3 & p, Vector3 & gradient) {
    gradient = Vector3(0.0, 0.0, slope);
    return slope * p.z();
  };
}

/** |p| - radius. */
SignedDistance
sphere(double radius)
{
  return [radius](const Vector3 & p, Vector3 & gradient) {
    gradient = p.normalized();
    return p.norm() - radius;
  };
}

LatticeEnergy
energyOf(const SurfaceAttraction & attraction, double weight)
{
  return [&attraction, weight](const VectorXd & x, VectorXd & gradient) {
    return attraction.addEnergy(x, weight, gradient);
  };
}

/** z of the boundary nodes and of the centres of the boundary quadrilaterals of a lattice of unit cells. */
std::vector<double>
heightsOfSprings(int n)
{
  std::vector<double> heights;
  const auto add = [&heights](int k, int count) { heights.insert(heights.end(), static_cast<std::size_t>(count), k); };
  for (int k = 0; k < n; ++k)
  {
    add(k, k == 0 || k == n - 1 ? n * n : 4 * (n - 1));
  }
  add(0, (n - 1) * (n - 1));
  add(n - 1, (n - 1) * (n - 1));
  for (int k = 0; k + 1 < n; ++k)
  {
    heights.insert(heights.end(), static_cast<std::size_t>(4 * (n - 1)), k + 0.5);
  }
  return heights;
}

double
sumOfSquares(const std::vector<double> & values, double level)
{
  double sum = 0.0;
  for (const double value : values)
  {
    sum += (value - level) * (value - level);
  }
  return sum;
}

/** What levelOfVolume asks for on a ball's lattice with its nodes on the sphere of radius 1. */
struct BallLevel
{
  double level;
  double volumeError; ///< of the boundary moved outwards by level - mean s

  explicit BallLevel(int shells)
  {
    const HexMesh       mesh = ballOfRadius(1.0).lattice(shells);
    const LatticeLayout layout(mesh.nodesPerSide);
    const VectorXd      x = vectorOf(mesh);
    SurfaceAttraction   attraction(layout, sphere(1.0), 1);
    const double        volume = ballOfRadius(1.0).volume();
    const double        enclosed = latticeVolumes(layout, x, 1).sum();
    attraction.freeze(x);
    level = attraction.levelOfVolume(x, volume, enclosed);

    // With the volume it has, the level is where the boundary is: mean s.
    const double present = attraction.levelOfVolume(x, enclosed, enclosed);
    volumeError = std::abs(enclosed * std::pow(1.0 + level - present, 3) - volume);
  }
};

} // namespace

TEST(SurfaceAttraction, EnergyIsThatOfOneSpringANodeAndOneAQuadrilateral)
{
  for (const int n : { 2, 3, 6 })
  {
    SurfaceAttraction attraction(LatticeLayout(n), plane(1.0), 1);
    const VectorXd    x = vectorOf(unitCells(n, 0.0, 1));
    attraction.freeze(x);
    attraction.setLevel(0.3);
    const double expected = 0.5 * 7.0 * sumOfSquares(heightsOfSprings(n), 0.3);
    EXPECT_NEAR(valueAt(energyOf(attraction, 7.0), x), expected, 1e-13 * expected) << n;
  }
}

TEST(SurfaceAttraction, SlopeIsDividedOutWithinItsBounds)
{
  const int      n = 4;
  const VectorXd x = vectorOf(unitCells(n, 0.0, 1));
  for (const auto & [slope, ofS] :
       { std::pair{ 0.5, 1.0 }, std::pair{ 2.0, 1.0 }, std::pair{ 0.03, 0.1 }, std::pair{ 6.0, 3.0 } })
  {
    SurfaceAttraction attraction(LatticeLayout(n), plane(slope), 1);
    attraction.freeze(x);
    const double expected = 0.5 * ofS * ofS * sumOfSquares(heightsOfSprings(n), 0.0);
    EXPECT_NEAR(valueAt(energyOf(attraction, 1.0), x), expected, 1e-13 * expected) << slope;
  }
}

TEST(SurfaceAttraction, GradientHasTaylorRemainderOfSecondOrder)
{
  const BentEllipsoid organ{ Vector3(4.0, 2.0, 2.5), 0.05 };
  HexMesh             mesh = shaken(organ.lattice(3), 0.2, 1);
  for (Vector3 & node : mesh.nodes)
  {
    node *= 1.1; // off the surface
  }
  SurfaceAttraction attraction(LatticeLayout(6), organ.distance(), 1);
  attraction.freeze(vectorOf(mesh));
  attraction.setLevel(-0.05);
  EXPECT_NEAR(taylorOrder(energyOf(attraction, 80.0), mesh, 1e-2), 2.0, 0.1);
  (void)attraction.strengthen(vectorOf(mesh), 0.3, 4.0);
  EXPECT_NEAR(taylorOrder(energyOf(attraction, 80.0), mesh, 1e-2), 2.0, 0.1);
}

TEST(SurfaceAttraction, InteriorNodesFeelNothing)
{
  const HexMesh     mesh = unitCells(6, 0.2, 2);
  SurfaceAttraction attraction(LatticeLayout(6), sphere(2.0), 1);
  attraction.freeze(vectorOf(mesh));
  const VectorXd gradient = gradientAt(energyOf(attraction, 1.0), vectorOf(mesh));
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
  {
    EXPECT_EQ(LatticeLayout(6).at(gradient, node) == Vector3::Zero(), !onBoundary(6, node)) << node;
  }
}

TEST(SurfaceAttraction, NodesAreThoseOfTheBoundaryInIncreasingOrder)
{
  const SurfaceAttraction  attraction(LatticeLayout(5), sphere(1.0), 1);
  std::vector<std::size_t> expected;
  for (std::size_t node = 0; node < 125; ++node)
  {
    if (onBoundary(5, node))
    {
      expected.push_back(node);
    }
  }
  EXPECT_EQ(attraction.nodes(), expected);
}

TEST(SurfaceAttraction, NodesMoveOntoTheLevelAlongTheNormal)
{
  const HexMesh       mesh = ballOfRadius(3.0).lattice(3);
  const LatticeLayout layout(6);
  SurfaceAttraction   attraction(layout, sphere(2.5), 1);
  attraction.setLevel(0.2);
  VectorXd       x = vectorOf(mesh);
  const VectorXd before = x;
  attraction.moveNodesToLevel(x);
  for (std::size_t node = 0; node < layout.nodes; ++node)
  {
    const Vector3 expected = onBoundary(6, node) ? Vector3(2.7 * mesh.nodes[node].normalized()) : mesh.nodes[node];
    EXPECT_LT((layout.at(x, node) - expected).norm(), 1e-12) << node;
  }
}

TEST(SurfaceAttraction, NormalsAreUnitVectorsOutwards)
{
  const HexMesh              mesh = ballOfRadius(3.0).lattice(3);
  const SurfaceAttraction    attraction(LatticeLayout(6), ballOfRadius(2.9).distance(), 1);
  const std::vector<Vector3> normals = attraction.normals(vectorOf(mesh));
  ASSERT_EQ(normals.size(), attraction.nodes().size());
  for (std::size_t b = 0; b < normals.size(); ++b)
  {
    EXPECT_LT((normals[b] - mesh.nodes[attraction.nodes()[b]].normalized()).norm(), 1e-12);
  }
}

TEST(SurfaceAttraction, LevelOfVolumeIsOfSecondOrderInTheCellSize)
{
  // Quadrilaterals with their nodes on the sphere enclose too little by O(h^2), so the level lies that far outside.
  std::vector<double> sizes;
  std::vector<double> levels;
  std::vector<double> volumeErrors;
  for (const int shells : { 4, 6, 8, 12 })
  {
    const BallLevel ball(shells);
    EXPECT_GT(ball.level, 0.0);
    sizes.push_back(1.0 / (2.0 * shells - 1.0));
    levels.push_back(ball.level);
    volumeErrors.push_back(ball.volumeError);
  }
  EXPECT_NEAR(analytic::observedOrder(sizes, levels), 2.0, 0.1);
  EXPECT_NEAR(analytic::observedOrder(sizes, volumeErrors), 4.0, 0.2); // the square of what was missing
}

TEST(SurfaceAttraction, LevelFollowsAConstantAddedToPhi)
{
  const HexMesh       mesh = ballOfRadius(3.0).lattice(4);
  const LatticeLayout layout(8);
  SurfaceAttraction   one(layout, sphere(3.0), 1);
  SurfaceAttraction   other(layout, sphere(2.5), 1);
  one.freeze(vectorOf(mesh));
  other.freeze(vectorOf(mesh));
  EXPECT_NEAR(
    other.levelOfVolume(vectorOf(mesh), 120.0, 100.0), one.levelOfVolume(vectorOf(mesh), 120.0, 100.0) + 0.5, 1e-13);
}

TEST(SurfaceAttraction, LargestDistanceIsOverNodesAndCentres)
{
  const VectorXd x = vectorOf(unitCells(4, 0.0, 1)); // [0,3]^3
  EXPECT_NEAR(SurfaceAttraction(LatticeLayout(4), plane(0.5), 1).largestDistance(x), 3.0, 1e-13);
  // The centres of a cube's faces are the nearest to its middle; three cells a side have a quadrilateral there.
  const auto fromMiddle = [](const Vector3 & p, Vector3 & gradient) {
    const Vector3 d = p - Vector3::Constant(1.5);
    gradient = d.normalized();
    return d.norm() - 1.5 * std::sqrt(3.0);
  };
  EXPECT_NEAR(SurfaceAttraction(LatticeLayout(4), fromMiddle, 1).largestDistance(x), 1.5 * std::sqrt(3.0) - 1.5, 1e-13);
}

TEST(SurfaceAttraction, LargestDistanceIsTrueWherePhiIsNoDistance)
{
  // (|d|^2 - R^2) / (2 R) has slope 1 on the sphere only; to first order the corners are 0.97 away.
  const double radius = 1.3;
  const auto   quadratic = [radius](const Vector3 & p, Vector3 & gradient) {
    const Vector3 d = p - Vector3::Constant(1.5);
    gradient = d / radius;
    return (d.squaredNorm() - radius * radius) / (2.0 * radius);
  };
  const VectorXd x = vectorOf(unitCells(4, 0.0, 1));
  EXPECT_NEAR(
    SurfaceAttraction(LatticeLayout(4), quadratic, 1).largestDistance(x), 1.5 * std::sqrt(3.0) - radius, 1e-6);
}

TEST(SurfaceAttraction, StrengthenMultipliesTheLongSpringsOnly)
{
  const int         n = 5;
  const VectorXd    x = vectorOf(unitCells(n, 0.0, 1));
  SurfaceAttraction attraction(LatticeLayout(n), plane(1.0), 1);
  attraction.freeze(x);
  std::vector<double> longOnes;
  std::vector<double> shortOnes;
  for (const double height : heightsOfSprings(n))
  {
    (height > 2.2 ? longOnes : shortOnes).push_back(height);
  }
  EXPECT_EQ(attraction.strengthen(x, 2.2, 4.0), longOnes.size());
  double expected = 0.5 * (sumOfSquares(shortOnes, 0.0) + 4.0 * sumOfSquares(longOnes, 0.0));
  EXPECT_NEAR(valueAt(energyOf(attraction, 1.0), x), expected, 1e-13 * expected);
  EXPECT_EQ(attraction.strengthen(x, 2.2, 4.0), longOnes.size());
  expected = 0.5 * (sumOfSquares(shortOnes, 0.0) + 16.0 * sumOfSquares(longOnes, 0.0));
  EXPECT_NEAR(valueAt(energyOf(attraction, 1.0), x), expected, 1e-13 * expected);
  EXPECT_EQ(attraction.strengthen(x, 4.0, 4.0), 0u);
}

TEST(SurfaceAttraction, IsTheSameForAnyNumberOfThreads)
{
  const BentEllipsoid organ{ Vector3(4.0, 2.0, 2.5), 0.05 };
  const VectorXd      x = vectorOf(organ.lattice(8));
  SurfaceAttraction   one(LatticeLayout(16), organ.distance(), 1);
  SurfaceAttraction   three(LatticeLayout(16), organ.distance(), 3);
  one.freeze(x);
  three.freeze(x);
  EXPECT_EQ(valueAt(energyOf(one, 3.0), x), valueAt(energyOf(three, 3.0), x));
  EXPECT_TRUE(gradientAt(energyOf(one, 3.0), x) == gradientAt(energyOf(three, 3.0), x));
  EXPECT_EQ(one.largestDistance(x), three.largestDistance(x));
  EXPECT_EQ(one.levelOfVolume(x, 80.0, 79.0), three.levelOfVolume(x, 80.0, 79.0));
}
