// Exact: integers only.
#include "moserhex/Geometry/TriangleTopology.h"

#include "moserhex/Analytic/Refusals.h"
#include "moserhex/Analytic/SurfaceShapes.h"
#include "moserhex/Common/Errors.h"

#include <gtest/gtest.h>

#include <set>

using namespace moserhex;

namespace
{

TriangleMesh
tetrahedron()
{
  TriangleMesh mesh;
  mesh.vertices = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  mesh.triangles = { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 0, 3, 2 } };
  return mesh;
}

TriangleMesh
twoTetrahedra(bool sharingAVertex)
{
  TriangleMesh       mesh = tetrahedron();
  const TriangleMesh other = tetrahedron();
  const int          shift = sharingAVertex ? 3 : 4;
  for (std::size_t v = sharingAVertex ? 1 : 0; v < 4; ++v)
  {
    mesh.vertices.push_back(-other.vertices[v]);
  }
  for (const Triangle & t : other.triangles)
  {
    Triangle u;
    for (int k = 0; k < 3; ++k)
    {
      u[2 - k] = sharingAVertex && t[k] == 0 ? 0 : t[k] + shift;
    }
    mesh.triangles.push_back(u);
  }
  return mesh;
}

std::string
refusalOf(const TriangleMesh & mesh)
{
  return analytic::messageOf([&] { requireSphere(mesh, "label 3"); });
}

} // namespace

TEST(TriangleTopology, NeighboursShareTheEdgeOfTheirSide)
{
  const TriangleMesh     mesh = analytic::torusSurface(7, 7);
  const TriangleTopology topology = triangleTopology(mesh);
  EXPECT_EQ(topology.edges.size(), mesh.triangles.size() * 3 / 2);
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const std::set<int> ends{ mesh.triangles[f][k], mesh.triangles[f][(k + 1) % 3] };
      const Edge          edge = topology.edges[topology.triangleEdges[f][k]];
      EXPECT_EQ(ends, (std::set<int>{ edge[0], edge[1] }));
      const Triangle & across = mesh.triangles[topology.neighbours[f][k]];
      for (const int v : ends)
      {
        EXPECT_NE(std::find(across.begin(), across.end(), v), across.end());
      }
      EXPECT_NE(topology.neighbours[f][k], static_cast<int>(f));
    }
  }
}

TEST(TriangleTopology, VertexTriangleHoldsTheVertex)
{
  const TriangleMesh     mesh = analytic::torusSurface(5, 5);
  const TriangleTopology topology = triangleTopology(mesh);
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
  {
    const Triangle & t = mesh.triangles[topology.vertexTriangle[v]];
    EXPECT_NE(std::find(t.begin(), t.end(), static_cast<int>(v)), t.end());
  }
}

TEST(TriangleTopology, OpenSurfaceIsRefused)
{
  TriangleMesh mesh = tetrahedron();
  mesh.triangles.pop_back();
  EXPECT_THROW((void)triangleTopology(mesh), InvalidInput);
}

TEST(TriangleTopology, IndexOutOfRangeIsRefused)
{
  TriangleMesh mesh = tetrahedron();
  mesh.triangles[2][1] = 4;
  EXPECT_THROW((void)triangleTopology(mesh), InvalidInput);
  mesh.triangles[2][1] = -1;
  EXPECT_THROW((void)triangleTopology(mesh), InvalidInput);
}

TEST(TriangleTopology, FlippedTriangleIsRefused)
{
  TriangleMesh mesh = tetrahedron();
  std::swap(mesh.triangles[1][0], mesh.triangles[1][1]);
  EXPECT_THROW((void)triangleTopology(mesh), InvalidInput);
}

TEST(TriangleTopology, RepeatedVertexIsRefused)
{
  TriangleMesh mesh = tetrahedron();
  mesh.triangles[0] = { 0, 0, 1 };
  EXPECT_THROW((void)triangleTopology(mesh), InvalidInput);
}

TEST(SurfaceTopologySummary, TetrahedronIsASphere)
{
  EXPECT_TRUE(summarizeTopology(tetrahedron()).isSphere());
  EXPECT_EQ(refusalOf(tetrahedron()), "accepted");
}

TEST(SurfaceTopologySummary, TorusIsRefusedWithItsEulerCharacteristic)
{
  EXPECT_EQ(summarizeTopology(analytic::torusSurface(8, 8)).eulerCharacteristic, 0);
  EXPECT_NE(refusalOf(analytic::torusSurface(8, 8)).find("label 3: V-E+F = 0, need 2 (genus 0)"), std::string::npos);
}

TEST(SurfaceTopologySummary, TwoSpheresAreTwoComponents)
{
  const SurfaceTopologySummary s = summarizeTopology(twoTetrahedra(false));
  EXPECT_EQ(s.components, 2u);
  EXPECT_EQ(s.eulerCharacteristic, 4);
  EXPECT_NE(refusalOf(twoTetrahedra(false)).find("2 components"), std::string::npos);
}

TEST(SurfaceTopologySummary, SpheresThatTouchInAVertexAreNotManifold)
{
  const SurfaceTopologySummary s = summarizeTopology(twoTetrahedra(true));
  EXPECT_EQ(s.nonManifoldVertices, 1u);
  EXPECT_EQ(s.components, 1u);
  EXPECT_FALSE(s.isSphere());
}

TEST(SurfaceTopologySummary, HoleIsCountedInBoundaryEdges)
{
  TriangleMesh mesh = tetrahedron();
  mesh.triangles.pop_back();
  EXPECT_EQ(summarizeTopology(mesh).boundaryEdges, 3u);
}

TEST(SurfaceTopologySummary, UnusedVerticesDoNotCount)
{
  TriangleMesh mesh = tetrahedron();
  mesh.vertices.push_back({ 9, 9, 9 });
  EXPECT_TRUE(summarizeTopology(mesh).isSphere());
}
