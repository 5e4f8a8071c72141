// Boxes to round-off, arcs with order 2 within 0.1.
#include "moserhex/Deformation/LatticeLines.h"

#include "TestLattices.h"
#include "moserhex/Analytic/ObservedOrder.h"
#include "moserhex/Analytic/Refusals.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace moserhex;

TEST(LatticeLines, TheThicknessOfABoxIsItsSize)
{
  const Vector3   size(24.0, 8.0, 5.0);
  const HexMesh   box = boxLattice(6, size);
  const Positions lengths = latticeLineLengths(box);
  for (int k = 1; k < 5; ++k)
  {
    EXPECT_LE((lengths[box.nodeNumber(2, 3, k)] - size).norm(), 1e-13);
  }
}

TEST(LatticeLines, LinesAlongTheSurfaceHaveNoThickness)
{
  const HexMesh   box = boxLattice(5, { 24.0, 8.0, 5.0 });
  const Positions lengths = latticeLineLengths(box);
  const Vector3   onFace = lengths[box.nodeNumber(2, 0, 3)];
  EXPECT_TRUE(std::isnan(onFace[0]) && std::isnan(onFace[2]));
  EXPECT_NEAR(onFace[1], 8.0, 1e-13);
  EXPECT_TRUE(lengths[box.nodeNumber(4, 0, 3)].array().isNaN().all()); // on an edge of the cube
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
    EXPECT_NEAR(lengths[wedge.nodeNumber(1, 2, k)][2], 22.0, 1e-12);
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
    errors.push_back(21.0 - latticeLineLengths(arc)[arc.nodeNumber(0, 1, 1)][0]);
  }
  EXPECT_NEAR(analytic::observedOrder(sizes, errors), 2.0, 0.1);
}

TEST(LatticeLines, PaddingIsRefused)
{
  const HexMesh padded = analytic::paddedLattice(4, 1, [](const Vector3 & index) { return index; });
  EXPECT_NE(analytic::messageOf([&] { (void)latticeLineLengths(padded); }), "accepted");
}
