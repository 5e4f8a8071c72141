#include "moserhex/CubeTransfer/CubeMap.h"

#include "../src/TrilinearCell.h"
#include "TestMeshes.h"
#include "moserhex/Analytic/Refusals.h"
#include "moserhex/Analytic/SurfaceShapes.h"
#include "moserhex/Common/Random.h"
#include "moserhex/Quality/JacobianBounds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

// Closed forms to round-off: 1e-13 in the cube, 1e-10 of a cell's edge for the bent bar. Comparisons of places and of
// numbers of threads: to the last bit.

using namespace moserhex;

namespace
{

Vector3
randomInCube(Random & random)
{
  const double x = random.uniform();
  const double y = random.uniform();
  return { x, y, random.uniform() };
}

/** The largest error of position(find(position(c))) and of cube coordinates, over random places. */
void
expectRoundTrip(const HexMesh & mesh, double edge, int count)
{
  const CubeMap map(mesh);
  Random        random(7);
  for (int n = 0; n < count; ++n)
  {
    const Vector3 c = randomInCube(random);
    const Vector3 p = map.position(map.place(c));
    const auto    found = map.find(p);
    ASSERT_TRUE(found) << "cube coordinates " << c.transpose();
    EXPECT_LE((map.position(*found) - p).norm(), 1e-10 * edge) << c.transpose();
    EXPECT_LE((map.cubeCoordinates(*found) - c).norm(), 1e-10) << c.transpose();
  }
}

/** Points of the 27 kinds of places of a lattice: nodes, edges, faces, inner points of cells. */
template <typename TBody>
void
forHalfSteps(int n, const TBody & body)
{
  for (int k = 0; k <= 2 * (n - 1); ++k)
  {
    for (int j = 0; j <= 2 * (n - 1); ++j)
    {
      for (int i = 0; i <= 2 * (n - 1); ++i)
      {
        body(std::array<int, 3>{ { i, j, k } });
      }
    }
  }
}

} // namespace

TEST(CubeMap, OnTheUnitCubeCubeCoordinatesArePositions)
{
  const HexMesh mesh = analytic::cubeLattice(6, 0.2);
  const CubeMap map(mesh);
  Random        random(1);
  for (int n = 0; n < 1000; ++n)
  {
    const Vector3 p = randomInCube(random);
    const auto    found = map.find(p);
    ASSERT_TRUE(found);
    EXPECT_LE((map.cubeCoordinates(*found) - p).norm(), 1e-13);
    EXPECT_LE((map.position(map.place(p)) - p).norm(), 1e-13);
  }
}

TEST(CubeMap, AnAffineLatticeIsInvertedByTheAffineMap)
{
  Matrix3 columns;
  columns << 30.0, 4.0, -7.0, -3.0, 22.0, 5.0, 6.0, 1.0, 41.0;
  const Vector3 origin(-110.0, 35.0, 720.0);
  const int     n = 7;
  const HexMesh mesh =
    analytic::lattice(n, [&](const Vector3 & index) { return Vector3(origin + columns * (index / (n - 1))); });
  const CubeMap map(mesh);
  Random        random(2);
  for (int count = 0; count < 1000; ++count)
  {
    const Vector3 c = randomInCube(random);
    const auto    found = map.find(origin + columns * c);
    ASSERT_TRUE(found);
    EXPECT_LE((map.cubeCoordinates(*found) - c).norm(), 1e-12);
  }
}

TEST(CubeMap, ABentLatticeIsInverted)
{
  const HexMesh mesh = bentLattice(9);
  ASSERT_EQ(certifyCells(mesh).positive, mesh.cellCount());
  expectRoundTrip(mesh, 2.0, 5000);
}

TEST(CubeMap, APlaceNearAFlatCornerIsFound)
{
  const HexMesh mesh = flatCornerCell();
  ASSERT_EQ(certifyCells(mesh).positive, 1u);
  const CubeMap map(mesh);
  for (const double away : { 0.1, 1e-2, 1e-4, 1e-8, 0.0 })
  {
    for (const double along : { 0.0, 0.5, 1.0 })
    {
      const Vector3 c(1.0 - away, 1.0 - along * away, away);
      const Vector3 p = map.position(map.place(c));
      const auto    found = map.find(p);
      ASSERT_TRUE(found) << c.transpose();
      EXPECT_LE((map.position(*found) - p).norm(), 1e-11);
    }
  }
}

TEST(CubeMap, PointsOnFacesEdgesAndNodesBelongToTheCellOfTheLowestNumber)
{
  for (const HexMesh & mesh : { analytic::cubeLattice(4, 0.7), bentLattice(4) })
  {
    const CubeMap map(mesh);
    forHalfSteps(4, [&](const std::array<int, 3> & halves) {
      // In half cells: an odd number is the middle of cell (n - 1) / 2, an even one lies between n / 2 - 1 and n / 2.
      std::size_t expected = 0;
      Vector3     c;
      for (int axis = 2; axis >= 0; --axis)
      {
        expected = 3 * expected + static_cast<std::size_t>(std::max(halves[static_cast<std::size_t>(axis)] - 1, 0) / 2);
        c[axis] = halves[static_cast<std::size_t>(axis)] / 6.0;
      }
      const auto found = map.find(map.position(map.place(c)));
      ASSERT_TRUE(found) << c.transpose();
      EXPECT_EQ(found->cell, expected) << c.transpose();
      EXPECT_LE((map.cubeCoordinates(*found) - c).norm(), 1e-12) << c.transpose();
    });
  }
}

TEST(CubeMap, NodesAreFoundToTheLastBit)
{
  const HexMesh mesh = bentLattice(5);
  const CubeMap map(mesh);
  for (const Vector3 & node : mesh.nodes)
  {
    const auto found = map.find(node);
    ASSERT_TRUE(found);
    EXPECT_LE((map.position(*found) - node).norm(), 1e-13);
  }
}

TEST(CubeMap, PointsAHairOutsideAreNotFoundAndThoseAHairInsideAre)
{
  const HexMesh mesh = bentLattice(5);
  const CubeMap map(mesh);
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double end : { 0.0, 1.0 })
    {
      for (const double u : { 0.13, 0.5, 0.77 })
      {
        Vector3 c(u, 0.9 - 0.7 * u, 0.31);
        c[axis] = end;
        Vector3 inner = c;
        inner[axis] = end == 0.0 ? 1e-3 : 1.0 - 1e-3;
        const Vector3 face = map.position(map.place(c));
        const Vector3 inwards = (map.position(map.place(inner)) - face).normalized();
        for (const double distance : { 1e-9, 1e-6, 1e-3, 0.1, 1.0 })
        {
          EXPECT_FALSE(map.find(face - distance * inwards)) << c.transpose() << " by " << distance;
          EXPECT_TRUE(map.find(face + distance * inwards)) << c.transpose() << " by " << distance;
        }
      }
    }
  }
}

TEST(CubeMap, FarPointsAndThoseThatAreNoNumbersAreNotFound)
{
  const HexMesh    mesh = bentLattice(4);
  const CubeMap    map(mesh);
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const Vector3 & p :
       { Vector3(1e9, 0, 0), Vector3(nan, 20, 105), Vector3(nan, nan, nan), Vector3(0, infinity, 0) })
  {
    EXPECT_FALSE(map.find(p));
  }
}

TEST(CubeMap, ThePlaceMovesWithTheMesh)
{
  const HexMesh mesh = bentLattice(5);
  const Matrix3 turn = analytic::rotation({ 1.0, 2.0, -1.0 }, 0.7);
  HexMesh       moved = mesh;
  for (Vector3 & node : moved.nodes)
  {
    node = 1e3 * (turn * node) + Vector3(5.0, -7.0, 11.0);
  }
  const CubeMap map(mesh);
  const CubeMap movedMap(moved);
  Random        random(3);
  for (int n = 0; n < 500; ++n)
  {
    const Vector3 p = map.position(map.place(randomInCube(random)));
    const auto    found = map.find(p);
    const auto    foundMoved = movedMap.find(1e3 * (turn * p) + Vector3(5.0, -7.0, 11.0));
    ASSERT_TRUE(found && foundMoved);
    EXPECT_LE((map.cubeCoordinates(*found) - movedMap.cubeCoordinates(*foundMoved)).norm(), 1e-11);
  }
}

TEST(CubeMap, ManyPointsAreFoundAsOneByOneWithAnyNumberOfThreads)
{
  const HexMesh mesh = bentLattice(6);
  const CubeMap map(mesh);
  Random        random(4);
  Positions     points;
  for (int n = 0; n < 3000; ++n)
  {
    points.push_back(Vector3(-30.0, 0.0, 95.0) + Vector3(75.0, 60.0, 30.0).cwiseProduct(randomInCube(random)));
  }
  const auto  one = map.find(points, 1);
  const auto  three = map.find(points, 3);
  std::size_t inside = 0;
  for (std::size_t n = 0; n < points.size(); ++n)
  {
    const auto alone = map.find(points[n]);
    ASSERT_EQ(one[n].has_value(), alone.has_value());
    ASSERT_EQ(one[n].has_value(), three[n].has_value());
    if (alone)
    {
      ++inside;
      EXPECT_EQ(one[n]->cell, alone->cell);
      EXPECT_EQ(one[n]->cell, three[n]->cell);
      EXPECT_EQ(one[n]->local, alone->local);
      EXPECT_EQ(one[n]->local, three[n]->local);
    }
  }
  EXPECT_GT(inside, 100u);
  EXPECT_LT(inside, 2900u);
}

TEST(CubeMap, TheShareOfRandomPointsInsideIsTheVolume)
{
  const HexMesh mesh = bentLattice(7);
  const CubeMap map(mesh);
  Vector3       lower = mesh.nodes.front();
  Vector3       upper = lower;
  for (const Vector3 & node : mesh.nodes)
  {
    lower = lower.cwiseMin(node);
    upper = upper.cwiseMax(node);
  }
  double volume = 0.0;
  for (const double cell : cellVolumes(mesh))
  {
    volume += cell;
  }
  const double share = volume / (upper - lower).prod();
  Random       random(5);
  const int    points = 40000;
  int          inside = 0;
  for (int n = 0; n < points; ++n)
  {
    inside += map.find(lower + (upper - lower).cwiseProduct(randomInCube(random))) ? 1 : 0;
  }
  EXPECT_NEAR(inside / static_cast<double>(points), share, 4.0 * std::sqrt(share * (1.0 - share) / points));
}

TEST(CubeMap, EveryInnerPointIsInExactlyOneCell)
{
  const HexMesh mesh = bentLattice(5);
  const CubeMap map(mesh);
  Random        random(11);
  for (int n = 0; n < 2000; ++n)
  {
    const Vector3            p = map.position(map.place(randomInCube(random)));
    std::vector<std::size_t> holding;
    for (std::size_t cell = 0; cell < mesh.cellCount(); ++cell)
    {
      if (trilinearInverse(cellCorners(mesh, cell), p, 1e-12))
      {
        holding.push_back(cell);
      }
    }
    ASSERT_EQ(holding.size(), 1u) << p.transpose();
    EXPECT_EQ(map.find(p)->cell, holding.front());
  }
}

TEST(CubeMap, CubeCoordinatesOutsideTheCubeAreRefused)
{
  const HexMesh mesh = analytic::cubeLattice(3);
  const CubeMap map(mesh);
  for (const Vector3 & c : { Vector3(1.0 + 1e-12, 0.5, 0.5),
                             Vector3(0.5, -1e-300, 0.5),
                             Vector3(0.5, 0.5, std::numeric_limits<double>::quiet_NaN()) })
  {
    EXPECT_NE(analytic::messageOf([&] { (void)map.place(c); }).find("outside [0,1]^3"), std::string::npos);
  }
}

TEST(CubeMap, AMeshThatIsNoneIsRefused)
{
  HexMesh mesh = analytic::cubeLattice(3);
  mesh.nodes.pop_back();
  EXPECT_NE(analytic::messageOf([&] { const CubeMap map(mesh); }).find("must be n^3 nodes"), std::string::npos);
}
