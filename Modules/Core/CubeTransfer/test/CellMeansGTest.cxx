#include "moserhex/CubeTransfer/CellMeans.h"

#include "TestMeshes.h"
#include "moserhex/Analytic/ObservedOrder.h"
#include "moserhex/Analytic/Refusals.h"

#include <gtest/gtest.h>

#include <cmath>

// Closed forms to round-off: 1e-12 of the values; orders within 0.1 of 2 q.

using namespace moserhex;

namespace
{

double
linear(const Vector3 & p)
{
  return 3.0 + Vector3(0.5, -2.0, 0.25).dot(p);
}

/** Integral of x over a trilinear cell over its volume, by the divergence theorem on its faces: another road than
 * quadrature in the cell. The faces are bilinear, so x^2 n is of degree 4 in each of their two parameters. */
double
meanOfX(const HexCorners & x)
{
  constexpr int    faces[6][4] = { { 0, 3, 2, 1 }, { 4, 5, 6, 7 }, { 0, 1, 5, 4 },
                                   { 1, 2, 6, 5 }, { 2, 3, 7, 6 }, { 3, 0, 4, 7 } };
  constexpr double third = 0.77459666924148337704; // sqrt(3/5): three points, exact to degree 5
  constexpr double points[3] = { 0.5 - 0.5 * third, 0.5, 0.5 + 0.5 * third };
  constexpr double weights[3] = { 5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0 };
  double           moment = 0.0;
  double           volume = 0.0;
  for (const auto & f : faces)
  {
    for (int a = 0; a < 3; ++a)
    {
      for (int b = 0; b < 3; ++b)
      {
        const double  u = points[a];
        const double  v = points[b];
        const Vector3 p = (1 - u) * (1 - v) * x[f[0]] + u * (1 - v) * x[f[1]] + u * v * x[f[2]] + (1 - u) * v * x[f[3]];
        const Vector3 pu = (1 - v) * (x[f[1]] - x[f[0]]) + v * (x[f[2]] - x[f[3]]);
        const Vector3 pv = (1 - u) * (x[f[3]] - x[f[0]]) + u * (x[f[2]] - x[f[1]]);
        const double  normal = pu[1] * pv[2] - pu[2] * pv[1]; // x component
        moment += weights[a] * weights[b] * 0.5 * p[0] * p[0] * normal;
        volume += weights[a] * weights[b] * p[0] * normal;
      }
    }
  }
  return moment / volume;
}

} // namespace

TEST(CellMeans, ALinearFunctionsMeansAreItsValuesAtTheCentroids)
{
  const HexMesh mesh = bentLattice(5);
  const auto    means = cellMeans(mesh, [](const Vector3 & p) { return p[0]; }, { 2, 1 });
  ASSERT_EQ(means.size(), mesh.cellCount());
  for (std::size_t cell = 0; cell < means.size(); ++cell)
  {
    EXPECT_NEAR(means[cell], meanOfX(cellCorners(mesh, cell)), 1e-12 * 50.0) << "cell " << cell;
  }
}

TEST(CellMeans, TwoPointsAreAsGoodAsManyForLinearFunctions)
{
  const HexMesh mesh = bentLattice(4);
  const auto    two = cellMeans(mesh, linear, { 2, 1 });
  const auto    nine = cellMeans(mesh, linear, { 9, 1 });
  for (std::size_t cell = 0; cell < two.size(); ++cell)
  {
    EXPECT_NEAR(two[cell], nine[cell], 1e-12 * 200.0);
  }
}

TEST(CellMeans, TheMeanOfAConstantIsTheConstant)
{
  for (const double mean : cellMeans(bentLattice(4), [](const Vector3 &) { return -7.25; }))
  {
    EXPECT_NEAR(mean, -7.25, 1e-14);
  }
}

TEST(CellMeans, MeansInTheOrderOfTheCells)
{
  const auto means =
    cellMeans(analytic::cubeLattice(4), [](const Vector3 & p) { return p[0] + 10 * p[1] + 100 * p[2]; });
  for (std::size_t cell = 0; cell < means.size(); ++cell)
  {
    EXPECT_NEAR(means[cell], 55.5 + cell % 3 + 10.0 * (cell / 3 % 3) + 100.0 * (cell / 9), 1e-12);
  }
}

TEST(CellMeans, APolynomialOfDegreeTwoQMinusOneIsExactInACube)
{
  const HexMesh mesh = analytic::cubeLattice(2);
  for (int q = 2; q <= 5; ++q)
  {
    const double mean =
      cellMeans(mesh, [q](const Vector3 & p) { return std::pow(p[0], 2 * q - 1) * p[1] * p[2]; }, { q, 1 }).front();
    EXPECT_NEAR(mean, 0.25 / (2 * q), 1e-14);
  }
}

TEST(CellMeans, TheErrorFallsWithTwiceTheNumberOfPoints)
{
  // exp(x / 4) over cells of edge h: mean = exp(a / 4) (exp(h / 4) - 1) / (h / 4)
  for (const int q : { 2, 3 })
  {
    std::vector<double> sizes;
    std::vector<double> errors;
    for (const int cells : { 2, 3, 4, 6 })
    {
      const double h = 12.0 / cells;
      const auto   means = cellMeans(
        analytic::cubeLattice(cells + 1, h), [](const Vector3 & p) { return std::exp(p[0] / 4.0); }, { q, 1 });
      double largest = 0.0;
      for (int i = 0; i < cells; ++i)
      {
        const double exact = std::exp(i * h / 4.0) * std::expm1(h / 4.0) / (h / 4.0);
        largest = std::max(largest, std::abs(means[static_cast<std::size_t>(i)] / exact - 1.0));
      }
      sizes.push_back(h);
      errors.push_back(largest);
    }
    EXPECT_NEAR(analytic::observedOrder(sizes, errors), 2.0 * q, 0.1) << q << " points";
  }
}

TEST(CellMeans, TheSameBytesForAnyNumberOfThreads)
{
  const HexMesh mesh = bentLattice(8);
  const auto    f = [](const Vector3 & p) { return std::sin(p[0]) * p[1] + p[2]; };
  EXPECT_EQ(cellMeans(mesh, f, { 3, 1 }), cellMeans(mesh, f, { 3, 3 }));
  EXPECT_EQ(nodeSamples(mesh, f, 1), nodeSamples(mesh, f, 3));
}

TEST(CellMeans, PointsOutOfRangeAreRefused)
{
  const HexMesh mesh = analytic::cubeLattice(2);
  for (const int q : { -1, 0, 1, 49 })
  {
    EXPECT_NE(analytic::messageOf([&] {
                (void)cellMeans(mesh, linear, { q, 1 });
              }).find("points per axis, need 2 to 48"),
              std::string::npos);
  }
}

TEST(CellMeans, ACellWithoutPositiveVolumeIsRefused)
{
  HexMesh mesh = analytic::cubeLattice(3);
  for (Vector3 & node : mesh.nodes)
  {
    node[0] = -node[0];
  }
  EXPECT_EQ(analytic::messageOf([&] { (void)cellMeans(mesh, linear); }), "cell means: cell 0 has no positive volume");
}

TEST(CellMeans, AMeshThatIsNoneIsRefused)
{
  HexMesh mesh = analytic::cubeLattice(3);
  mesh.nodes.pop_back();
  EXPECT_NE(analytic::messageOf([&] { (void)cellMeans(mesh, linear); }), "accepted");
  EXPECT_NE(analytic::messageOf([&] { (void)nodeSamples(mesh, linear); }), "accepted");
}

TEST(NodeSamples, AreTheFunctionAtTheNodes)
{
  const HexMesh mesh = bentLattice(3);
  const auto    samples = nodeSamples(mesh, linear);
  ASSERT_EQ(samples.size(), mesh.nodes.size());
  for (std::size_t node = 0; node < samples.size(); ++node)
  {
    EXPECT_EQ(samples[node], linear(mesh.nodes[node]));
  }
}
