// Exact for boxes whose faces lie on voxel faces: volume, Dice, distances of face centres. Sampling of a shifted box:
// multiples of a fifth of a cell, exact as well. Rigid motion of image and mesh together: 1e-9.
#include "moserhex/Quality/LabelAgreement.h"

#include "moserhex/Common/Errors.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace moserhex;

namespace
{

/** Voxels [4,14)^3 of a 20^3 image with sides of 1 mm: the cube [3.5, 13.5]^3. */
LabelVolume
cubeLabel()
{
  LabelVolume label;
  label.size = { { 20, 20, 20 } };
  for (int k = 0; k < 20; ++k)
  {
    for (int j = 0; j < 20; ++j)
    {
      for (int i = 0; i < 20; ++i)
      {
        const bool inside = std::min({ i, j, k }) >= 4 && std::max({ i, j, k }) < 14;
        label.inside.push_back(inside ? 1 : 0);
      }
    }
  }
  return label;
}

/** n^3 nodes over the box [low, high]. */
HexMesh
boxLattice(int n, const Vector3 & low, const Vector3 & high)
{
  HexMesh mesh{ n, {} };
  for (int k = 0; k < n; ++k)
  {
    for (int j = 0; j < n; ++j)
    {
      for (int i = 0; i < n; ++i)
      {
        mesh.nodes.emplace_back(low + (high - low).cwiseProduct(Vector3(i, j, k)) / (n - 1));
      }
    }
  }
  return mesh;
}

HexMesh
fittingLattice()
{
  return boxLattice(6, Vector3::Constant(3.5), Vector3::Constant(13.5));
}

} // namespace

TEST(LabelAgreement, MeshOfTheLabelsOwnFacesAgrees)
{
  const LabelAgreement agreement = compareWithLabel(unstructured(fittingLattice()), cubeLabel());
  EXPECT_EQ(agreement.labelVolume, 1000.0);
  EXPECT_NEAR(agreement.volumeError, 0.0, 1e-12);
  EXPECT_NEAR(agreement.dice, 1.0, 1e-12);
  EXPECT_NEAR(agreement.faceCentres.maximum, 0.0, 1e-12);
  EXPECT_NEAR(agreement.boundaryNodes.median, 0.0, 1e-12);
  // At the cube's corners the mean of one voxel inside and three, three and one outside, 1, sqrt 2 and sqrt 3 away.
  EXPECT_NEAR(agreement.boundaryNodes.maximum, (3.0 * std::sqrt(2.0) + std::sqrt(3.0) - 1.0) / 8.0, 1e-12);
}

TEST(LabelAgreement, MeshElsewhereIsAsFarAsItIs)
{
  const Vector3        away(1000.0, 0.0, 0.0);
  const HexMesh        mesh = boxLattice(6, Vector3::Constant(3.5) + away, Vector3::Constant(13.5) + away);
  const LabelAgreement agreement = compareWithLabel(unstructured(mesh), cubeLabel());
  EXPECT_EQ(agreement.dice, 0.0);
  EXPECT_NEAR(agreement.faceCentres.minimum, 990.0, 1e-9);
  EXPECT_GE(agreement.faceCentres.maximum, 1000.0 - 1e-9);
}

TEST(LabelAgreement, ShiftIsSeenInDiceAndDistance)
{
  HexMesh mesh = fittingLattice();
  for (Vector3 & node : mesh.nodes)
  {
    node.x() += 0.8; // two of the five samples of the last cells leave the label
  }
  const LabelAgreement agreement = compareWithLabel(unstructured(mesh), cubeLabel());
  EXPECT_NEAR(agreement.dice, 0.92, 1e-12);
  EXPECT_NEAR(agreement.volumeError, 0.0, 1e-12);
  EXPECT_NEAR(agreement.faceCentres.maximum, 0.8, 1e-12); // of the two faces across the shift
}

TEST(LabelAgreement, LargerMeshHasThePositiveVolumeError)
{
  const HexMesh        mesh = boxLattice(6, Vector3(3.5, 3.5, 3.5), Vector3(15.5, 13.5, 13.5));
  const LabelAgreement agreement = compareWithLabel(unstructured(mesh), cubeLabel());
  EXPECT_NEAR(agreement.volumeError, 0.2, 1e-12);
  EXPECT_NEAR(agreement.dice, 2000.0 / 2200.0, 0.02); // samples on a grid of 0.48 mm
}

TEST(LabelAgreement, RigidMotionOfBothChangesNothing)
{
  const HexMesh        still = boxLattice(5, Vector3(3.7, 3.2, 4.1), Vector3(13.9, 12.6, 13.0));
  const LabelAgreement before = compareWithLabel(unstructured(still), cubeLabel());
  const Matrix3        turn = Eigen::AngleAxisd(0.8, Vector3(1, 2, -1).normalized()).toRotationMatrix();
  const Vector3        shift(50, -70, 30);
  LabelVolume          label = cubeLabel();
  label.direction = turn;
  label.origin = shift;
  HexMesh mesh = still;
  for (Vector3 & node : mesh.nodes)
  {
    node = (turn * node + shift).eval();
  }
  const LabelAgreement after = compareWithLabel(unstructured(mesh), label);
  EXPECT_NEAR(after.dice, before.dice, 1e-9);
  EXPECT_NEAR(after.volumeError, before.volumeError, 1e-9);
  EXPECT_NEAR(after.boundaryNodes.maximum, before.boundaryNodes.maximum, 1e-9);
  EXPECT_NEAR(after.faceCentres.p99, before.faceCentres.p99, 1e-9);
}

TEST(LabelAgreement, MeshFarAwayHasNoOverlapAndTheWayToItCounts)
{
  const HexMesh        mesh = boxLattice(4, Vector3::Constant(1000.0), Vector3::Constant(1010.0));
  const LabelAgreement agreement = compareWithLabel(unstructured(mesh), cubeLabel());
  EXPECT_EQ(agreement.dice, 0.0);
  EXPECT_NEAR(agreement.boundaryNodes.maximum, (993.0 + 4.0) * std::sqrt(3.0) - 0.5, 1e-9);
}

TEST(LabelAgreement, ThreadsChangeNoBit)
{
  const auto           mesh = unstructured(boxLattice(9, Vector3(3.1, 3.2, 4.1), Vector3(13.9, 12.6, 13.0)));
  const LabelAgreement one = compareWithLabel(mesh, cubeLabel(), 1);
  const LabelAgreement two = compareWithLabel(mesh, cubeLabel(), 2);
  EXPECT_EQ(one.dice, two.dice);
  EXPECT_EQ(one.boundaryNodes.mean, two.boundaryNodes.mean);
}

TEST(LabelAgreement, EmptyLabelAndEmptyMeshAreRefused)
{
  LabelVolume label = cubeLabel();
  EXPECT_THROW((void)compareWithLabel({}, label), InvalidInput);
  std::fill(label.inside.begin(), label.inside.end(), std::uint8_t{ 0 });
  EXPECT_THROW((void)compareWithLabel(unstructured(fittingLattice()), label), InvalidInput);
}
