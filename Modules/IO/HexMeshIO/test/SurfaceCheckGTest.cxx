// What is repaired and what is refused of a surface whose file is in order. Counts and codes are exact.
#include "SurfaceCheck.h"

#include "TestFolder.h"
#include "moserhex/Analytic/SurfaceShapes.h"
#include "moserhex/Geometry/TriangleTopology.h"

#include <gtest/gtest.h>

using namespace moserhex;
using namespace moserhex::analytic;

namespace
{

SurfaceFile
check(const TriangleMesh & mesh)
{
  return checkedSurface("a.stl", { mesh, 0, false });
}

ErrorCode
codeOf(const TriangleMesh & mesh)
{
  return codeThrownBy([&] { (void)check(mesh); });
}

std::string
warningsOf(const TriangleMesh & mesh)
{
  std::string all;
  for (const std::string & warning : check(mesh).warnings)
  {
    all += warning + "\n";
  }
  return all;
}

TriangleMesh
turned(TriangleMesh mesh)
{
  for (Triangle & triangle : mesh.triangles)
  {
    std::swap(triangle[0], triangle[1]);
  }
  return mesh;
}

TriangleMesh
with(TriangleMesh mesh, const TriangleMesh & other, const Vector3 & shift = Vector3::Zero())
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

} // namespace

TEST(SurfaceCheck, CleanSurfaceHasNoWarnings)
{
  EXPECT_EQ(warningsOf(icosphere(2, 10.0)), "");
}

TEST(SurfaceCheck, RepairsAreCountedInWarnings)
{
  TriangleMesh mesh = cubeSurface(2, 10.0);
  mesh.triangles.push_back(mesh.triangles[0]);
  mesh.triangles.push_back({ 1, 1, 2 });
  std::swap(mesh.triangles[7][0], mesh.triangles[7][1]);
  const SurfaceFile file = checkedSurface("a.obj", { mesh, 3, false });
  ASSERT_EQ(file.warnings.size(), 4u);
  EXPECT_EQ(file.warnings[0], "3 polygons cut into triangles");
  EXPECT_EQ(file.warnings[1], "1 degenerate triangle removed (two corners in one place)");
  EXPECT_EQ(file.warnings[2], "1 duplicate triangle removed");
  EXPECT_EQ(file.warnings[3], "1 triangle turned to agree with the others");
  EXPECT_TRUE(summarizeTopology(file.mesh).isSphere());
  EXPECT_NEAR(enclosedVolume(file.mesh), 1000.0, 1e-9);
}

TEST(SurfaceCheck, InwardSurfaceIsTurnedWithAWarning)
{
  EXPECT_EQ(warningsOf(turned(icosphere(1))), "the surface faced inwards and was turned\n");
  EXPECT_GT(enclosedVolume(check(turned(icosphere(1))).mesh), 0.0);
}

TEST(SurfaceCheck, OpenSurfaceIsRefusedWithItsLoops)
{
  TriangleMesh mesh = icosphere(2);
  mesh.triangles.pop_back();
  EXPECT_EQ(codeOf(mesh), ErrorCode::SurfaceOpen);
  EXPECT_NE(messageOf<BadInput>([&] { (void)check(mesh); }).find("1 boundary loop of 3 edges"), std::string::npos);
}

TEST(SurfaceCheck, TJunctionIsAnOpening)
{
  TriangleMesh   mesh = cubeSurface(1, 2.0);
  const Triangle t = mesh.triangles[0];
  const auto     middle = static_cast<VertexIndex>(mesh.vertices.size());
  mesh.vertices.push_back(0.5 * (mesh.vertices[t[0]] + mesh.vertices[t[1]]));
  mesh.triangles[0] = { t[0], middle, t[2] };
  mesh.triangles.push_back({ middle, t[1], t[2] });
  EXPECT_EQ(codeOf(mesh), ErrorCode::SurfaceOpen);
}

TEST(SurfaceCheck, CubesThatShareAnEdgeOrAFaceAreRefused)
{
  const TriangleMesh cube = cubeSurface(1, 2.0);
  EXPECT_EQ(codeOf(with(cube, cube, Vector3(2, 2, 0))), ErrorCode::SurfaceNonManifold);
  EXPECT_EQ(codeOf(with(cube, cube, Vector3(2, 0, 0))), ErrorCode::SurfaceNonManifold);
}

TEST(SurfaceCheck, SeparatePartsAreRefused)
{
  const TriangleMesh cube = cubeSurface(1, 2.0);
  EXPECT_EQ(codeOf(with(cube, cube, Vector3(5, 0, 0))), ErrorCode::Topology);
  EXPECT_EQ(codeOf(with(cube, cube, Vector3(2, 2, 2))), ErrorCode::Topology); // share a vertex
  TriangleMesh many = cube;
  for (int k = 1; k < 120; ++k)
  {
    many = with(std::move(many), cube, Vector3(5.0 * k, 0, 0));
  }
  EXPECT_NE(messageOf<BadInput>([&] { (void)check(many); }).find("120 separate parts"), std::string::npos);
}

TEST(SurfaceCheck, InnerShellIsACavityOnlyWhenOrientedTheOtherWay)
{
  const TriangleMesh outer = icosphere(2, 10.0);
  const TriangleMesh inner = icosphere(2, 4.0);
  EXPECT_EQ(warningsOf(with(outer, turned(inner))), "the surface has 1 cavity\n");
  EXPECT_EQ(warningsOf(with(turned(inner), outer)), "the surface has 1 cavity\n");
  EXPECT_EQ(codeOf(with(outer, inner)), ErrorCode::Topology);
  EXPECT_EQ(codeOf(with(turned(outer), turned(inner))), ErrorCode::Topology);
  EXPECT_EQ(codeOf(with(with(outer, turned(inner)), turned(icosphere(1, 2.0)))), ErrorCode::Topology);
  EXPECT_EQ(codeOf(with(with(outer, turned(inner)), icosphere(1, 2.0))), ErrorCode::Topology);
  EXPECT_NEAR(enclosedVolume(check(with(turned(outer), inner)).mesh),
              enclosedVolume(outer) - enclosedVolume(inner),
              1e-9); // inside out as a whole
}

TEST(SurfaceCheck, SlightOverlapIsAWarningAndAnythingElseIsRefused)
{
  const TriangleMesh big = icosphere(3, 10.0);
  const TriangleMesh small = icosphere(2, 3.0);
  EXPECT_NE(warningsOf(with(big, small, Vector3(11, 0, 0))).find("cut one another, the first near"), std::string::npos);
  EXPECT_EQ(codeOf(with(big, turned(small), Vector3(11, 0, 0))), ErrorCode::SurfaceIntersects);
  EXPECT_EQ(codeOf(with(big, big, Vector3(4, 1, 0))), ErrorCode::SurfaceIntersects);
}

TEST(SurfaceCheck, KleinBottleIsRefused)
{
  // A torus of squares whose last row is joined to the first one mirrored; where its vertices are does not matter.
  constexpr int n = 5;
  TriangleMesh  mesh;
  const auto    vertex = [](int i, int j) { return (i % n) * n + (i < n ? j : 2 * n - j) % n; };
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < n; ++j)
    {
      mesh.vertices.emplace_back(i, j, 0.37 * i * j);
      mesh.triangles.push_back({ vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1) });
      mesh.triangles.push_back({ vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1) });
    }
  }
  EXPECT_EQ(codeOf(mesh), ErrorCode::SurfaceNonManifold);
  EXPECT_NE(messageOf<BadInput>([&] { (void)check(mesh); }).find("not orientable"), std::string::npos);
}

TEST(SurfaceCheck, HandlesAreCounted)
{
  EXPECT_EQ(warningsOf(torusSurface(24, 12, 20.0, 7.0)), "the surface has 1 handle (genus 1)\n");
}

TEST(SurfaceCheck, SurfaceThatTouchesItselfAtAVertexIsAccepted)
{
  // The poles of a sphere moved into one place.
  TriangleMesh mesh = icosphere(3, 10.0);
  const auto   byZ = [](const Vector3 & a, const Vector3 & b) { return a.z() < b.z(); };
  auto         lowest = std::min_element(mesh.vertices.begin(), mesh.vertices.end(), byZ);
  auto         highest = std::max_element(mesh.vertices.begin(), mesh.vertices.end(), byZ);
  *lowest = Vector3(0.1, 0.2, 0.3);
  *highest = Vector3(0.1, 0.2, 0.3);
  EXPECT_NE(warningsOf(mesh).find("touches itself at 1 vertex"), std::string::npos);
}

TEST(SurfaceCheck, FlatOrCollapsedSurfaceIsDegenerate)
{
  const TriangleMesh flat{ { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } },
                           { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 2, 1 }, { 0, 3, 2 } } };
  EXPECT_EQ(codeOf(flat), ErrorCode::SurfaceDegenerate);
  TriangleMesh collapsed = cubeSurface(1, 0.0);
  EXPECT_EQ(codeOf(collapsed), ErrorCode::SurfaceDegenerate);
}

TEST(SurfaceCheck, FarVertexIsRefusedOnlyWhenUsed)
{
  TriangleMesh mesh = icosphere(1);
  mesh.vertices.push_back(Vector3::Constant(1e9));
  EXPECT_EQ(warningsOf(mesh), "");
  mesh.vertices[3].x() = 2e6;
  EXPECT_EQ(codeOf(mesh), ErrorCode::Geometry);
}

TEST(SurfaceCheck, SizeOfMetresOrMicrometresIsDoubted)
{
  EXPECT_EQ(warningsOf(icosphere(1, 0.025)), "the surface is 0.05 mm long: are its coordinates millimetres?\n");
  EXPECT_EQ(warningsOf(icosphere(1, 2.5e4)), "the surface is 5e+04 mm long: are its coordinates millimetres?\n");
}

TEST(SurfaceCheck, SelfIntersectionWithoutACompactSolidIsRefused)
{
  // Two crossing needles: no grid of voxels resolves them.
  const TriangleMesh cube = cubeSurface(1, 1.0);
  TriangleMesh       needle = cube;
  for (Vector3 & vertex : needle.vertices)
  {
    vertex = vertex.cwiseProduct(Vector3(1e5, 1e-3, 1e-3));
  }
  EXPECT_THROW((void)check(with(needle, turned(cube), Vector3(0.1, 0.2, 0.3))), BadInput);
}

TEST(SurfaceCheck, RasIsTurnedIntoLps)
{
  TriangleMesh mesh = icosphere(1);
  for (Vector3 & vertex : mesh.vertices)
  {
    vertex += Vector3(10, 20, 30);
  }
  const BoundingBox box = boundingBox(checkedSurface("a.vtk", { mesh, 0, true }).mesh.vertices);
  EXPECT_LT((0.5 * (box.lower + box.upper) - Vector3(-10, -20, 30)).norm(), 1e-12);
}
