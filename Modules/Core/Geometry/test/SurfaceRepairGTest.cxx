// Exact: integers, and volumes of cubes with binary fractions as coordinates.
#include "moserhex/Geometry/SurfaceRepair.h"

#include "moserhex/Analytic/SurfaceShapes.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Geometry/TriangleTopology.h"

#include <gtest/gtest.h>

using namespace moserhex;
using namespace moserhex::analytic;

namespace
{

TriangleMesh
joined(TriangleMesh mesh, const TriangleMesh & other, const Vector3 & shift)
{
  const auto first = static_cast<VertexIndex>(mesh.vertices.size());
  for (const Vector3 & vertex : other.vertices)
  {
    mesh.vertices.push_back(vertex + shift);
  }
  for (const Triangle & t : other.triangles)
  {
    mesh.triangles.push_back({ t[0] + first, t[1] + first, t[2] + first });
  }
  return mesh;
}

/** Every triangle with three vertices of its own, as STL has them. */
TriangleMesh
soupOf(const TriangleMesh & mesh)
{
  TriangleMesh soup;
  for (const Triangle & t : mesh.triangles)
  {
    const auto first = static_cast<VertexIndex>(soup.vertices.size());
    for (const VertexIndex vertex : t)
    {
      soup.vertices.push_back(mesh.vertices[vertex]);
    }
    soup.triangles.push_back({ first, first + 1, first + 2 });
  }
  return soup;
}

void
turn(Triangle & triangle)
{
  std::swap(triangle[1], triangle[2]);
}

/** A strip of quadrilaterals closed with a half turn, doubled across to have no boundary: a Klein bottle. */
TriangleMesh
kleinBottle(int n)
{
  TriangleMesh mesh;
  mesh.vertices.assign(static_cast<std::size_t>(n) * n, Vector3::Zero());
  const auto vertex = [n](int i, int j) {
    const bool wrapped = i >= n;
    return static_cast<VertexIndex>((i % n) * n + (wrapped ? (2 * n - j) % n : j % n));
  };
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < n; ++j)
    {
      mesh.triangles.push_back({ vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1) });
      mesh.triangles.push_back({ vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1) });
    }
  }
  return mesh;
}

} // namespace

TEST(SurfaceRepair, WeldingASoupGivesTheClosedSurface)
{
  const TriangleMesh  mesh = icosphere(2);
  const WeldedSurface welded = weldSurface(soupOf(mesh));
  EXPECT_EQ(welded.mesh.vertices.size(), mesh.vertices.size());
  EXPECT_EQ(welded.mesh.triangles.size(), mesh.triangles.size());
  EXPECT_TRUE(summarizeTopology(welded.mesh).isSphere());
  EXPECT_EQ(welded.collapsedTriangles + welded.duplicateTriangles, 0u);
}

TEST(SurfaceRepair, WeldingRemovesRepetitionsCollapsedTrianglesAndUnusedVertices)
{
  TriangleMesh mesh = cubeSurface(1);
  mesh.triangles.push_back(mesh.triangles[3]);
  mesh.triangles.push_back({ mesh.triangles[5][1], mesh.triangles[5][2], mesh.triangles[5][0] });
  mesh.triangles.push_back({ 2, 2, 5 });
  mesh.vertices.push_back(Vector3::Constant(1e18));
  const WeldedSurface welded = weldSurface(mesh);
  EXPECT_EQ(welded.duplicateTriangles, 2u);
  EXPECT_EQ(welded.collapsedTriangles, 1u);
  EXPECT_EQ(welded.mesh.triangles.size(), 12u);
  EXPECT_EQ(welded.mesh.vertices.size(), 8u);
}

TEST(SurfaceRepair, TriangleOfTheOtherSenseIsNoRepetition)
{
  TriangleMesh mesh = cubeSurface(1);
  mesh.triangles.push_back(mesh.triangles[0]);
  turn(mesh.triangles.back());
  EXPECT_EQ(weldSurface(mesh).duplicateTriangles, 0u);
}

TEST(SurfaceRepair, ZeroOfEitherSignIsOnePlace)
{
  const TriangleMesh mesh{ { { 0, 0, 0 }, { -0.0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 2, 3 }, { 1, 2, 3 } } };
  EXPECT_EQ(weldSurface(mesh).mesh.vertices.size(), 3u);
}

TEST(SurfaceRepair, BoundaryLoopsAndOverusedEdgesAreCounted)
{
  TriangleMesh mesh = icosphere(2);
  EXPECT_EQ(countSurfaceEdges(mesh).boundaryEdges, 0u);
  mesh.triangles.erase(mesh.triangles.begin() + 200);
  mesh.triangles.erase(mesh.triangles.begin());
  const SurfaceEdgeCounts open = countSurfaceEdges(mesh);
  EXPECT_EQ(open.boundaryEdges, 6u);
  EXPECT_EQ(open.boundaryLoops, 2u);
  EXPECT_EQ(open.overusedEdges, 0u);

  const TriangleMesh cube = cubeSurface(1, 1.0);
  const TriangleMesh two = weldSurface(joined(cube, cube, Vector3(1, 1, 0))).mesh;
  EXPECT_EQ(countSurfaceEdges(two).overusedEdges, 1u);
}

TEST(SurfaceRepair, MinorityIsTurned)
{
  TriangleMesh mesh = icosphere(2, 10.0);
  const double volume = enclosedVolume(mesh);
  for (const std::size_t f : { 3, 4, 77, 78, 300 })
  {
    turn(mesh.triangles[f]);
  }
  const OrientedSurface oriented = orientSurface(mesh);
  EXPECT_TRUE(oriented.orientable);
  EXPECT_EQ(oriented.parts, 1);
  EXPECT_EQ(oriented.turnedTriangles, 5u);
  EXPECT_NEAR(enclosedVolume(oriented.mesh), volume, 1e-9);
}

TEST(SurfaceRepair, HalfAndHalfIsDecidedByTheVolume)
{
  TriangleMesh mesh = cubeSurface(1, 2.0);
  for (std::size_t f = 0; f < 12; f += 2)
  {
    turn(mesh.triangles[f]);
  }
  const OrientedSurface oriented = orientSurface(mesh);
  EXPECT_EQ(oriented.turnedTriangles, 6u);
  EXPECT_DOUBLE_EQ(enclosedVolume(oriented.mesh), 8.0);
}

TEST(SurfaceRepair, InwardSurfaceStaysInward)
{
  TriangleMesh mesh = icosphere(1);
  std::for_each(mesh.triangles.begin(), mesh.triangles.end(), turn);
  const OrientedSurface oriented = orientSurface(mesh);
  EXPECT_EQ(oriented.turnedTriangles, 0u);
  EXPECT_LT(enclosedVolume(oriented.mesh), 0.0);
}

TEST(SurfaceRepair, KleinBottleIsNotOrientable)
{
  EXPECT_EQ(countSurfaceEdges(kleinBottle(6)).boundaryEdges, 0u);
  EXPECT_FALSE(orientSurface(kleinBottle(6)).orientable);
  EXPECT_TRUE(orientSurface(torusSurface(8, 8)).orientable);
}

TEST(SurfaceRepair, PartsAreMeshesOfTheirOwn)
{
  const OrientedSurface oriented = orientSurface(joined(icosphere(1), cubeSurface(1, 2.0), Vector3(5, 0, 0)));
  ASSERT_EQ(oriented.parts, 2);
  const std::vector<TriangleMesh> parts = partsOf(oriented);
  EXPECT_EQ(parts[0].vertices.size(), 42u);
  EXPECT_EQ(parts[1].vertices.size(), 8u);
  EXPECT_NEAR(enclosedVolume(parts[1]), 8.0, 1e-12);
}

TEST(SurfaceRepair, OpenSurfaceCannotBeOriented)
{
  TriangleMesh mesh = cubeSurface(1);
  mesh.triangles.pop_back();
  EXPECT_THROW((void)orientSurface(mesh), InvalidInput);
}
