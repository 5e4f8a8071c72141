// Unit length and symmetry: round-off. The two ways to the sphere are different area-preserving maps that share the
// cube's symmetry: areas are compared with the discretisation's own error, directions with a bound in degrees.
#include "moserhex/HexMap/CubeShellMaps.h"

#include "moserhex/Common/Errors.h"
#include "moserhex/Geometry/TriangleTopology.h"
#include "moserhex/SphericalMap/SphereMapQuality.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

using namespace moserhex;

namespace
{

/** Root mean square of the relative deviation of the quadrilaterals' solid angles from their mean 4 pi / number. */
double
areaErrorRms(const CubeLattice & lattice, int shell, const Positions & directions)
{
  const auto                         nodes = lattice.nodesOfShell(shell);
  std::map<std::size_t, std::size_t> place;
  for (std::size_t m = 0; m < nodes.size(); ++m)
  {
    place[nodes[m]] = m;
  }
  const auto quads = lattice.quadsOfShell(shell);
  double     squares = 0.0;
  for (const Quad & quad : quads)
  {
    const Vector3 & a = directions[place[quad[0]]];
    const Vector3 & b = directions[place[quad[1]]];
    const Vector3 & c = directions[place[quad[2]]];
    const Vector3 & d = directions[place[quad[3]]];
    const double    angle = signedSolidAngle(a, b, c) + signedSolidAngle(a, c, d);
    squares += std::pow(angle * static_cast<double>(quads.size()) / (4.0 * pi) - 1.0, 2);
  }
  return std::sqrt(squares / static_cast<double>(quads.size()));
}
} // namespace

TEST(CubeSurfaceMesh, IsAClosedSphereOfTheRightArea)
{
  for (const int squares : { 1, 2, 5 })
  {
    const TriangleMesh mesh = cubeSurfaceMesh(squares);
    EXPECT_EQ(mesh.triangles.size(), static_cast<std::size_t>(12 * squares * squares));
    EXPECT_TRUE(summarizeTopology(mesh).isSphere());
    EXPECT_NEAR(surfaceArea(mesh), 24.0, 1e-12);
    EXPECT_NEAR(enclosedVolume(mesh), 8.0, 1e-12);
  }
}

TEST(CubeSurfaceMesh, EverySymmetryOfTheCubeKeepsTheTriangulationWhenEven)
{
  const TriangleMesh mesh = cubeSurfaceMesh(4);
  const auto         key = [](const Vector3 & p) {
    return std::array<long, 3>{ std::lround(4 * p[0]), std::lround(4 * p[1]), std::lround(4 * p[2]) };
  };
  std::map<std::array<long, 3>, int> vertexAt;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
  {
    vertexAt[key(mesh.vertices[v])] = static_cast<int>(v);
  }
  const auto sorted = [](Triangle triangle) {
    std::sort(triangle.begin(), triangle.end());
    return triangle;
  };
  std::map<Triangle, int> triangles;
  for (const Triangle & triangle : mesh.triangles)
  {
    ++triangles[sorted(triangle)];
  }
  // Generators of the 48 symmetries: cyclic exchange, exchange of two axes, reflection.
  const auto images = { +[](const Vector3 & p) { return Vector3(p[1], p[2], p[0]); },
                        +[](const Vector3 & p) { return Vector3(p[1], p[0], p[2]); },
                        +[](const Vector3 & p) { return Vector3(-p[0], p[1], p[2]); } };
  for (const auto & image : images)
  {
    for (const Triangle & triangle : mesh.triangles)
    {
      Triangle moved{};
      for (std::size_t corner = 0; corner < 3; ++corner)
      {
        moved[corner] = vertexAt.at(key(image(mesh.vertices[static_cast<std::size_t>(triangle[corner])])));
      }
      EXPECT_EQ(triangles.count(sorted(moved)), 1U);
    }
  }
}

TEST(CubeShellMaps, ClosedFormIsTheSameForNodesAtTheSamePlaceOfTheirShell)
{
  // Shell 2 (3 quads a side) and shell 5 (9 quads a side): every third node of the larger one.
  const CubeLattice lattice(5);
  const Positions   small = cubeShellMap(lattice, 2);
  const Positions   large = cubeShellMap(lattice, 5);
  const auto        smallNodes = lattice.nodesOfShell(2);
  const auto        largeNodes = lattice.nodesOfShell(5);
  for (std::size_t m = 0; m < smallNodes.size(); ++m)
  {
    const auto at = lattice.nodeIndex(smallNodes[m]);
    const auto node = lattice.nodeNumber(3 * (at[0] - 3), 3 * (at[1] - 3), 3 * (at[2] - 3));
    const auto found = std::lower_bound(largeNodes.begin(), largeNodes.end(), node);
    ASSERT_TRUE(found != largeNodes.end() && *found == node);
    EXPECT_LT((small[m] - large[static_cast<std::size_t>(found - largeNodes.begin())]).norm(), 1e-14);
  }
}

TEST(CubeShellMaps, IndicesGrowWithTheDirections)
{
  const CubeLattice lattice(3);
  const auto        nodes = lattice.nodesOfShell(3);
  for (const CubeShellMethod method : { CubeShellMethod::closedForm, CubeShellMethod::conformalMoser })
  {
    CubeShellMapOptions options;
    options.method = method;
    const Positions directions = cubeShellMap(lattice, 3, options);
    for (std::size_t m = 0; m < nodes.size(); ++m)
    {
      EXPECT_NEAR(directions[m].norm(), 1.0, 1e-12);
      EXPECT_GT(directions[m].dot(lattice.position(nodes[m])), 0.8);
    }
  }
}

TEST(CubeShellMaps, ClosedFormQuadsHaveEqualSolidAngles)
{
  // Exact in the continuum. Straight sides instead of curved ones cost little except at the face's centre, where the
  // map has a corner: the middle quadrilateral loses a fifth of its area at any resolution.
  const CubeLattice lattice(10);
  EXPECT_LT(areaErrorRms(lattice, 10, cubeShellMap(lattice, 10)), 0.02);
  EXPECT_LT(areaErrorRms(lattice, 1, cubeShellMap(lattice, 1)), 1e-12);
}

TEST(CubeShellMaps, ThePapersWayAgreesWithTheClosedForm)
{
  const CubeLattice   lattice(6);
  CubeShellMapOptions paper;
  paper.method = CubeShellMethod::conformalMoser;
  for (const int shell : { 1, 3, 6 })
  {
    const Positions closed = cubeShellMap(lattice, shell);
    const Positions moser = cubeShellMap(lattice, shell, paper);
    ASSERT_EQ(closed.size(), moser.size());
    double largestAngle = 0.0;
    for (std::size_t m = 0; m < closed.size(); ++m)
    {
      largestAngle = std::max(largestAngle, std::acos(std::min(1.0, closed[m].dot(moser[m]))) * 180.0 / pi);
    }
    EXPECT_LT(largestAngle, 5.0) << shell;
    EXPECT_LT(areaErrorRms(lattice, shell, moser), 0.05) << shell;
  }
}

TEST(CubeShellMaps, ShellOutOfRangeIsRefused)
{
  const CubeLattice   lattice(3);
  CubeShellMapOptions paper;
  paper.method = CubeShellMethod::conformalMoser;
  EXPECT_THROW(static_cast<void>(cubeShellMap(lattice, 0)), InvalidInput);
  EXPECT_THROW(static_cast<void>(cubeShellMap(lattice, 4, paper)), InvalidInput);
}

TEST(CubeShellMaps, NegativeSubdivisionsAreRefused)
{
  CubeShellMapOptions options;
  options.subdivisions = -1;
  EXPECT_THROW(static_cast<void>(cubeShellMap(CubeLattice(3), 2, options)), InvalidInput);
}

TEST(CubeSurfaceMesh, NoSquaresAreRefused)
{
  EXPECT_THROW(static_cast<void>(cubeSurfaceMesh(0)), InvalidInput);
}
