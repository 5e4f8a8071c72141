// Round-off: lengths of lines in cubes. Exact: how many there are.
#include "MeshCut.h"
#include "moserhex/Analytic/Lattices.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace moserhex;
using namespace moserhex::app;

namespace
{

double
lengthOf(const std::vector<PlaneLine> & lines)
{
  double length = 0.0;
  for (const PlaneLine & line : lines)
  {
    for (std::size_t p = 1; p < line.size(); ++p)
    {
      length += std::hypot(line[p][0] - line[p - 1][0], line[p][1] - line[p - 1][1]);
    }
  }
  return length;
}

} // namespace

TEST(MeshCut, OfACubeIsItsSquareAndItsShells)
{
  const HexMesh mesh = analytic::cubeLattice(6);
  for (const int axis : { 0, 1, 2 })
  {
    const MeshCut cut = cutMesh(mesh, { axis, 2.5 });
    ASSERT_EQ(cut.boundary.size(), 1u);
    EXPECT_EQ(cut.boundary[0].front(), cut.boundary[0].back());
    EXPECT_NEAR(lengthOf(cut.boundary), 20.0, 1e-12);
    ASSERT_EQ(cut.shells.size(), 2u);
    EXPECT_NEAR(lengthOf(cut.shells.at(1)), 4.0, 1e-12);
    EXPECT_NEAR(lengthOf(cut.shells.at(2)), 12.0, 1e-12);
    EXPECT_NEAR(lengthOf(cut.inner), 2.0 * 6.0 * 5.0 - 20.0 - 12.0 - 4.0, 1e-12);
  }
}

TEST(MeshCut, ThroughNodesIsStillOneLine)
{
  const MeshCut cut = cutMesh(analytic::cubeLattice(6), { 2, 2.0 });
  ASSERT_EQ(cut.boundary.size(), 1u);
  EXPECT_NEAR(lengthOf(cut.boundary), 20.0, 1e-12);
}

TEST(MeshCut, BesideTheMeshIsEmpty)
{
  const MeshCut cut = cutMesh(analytic::cubeLattice(4), { 0, 7.0 });
  EXPECT_TRUE(cut.boundary.empty());
  EXPECT_TRUE(cut.shells.empty());
  EXPECT_TRUE(cut.inner.empty());
}

TEST(MeshCut, OfAPaddedMeshEndsAtThePadding)
{
  const HexMesh mesh = analytic::paddedLattice(4, 1, [](const Vector3 & index) { return index; });
  const MeshCut cut = cutMesh(mesh, { 1, 1.5 });
  ASSERT_EQ(cut.boundary.size(), 1u);
  EXPECT_NEAR(lengthOf(cut.boundary), 4.0 * 5.0, 1e-12);
  EXPECT_EQ(cut.shells.count(2), 1u);
  EXPECT_NEAR(lengthOf(cut.shells.at(2)), 4.0 * 3.0, 1e-12);
}
