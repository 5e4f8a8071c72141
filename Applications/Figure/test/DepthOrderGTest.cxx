// Exact: the order. Two roads: what is drawn last at a point against the nearest facet there, by a search of all.
#include "DepthOrder.h"

#include "Facets.h"
#include "moserhex/Analytic/Lattices.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

using namespace moserhex;
using namespace moserhex::app;

namespace
{

SeenFacet
square(double left, double bottom, double side, const std::vector<double> & nearness)
{
  return { { { left, bottom }, { left + side, bottom }, { left + side, bottom + side }, { left, bottom + side } },
           nearness };
}

/** Nearness of a facet at a point, by the triangles around its first corner; nothing where it does not reach. */
std::optional<double>
nearnessAt(const SeenFacet & facet, const Point2 & p)
{
  const auto cross = [](const Point2 & a, const Point2 & b) { return a[0] * b[1] - a[1] * b[0]; };
  for (std::size_t corner = 2; corner < facet.outline.size(); ++corner)
  {
    const std::array<std::size_t, 3> t{ 0, corner - 1, corner };
    const auto                       at = [&](std::size_t i) { return facet.outline[t[i]]; };
    const double                     all = cross(at(1) - at(0), at(2) - at(0));
    std::array<double, 3>            weights{};
    for (std::size_t i = 0; i < 3; ++i)
    {
      weights[i] = cross(at((i + 2) % 3) - at((i + 1) % 3), p - at((i + 1) % 3)) / all;
    }
    if (*std::min_element(weights.begin(), weights.end()) > 1e-3) // not at the edge of two facets
    {
      return weights[0] * facet.nearness[t[0]] + weights[1] * facet.nearness[t[1]] + weights[2] * facet.nearness[t[2]];
    }
  }
  return {};
}

/** Points at which another facet than the nearest is drawn last. */
int
wrongPoints(const std::vector<SeenFacet> & facets, int & looked)
{
  const std::vector<std::size_t> order = drawingOrder(facets);
  std::vector<std::size_t>       sorted = order;
  std::sort(sorted.begin(), sorted.end());
  std::vector<std::size_t> all(facets.size());
  std::iota(all.begin(), all.end(), std::size_t{ 0 });
  EXPECT_EQ(sorted, all);

  std::mt19937                           random(7);
  std::uniform_real_distribution<double> anywhere(-1.5, 1.5);
  int                                    wrong = 0;
  for (int sample = 0; sample < 4000; ++sample)
  {
    const Point2 p(anywhere(random), anywhere(random));
    double       nearest = std::numeric_limits<double>::lowest();
    double       drawnLast = nearest;
    for (const std::size_t facet : order)
    {
      if (const auto nearness = nearnessAt(facets[facet], p))
      {
        drawnLast = *nearness;
        nearest = std::max(nearest, *nearness);
        ++looked;
      }
    }
    wrong += drawnLast < nearest - 1e-9 ? 1 : 0;
  }
  return wrong;
}

/** A bowl: a plate of the unit cube's lattice bent upwards, so that near parts cover far ones. */
HexMesh
bowl(int n)
{
  return analytic::lattice(n, [n](const Vector3 & index) {
    const Vector3 c = 2.0 * index / (n - 1) - Vector3::Ones();
    return Vector3(c[0], c[1], 0.2 * c[2] + 1.2 * (c[0] * c[0] + c[1] * c[1]) - 1.0);
  });
}

std::vector<std::size_t>
allCells(const HexMesh & mesh)
{
  std::vector<std::size_t> cells(mesh.cellCount());
  std::iota(cells.begin(), cells.end(), std::size_t{ 0 });
  return cells;
}

} // namespace

TEST(DepthOrder, NearFacetsComeLastThoughTheirMiddleIsFarther)
{
  // A large slanted square, whose middle is nearer than the small one's, lies behind it where they overlap.
  const std::vector<SeenFacet> facets{ square(0.0, 0.0, 0.2, { 1, 1, 1, 1 }),
                                       square(0.0, 0.0, 10.0, { 0, 10, 10, 0 }) };
  EXPECT_EQ(drawingOrder(facets), (std::vector<std::size_t>{ 1, 0 }));
  EXPECT_EQ(drawingOrder({ facets[1], facets[0] }), (std::vector<std::size_t>{ 0, 1 }));
}

TEST(DepthOrder, FacetsThatDoNotOverlapGoByDepthAndThenByNumber)
{
  const std::vector<SeenFacet> facets{ square(4.0, 0.0, 1.0, { 2, 2, 2, 2 }),
                                       square(2.0, 0.0, 1.0, { 1, 1, 1, 1 }),
                                       square(0.0, 0.0, 1.0, { 2, 2, 2, 2 }),
                                       square(1.0, 0.0, 1.0, { 2, 2, 2, 2 }) }; // touches the one before
  EXPECT_EQ(drawingOrder(facets), (std::vector<std::size_t>{ 1, 0, 2, 3 }));
  EXPECT_TRUE(drawingOrder({}).empty());
}

TEST(DepthOrder, FacetsThatCoverEachOtherInACircleAreAllDrawn)
{
  // Three bars, each above the next at one end and below the one before at the other.
  std::vector<SeenFacet> bars;
  for (int bar = 0; bar < 3; ++bar)
  {
    const double a = bar * 2.0 * pi / 3.0;
    const auto   turned = [a](double x, double y) {
      return Point2(std::cos(a) * x - std::sin(a) * y, std::sin(a) * x + std::cos(a) * y);
    };
    bars.push_back({ { turned(-2, -0.7), turned(2, -0.7), turned(2, -0.5), turned(-2, -0.5) }, { 0, 1, 1, 0 } });
  }
  const std::vector<std::size_t> order = drawingOrder(bars);
  EXPECT_EQ(order, (std::vector<std::size_t>{ 0, 2, 1 })) << "the first number breaks the circle, then as they cover";
}

TEST(DepthOrder, WhatIsDrawnLastIsNearestFromEverySide)
{
  const HexMesh             mesh = bowl(9);
  const UnstructuredHexMesh cells = unstructured(mesh);
  for (const double azimuth : { 0.0, 30.0, 45.0, 200.0 })
  {
    for (const double elevation : { -50.0, 0.0, 20.0, 60.0, 90.0 })
    {
      int looked = 0;
      EXPECT_EQ(wrongPoints(facesSeen(cells, allCells(mesh), cameraFrom(azimuth, elevation)), looked), 0)
        << azimuth << ' ' << elevation;
      EXPECT_GT(looked, 400);
    }
  }
}

TEST(DepthOrder, WhatIsDrawnLastIsNearestInAnOpenedShell)
{
  const HexMesh            mesh = analytic::lattice(8, [](const Vector3 & index) { // a ball
    const Vector3 c = (2.0 * index / 7.0 - Vector3::Ones());
    return c.isZero() ? c : Vector3(c * (c.cwiseAbs().maxCoeff() / c.norm()));
  });
  const Camera             camera = cameraFrom(30.0, 25.0);
  const Positions          places = cellPlaces(mesh);
  std::vector<std::size_t> shell;
  for (std::size_t cell = 0; cell < mesh.cellCount(); ++cell)
  {
    if ((places[cell] - Vector3::Constant(0.5)).cwiseAbs().maxCoeff() > 0.4)
    {
      shell.push_back(cell);
    }
  }
  const std::vector<std::size_t> opened = withoutNearestOctant(shell, places, camera);
  EXPECT_EQ(shell.size() - opened.size(), 19U); // 27 - 8 cells of the shell in an eighth without the middle layers
  int looked = 0;
  EXPECT_EQ(wrongPoints(facesSeen(unstructured(mesh), opened, camera), looked), 0);
  EXPECT_GT(looked, 1000);
}
