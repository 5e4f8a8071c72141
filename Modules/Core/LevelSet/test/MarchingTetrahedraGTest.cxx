// Identities within round-off of the vertices' margin (1e-4 of an edge: 1e-5 mm^3 for each of the few
// vertices it moves); closed
// forms for linear functions (1e-12); orders fitted on four grids, slope within 0.1.
#include "TestShapes.h"
#include "moserhex/Analytic/ObservedOrder.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Geometry/TriangleTopology.h"
#include "moserhex/LevelSet/MarchingTetrahedra.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <cmath>

using namespace moserhex;

namespace
{

LevelSet
ball(int n, double radius)
{
  const Vector3 centre(0.013, -0.007, 0.019);
  return test::sample(test::unitGrid(n), [&](const Vector3 & p) { return (p - centre).norm() - radius; });
}

LevelSet
withFrame(LevelSet levelSet, const Matrix3 & direction, const Vector3 & origin)
{
  levelSet.grid.direction = direction;
  levelSet.grid.origin = origin;
  return levelSet;
}

} // namespace

TEST(MarchingTetrahedra, BallIsAnOutwardSphere)
{
  const TriangleMesh mesh = marchingTetrahedra(ball(21, 0.7), 0.0);
  EXPECT_TRUE(summarizeTopology(mesh).isSphere());
  EXPECT_NO_THROW((void)triangleTopology(mesh));
  EXPECT_GT(enclosedVolume(mesh), 0.0);
}

TEST(MarchingTetrahedra, LeftHandedObliqueGridGivesTheMovedOutwardSurface)
{
  const LevelSet     original = ball(21, 0.7);
  const Matrix3      rotation = Eigen::AngleAxisd(0.7, Vector3(1, -2, 0.5).normalized()).toRotationMatrix();
  const Matrix3      mirrored = rotation * Vector3(1, -1, 1).asDiagonal();
  const Vector3      origin(5, -3, 40);
  const TriangleMesh a = marchingTetrahedra(original, 0.0);
  const TriangleMesh b = marchingTetrahedra(withFrame(original, mirrored, origin), 0.0);
  ASSERT_EQ(a.vertices.size(), b.vertices.size());
  for (std::size_t v = 0; v < a.vertices.size(); ++v)
  {
    EXPECT_LT((mirrored * (a.vertices[v] - original.grid.origin) + origin - b.vertices[v]).norm(), 1e-12);
  }
  EXPECT_NEAR(enclosedVolume(a), enclosedVolume(b), 1e-12);
}

TEST(MarchingTetrahedra, VerticesLieOnTheLevelOfALinearFunction)
{
  const Vector3 normal = Vector3(0.3, -1.1, 0.7);
  LevelSet      f = test::sample(test::unitGrid(9), [&](const Vector3 & p) { return normal.dot(p) + 0.013; });
  for (std::size_t node = 0; node < f.values.size(); ++node)
  {
    if (f.grid.isBorder(node))
    {
      f.values[node] = 1e9; // closes the box
    }
  }
  int onPlane = 0;
  for (const Vector3 & p : marchingTetrahedra(f, 0.0).vertices)
  {
    const double far = p.cwiseAbs().maxCoeff();
    if (far < 0.74)
    {
      EXPECT_NEAR(normal.dot(p) + 0.013, 0.0, 2e-4 * f.grid.spacing);
      ++onPlane;
    }
  }
  EXPECT_GT(onPlane, 50);
}

TEST(MarchingTetrahedra, NoCrossingGivesAnEmptyMesh)
{
  EXPECT_TRUE(marchingTetrahedra(ball(9, 0.5), -3.0).triangles.empty());
}

TEST(MarchingTetrahedra, InsideNodeOnTheBorderIsRefused)
{
  EXPECT_THROW((void)marchingTetrahedra(ball(9, 1.2), 0.0), InvalidInput);
}

TEST(MarchingTetrahedra, NaNIsRefused)
{
  LevelSet f = ball(9, 0.5);
  f.values[7] = NAN;
  EXPECT_THROW((void)marchingTetrahedra(f, 0.0), InvalidInput);
}

TEST(VolumeBelowLevel, EqualsTheVolumeOfTheMesh)
{
  for (std::uint64_t seed = 0; seed < 5; ++seed)
  {
    const LevelSet         f = test::randomField({ { 8, 9, 7 } }, seed);
    const VolumeBelowLevel below(f);
    for (const double level : { 0.1, 0.37, 0.5, 0.81, 0.99 })
    {
      EXPECT_NEAR(below.volume(level), enclosedVolume(marchingTetrahedra(f, level)), 1e-4) << "seed " << seed;
    }
  }
}

TEST(VolumeBelowLevel, EqualsTheVolumeOfTheMeshWithInfiniteValues)
{
  LevelSet f = test::randomField({ { 8, 9, 7 } }, 11);
  for (std::size_t node = 0; node < f.values.size(); ++node)
  {
    if (f.values[node] > 0.7)
    {
      f.values[node] = INFINITY;
    }
  }
  EXPECT_NEAR(VolumeBelowLevel(f).volume(0.5), enclosedVolume(marchingTetrahedra(f, 0.5)), 1e-4);
}

TEST(VolumeBelowLevel, HalfSpaceIsExact)
{
  const LevelSet f = test::sample(test::unitGrid(7), [](const Vector3 & p) { return p.x(); });
  for (const double level : { -1.0, -0.31, 0.0, 0.25, 1.0 })
  {
    EXPECT_NEAR(VolumeBelowLevel(f).volume(level), 4.0 * (level + 1.0), 1e-12);
  }
}

TEST(VolumeBelowLevel, BallIsSecondOrder)
{
  std::vector<double> h;
  std::vector<double> error;
  for (const int n : { 17, 33, 65, 129 })
  {
    const LevelSet f = ball(n, 0.7);
    h.push_back(f.grid.spacing);
    error.push_back(std::abs(VolumeBelowLevel(f).volume(0.0) - 4.0 / 3.0 * pi * std::pow(0.7, 3)));
  }
  EXPECT_NEAR(analytic::observedOrder(h, error), 2.0, 0.1);
}

TEST(VolumeBelowLevel, CubesOfABracketGiveTheSameVolumeToTheBit)
{
  const LevelSet         f = ball(25, 0.5);
  const VolumeBelowLevel below(f);
  auto                   cubes = below.cubesBetween(-0.3, 0.4);
  const std::size_t      before = cubes.partial.size();
  below.narrow(cubes, -0.1, 0.2);
  EXPECT_LT(cubes.partial.size(), before);
  EXPECT_GT(cubes.whole, 0u);
  for (const double level : { -0.1, -0.03, 0.0, 0.11, 0.2 })
  {
    EXPECT_EQ(below.volume(level, cubes), below.volume(level));
  }
}

TEST(LevelOfVolume, EnclosesTheVolume)
{
  const LevelSet f = ball(25, 0.5);
  for (const double volume : { 1e-4, 0.1, 1.0, 3.0 })
  {
    EXPECT_NEAR(VolumeBelowLevel(f).volume(levelOfVolume(f, volume)), volume, 1e-9 * volume);
  }
}

TEST(LevelOfVolume, StaysInTheRangeOfTheSearch)
{
  const LevelSet       f = ball(25, 0.5);
  LevelOfVolumeOptions options;
  options.lower = -0.1;
  options.upper = 0.1;
  const double level = levelOfVolume(f, 4.0 / 3.0 * pi * 0.125, options);
  EXPECT_NEAR(level, 0.0, 0.02);
  EXPECT_THROW((void)levelOfVolume(f, 2.5, options), InvalidInput);
}

TEST(LevelOfVolume, MoreThanTheBoxIsRefused)
{
  EXPECT_THROW((void)levelOfVolume(ball(9, 0.5), 9.0), InvalidInput);
}

TEST(LevelOfVolume, PlateauIsReported)
{
  LevelSet f = ball(17, 0.5);
  for (double & value : f.values)
  {
    value = value < 0.0 ? -1.0 : (value < 0.4 ? 0.0 : 1.0);
  }
  // At level 0 the volume jumps from that of the inner ball to that of the plateau.
  const VolumeBelowLevel below(f);
  const double           volume = 0.5 * (below.volume(0.0) + below.volume(std::nextafter(0.0, 1.0)));
  EXPECT_THROW((void)levelOfVolume(f, volume), NotConverged);
}
