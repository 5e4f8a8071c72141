// Boxes to round-off, arcs with order 2 within 0.1.
#include "moserhex/Deformation/LatticeLines.h"

#include "TestLattices.h"
#include "moserhex/Analytic/ObservedOrder.h"
#include "moserhex/Analytic/Refusals.h"

#include <gtest/gtest.h>

using namespace moserhex;

TEST(LatticeLines, TheThicknessOfABoxIsItsSize)
{
  const Vector3 size(24.0, 8.0, 5.0);
  for (const Vector3 & length : latticeLineLengths(boxLattice(6, size)))
  {
    EXPECT_LE((length - size).norm(), 1e-13);
  }
}

TEST(LatticeLines, EveryLineHasItsOwnLength)
{
  // Wedge: the height along k is 1 + i + 10 j.
  const HexMesh wedge =
    analytic::lattice(4, [](const Vector3 & c) { return Vector3(c[0], c[1], (1 + c[0] + 10 * c[1]) * c[2] / 3.0); });
  const Positions lengths = latticeLineLengths(wedge);
  for (int k = 0; k < 4; ++k)
  {
    EXPECT_NEAR(lengths[wedge.nodeNumber(2, 1, k)][2], 13.0, 1e-12);
    EXPECT_NEAR(lengths[wedge.nodeNumber(3, 0, k)][2], 4.0, 1e-12);
  }
}

TEST(LatticeLines, ArcsAreMeasuredWithOrderTwo)
{
  std::vector<double> sizes;
  std::vector<double> errors;
  for (const int n : { 4, 8, 16, 32 })
  {
    const HexMesh arc = analytic::lattice(n, [n](const Vector3 & c) {
      const double angle = c[0] / (n - 1);
      return Vector3((20 + c[1]) * std::sin(angle), (20 + c[1]) * std::cos(angle), c[2]);
    });
    sizes.push_back(1.0 / (n - 1));
    errors.push_back(20.0 - latticeLineLengths(arc)[0][0]);
  }
  EXPECT_NEAR(analytic::observedOrder(sizes, errors), 2.0, 0.1);
}

TEST(LatticeLines, PaddingIsRefused)
{
  const HexMesh padded = analytic::paddedLattice(4, 1, [](const Vector3 & index) { return index; });
  EXPECT_NE(analytic::messageOf([&] { (void)latticeLineLengths(padded); }), "accepted");
}
