// Equal volumes to 1e-9 (variance 1e-18), as the header promises.
#include "moserhex/ShapeStatistics/EqualVolumeShape.h"

#include "BoundaryDistance.h"
#include "TestShapes.h"
#include "moserhex/Analytic/Refusals.h"
#include "moserhex/Geometry/SelfIntersection.h"

#include <gtest/gtest.h>

#include <numeric>

using namespace moserhex;
using namespace moserhex::testing;

namespace
{

const EqualVolumeOptions oneThread{ EqualVolumeWay::Free, 1 };

} // namespace

TEST(BoundaryDistance, OfACubeIsTheDistanceToItsFaces)
{
  const SignedDistance phi = boundaryDistance(analytic::cubeLattice(4, 2.0)); // [0,6]^3
  Vector3              gradient;
  EXPECT_NEAR(phi(Vector3(3.0, 3.0, 5.5), gradient), -0.5, 1e-12);
  EXPECT_NEAR(phi(Vector3(3.1, 3.2, 7.5), gradient), 1.5, 1e-12);
  EXPECT_LT((gradient - Vector3(0, 0, 1)).norm(), 0.5);
  EXPECT_NEAR(phi(Vector3(6.0, 2.0, 3.0), gradient), 0.0, 1e-12);
}

TEST(BoundaryDistance, TheSideIsRightAroundAThinSpike)
{
  HexMesh mesh = analytic::cubeLattice(4, 2.0);
  mesh.nodes[mesh.nodeNumber(3, 3, 3)] = Vector3(40.0, 9.0, 7.0);
  const TriangleMesh   boundary = boundaryTriangles(mesh);
  const SignedDistance phi = boundaryDistance(mesh);
  Random               random(71);
  Vector3              gradient;
  for (int i = 0; i < 2000; ++i)
  {
    const Vector3 p(random.uniform(-20.0, 60.0), random.uniform(-20.0, 30.0), random.uniform(-20.0, 30.0));
    EXPECT_EQ(phi(p, gradient) < 0.0, windingNumber(boundary, p) > 0.5) << p.transpose();
  }
}

TEST(EqualVolumeShape, BecomesAnEqualVolumeMeshOfItsOwnOutline)
{
  const HexMesh          mean = softCube(8);
  const EqualVolumeShape result = equalVolumeShape(mean, oneThread);
  EXPECT_TRUE(result.exact);
  EXPECT_TRUE(result.shortcomings.empty());
  EXPECT_GT(result.varianceBefore, 1e-4);
  EXPECT_LT(result.varianceAfter, 1e-18);
  EXPECT_EQ(result.certified.positive, 343u);
  const auto volumes = cellVolumes(mean);
  EXPECT_NEAR(result.volume, std::accumulate(volumes.begin(), volumes.end(), 0.0), 1e-9 * result.volume);
  EXPECT_GT(result.largestMove, result.meanMove);
  EXPECT_LT(result.largestMove, 6.0); // an edge of a cell
}

TEST(EqualVolumeShape, AnEqualVolumeMeshStaysWhereItIs)
{
  const EqualVolumeShape result = equalVolumeShape(analytic::cubeLattice(5, 2.0), oneThread);
  EXPECT_TRUE(result.exact);
  EXPECT_EQ(result.way, EqualVolumeWay::Projection);
  EXPECT_EQ(result.largestMove, 0.0);
}

TEST(EqualVolumeShape, CellsTurnedOverAreReworked)
{
  HexMesh mean = softCube(6);
  std::swap(mean.nodes[mean.nodeNumber(1, 2, 2)], mean.nodes[mean.nodeNumber(4, 3, 3)]);
  const EqualVolumeShape result = equalVolumeShape(mean, oneThread);
  EXPECT_TRUE(result.exact) << (result.exact ? "" : result.shortcomings.front());
  EXPECT_NE(result.way, EqualVolumeWay::Projection);
}

TEST(EqualVolumeShape, WhereNoWayIsExactTheNearestIsKept)
{
  // A dent to the middle of one side. Free is tried last, and comes less near than tied.
  HexMesh mean = softCube(6);
  mean.nodes[mean.nodeNumber(5, 2, 2)] = mean.nodes[mean.nodeNumber(2, 2, 2)];
  const EqualVolumeShape tied = equalVolumeShape(mean, { EqualVolumeWay::Tied, 1 });
  const EqualVolumeShape all = equalVolumeShape(mean, oneThread);
  EXPECT_FALSE(all.exact);
  EXPECT_EQ(all.way, EqualVolumeWay::Tied);
  EXPECT_EQ(all.certified.positive, all.mesh.cellCount());
  EXPECT_EQ(all.boundaryDistance, tied.boundaryDistance);
  ASSERT_EQ(all.shortcomings.size(), 1u);
  EXPECT_NE(all.shortcomings[0].find("the boundary is "), std::string::npos);
  EXPECT_GT(all.largestMove, 0.0);
}

TEST(EqualVolumeShape, TheSameForAnyNumberOfThreads)
{
  const EqualVolumeShape one = equalVolumeShape(softCube(6), oneThread);
  const EqualVolumeShape three = equalVolumeShape(softCube(6), { EqualVolumeWay::Free, 3 });
  EXPECT_TRUE(std::equal(one.mesh.nodes.begin(), one.mesh.nodes.end(), three.mesh.nodes.begin()));
}

TEST(EqualVolumeShape, TooCoarseAMeshIsRefused)
{
  EXPECT_EQ(analytic::messageOf([] { (void)equalVolumeShape(analytic::cubeLattice(2)); }),
            "equal volumes: 2 nodes a side, need at least 3");
}
