// Closed forms: 1e-12 of the coordinates.
#include "moserhex/Correspondence/LandmarkErrors.h"

#include "moserhex/Analytic/Lattices.h"
#include "moserhex/Common/Errors.h"

#include <gtest/gtest.h>

using namespace moserhex;
using namespace moserhex::analytic;

TEST(PointDistances, AreThoseOfThePairs)
{
  const Positions a{ Vector3(0, 0, 0), Vector3(1, 1, 1) };
  const Positions b{ Vector3(3, 4, 0), Vector3(1, 1, 3) };
  EXPECT_EQ(pointDistances(a, b), (std::vector<double>{ 5.0, 2.0 }));
}

TEST(PointDistances, RefusesOtherNumbersOfPointsAndNone)
{
  EXPECT_THROW((void)pointDistances({ Vector3::Zero() }, {}), InvalidInput);
  EXPECT_THROW((void)pointDistances({}, {}), InvalidInput);
}

TEST(InnerLandmarkErrors, AreInCellEdgesAndLeaveTheBoundaryOut)
{
  const HexMesh baseline = cubeLattice(5, 2.0);
  HexMesh       followUp = cubeLattice(5, 3.0);                            // edges of 3 mm
  followUp.nodes[followUp.nodeNumber(0, 2, 2)] += Vector3(0.0, 0.3, -0.3); // on the boundary, volumes stay
  const auto stretchAndMiss = [](const Vector3 & p) { return Vector3(1.5 * p + Vector3(0.0, 0.6, 0.0)); };
  const std::vector<double> errors = innerLandmarkErrors(baseline, followUp, stretchAndMiss);
  ASSERT_EQ(errors.size(), 27u);
  for (const double error : errors)
  {
    EXPECT_NEAR(error, 0.2, 1e-12);
  }
}

TEST(InnerLandmarkErrors, RefusesLatticesThatDoNotCorrespondOrHaveNoInside)
{
  const auto identity = [](const Vector3 & p) { return p; };
  EXPECT_THROW((void)innerLandmarkErrors(cubeLattice(4), cubeLattice(5), identity), InvalidInput);
  EXPECT_THROW((void)innerLandmarkErrors(cubeLattice(2), cubeLattice(2), identity), InvalidInput);
}

TEST(AffinePart, IsTheMatrixOfAnAffineMap)
{
  const Matrix3   F = (Matrix3() << 1.1, 0.2, -0.3, 0.0, 0.9, 0.1, 0.05, 0.0, 1.3).finished();
  const Positions from = lattice(4, [](const Vector3 & at) { return Vector3(at[0], 2.0 * at[1], at[2] + 5.0); }).nodes;
  Positions       to = from;
  for (Vector3 & p : to)
  {
    p = F * p + Vector3(7.0, -3.0, 1.0);
  }
  EXPECT_LT((affinePart(from, to) - F).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(AffinePart, RefusesPointsInAPlane)
{
  const Positions flat{ Vector3(0, 0, 1), Vector3(1, 0, 1), Vector3(0, 1, 1), Vector3(2, 1, 1) };
  EXPECT_THROW((void)affinePart(flat, flat), InvalidInput);
}

TEST(AffinePartError, IsTheLargestEntryOfTheDifference)
{
  const HexMesh baseline = cubeLattice(4, 2.0);
  HexMesh       followUp = baseline;
  const Matrix3 found = (Matrix3() << 1.0, 0.2, 0.0, 0.0, 1.0, 0.0, 0.0, -0.05, 1.0).finished();
  for (Vector3 & node : followUp.nodes)
  {
    node = found * node + Vector3(1.0, 0.0, 0.0);
  }
  const auto sheared = [](const Vector3 & p) { return Vector3(p.x() + 0.25 * p.z(), p.y(), p.z()); };
  EXPECT_NEAR(affinePartError(baseline, followUp, sheared), 0.25, 1e-12); // 0.2, -0.25 and -0.05
}
