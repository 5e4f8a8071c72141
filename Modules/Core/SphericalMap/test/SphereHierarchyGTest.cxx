// No tolerance: the contract is combinatorial, no flipped triangle and solid angles that sum to 4 pi.
#include "../src/HalfEdgeCollapse.h"

#include "moserhex/Analytic/SurfaceShapes.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Random.h"
#include "moserhex/Geometry/TriangleTopology.h"
#include "moserhex/SphericalMap/SphereHierarchy.h"
#include "moserhex/SphericalMap/SphereMapQuality.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace moserhex;

namespace
{

void
expectBijective(const TriangleMesh & surface, const std::string & what)
{
  const auto             result = sphereMapByHierarchy(surface);
  const SphereMapQuality quality = sphereMapQuality(surface, result.positions);
  EXPECT_TRUE(isBijective(quality)) << what << ": " << quality.flippedTriangles << " flipped, sum "
                                    << quality.solidAngleSum;
}

TriangleMesh
bipyramid(int valence)
{
  TriangleMesh mesh;
  for (int i = 0; i < valence; ++i)
  {
    const double angle = 6.283185307179586 * i / valence;
    mesh.vertices.push_back({ std::cos(angle), std::sin(angle), 0.0 });
  }
  mesh.vertices.push_back({ 0, 0, 1 });
  mesh.vertices.push_back({ 0, 0, -1 });
  for (int i = 0; i < valence; ++i)
  {
    mesh.triangles.push_back({ i, (i + 1) % valence, valence });
    mesh.triangles.push_back({ (i + 1) % valence, i, valence + 1 });
  }
  return mesh;
}

} // namespace

TEST(SphereHierarchy, CollapseEndsAtATetrahedron)
{
  const TriangleMesh     surface = analytic::icosphere(3);
  const CollapseSequence sequence = collapseToTetrahedron(surface, triangleAreas(surface));
  EXPECT_EQ(sequence.last.size(), 4u);
  EXPECT_EQ(sequence.vertices.size(), surface.vertices.size() - 4);
  TriangleMesh last;
  last.vertices = surface.vertices;
  last.triangles = sequence.last;
  EXPECT_TRUE(summarizeTopology(last).isSphere());
}

TEST(SphereHierarchy, EveryLevelIsASphereWithTheWholeArea)
{
  const TriangleMesh surface = analytic::ellipsoidSurface(3, Vector3(5, 1, 1));
  for (const CollapseLevel & level : collapseToTetrahedron(surface, triangleAreas(surface)).levels)
  {
    TriangleMesh mesh;
    mesh.vertices = surface.vertices;
    mesh.triangles = level.triangles;
    EXPECT_TRUE(summarizeTopology(mesh).isSphere());
    double area = 0.0;
    for (const double a : level.areas)
    {
      area += a;
    }
    EXPECT_NEAR(area, surfaceArea(surface), 1e-10 * surfaceArea(surface));
  }
}

TEST(SphereHierarchy, GeometryMayBeNoise)
{
  TriangleMesh surface = analytic::icosphere(3);
  Random       random(7);
  for (Vector3 & p : surface.vertices)
  {
    p = Vector3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
  }
  expectBijective(surface, "random positions, seed 7");
}

TEST(SphereHierarchy, GeometryMayBeFlatOrLong)
{
  TriangleMesh surface = analytic::icosphere(3);
  for (Vector3 & p : surface.vertices)
  {
    p[0] = 0.0;
  }
  expectBijective(surface, "flat");
  expectBijective(analytic::ellipsoidSurface(3, Vector3(30, 1, 1)), "long");
  expectBijective(analytic::cubeSurface(12), "cube");
}

TEST(SphereHierarchy, ConnectivityMayBeExtreme)
{
  expectBijective(bipyramid(3), "valence 3");
  expectBijective(bipyramid(5), "valence 5");
  expectBijective(bipyramid(300), "valence 300");
  TriangleMesh tetrahedron;
  tetrahedron.vertices = { { 1, 1, 1 }, { 1, -1, -1 }, { -1, 1, -1 }, { -1, -1, 1 } };
  tetrahedron.triangles = { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 1 }, { 1, 3, 2 } };
  expectBijective(tetrahedron, "tetrahedron");
}

TEST(SphereHierarchy, TwoRunsAreEqualBitForBit)
{
  const TriangleMesh surface = analytic::ellipsoidSurface(2, Vector3(3, 2, 1));
  EXPECT_EQ(sphereMapByHierarchy(surface).positions, sphereMapByHierarchy(surface).positions);
}

TEST(SphereHierarchy, TorusIsRefused)
{
  EXPECT_THROW((void)sphereMapByHierarchy(analytic::torusSurface(12, 8)), InvalidInput);
}

TEST(SphereHierarchy, CancellationIsObeyed)
{
  EXPECT_THROW((void)sphereMapByHierarchy(analytic::icosphere(2), {}, [](double) { return false; }), Cancelled);
}
