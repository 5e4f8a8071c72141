// Exact class: counts and yes-or-no answers for positions listed by hand. Winding numbers are sums of arc tangents
// (1e-12).
#include "moserhex/Common/Random.h"
#include "moserhex/Geometry/SelfIntersection.h"

#include <gtest/gtest.h>

using namespace moserhex;

namespace
{

/** Octahedron of radius r about a centre, outwards. */
TriangleMesh
octahedron(double r, const Vector3 & centre = Vector3::Zero())
{
  TriangleMesh mesh;
  for (const Vector3 & p : { Vector3(1, 0, 0),
                             Vector3(-1, 0, 0),
                             Vector3(0, 1, 0),
                             Vector3(0, -1, 0),
                             Vector3(0, 0, 1),
                             Vector3(0, 0, -1) })
  {
    mesh.vertices.push_back(centre + r * p);
  }
  mesh.triangles = { { 0, 2, 4 }, { 2, 1, 4 }, { 1, 3, 4 }, { 3, 0, 4 },
                     { 2, 0, 5 }, { 1, 2, 5 }, { 3, 1, 5 }, { 0, 3, 5 } };
  return mesh;
}

const TriangleCorners flat{ Vector3(0, 0, 0), Vector3(2, 0, 0), Vector3(0, 2, 0) };

TriangleCorners
upright(double x, double low, double high)
{
  return { Vector3(x, 0.3, low), Vector3(x, 0.3, high), Vector3(x, 0.6, high) };
}

} // namespace

TEST(TrianglesIntersect, WhenOneCrossesThePlaneInsideTheOther)
{
  EXPECT_TRUE(trianglesIntersect(flat, upright(0.5, -1, 1)));
  EXPECT_TRUE(trianglesIntersect(upright(0.5, -1, 1), flat));
}

TEST(TrianglesIntersect, NotWhenApartAboveOrBeside)
{
  EXPECT_FALSE(trianglesIntersect(flat, upright(0.5, 1e-12, 1)));
  EXPECT_FALSE(trianglesIntersect(flat, upright(5, -1, 1)));
  EXPECT_TRUE(trianglesIntersect(flat, upright(0.5, 0, 1))); // touches with a corner
}

TEST(TrianglesIntersect, CoplanarPairsAreDecidedInTheirPlane)
{
  const auto shifted = [](double x) {
    TriangleCorners t = flat;
    for (Vector3 & p : t)
    {
      p.x() += x;
    }
    return t;
  };
  EXPECT_TRUE(trianglesIntersect(flat, shifted(1)));
  EXPECT_TRUE(trianglesIntersect(flat, shifted(2))); // touches with a corner
  EXPECT_FALSE(trianglesIntersect(flat, shifted(2.5)));
  const TriangleCorners inside{ Vector3(0.4, 0.4, 0), Vector3(0.6, 0.4, 0), Vector3(0.4, 0.6, 0) };
  EXPECT_TRUE(trianglesIntersect(flat, inside));
  EXPECT_TRUE(trianglesIntersect(inside, flat));
}

TEST(SelfIntersection, ConvexSurfaceHasNone)
{
  EXPECT_EQ(countSelfIntersections(octahedron(1)), 0u);
  EXPECT_EQ(countSelfIntersections({}), 0u);
}

TEST(SelfIntersection, CornerPushedThroughTheOppositeSideIsFound)
{
  TriangleMesh mesh = octahedron(1);
  mesh.vertices[4] = { 2, 2, -0.5 }; // the top goes out through a bottom face
  EXPECT_GT(countSelfIntersections(mesh), 0u);
}

TEST(SelfIntersection, PairsWithOneCommonVertexAreTestedOppositeToIt)
{
  TriangleMesh mesh;
  mesh.vertices = {
    { 0, 0, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, { 0.5, 0.4, 1 }, { 0.4, 0.5, -1 }, { 3, 3, 1 }, { 3, 3, -1 }
  };
  mesh.triangles = { { 0, 1, 2 }, { 0, 3, 4 } };
  EXPECT_EQ(countSelfIntersections(mesh), 1u);
  mesh.triangles = { { 1, 0, 2 }, { 1, 5, 6 } };
  EXPECT_EQ(countSelfIntersections(mesh), 0u);
}

TEST(SelfIntersection, TreeCountsWhatAllPairsCount)
{
  Random       random(5);
  TriangleMesh mesh;
  for (int t = 0; t < 150; ++t)
  {
    const Vector3 centre(random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2));
    for (int k = 0; k < 3; ++k)
    {
      mesh.vertices.push_back(centre + Vector3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)));
    }
    mesh.triangles.push_back({ 3 * t, 3 * t + 1, 3 * t + 2 });
  }
  const auto corners = [&](int t) {
    return TriangleCorners{ mesh.vertices[3 * t], mesh.vertices[3 * t + 1], mesh.vertices[3 * t + 2] };
  };
  std::size_t expected = 0;
  for (int s = 0; s < 150; ++s)
  {
    for (int t = s + 1; t < 150; ++t)
    {
      expected += trianglesIntersect(corners(s), corners(t)) ? 1 : 0;
    }
  }
  EXPECT_GT(expected, 100u);
  EXPECT_EQ(countSelfIntersections(mesh), expected);
}

TEST(Intersections, NestedSurfacesAreDisjointAndCrossingOnesAreNot)
{
  EXPECT_EQ(countIntersections(octahedron(1), octahedron(2)), 0u);
  EXPECT_GT(countIntersections(octahedron(1), octahedron(1, { 0.7, 0.1, 0.2 })), 0u);
  EXPECT_EQ(countIntersections(octahedron(1), {}), 0u);
}

TEST(WindingNumber, IsOneInsideAndZeroOutside)
{
  const TriangleMesh mesh = octahedron(2);
  EXPECT_NEAR(windingNumber(mesh, { 0.1, 0.2, 0.3 }), 1, 1e-12);
  EXPECT_NEAR(windingNumber(mesh, { 3, 0.2, 0.3 }), 0, 1e-12);
}

TEST(Nested, InnerInsideOuterOnly)
{
  EXPECT_TRUE(isNestedInside(octahedron(1), octahedron(2)));
  EXPECT_FALSE(isNestedInside(octahedron(2), octahedron(1)));
  EXPECT_FALSE(isNestedInside(octahedron(1), octahedron(1.2, { 0.5, 0, 0 })));
  EXPECT_FALSE(isNestedInside(octahedron(1), octahedron(2, { 9, 0, 0 })));
}
