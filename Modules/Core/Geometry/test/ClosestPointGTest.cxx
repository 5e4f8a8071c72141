// Round-off class (1e-12): a point of a triangle is known in closed form in each Voronoi region; the tree must give
// exactly what a scan over all triangles gives.
#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Random.h"
#include "moserhex/Geometry/ClosestPoint.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace moserhex;

namespace
{

const Vector3 a(0, 0, 0);
const Vector3 b(2, 0, 0);
const Vector3 c(0, 2, 0);

Vector3
randomPoint(Random & random, double extent)
{
  const double x = random.uniform(-extent, extent);
  const double y = random.uniform(-extent, extent);
  const double z = random.uniform(-extent, extent);
  return { x, y, z };
}

/** Triangles of size about 1 scattered in a box of side 20. */
TriangleMesh
triangleSoup(int count)
{
  Random       random(7);
  TriangleMesh mesh;
  for (int t = 0; t < count; ++t)
  {
    const Vector3 centre = randomPoint(random, 10);
    for (int k = 0; k < 3; ++k)
    {
      mesh.vertices.push_back(centre + randomPoint(random, 1));
    }
    mesh.triangles.push_back({ 3 * t, 3 * t + 1, 3 * t + 2 });
  }
  return mesh;
}

} // namespace

TEST(ClosestPointOnTriangle, FootOfThePerpendicularWhenItLiesInside)
{
  const ClosestPointOnTriangle r = closestPointOnTriangle({ 0.5, 0.25, 3 }, a, b, c);
  EXPECT_TRUE(r.point.isApprox(Vector3(0.5, 0.25, 0), 1e-12));
  EXPECT_NEAR(r.squaredDistance, 9, 1e-12);
  EXPECT_TRUE(r.barycentric.isApprox(Vector3(0.625, 0.25, 0.125), 1e-12));
}

TEST(ClosestPointOnTriangle, NearestSideOrCornerWhenTheFootLiesOutside)
{
  EXPECT_TRUE(closestPointOnTriangle({ 2, 2, 1 }, a, b, c).point.isApprox(Vector3(1, 1, 0), 1e-12));
  EXPECT_TRUE(closestPointOnTriangle({ 1, -1, 0 }, a, b, c).point.isApprox(Vector3(1, 0, 0), 1e-12));
  EXPECT_TRUE(closestPointOnTriangle({ 5, -1, 0 }, a, b, c).point.isApprox(b, 1e-12));
  EXPECT_LT(closestPointOnTriangle({ -1, -1, 0 }, a, b, c).point.norm(), 1e-12);
}

TEST(ClosestPointOnTriangle, PointsOnCornersSidesAndBesideThemHaveTheirOwnDistance)
{
  for (const double offset : { 0.0, 1e-12, -1e-12 })
  {
    EXPECT_NEAR(closestPointOnTriangle(b + Vector3(offset, 0, 0), a, b, c).squaredDistance, 0, 1e-23);
    EXPECT_NEAR(closestPointOnTriangle({ 1, offset, 0 }, a, b, c).squaredDistance, 0, 1e-23);
    EXPECT_NEAR(closestPointOnTriangle({ 0.5, 0.5, offset }, a, b, c).squaredDistance, 0, 1e-23);
  }
}

TEST(ClosestPointOnTriangle, DegenerateTrianglesAreSegmentsAndPoints)
{
  EXPECT_NEAR(closestPointOnTriangle({ 1, 1, 0 }, a, b, 0.5 * b).squaredDistance, 1, 1e-12);
  EXPECT_NEAR(closestPointOnTriangle({ 3, 4, 0 }, a, a, a).squaredDistance, 25, 1e-12);
}

TEST(ClosestPointOnTriangle, BarycentricWeightsReproduceThePoint)
{
  Random random(3);
  for (int i = 0; i < 200; ++i)
  {
    const Vector3                p = randomPoint(random, 4);
    const ClosestPointOnTriangle r = closestPointOnTriangle(p, a, b, c);
    const Vector3                q = r.barycentric[0] * a + r.barycentric[1] * b + r.barycentric[2] * c;
    EXPECT_LT((q - r.point).norm(), 1e-12);
    EXPECT_NEAR(r.barycentric.sum(), 1, 1e-12);
    EXPECT_GE(r.barycentric.minCoeff(), 0);
    EXPECT_NEAR((p - r.point).squaredNorm(), r.squaredDistance, 1e-12);
  }
}

TEST(ClosestPointSearch, FindsWhatAScanOverAllTrianglesFinds)
{
  const TriangleMesh       soup = triangleSoup(500);
  const ClosestPointSearch search(soup);
  Random                   random(11);
  for (int i = 0; i < 500; ++i)
  {
    const Vector3 p = randomPoint(random, 15);
    double        nearest = INFINITY;
    int           triangle = -1;
    for (int t = 0; t < 500; ++t)
    {
      const double d =
        closestPointOnTriangle(p, soup.vertices[3 * t], soup.vertices[3 * t + 1], soup.vertices[3 * t + 2])
          .squaredDistance;
      if (d < nearest)
      {
        nearest = d;
        triangle = t;
      }
    }
    const ClosestPointOnSurface found = search.closest(p);
    EXPECT_EQ(found.squaredDistance, nearest) << "point " << i << " of seed 11";
    EXPECT_EQ(found.triangle, triangle);
    const ClosestPointOnSurface guessed = search.closest(p, i); // mostly far away
    EXPECT_EQ(guessed.squaredDistance, nearest) << "guess " << i;
    EXPECT_EQ(guessed.triangle, triangle);
  }
}

TEST(ClosestPointSearch, TheSmallestNumberWinsAmongEqualTriangles)
{
  TriangleMesh mesh;
  mesh.vertices = { a, b, c };
  mesh.triangles.assign(40, { 0, 1, 2 });
  EXPECT_EQ(ClosestPointSearch(mesh).closest({ 0.3, 0.3, 1 }).triangle, 0);
  EXPECT_EQ(ClosestPointSearch(mesh).closest({ 0.3, 0.3, 1 }, 17).triangle, 0);
}

TEST(ClosestPointSearch, EmptySurfaceIsRefused)
{
  EXPECT_THROW(ClosestPointSearch{ TriangleMesh{} }, InvalidInput);
}

TEST(DistanceSummary, HoldsSmallestMeanAndLargest)
{
  TriangleMesh mesh;
  mesh.vertices = { a, b, c };
  mesh.triangles = { { 0, 1, 2 } };
  const DistanceSummary s =
    summarizeDistances({ { 0.5, 0.5, 1 }, { 0.5, 0.5, 2 }, { 0.5, 0.5, -6 } }, ClosestPointSearch(mesh));
  EXPECT_NEAR(s.smallest, 1, 1e-12);
  EXPECT_NEAR(s.mean, 3, 1e-12);
  EXPECT_NEAR(s.largest, 6, 1e-12);
  EXPECT_EQ(summarizeDistances({}, ClosestPointSearch(mesh)).largest, 0);
}
