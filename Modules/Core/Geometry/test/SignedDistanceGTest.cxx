#include "moserhex/Geometry/SignedDistance.h"

#include "moserhex/Analytic/Refusals.h"

#include <gtest/gtest.h>

#include <cmath>

// Closed forms to 1e-12 of the size.

using namespace moserhex;

namespace
{

/** A spike of four faces whose tip sees points behind single faces: the case that needs pseudonormals. */
TriangleMesh
spike()
{
  return { { { -1, -1, 0 }, { 1, -1, 0 }, { 1, 1, 0 }, { -1, 1, 0 }, { 0, 0, 20 } },
           { { 0, 1, 4 }, { 1, 2, 4 }, { 2, 3, 4 }, { 3, 0, 4 }, { 0, 2, 1 }, { 0, 3, 2 } } };
}

/** A prism along y from 0 to 3 whose upper edge is sharp. */
TriangleMesh
ridge()
{
  return { { { -1, 0, 0 }, { 1, 0, 0 }, { 0, 0, 20 }, { -1, 3, 0 }, { 1, 3, 0 }, { 0, 3, 20 } },
           { { 0, 1, 2 }, { 3, 5, 4 }, { 1, 4, 5 }, { 1, 5, 2 }, { 3, 0, 2 }, { 3, 2, 5 }, { 0, 3, 4 }, { 0, 4, 1 } } };
}

/** The cube [0,1]^3, two triangles a face. */
TriangleMesh
cube()
{
  return { { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } },
           { { 0, 2, 1 },
             { 0, 3, 2 },
             { 4, 5, 6 },
             { 4, 6, 7 },
             { 0, 1, 5 },
             { 0, 5, 4 },
             { 2, 3, 7 },
             { 2, 7, 6 },
             { 1, 2, 6 },
             { 1, 6, 5 },
             { 0, 4, 7 },
             { 0, 7, 3 } } };
}

double
distanceToCube(const Vector3 & p)
{
  const Vector3 q = (p.array() - 0.5).abs() - 0.5;
  return q.cwiseMax(0.0).norm() + std::min(q.maxCoeff(), 0.0);
}

} // namespace

TEST(SignedDistance, OfACubeEverywhere)
{
  const SignedDistance distance(cube());
  for (int k = -3; k <= 7; ++k)
  {
    for (int j = -3; j <= 7; ++j)
    {
      for (int i = -3; i <= 7; ++i)
      {
        const Vector3 p(0.25 * i, 0.25 * j, 0.25 * k); // on corners, edges, faces, inside and outside
        EXPECT_NEAR(distance(p), distanceToCube(p), 1e-12) << p.transpose();
      }
    }
  }
}

TEST(SignedDistance, PointsBeyondASharpTipAreOutside)
{
  const SignedDistance distance(spike());
  EXPECT_NEAR(distance({ 0, 0, 21 }), 1.0, 1e-12);
  EXPECT_NEAR(distance({ 0.04, 0.03, 20.5 }), Vector3(0.04, 0.03, 0.5).norm(), 1e-12);
  EXPECT_LT(distance({ 0, 0, 19 }), 0.0);
  EXPECT_EQ(distance({ 0, 0, 20 }), 0.0);
}

TEST(SignedDistance, ManyTrianglesOnOneSideOfATipDoNotOutvoteTheOthers)
{
  TriangleMesh          surface = spike();
  constexpr int         parts = 12;
  std::vector<Triangle> kept(surface.triangles.begin() + 1, surface.triangles.end()); // without the side y = -1
  std::vector<int>      base{ 0 };
  for (int part = 1; part < parts; ++part)
  {
    base.push_back(static_cast<int>(surface.vertices.size()));
    surface.vertices.emplace_back(-1.0 + 2.0 * part / parts, -1.0, 0.0);
  }
  base.push_back(1);
  kept.erase(kept.begin() + 3); // { 0, 2, 1 } of the bottom
  for (std::size_t part = 0; part < parts; ++part)
  {
    kept.push_back({ base[part], base[part + 1], 4 });
    kept.push_back({ base[part], 2, base[part + 1] });
  }
  surface.triangles = kept;
  EXPECT_NEAR(SignedDistance(surface)({ 0.0, 0.045, 20.5 }), std::hypot(0.045, 0.5), 1e-12);
}

TEST(SignedDistance, PointsBeyondASharpRidgeAreOutside)
{
  const SignedDistance distance(ridge());
  EXPECT_NEAR(distance({ 0.04, 1.0, 20.5 }), std::hypot(0.04, 0.5), 1e-12);
  EXPECT_NEAR(distance({ -0.04, 1.0, 20.5 }), std::hypot(0.04, 0.5), 1e-12);
  EXPECT_LT(distance({ 0, 1.0, 19.9 }), 0.0);
}

TEST(SignedDistance, AnOpenSurfaceIsRefused)
{
  TriangleMesh open = cube();
  open.triangles.pop_back();
  EXPECT_NE(analytic::messageOf([&] { (void)SignedDistance(open); }).find("has 1 triangles, need 2"),
            std::string::npos);
  EXPECT_THROW((void)SignedDistance(TriangleMesh{}), InvalidInput);
}
