// Known motions come back to 1e-12 of the coordinates.
#include "moserhex/Deformation/LatticeAlignment.h"

#include "TestLattices.h"
#include "moserhex/Analytic/Refusals.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <numeric>
#include <utility>

using namespace moserhex;

namespace
{

SimilarityTransform
someMotion(double scale)
{
  return { scale, Eigen::AngleAxisd(0.4, Vector3(1, 2, -1).normalized()).toRotationMatrix(), { 5.0, -3.0, 2.0 } };
}

double
largestDifference(const HexMesh & a, const HexMesh & b)
{
  double largest = 0.0;
  for (const Vector3 & difference : displacements(a, b))
  {
    largest = std::max(largest, difference.norm());
  }
  return largest;
}

} // namespace

TEST(LatticeAlignment, AMovedOrganComesBackToItsBaseline)
{
  const HexMesh baseline = unevenLattice(5);
  const HexMesh moved = transformed(baseline, someMotion(1.0));
  EXPECT_GT(largestDifference(baseline, moved), 1.0);
  const auto back = transformed(moved, latticeAlignment(moved, baseline, AlignmentKind::Rigid));
  EXPECT_LE(largestDifference(baseline, back), 1e-12 * 50.0);
}

TEST(LatticeAlignment, OnlyTheSimilarityTakesTheSizeAway)
{
  const HexMesh baseline = unevenLattice(5);
  const HexMesh grown = transformed(baseline, someMotion(1.25));
  EXPECT_NEAR(latticeAlignment(grown, baseline, AlignmentKind::Similarity).scale, 0.8, 1e-13);
  EXPECT_EQ(latticeAlignment(grown, baseline, AlignmentKind::Rigid).scale, 1.0);
  const auto back = transformed(grown, latticeAlignment(grown, baseline, AlignmentKind::Similarity));
  EXPECT_LE(largestDifference(baseline, back), 1e-12 * 50.0);
}

TEST(LatticeAlignment, ASimilarityLeavesNoChangeOfVolumeWhereNodesDoNotFit)
{
  const auto volumeOf = [](const HexMesh & mesh) {
    const std::vector<double> volumes = cellVolumes(mesh);
    return std::accumulate(volumes.begin(), volumes.end(), 0.0);
  };
  const HexMesh baseline = boxLattice(7, { 8, 8, 8 });
  const HexMesh bulged = mapped(baseline, [](const Vector3 & x) {
    return Vector3(1.1 * x[0], 1.1 * x[1] + 0.04 * x[0] * x[0], 1.1 * x[2] + 0.05 * x[1] * x[0]);
  });
  for (const auto & [from, to] : { std::pair(baseline, bulged), std::pair(bulged, baseline) })
  {
    const SimilarityTransform motion = latticeAlignment(from, to, AlignmentKind::Similarity);
    EXPECT_NEAR(volumeOf(transformed(from, motion)) / volumeOf(to), 1.0, 1e-12);
    EXPECT_LT((motion.rotation - latticeAlignment(from, to, AlignmentKind::Rigid).rotation).norm(), 1e-15);
    Vector3 between = Vector3::Zero();
    for (const Vector3 & u : displacements(to, transformed(from, motion)))
    {
      between += u;
    }
    EXPECT_LT(between.norm(), 1e-10); // the means of the nodes meet
  }
}

TEST(LatticeAlignment, NoneLeavesTheMeshWhereItIs)
{
  const HexMesh baseline = unevenLattice(4);
  const HexMesh moved = transformed(baseline, someMotion(1.0));
  EXPECT_EQ(transformed(moved, latticeAlignment(moved, baseline, AlignmentKind::None)).nodes, moved.nodes);
}

TEST(LatticeAlignment, DisplacementsLeadFromTheBaselineToTheFollowUp)
{
  const Vector3 step(0.5, -1.0, 2.0);
  for (const Vector3 & u :
       displacements(boxLattice(3, { 8, 8, 8 }),
                     mapped(boxLattice(3, { 8, 8, 8 }), [&](const Vector3 & x) { return Vector3(x + step); })))
  {
    EXPECT_EQ(u, step);
  }
}

TEST(LatticeAlignment, MeshesThatDoNotCorrespondAreRefused)
{
  const auto refusal = [](const HexMesh & a, const HexMesh & b) {
    return analytic::messageOf([&] { requireComparable(a, b); });
  };
  EXPECT_NE(refusal(unevenLattice(4), unevenLattice(5)).find("4 and 5 nodes a side"), std::string::npos);
  const HexMesh padded = analytic::paddedLattice(4, 1, [](const Vector3 & index) { return index; });
  EXPECT_NE(refusal(padded, padded).find("must be a lattice alone"), std::string::npos);
}
