// Cubics: round-off (1e-13); the order is fitted, within 0.1 of 4.
#include "LatticeRefinement.h"

#include "TestLattices.h"
#include "moserhex/Analytic/ObservedOrder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

using namespace moserhex;
using namespace moserhex::testing;

namespace
{
/** Polynomial of this degree in every variable, full tensor product. */
Vector3
tensorPolynomial(int degree, const Vector3 & p)
{
  Vector3 sum = Vector3::Zero();
  for (int a = 0; a <= degree; ++a)
  {
    for (int b = 0; b <= degree; ++b)
    {
      for (int c = 0; c <= degree; ++c)
      {
        const double term = std::pow(p[0], a) * std::pow(p[1], b) * std::pow(p[2], c);
        sum += term * Vector3(1.0 + a - b, 2.0 - c, std::cos(a + 2.0 * b + 3.0 * c));
      }
    }
  }
  return sum;
}

template <typename TMap>
double
largestError(int n, int finer, TMap map)
{
  const Positions fine = interpolateLattice(mappedLattice(n, map).nodes, n, finer);
  const Positions exact = mappedLattice(finer, map).nodes;
  EXPECT_EQ(fine.size(), exact.size());
  double largest = 0.0;
  for (std::size_t node = 0; node < exact.size(); ++node)
  {
    largest = std::max(largest, (fine[node] - exact[node]).norm());
  }
  return largest;
}
} // namespace

TEST(LatticeRefinement, CubicsAreExact)
{
  for (const auto & [n, finer] : { std::pair{ 4, 5 }, std::pair{ 4, 8 }, std::pair{ 6, 12 }, std::pair{ 7, 20 } })
  {
    EXPECT_LT(largestError(n, finer, [](const Vector3 & p) { return tensorPolynomial(3, p); }), 1e-12) << n;
  }
}

TEST(LatticeRefinement, FewNodesAreExactForWhatTheyCanHold)
{
  EXPECT_LT(largestError(2, 7, [](const Vector3 & p) { return tensorPolynomial(1, p); }), 1e-13);
  EXPECT_LT(largestError(3, 8, [](const Vector3 & p) { return tensorPolynomial(2, p); }), 1e-13);
}

TEST(LatticeRefinement, ErrorIsOfFourthOrder)
{
  const auto smooth = [](const Vector3 & p) {
    return Vector3(std::sin(3.0 * p[0]) * p[1], std::exp(p[1] - p[2]), std::cos(2.0 * p[2] + p[0] * p[1]));
  };
  std::vector<double> sizes;
  std::vector<double> errors;
  for (const int n : { 17, 21, 25, 33 })
  {
    sizes.push_back(1.0 / (n - 1.0));
    errors.push_back(largestError(n, 2 * n - 1, smooth));
  }
  EXPECT_NEAR(analytic::observedOrder(sizes, errors), 4.0, 0.1);
}

TEST(LatticeRefinement, NodesThatStayKeepTheirPlaces)
{
  const HexMesh mesh = shaken(regularLattice(5), 0.1, 1);
  EXPECT_EQ(interpolateLattice(mesh.nodes, 5, 5), mesh.nodes);
  const HexMesh fine{ 9, interpolateLattice(mesh.nodes, 5, 9) };
  for (int k = 0; k < 5; ++k)
  {
    for (int j = 0; j < 5; ++j)
    {
      for (int i = 0; i < 5; ++i)
      {
        EXPECT_EQ(fine.nodes[fine.nodeNumber(2 * i, 2 * j, 2 * k)], mesh.nodes[mesh.nodeNumber(i, j, k)]);
      }
    }
  }
}

TEST(LatticeRefinement, MovedLatticeGivesTheMovedResult)
{
  HexMesh         mesh = shaken(regularLattice(6), 0.1, 2);
  const Positions before = interpolateLattice(mesh.nodes, 6, 11);
  Matrix3         matrix;
  matrix << 1.0, 0.3, -0.2, 0.1, 0.8, 0.25, -0.15, 0.2, 1.1;
  for (Vector3 & node : mesh.nodes)
  {
    node = matrix * node + Vector3(10.0, -20.0, 5.0);
  }
  const Positions after = interpolateLattice(mesh.nodes, 6, 11);
  for (std::size_t node = 0; node < before.size(); ++node)
  {
    EXPECT_LT((after[node] - matrix * before[node] - Vector3(10.0, -20.0, 5.0)).norm(), 1e-13 * 20.0);
  }
}

TEST(RefinementLevels, LeadFromCoarseToFineByAtMostDoubling)
{
  for (int coarse = 2; coarse <= 20; ++coarse)
  {
    for (int fine = coarse; fine <= 130; ++fine)
    {
      const std::vector<int> levels = refinementLevels(coarse, fine);
      ASSERT_EQ(levels.front(), coarse) << fine;
      ASSERT_EQ(levels.back(), fine) << coarse;
      ASSERT_EQ(levels.size() == 1, coarse == fine);
      for (std::size_t l = 1; l < levels.size(); ++l)
      {
        ASSERT_GT(levels[l], levels[l - 1]) << coarse << " " << fine;
        ASSERT_LE(levels[l], 2 * levels[l - 1]) << coarse << " " << fine;
        ASSERT_TRUE(l + 1 == levels.size() || levels[l] % 2 == 0) << coarse << " " << fine;
      }
    }
  }
}

TEST(RefinementLevels, AreNoMoreThanNeeded)
{
  EXPECT_EQ(refinementLevels(6, 12), (std::vector<int>{ 6, 12 }));
  EXPECT_EQ(refinementLevels(6, 20), (std::vector<int>{ 6, 10, 20 }));
  EXPECT_EQ(refinementLevels(6, 64), (std::vector<int>{ 6, 8, 16, 32, 64 }));
}
