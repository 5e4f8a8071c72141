// Round-off class (1e-12): closed forms on the octahedron and the cube, and invariances. Nothing is discretised.
#include "moserhex/Analytic/SurfaceShapes.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/SphericalMap/SphereMapQuality.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace moserhex;

namespace
{

Positions
projected(const TriangleMesh & mesh)
{
  Positions sphere;
  for (const Vector3 & p : mesh.vertices)
  {
    sphere.push_back(p.normalized());
  }
  return sphere;
}

} // namespace

TEST(SphereMapQuality, OctantHasHalfPi)
{
  EXPECT_NEAR(signedSolidAngle(Vector3::UnitX(), Vector3::UnitY(), Vector3::UnitZ()), pi / 2, 1e-15);
  EXPECT_NEAR(signedSolidAngle(Vector3::UnitY(), Vector3::UnitX(), Vector3::UnitZ()), -pi / 2, 1e-15);
}

TEST(SphereMapQuality, LargeTriangleIsMeasuredByItsOutside)
{
  // Three points on the circle z = -0.5: the triangle over the north pole covers 4 pi minus the one below.
  Positions    s;
  const double radius = std::sqrt(0.75);
  for (int k = 0; k < 3; ++k)
  {
    s.push_back(Vector3(radius * std::cos(2 * pi * k / 3), radius * std::sin(2 * pi * k / 3), -0.5));
  }
  const double below = signedSolidAngle(s[2], s[1], s[0]);
  EXPECT_GT(below, 0.0);
  EXPECT_NEAR(signedSolidAngle(s[0], s[1], s[2]), -below, 1e-15);
}

TEST(SphereMapQuality, IdentityOfTheSphereIsPerfect)
{
  const TriangleMesh     mesh = analytic::icosphere(3);
  const SphereMapQuality quality = sphereMapQuality(mesh, mesh.vertices);
  EXPECT_TRUE(isBijective(quality));
  EXPECT_NEAR(quality.solidAngleSum, 4 * pi, 1e-12);
  EXPECT_NEAR(quality.meanAngleError, 0.0, 1e-12);
  EXPECT_NEAR(quality.quasiConformal, 1.0, 1e-6);
  EXPECT_LT(quality.areaRatioRms, 0.01) << "flat against spherical area of the same triangles";
}

TEST(SphereMapQuality, TurnedTriangleIsCountedAndSumStaysFourPi)
{
  TriangleMesh   mesh = analytic::icosphere(2);
  Positions      sphere = mesh.vertices;
  const Triangle t = mesh.triangles[17];
  sphere[t[0]] = (sphere[t[1]] + sphere[t[2]] - 0.5 * sphere[t[0]]).normalized(); // across the opposite side
  const SphereMapQuality quality = sphereMapQuality(mesh, sphere);
  EXPECT_GE(quality.flippedTriangles, 1);
  EXPECT_LT(quality.areaRatioMin, 0.0);
  EXPECT_FALSE(isBijective(quality));
  EXPECT_NEAR(quality.solidAngleSum, 4 * pi, 1e-12) << "the sum alone does not see a fold";
}

TEST(SphereMapQuality, MirrorImageIsAllFlipped)
{
  const TriangleMesh mesh = analytic::icosphere(1);
  Positions          mirrored = mesh.vertices;
  for (Vector3 & s : mirrored)
  {
    s[0] = -s[0];
  }
  EXPECT_EQ(countFlippedTriangles(mesh.triangles, mirrored), static_cast<int>(mesh.triangles.size()));
}

TEST(SphereMapQuality, PositionThatIsNotFiniteCountsAsFlipped)
{
  const TriangleMesh mesh = analytic::icosphere(0);
  Positions          sphere = mesh.vertices;
  sphere[3][0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(countFlippedTriangles(mesh.triangles, sphere), 5);
}

TEST(SphereMapQuality, TargetsSumToFourPiAndRespectTheFloor)
{
  TriangleMesh mesh = analytic::icosphere(1);
  for (const VertexIndex v : mesh.triangles[0])
  {
    mesh.vertices[v] = mesh.vertices[mesh.triangles[0][0]];
  }
  const std::vector<double> targets = targetSolidAngles(mesh, 0.01);
  double                    sum = 0.0;
  for (const double target : targets)
  {
    EXPECT_GT(target, 0.009 * 4 * pi / static_cast<double>(targets.size()));
    sum += target;
  }
  EXPECT_NEAR(sum, 4 * pi, 1e-12);
}

TEST(SphereMapQuality, DoesNotChangeWithScale)
{
  const TriangleMesh mesh = analytic::ellipsoidSurface(2, Vector3(3, 1, 1));
  const Positions    sphere = projected(mesh);
  const auto         reference = sphereMapQuality(mesh, sphere);
  for (const double scale : { 1e-8, 1e8 })
  {
    TriangleMesh scaled = mesh;
    for (Vector3 & p : scaled.vertices)
    {
      p *= scale;
    }
    const auto quality = sphereMapQuality(scaled, sphere);
    EXPECT_NEAR(quality.areaRatioRms, reference.areaRatioRms, 1e-12);
    EXPECT_NEAR(quality.meanAngleError, reference.meanAngleError, 1e-10);
    EXPECT_NEAR(quality.quasiConformal, reference.quasiConformal, 1e-10);
  }
}

TEST(SphereMapQuality, SurfaceWithoutAreaIsRefused)
{
  TriangleMesh mesh = analytic::icosphere(0);
  for (Vector3 & p : mesh.vertices)
  {
    p = Vector3::Ones();
  }
  EXPECT_THROW((void)targetSolidAngles(mesh), InvalidInput);
}

TEST(SphereMapQuality, WrongSizeIsRefused)
{
  const TriangleMesh mesh = analytic::icosphere(0);
  EXPECT_THROW((void)sphereMapQuality(mesh, Positions(3, Vector3::UnitX())), InvalidInput);
}
