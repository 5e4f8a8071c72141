// Concentric spheres: within the distance of the triangles' middles from the sphere, 0.5 % of the radius at level 4.
// Concentric cubes: exact where the distance is constant, else the integral of the distance, by second-order sampling.
#include "moserhex/Correspondence/SurfaceDistance.h"

#include "moserhex/Analytic/SurfaceShapes.h"
#include "moserhex/Common/Errors.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace moserhex;
using namespace moserhex::analytic;

namespace
{

/** Two triangles parallel to the plane z = 0, far inside it: 8 mm^2 at height 1, 2 mm^2 at height 3. */
TriangleMesh
twoTriangles()
{
  TriangleMesh mesh;
  mesh.vertices = { Vector3(0, 0, 1), Vector3(4, 0, 1),  Vector3(0, 4, 1),
                    Vector3(9, 9, 3), Vector3(11, 9, 3), Vector3(9, 11, 3) };
  mesh.triangles = { { 0, 1, 2 }, { 3, 4, 5 } };
  return mesh;
}

TriangleMesh
plane()
{
  TriangleMesh mesh;
  mesh.vertices = { Vector3(-99, -99, 0), Vector3(99, -99, 0), Vector3(99, 99, 0), Vector3(-99, 99, 0) };
  mesh.triangles = { { 0, 1, 2 }, { 0, 2, 3 } };
  return mesh;
}

/** From the cube of side 4 to that of side 2 about the same point, the mean over a face. */
double
meanDistanceOfCubes()
{
  constexpr int steps = 2000;
  double        sum = 0.0;
  for (int i = 0; i < steps; ++i)
  {
    for (int j = 0; j < steps; ++j)
    {
      const double x = std::max(0.0, 2.0 * (i + 0.5) / steps - 1.0);
      const double y = std::max(0.0, 2.0 * (j + 0.5) / steps - 1.0);
      sum += std::sqrt(1.0 + x * x + y * y);
    }
  }
  return sum / (static_cast<double>(steps) * steps);
}

} // namespace

TEST(SurfaceDistance, OfConcentricSpheresIsTheDifferenceOfTheirRadii)
{
  const WeightedDistribution found = symmetricSurfaceDistance(icosphere(4, 20.0), icosphere(4, 21.5));
  EXPECT_NEAR(found.median, 1.5, 0.1);
  EXPECT_NEAR(found.p05, 1.5, 0.1);
  EXPECT_NEAR(found.p95, 1.5, 0.1);
  const double areas = 4.0 * pi * (20.0 * 20.0 + 21.5 * 21.5);
  EXPECT_NEAR(found.weight, areas, 0.005 * areas);
}

TEST(SurfaceDistance, CountsByArea)
{
  SurfaceDistanceOptions options;
  for (const double spacing : { 100.0, 0.7 }) // one point a triangle, and many
  {
    options.spacing = spacing;
    const WeightedDistribution found = surfaceDistance(twoTriangles(), plane(), options);
    EXPECT_NEAR(found.weight, 10.0, 1e-12);
    EXPECT_NEAR(found.mean, 1.4, 1e-12);
    EXPECT_NEAR(found.median, 1.0, 1e-12);
    EXPECT_NEAR(found.p95, 3.0, 1e-12);
  }
}

TEST(SurfaceDistance, OfCubesIsItsIntegralHoweverCoarseTheTriangles)
{
  SurfaceDistanceOptions options;
  options.spacing = 0.05;
  const TriangleMesh         small = cubeSurface(1, 2.0);
  const WeightedDistribution outwards = surfaceDistance(small, cubeSurface(3, 4.0), options);
  EXPECT_NEAR(outwards.minimum, 1.0, 1e-12);
  EXPECT_NEAR(outwards.maximum, 1.0, 1e-12);
  const double mean = meanDistanceOfCubes();
  EXPECT_NEAR(surfaceDistance(cubeSurface(1, 4.0), small, options).mean, mean, 1e-3);
  EXPECT_NEAR(surfaceDistance(cubeSurface(7, 4.0), small, options).mean, mean, 1e-3);
}

TEST(SurfaceDistance, SymmetricTakesBothDirectionsTogether)
{
  const TriangleMesh         small = cubeSurface(2, 2.0);
  const TriangleMesh         large = cubeSurface(2, 4.0);
  const WeightedDistribution inwards = surfaceDistance(large, small);
  const WeightedDistribution both = symmetricSurfaceDistance(small, large);
  EXPECT_NEAR(both.weight, 24.0 + 96.0, 1e-9);
  EXPECT_NEAR(both.mean, (24.0 * 1.0 + 96.0 * inwards.mean) / 120.0, 1e-12);
  EXPECT_EQ(both.maximum, inwards.maximum);
}

TEST(SurfaceDistance, DoesNotDependOnThreads)
{
  SurfaceDistanceOptions one;
  one.threads = 1;
  SurfaceDistanceOptions three;
  three.threads = 3;
  const TriangleMesh a = icosphere(3, 10.0);
  const TriangleMesh b = ellipsoidSurface(3, Vector3(12.0, 9.0, 8.0));
  EXPECT_EQ(symmetricSurfaceDistance(a, b, one).mean, symmetricSurfaceDistance(a, b, three).mean);
}

TEST(SurfaceDistance, RefusesASpacingOfZeroAndSurfacesWithoutArea)
{
  SurfaceDistanceOptions options;
  options.spacing = 0.0;
  EXPECT_THROW((void)surfaceDistance(plane(), plane(), options), InvalidInput);
  EXPECT_THROW((void)symmetricSurfaceDistance(plane(), plane(), options), InvalidInput);
  EXPECT_THROW((void)surfaceDistance({}, plane()), InvalidInput);
  EXPECT_THROW((void)surfaceDistance(plane(), {}), InvalidInput);
}
