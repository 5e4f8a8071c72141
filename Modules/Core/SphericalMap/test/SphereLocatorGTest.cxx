// Round-off class: a located point mapped back must be where it was, 1e-14 (3e-14 where triangles are small);
// degenerate positions are listed, not sampled.
#include "moserhex/Analytic/SurfaceShapes.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Random.h"
#include "moserhex/SphericalMap/SphereLocator.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <Eigen/Geometry>

#include <cmath>
#include <limits>
#include <memory>

using namespace moserhex;

namespace
{

/** The sphere with its triangles drawn towards one pole: sizes differ by a factor of hundreds. */
TriangleMesh
unevenSphere(int levels)
{
  TriangleMesh mesh = analytic::icosphere(levels);
  for (Vector3 & s : mesh.vertices)
  {
    s = (s + Vector3(0.0, 0.1, 0.85)).normalized();
  }
  return mesh;
}

double
roundTripError(const TriangleMesh & mesh, const SphereLocator & locator, const Vector3 & direction)
{
  const SphereLocator::Hit hit = locator.locate(direction);
  const Triangle &         t = mesh.triangles[hit.triangle];
  EXPECT_GE(hit.barycentric.minCoeff(), 0.0);
  EXPECT_NEAR(hit.barycentric.sum(), 1.0, 1e-15);
  Vector3 point = Vector3::Zero();
  for (int k = 0; k < 3; ++k)
  {
    point += hit.barycentric[k] * mesh.vertices[t[k]];
  }
  return (point.normalized() - direction.normalized()).norm();
}

} // namespace

TEST(SphereLocator, RandomDirectionsComeBack)
{
  const TriangleMesh  mesh = unevenSphere(4);
  const SphereLocator locator(mesh.triangles, mesh.vertices);
  Random              random(11);
  for (int i = 0; i < 20000; ++i)
  {
    const double z = random.uniform(-1.0, 1.0);
    const double angle = random.uniform(0.0, 6.283185307179586);
    const double radius = std::sqrt(1.0 - z * z);
    EXPECT_LT(roundTripError(mesh, locator, Vector3(radius * std::cos(angle), radius * std::sin(angle), z)), 1e-13);
  }
}

TEST(SphereLocator, EveryVertexIsFound)
{
  const TriangleMesh  mesh = unevenSphere(3);
  const SphereLocator locator(mesh.triangles, mesh.vertices);
  for (const Vector3 & s : mesh.vertices)
  {
    EXPECT_LT(roundTripError(mesh, locator, s), 1e-14);
  }
}

TEST(SphereLocator, DirectionsNextToEdgesAndVerticesAreFound)
{
  const TriangleMesh  mesh = unevenSphere(3);
  const SphereLocator locator(mesh.triangles, mesh.vertices);
  for (const Triangle & t : mesh.triangles)
  {
    const Vector3 & a = mesh.vertices[t[0]];
    const Vector3 & b = mesh.vertices[t[1]];
    const Vector3   across = a.cross(b).normalized();
    const Vector3   middle = (a + b).normalized();
    for (const double offset : { 0.0, 1e-12, -1e-12, 1e-15, -1e-15 })
    {
      EXPECT_LT(roundTripError(mesh, locator, middle + offset * across), 3e-14);
      EXPECT_LT(roundTripError(mesh, locator, a + offset * across), 3e-14);
      EXPECT_LT(roundTripError(mesh, locator, a + offset * (b - a)), 3e-14);
    }
  }
}

TEST(SphereLocator, PolesAndCubeEdgesOfTheTableAreFound)
{
  const TriangleMesh  mesh = analytic::icosphere(4);
  const SphereLocator locator(mesh.triangles, mesh.vertices);
  for (int i = -1; i <= 1; ++i)
  {
    for (int j = -1; j <= 1; ++j)
    {
      for (int k = -1; k <= 1; ++k)
      {
        if (i != 0 || j != 0 || k != 0)
        {
          EXPECT_LT(roundTripError(mesh, locator, Vector3(i, j, k)), 1e-14) << i << ' ' << j << ' ' << k;
        }
      }
    }
  }
}

TEST(SphereLocator, TetrahedronIsCovered)
{
  // Four triangles of pi each: the largest a locator can meet.
  TriangleMesh mesh;
  mesh.vertices = { { 1, 1, 1 }, { 1, -1, -1 }, { -1, 1, -1 }, { -1, -1, 1 } };
  for (Vector3 & s : mesh.vertices)
  {
    s.normalize();
  }
  mesh.triangles = { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 1 }, { 1, 3, 2 } };
  const SphereLocator locator(mesh.triangles, mesh.vertices);
  Random              random(3);
  for (int i = 0; i < 1000; ++i)
  {
    const Vector3 direction(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    EXPECT_LT(roundTripError(mesh, locator, direction), 1e-13);
  }
}

TEST(SphereLocator, StartTriangleDoesNotMatter)
{
  const TriangleMesh  mesh = analytic::icosphere(3);
  const SphereLocator locator(mesh.triangles, mesh.vertices);
  const Vector3       direction = Vector3(0.3, -0.5, 0.2);
  const int           expected = locator.locate(direction).triangle;
  for (std::size_t f = 0; f < mesh.triangles.size(); f += 37)
  {
    EXPECT_EQ(locator.locateFrom(direction, static_cast<int>(f)).triangle, expected);
  }
}

TEST(SphereLocator, KeepsItsOwnCopies)
{
  auto                triangulation = std::make_unique<TriangleMesh>(analytic::icosphere(2));
  const SphereLocator locator(triangulation->triangles, triangulation->vertices);
  const TriangleMesh  copy = *triangulation;
  triangulation.reset();
  EXPECT_LT(roundTripError(copy, locator, Vector3(1, 2, 3)), 1e-14);
}

TEST(SphereLocator, ZeroDirectionIsRefused)
{
  const TriangleMesh  mesh = analytic::icosphere(0);
  const SphereLocator locator(mesh.triangles, mesh.vertices);
  EXPECT_THROW((void)locator.locate(Vector3::Zero()), InvalidInput);
  EXPECT_THROW((void)locator.locate(Vector3(std::numeric_limits<double>::quiet_NaN(), 0, 1)), InvalidInput);
}

TEST(SphereLocator, StartThatDoesNotExistIsRefused)
{
  const TriangleMesh  mesh = analytic::icosphere(0);
  const SphereLocator locator(mesh.triangles, mesh.vertices);
  EXPECT_THROW((void)locator.locateFrom(Vector3::UnitX(), -1), InvalidInput);
  EXPECT_THROW((void)locator.locateFrom(Vector3::UnitX(), 20), InvalidInput);
}

TEST(SphereLocator, OpenSurfaceIsRefused)
{
  EXPECT_THROW(SphereLocator({}, {}), InvalidInput);
  TriangleMesh mesh = analytic::icosphere(1);
  mesh.triangles.pop_back();
  EXPECT_THROW(SphereLocator(mesh.triangles, mesh.vertices), InvalidInput);
  TriangleMesh bad = analytic::icosphere(1);
  bad.vertices[0][0] = std::numeric_limits<double>::infinity();
  EXPECT_THROW(SphereLocator(bad.triangles, bad.vertices), InvalidInput);
}
