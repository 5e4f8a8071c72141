// Boxes to round-off; on balls order 2 within 0.15.
#include "moserhex/Deformation/SurfaceMotion.h"

#include "TestLattices.h"
#include "moserhex/Analytic/ObservedOrder.h"
#include "moserhex/Analytic/Refusals.h"
#include "moserhex/Deformation/LatticeAlignment.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>

using namespace moserhex;

namespace
{

HexMesh
scaledBy(const HexMesh & mesh, double scale)
{
  return mapped(mesh, [scale](const Vector3 & x) { return Vector3(scale * x); });
}

/** So that its nodes lie over no nodes of the other. */
HexMesh
turned(const HexMesh & mesh)
{
  const Matrix3 turn = Eigen::AngleAxisd(0.3, Vector3(1, 2, -1).normalized()).toRotationMatrix();
  return mapped(mesh, [&turn](const Vector3 & x) { return Vector3(turn * x); });
}

} // namespace

TEST(SurfaceMotion, TheSurfaceIsClosedAndOutward)
{
  EXPECT_NEAR(enclosedVolume(latticeSurface(boxLattice(5, { 8, 6, 4 }))), 8.0 * 6.0 * 4.0, 1e-12 * 192.0);
  EXPECT_NEAR(surfaceArea(latticeSurface(boxLattice(5, { 8, 6, 4 }))), 2.0 * (48.0 + 32.0 + 24.0), 1e-12 * 208.0);
}

TEST(SurfaceMotion, AnInflatedBallMovesOutwardsEverywhere)
{
  const HexMesh       ball = ballLattice(20, 20.0);
  const SurfaceMotion motion = surfaceMotion(ball, scaledBy(ball, 1.1));
  for (std::size_t b = 0; b < motion.nodes.size(); ++b)
  {
    EXPECT_NEAR(motion.normalMotion[b], 2.0, 1e-4);
    EXPECT_NEAR(motion.signedDistance[b], 2.0, 1e-12);
    EXPECT_NEAR(motion.baselineSignedDistance[b], 2.0, 0.1); // to facets of the larger ball
  }
  for (const double ratio : motion.areaRatio)
  {
    EXPECT_NEAR(ratio, 1.21, 1e-12);
  }
}

TEST(SurfaceMotion, NormalsHaveOrderTwoAwayFromTheCubesEdgesAndDistancesEverywhere)
{
  std::vector<double> sizes;
  std::vector<double> normalErrors;
  std::vector<double> distanceErrors;
  for (const int n : { 9, 17, 33, 65 })
  {
    const HexMesh       ball = ballLattice(n, 20.0);
    const SurfaceMotion motion = surfaceMotion(ball, scaledBy(turned(ball), 1.1));
    double              normalError = 0.0;
    double              distanceError = 0.0;
    for (std::size_t b = 0; b < motion.nodes.size(); ++b)
    {
      const Vector3 & X = ball.nodes[motion.nodes[b]];
      const bool      isOnEdge = (X.cwiseAbs().array() > X.cwiseAbs().maxCoeff() - 1e-9).count() > 1;
      normalError = std::max(normalError, isOnEdge ? 0.0 : (motion.normals[b] - X / 20.0).norm());
      distanceError = std::max(distanceError, std::abs(motion.signedDistance[b] - 2.0));
    }
    sizes.push_back(1.0 / (n - 1));
    normalErrors.push_back(normalError);
    distanceErrors.push_back(distanceError);
  }
  EXPECT_NEAR(analytic::observedOrder(sizes, normalErrors), 2.0, 0.15);
  EXPECT_NEAR(analytic::observedOrder(sizes, distanceErrors), 2.0, 0.15);
}

TEST(SurfaceMotion, ASmallerBallLiesInside)
{
  const HexMesh       ball = ballLattice(12, 20.0);
  const SurfaceMotion motion = surfaceMotion(ball, scaledBy(ball, 0.9));
  EXPECT_LT(*std::max_element(motion.normalMotion.begin(), motion.normalMotion.end()), -1.8);
  EXPECT_LT(*std::max_element(motion.signedDistance.begin(), motion.signedDistance.end()), -1.7);
  EXPECT_LT(*std::max_element(motion.baselineSignedDistance.begin(), motion.baselineSignedDistance.end()), -1.7);
}

TEST(SurfaceMotion, NoMotionIsExactlyNone)
{
  const HexMesh       ball = ballLattice(8, 20.0);
  const SurfaceMotion motion = surfaceMotion(ball, ball);
  EXPECT_EQ(motion.normalMotion, std::vector<double>(motion.nodes.size(), 0.0));
  EXPECT_EQ(motion.signedDistance, std::vector<double>(motion.nodes.size(), 0.0));
  EXPECT_EQ(motion.baselineSignedDistance, std::vector<double>(motion.nodes.size(), 0.0));
  EXPECT_EQ(motion.areaRatio, std::vector<double>(motion.area.size(), 1.0));
}

namespace
{

/** A box of 8 mm, its middle node on top drawn out to a finger. \param length  of the finger [mm] */
HexMesh
boxWithFinger(double length)
{
  HexMesh mesh = boxLattice(9, { 8, 8, 8 });
  mesh.nodes[mesh.nodeNumber(4, 4, 8)][2] += length;
  return mesh;
}

double
largest(const std::vector<double> & values)
{
  return *std::max_element(values.begin(), values.end());
}

double
smallest(const std::vector<double> & values)
{
  return *std::min_element(values.begin(), values.end());
}

} // namespace

TEST(SurfaceMotion, AFingerThatAppearsIsSeenFromTheFollowUp)
{
  const SurfaceMotion motion = surfaceMotion(boxWithFinger(0.0), boxWithFinger(10.0));
  EXPECT_NEAR(largest(motion.signedDistance), 10.0, 1e-12);
  EXPECT_LT(largest(motion.baselineSignedDistance), 1.0); // as thick as the finger is
  EXPECT_NEAR(smallest(motion.signedDistance), 0.0, 1e-12);
}

TEST(SurfaceMotion, AFingerThatDisappearsIsSeenFromTheBaseline)
{
  const SurfaceMotion motion = surfaceMotion(boxWithFinger(10.0), boxWithFinger(0.0));
  EXPECT_NEAR(smallest(motion.baselineSignedDistance), -10.0, 1e-12);
  EXPECT_GT(smallest(motion.signedDistance), -1.0); // as thick as the finger is
  EXPECT_NEAR(largest(motion.baselineSignedDistance), 0.0, 1e-12);
}

TEST(SurfaceMotion, SlidingAlongTheSurfaceIsNoDistance)
{
  // Each square face of the cube slides within itself; edges stay.
  const HexMesh       cube = boxLattice(9, { 8, 8, 8 });
  const HexMesh       slid = mapped(cube, [](const Vector3 & x) {
    const auto slide = [](double t) { return 0.02 * t * (16.0 - t * t); };
    return Vector3(x[0] + slide(x[0]), x[1] + slide(x[1]), x[2] + slide(x[2]));
  });
  const SurfaceMotion motion = surfaceMotion(cube, slid);
  for (const double distance : motion.signedDistance)
  {
    EXPECT_NEAR(distance, 0.0, 1e-12);
  }
  EXPECT_NE(motion.areaRatio[0], 1.0);
}

TEST(SurfaceMotion, AreasInTheOrderOfTheQuadrilaterals)
{
  // A box pulled along i: areas of the faces i = 0 and i = n-1 stay.
  const HexMesh       box = boxLattice(4, { 6, 6, 6 });
  const SurfaceMotion motion =
    surfaceMotion(box, mapped(box, [](const Vector3 & x) { return Vector3(1.5 * x[0], x[1], x[2]); }));
  ASSERT_EQ(motion.areaRatio.size(), 54u);
  for (std::size_t quad = 0; quad < 54; ++quad)
  {
    EXPECT_NEAR(motion.area[quad], 4.0, 1e-12);
    EXPECT_NEAR(motion.areaRatio[quad], quad < 18 ? 1.0 : 1.5, 1e-12);
  }
}

TEST(SurfaceMotion, TheSameForAnyNumberOfThreads)
{
  const HexMesh ball = ballLattice(10, 20.0);
  const HexMesh other = mapped(ball, [](const Vector3 & x) { return Vector3(x + 0.1 * x[0] * Vector3(1, 0.5, 0)); });
  EXPECT_EQ(surfaceMotion(ball, other, 1).signedDistance, surfaceMotion(ball, other, 3).signedDistance);
}

TEST(SurfaceMotion, AQuadrilateralWithoutAreaIsRefused)
{
  const HexMesh box = boxLattice(3, { 6, 6, 6 });
  const HexMesh flat = mapped(box, [](const Vector3 & x) { return Vector3(x[0], 0.0, 0.0); });
  EXPECT_NE(
    analytic::messageOf([&] { (void)surfaceMotion(flat, box); }).find("quadrilateral 0 of the baseline has no area"),
    std::string::npos);
}
