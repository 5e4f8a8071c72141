// Exact class: topology of the result, counts, determinism. Closed-form class: with projection the vertices lie on the
// sphere to round-off (1e-12) and the inscribed volume approaches the ball's with order 2 (slope within 0.1).
#include "moserhex/Analytic/ObservedOrder.h"
#include "moserhex/Analytic/SurfaceShapes.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Geometry/SurfaceRemeshing.h"
#include "moserhex/Geometry/TriangleTopology.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace moserhex;

namespace
{

/** Latitude-longitude sphere of radius 1: slivers at the poles, a hard start. */
TriangleMesh
unevenSphere(int meridians, int parallels)
{
  TriangleMesh mesh;
  mesh.vertices.push_back({ 0, 0, 1 });
  for (int j = 1; j < parallels; ++j)
  {
    for (int i = 0; i < meridians; ++i)
    {
      const double theta = pi * j / parallels;
      const double psi = 2 * pi * i / meridians;
      mesh.vertices.push_back({ std::sin(theta) * std::cos(psi), std::sin(theta) * std::sin(psi), std::cos(theta) });
    }
  }
  mesh.vertices.push_back({ 0, 0, -1 });
  const auto node = [&](int j, int i) { return 1 + (j - 1) * meridians + i % meridians; };
  const int  last = static_cast<int>(mesh.vertices.size()) - 1;
  for (int i = 0; i < meridians; ++i)
  {
    mesh.triangles.push_back({ 0, node(1, i), node(1, i + 1) });
    for (int j = 1; j + 1 < parallels; ++j)
    {
      mesh.triangles.push_back({ node(j, i), node(j + 1, i), node(j + 1, i + 1) });
      mesh.triangles.push_back({ node(j, i), node(j + 1, i + 1), node(j, i + 1) });
    }
    mesh.triangles.push_back({ node(parallels - 1, i), last, node(parallels - 1, i + 1) });
  }
  return mesh;
}

SurfaceRemeshingOptions
edgeLength(double length)
{
  SurfaceRemeshingOptions options;
  options.targetEdgeLength = length;
  return options;
}

const PointProjection ontoUnitSphere = [](const Vector3 & p) -> Vector3 { return p.normalized(); };

} // namespace

TEST(SurfaceRemeshing, SphereStaysASphereWithoutSliversOrNegativeCotangents)
{
  const SurfaceRemeshingResult result = remeshSurface(unevenSphere(80, 40), edgeLength(0.12), ontoUnitSphere);
  EXPECT_TRUE(summarizeTopology(result.mesh).isSphere());
  EXPECT_TRUE(result.report.converged);
  const SurfaceQualitySummary quality = summarizeSurfaceQuality(result.mesh);
  EXPECT_GE(quality.minimumAngle, 30);
  EXPECT_EQ(quality.negativeCotangents, 0u);
  EXPECT_LT(quality.largestArea, 2);
  EXPECT_GT(quality.smallestArea, 0.4);
  for (const Vector3 & p : result.mesh.vertices)
  {
    EXPECT_NEAR(p.norm(), 1, 1e-12);
  }
}

TEST(SurfaceRemeshing, TriangleCountFollowsTheEdgeLength)
{
  for (const double length : { 0.3, 0.15, 0.075 })
  {
    const TriangleMesh mesh = remeshSurface(unevenSphere(60, 30), edgeLength(length), ontoUnitSphere).mesh;
    const double       expected = 4 * pi / (std::sqrt(3.0) / 4 * length * length);
    EXPECT_GT(static_cast<double>(mesh.triangles.size()), 0.7 * expected);
    EXPECT_LT(static_cast<double>(mesh.triangles.size()), 1.3 * expected);
  }
}

TEST(SurfaceRemeshing, VolumeOfTheInscribedSphereConvergesWithOrderTwo)
{
  std::vector<double> sizes;
  std::vector<double> errors;
  for (const double length : { 0.4, 0.2, 0.1, 0.05 })
  {
    const TriangleMesh mesh = remeshSurface(unevenSphere(60, 30), edgeLength(length), ontoUnitSphere).mesh;
    // The mean edge length is what the mesh has, not what was asked for.
    sizes.push_back(std::sqrt(1 / static_cast<double>(mesh.triangles.size())));
    errors.push_back(4 * pi / 3 - enclosedVolume(mesh));
  }
  EXPECT_NEAR(analytic::observedOrder(sizes, errors), 2, 0.1);
}

TEST(SurfaceRemeshing, TorusStaysATorus)
{
  const TriangleMesh before = analytic::torusSurface(60, 20);
  for (const double length : { 0.35, 0.1 })
  {
    const TriangleMesh           after = remeshSurface(before, edgeLength(length)).mesh;
    const SurfaceTopologySummary topology = summarizeTopology(after);
    EXPECT_EQ(topology.eulerCharacteristic, 0);
    EXPECT_EQ(topology.components, 1u);
    EXPECT_EQ(topology.boundaryEdges + topology.nonManifoldEdges + topology.nonManifoldVertices, 0u);
    EXPECT_NEAR(enclosedVolume(after) / enclosedVolume(before), 1, 0.1);
  }
}

TEST(SurfaceRemeshing, TopologySurvivesAnEdgeLengthFarTooLarge)
{
  EXPECT_TRUE(summarizeTopology(remeshSurface(unevenSphere(40, 20), edgeLength(10)).mesh).isSphere());
  EXPECT_EQ(summarizeTopology(remeshSurface(analytic::torusSurface(30, 12), edgeLength(10)).mesh).eulerCharacteristic,
            0);
}

TEST(SurfaceRemeshing, SmoothingRoundsAloneKeepTheVertexCount)
{
  SurfaceRemeshingOptions options;
  options.sizingRounds = 0;
  const TriangleMesh before = unevenSphere(30, 20);
  const TriangleMesh after = remeshSurface(before, options, ontoUnitSphere).mesh;
  EXPECT_EQ(after.vertices.size(), before.vertices.size());
  EXPECT_EQ(after.triangles.size(), before.triangles.size());
}

TEST(SurfaceRemeshing, TwoRunsAreEqualBitForBit)
{
  const TriangleMesh a = remeshSurface(unevenSphere(50, 25), edgeLength(0.1), ontoUnitSphere).mesh;
  const TriangleMesh b = remeshSurface(unevenSphere(50, 25), edgeLength(0.1), ontoUnitSphere).mesh;
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.triangles, b.triangles);
}

TEST(SurfaceRemeshing, OpenAndNonManifoldSurfacesAreRefused)
{
  TriangleMesh open = unevenSphere(12, 6);
  open.triangles.pop_back();
  EXPECT_THROW((void)remeshSurface(open, edgeLength(0.5)), InvalidInput);
  TriangleMesh doubled = unevenSphere(12, 6);
  doubled.triangles.push_back(doubled.triangles[0]);
  EXPECT_THROW((void)remeshSurface(doubled, edgeLength(0.5)), InvalidInput);
  TriangleMesh pinched = unevenSphere(12, 6);
  const auto   count = static_cast<VertexIndex>(pinched.vertices.size());
  const auto   once = pinched.triangles;
  for (Triangle t : once) // a second sphere that shares vertex 0
  {
    for (VertexIndex & v : t)
    {
      v = v == 0 ? 0 : v + count;
    }
    pinched.triangles.push_back(t);
  }
  const Positions points = pinched.vertices;
  for (const Vector3 & p : points)
  {
    pinched.vertices.push_back(Vector3(0, 0, 2) - p);
  }
  EXPECT_THROW((void)remeshSurface(pinched, edgeLength(0.5)), InvalidInput);
}

TEST(SurfaceRemeshing, OptionsOutOfRangeAreRefused)
{
  const TriangleMesh sphere = unevenSphere(12, 6);
  EXPECT_THROW((void)remeshSurface(sphere, edgeLength(0)), InvalidInput);
  const auto refused = [&](auto change) {
    SurfaceRemeshingOptions options = edgeLength(0.5);
    change(options);
    EXPECT_THROW((void)remeshSurface(sphere, options), InvalidInput);
  };
  refused([](auto & o) { o.sizingRounds = -1; });
  refused([](auto & o) { o.smoothingRounds = -1; });
  refused([](auto & o) { o.splitRatio = 1; });
  refused([](auto & o) { o.collapseRatio = 1; });
  refused([](auto & o) { o.relaxation = 0; });
}

TEST(SurfaceQuality, RegularOctahedronHasSixtyDegreesAndEqualAreas)
{
  TriangleMesh mesh;
  mesh.vertices = { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } };
  mesh.triangles = { { 0, 2, 4 }, { 2, 1, 4 }, { 1, 3, 4 }, { 3, 0, 4 },
                     { 2, 0, 5 }, { 1, 2, 5 }, { 3, 1, 5 }, { 0, 3, 5 } };
  const SurfaceQualitySummary quality = summarizeSurfaceQuality(mesh);
  EXPECT_NEAR(quality.minimumAngle, 60, 1e-10);
  EXPECT_NEAR(quality.smallestArea, 1, 1e-12);
  EXPECT_NEAR(quality.largestArea, 1, 1e-12);
  EXPECT_NEAR(quality.largestCrease, std::acos(1.0 / 3) * 180 / pi, 1e-10);
  EXPECT_EQ(quality.negativeCotangents, 0u);
}

TEST(SurfaceQuality, SliverPairHasANegativeCotangentSum)
{
  TriangleMesh mesh; // flat kite with a short diagonal flipped the wrong way, closed by a second sheet
  mesh.vertices = { { -1, 0, 0 }, { 1, 0, 0 }, { 0, 0.2, 0.01 }, { 0, -0.2, 0.01 }, { 0, 0, -1 } };
  mesh.triangles = { { 0, 1, 2 }, { 1, 0, 3 }, { 2, 1, 4 }, { 0, 2, 4 }, { 1, 3, 4 }, { 3, 0, 4 } };
  EXPECT_GE(summarizeSurfaceQuality(mesh).negativeCotangents, 1u);
}
