// Tolerances: counts are exact; cube and torus identities to round-off (1e-12 relative); the sphere's volume deficit is
// a second-order quantity, checked by its fitted order.
#include "moserhex/Analytic/SurfaceShapes.h"

#include "moserhex/Analytic/ObservedOrder.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Geometry/TriangleTopology.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace moserhex;
using namespace moserhex::analytic;

TEST(Icosphere, HasTheCountsOfAQuadrisectedIcosahedron)
{
  const TriangleMesh mesh = icosphere(3);
  EXPECT_EQ(mesh.vertices.size(), 642u);
  EXPECT_EQ(mesh.triangles.size(), 1280u);
}

TEST(Icosphere, IsAnOutwardSphere)
{
  const TriangleMesh mesh = icosphere(2, 3.0);
  EXPECT_TRUE(summarizeTopology(mesh).isSphere());
  EXPECT_GT(enclosedVolume(mesh), 0.0);
  for (const Vector3 & vertex : mesh.vertices)
  {
    EXPECT_NEAR(vertex.norm(), 3.0, 1e-14);
  }
}

TEST(Icosphere, VolumeConvergesWithOrderTwo)
{
  std::vector<double> h;
  std::vector<double> error;
  for (int levels = 2; levels <= 5; ++levels)
  {
    h.push_back(std::pow(0.5, levels));
    error.push_back(relativeError(enclosedVolume(icosphere(levels)), 4.0 / 3.0 * pi));
  }
  EXPECT_NEAR(observedOrder(h, error), 2.0, 0.1);
}

TEST(EllipsoidSurface, VolumeScalesWithTheSemiAxes)
{
  const double unit = enclosedVolume(icosphere(3));
  EXPECT_NEAR(enclosedVolume(ellipsoidSurface(3, Vector3(3, 1, 2))) / (6.0 * unit), 1.0, 1e-12);
}

TEST(CubeSurface, IsAnOutwardSphereOfExactVolumeAndArea)
{
  const TriangleMesh mesh = cubeSurface(4, 2.0);
  EXPECT_TRUE(summarizeTopology(mesh).isSphere());
  EXPECT_EQ(mesh.triangles.size(), 6u * 2u * 16u);
  EXPECT_NEAR(enclosedVolume(mesh), 8.0, 1e-12);
  EXPECT_NEAR(surfaceArea(mesh), 24.0, 1e-12);
}

TEST(TorusSurface, HasEulerCharacteristicZeroAndPositiveVolume)
{
  const TriangleMesh           mesh = torusSurface(24, 12);
  const SurfaceTopologySummary summary = summarizeTopology(mesh);
  EXPECT_EQ(summary.eulerCharacteristic, 0);
  EXPECT_EQ(summary.boundaryEdges, 0u);
  EXPECT_EQ(summary.nonManifoldEdges, 0u);
  EXPECT_GT(enclosedVolume(mesh), 0.0);
}

TEST(Renumbered, KeepsVolumeAndChangesTheOrder)
{
  const TriangleMesh mesh = ellipsoidSurface(2, Vector3(3, 1, 1));
  const TriangleMesh other = renumbered(mesh, 7);
  EXPECT_TRUE(summarizeTopology(other).isSphere());
  EXPECT_NEAR(enclosedVolume(other) / enclosedVolume(mesh), 1.0, 1e-12);
  EXPECT_NE(other.triangles, mesh.triangles);
}

TEST(SurfaceShapes, BadCountsAreRefused)
{
  EXPECT_THROW((void)icosphere(-1), InvalidInput);
  EXPECT_THROW((void)cubeSurface(0), InvalidInput);
  EXPECT_THROW((void)torusSurface(2, 12), InvalidInput);
}
