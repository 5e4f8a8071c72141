// Closed forms on boxes, parallelepipeds and single moved corners (round-off, 1e-12), invariance under rigid motion and
// scale (1e-11), counting of classes (exact). The comparison with vtkMeshQuality is in Testing/Integration.
#include "moserhex/Quality/HexQuality.h"

#include "TestHexahedra.h"
#include "moserhex/Analytic/Lattices.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Random.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace moserhex;

namespace
{
HexCorners
transformed(HexCorners corners, const Matrix3 & matrix)
{
  for (Vector3 & corner : corners)
  {
    corner = (matrix * corner).eval();
  }
  return corners;
}

HexCorners
randomHex(std::uint64_t seed)
{
  Random     random(seed);
  HexCorners corners = unitCube();
  for (Vector3 & corner : corners)
  {
    corner += Vector3(random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2));
  }
  return corners;
}

} // namespace

TEST(HexQuality, UnitCubeIsPerfect)
{
  const HexCellQuality quality = hexCellQuality(unitCube());
  EXPECT_NEAR(quality.volume, 1.0, 1e-12);
  EXPECT_NEAR(quality.minimumJacobian, 1.0, 1e-12);
  EXPECT_NEAR(quality.scaledJacobian, 1.0, 1e-12);
  EXPECT_NEAR(quality.edgeRatio, 1.0, 1e-12);
  EXPECT_NEAR(quality.aspectRatio, 1.0, 1e-12);
  EXPECT_NEAR(quality.taper, 0.0, 1e-12);
  EXPECT_NEAR(quality.skew, 0.0, 1e-12);
  EXPECT_NEAR(quality.shape, 1.0, 1e-12);
  EXPECT_FALSE(quality.concave);
}

TEST(HexQuality, BoxHasTheRatioOfItsSides)
{
  const HexCellQuality quality = hexCellQuality(transformed(unitCube(), Vector3(1, 2, 5).asDiagonal()));
  EXPECT_NEAR(quality.volume, 10.0, 1e-12);
  EXPECT_NEAR(quality.scaledJacobian, 1.0, 1e-12);
  EXPECT_NEAR(quality.edgeRatio, 5.0, 1e-12);
  EXPECT_NEAR(quality.aspectRatio, 5.0, 1e-12);
  EXPECT_NEAR(quality.shape, 3.0 * std::pow(10.0, 2.0 / 3.0) / 30.0, 1e-12);
}

TEST(HexQuality, ParallelepipedHasTheSineOfItsAngle)
{
  Matrix3 shear = Matrix3::Identity();
  shear(0, 1) = std::cos(1.0);
  shear(1, 1) = std::sin(1.0);
  const HexCellQuality quality = hexCellQuality(transformed(unitCube(), shear));
  EXPECT_NEAR(quality.scaledJacobian, std::sin(1.0), 1e-12);
  EXPECT_NEAR(quality.skew, std::cos(1.0), 1e-12);
  EXPECT_NEAR(quality.taper, 0.0, 1e-12);
}

TEST(HexQuality, FrustumHasTheTaperOfItsFaces)
{
  // Top face half as large: X1 = X2 = 2 (1 + 1/2) e, X13 = X23 = 2 (1/2 - 1) e, so taper = 1 / min(3, |X3| = 4).
  HexCorners corners = unitCube();
  for (std::size_t c = 4; c < 8; ++c)
  {
    corners[c] = Vector3(0.25, 0.25, 0.0) + Vector3(0.5, 0.5, 1.0).cwiseProduct(corners[c]);
  }
  EXPECT_NEAR(hexCellQuality(corners).taper, 1.0 / 3.0, 1e-12);
}

TEST(HexQuality, InvertedCubeIsMinusOne)
{
  const HexCellQuality quality = hexCellQuality(transformed(unitCube(), Vector3(1, 1, -1).asDiagonal()));
  EXPECT_NEAR(quality.volume, -1.0, 1e-12);
  EXPECT_NEAR(quality.scaledJacobian, -1.0, 1e-12);
  EXPECT_EQ(quality.shape, 0.0);
  EXPECT_TRUE(quality.concave);
}

TEST(HexQuality, ACornerPushedThroughTheFarDiagonalPlaneIsConcave)
{
  HexCorners corners = unitCube();
  corners[0] = Vector3::Constant(0.332); // plane through its three neighbours: x + y + z = 1
  EXPECT_FALSE(hexCellQuality(corners).concave);
  corners[0] = Vector3::Constant(0.334);
  EXPECT_TRUE(hexCellQuality(corners).concave);
  EXPECT_GT(hexCellQuality(corners).volume, 0.0);
}

TEST(HexQuality, ZeroDeterminantCountsAsConcave)
{
  HexCorners corners = unitCube();
  for (std::size_t c = 4; c < 8; ++c)
  {
    corners[c][2] = 0.0;
  }
  EXPECT_TRUE(hexCellQuality(corners).concave);
}

TEST(HexQuality, RigidMotionAndScaleChangeNoRatio)
{
  const Matrix3 rotation = Eigen::AngleAxisd(0.7, Vector3(1, 2, -1).normalized()).toRotationMatrix();
  for (std::uint64_t seed = 0; seed < 50; ++seed)
  {
    const HexCorners     corners = randomHex(seed);
    const HexCellQuality before = hexCellQuality(corners);
    for (const double scale : { 1e-8, 1.0, 1e8 })
    {
      const HexCellQuality after = hexCellQuality(transformed(corners, scale * rotation));
      EXPECT_NEAR(after.scaledJacobian, before.scaledJacobian, 1e-11) << seed;
      EXPECT_NEAR(after.aspectRatio, before.aspectRatio, 1e-11) << seed;
      EXPECT_NEAR(after.taper, before.taper, 1e-11) << seed;
      EXPECT_NEAR(after.skew, before.skew, 1e-11) << seed;
      EXPECT_NEAR(after.shape, before.shape, 1e-11) << seed;
      EXPECT_NEAR(after.minimumJacobian / std::pow(scale, 3), before.minimumJacobian, 1e-11) << seed;
    }
  }
}

TEST(HexQuality, MinimumJacobianIsNotAboveTheCornerJacobians)
{
  for (std::uint64_t seed = 0; seed < 50; ++seed)
  {
    const HexCorners corners = randomHex(seed);
    const auto       jacobians = cornerJacobians(corners);
    const double     smallest = *std::min_element(jacobians.begin(), jacobians.end());
    EXPECT_LE(hexCellQuality(corners).minimumJacobian, smallest + 1e-15);
    EXPECT_EQ(hexCellQuality(corners).concave, smallest <= 0.0);
  }
}

TEST(HexQuality, DistributionOfEquallySpacedNumbers)
{
  std::vector<double> values;
  for (int i = 100; i >= 0; --i)
  {
    values.push_back(i);
  }
  const Distribution distribution = distributionOf(values);
  EXPECT_EQ(distribution.minimum, 0.0);
  EXPECT_NEAR(distribution.p01, 1.0, 1e-12);
  EXPECT_NEAR(distribution.p05, 5.0, 1e-12);
  EXPECT_EQ(distribution.median, 50.0);
  EXPECT_NEAR(distribution.mean, 50.0, 1e-12);
  EXPECT_NEAR(distribution.p99, 99.0, 1e-12);
  EXPECT_EQ(distribution.maximum, 100.0);
  EXPECT_THROW(static_cast<void>(distributionOf({})), InvalidInput);
}

TEST(HexQuality, RegularMeshHasNoVarianceAndKnownClasses)
{
  const HexQualitySummary summary = summarizeQuality(analytic::cubeLattice(6, 2.0));
  EXPECT_EQ(summary.cells, 125U);
  EXPECT_NEAR(summary.volume, 1000.0, 1e-9);
  EXPECT_NEAR(summary.volumeVariance, 0.0, 1e-24);
  EXPECT_EQ(summary.concaveCells, 0U);
  EXPECT_EQ(summary.corners.cells, 8U);
  EXPECT_EQ(summary.edges.cells, 36U);
  EXPECT_EQ(summary.rest.cells, 81U);
  EXPECT_NEAR(summary.minimumJacobian.minimum, 1.0, 1e-12);
}

TEST(HexQuality, VarianceOfTwoThicknessesIsThePopulationVariance)
{
  // Layers of thickness 1 and 3: ratios 1/2 and 3/2, variance 1/4.
  HexMesh mesh = analytic::cubeLattice(3);
  for (Vector3 & node : mesh.nodes)
  {
    node[2] = node[2] > 1.5 ? 4.0 : node[2];
  }
  const HexQualitySummary summary = summarizeQuality(mesh);
  EXPECT_NEAR(summary.volumeVariance, 0.25, 1e-12);
  EXPECT_NEAR(summary.ratioMin, 0.5, 1e-12);
  EXPECT_NEAR(summary.ratioMax, 1.5, 1e-12);
  EXPECT_NEAR(summary.corners.volumeVariance, 0.25, 1e-12);
}

TEST(HexQuality, ConcaveCellsAreCountedInTheirClass)
{
  HexMesh mesh = analytic::cubeLattice(6);
  mesh.nodes[mesh.nodeNumber(0, 0, 0)] = Vector3(0.6, 0.6, 0.6);  // corner cell
  mesh.nodes[mesh.nodeNumber(2, 2, 2)] += Vector3(0.7, 0.7, 0.7); // inner cell towards +++
  const HexQualitySummary summary = summarizeQuality(mesh);
  EXPECT_EQ(summary.corners.concaveCells, 1U);
  EXPECT_EQ(summary.edges.concaveCells, 0U);
  EXPECT_GE(summary.rest.concaveCells, 1U);
  EXPECT_EQ(summary.concaveCells, summary.corners.concaveCells + summary.rest.concaveCells);
  EXPECT_NEAR(summary.concavePercent, 100.0 * static_cast<double>(summary.concaveCells) / 125.0, 1e-12);
}

TEST(HexQuality, VolumeQualityAgreesWithTheSummary)
{
  const HexMesh           mesh = perturbedLattice(5, 0.4, 5);
  const HexQualitySummary summary = summarizeQuality(mesh);
  const VolumeQuality     quality = volumeQuality(mesh);
  EXPECT_GT(summary.concaveCells, 0U);
  EXPECT_EQ(quality.concaveCells, summary.concaveCells);
  EXPECT_EQ(quality.volumeVariance, summary.volumeVariance);
  EXPECT_EQ(quality.concavePercent, summary.concavePercent);
}

TEST(HexQuality, WrongNumberOfNodesIsRefused)
{
  HexMesh mesh = analytic::cubeLattice(4);
  mesh.nodes.pop_back();
  EXPECT_THROW(static_cast<void>(summarizeQuality(mesh)), InvalidInput);
  EXPECT_THROW(static_cast<void>(summarizeQuality(HexMesh{ 1, { Vector3::Zero() } })), InvalidInput);
}

TEST(HexQuality, CoordinateThatIsNotFiniteIsRefused)
{
  HexMesh mesh = analytic::cubeLattice(4);
  mesh.nodes[17][1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(static_cast<void>(summarizeQuality(mesh)), InvalidInput);
}

TEST(HexQuality, RatiosToTheMeanOfAMeshWithoutVolumeAreUndefined)
{
  HexMesh flat = analytic::cubeLattice(4);
  HexMesh cancelling = analytic::cubeLattice(3); // four cells are the mirror images of the other four
  for (Vector3 & node : flat.nodes)
  {
    node.z() = 0.0;
  }
  for (std::size_t node = 18; node < 27; ++node)
  {
    cancelling.nodes[node].z() = cancelling.nodes[node - 18].z();
  }
  HexMesh turned = flat; // flat up to rounding
  for (Vector3 & node : turned.nodes)
  {
    node = Eigen::AngleAxisd(0.7, Vector3(1, 2, 3).normalized()) * node;
  }
  for (const HexMesh & mesh : { flat, cancelling, turned })
  {
    const HexQualitySummary summary = summarizeQuality(mesh);
    EXPECT_NEAR(summary.volume, 0.0, 1e-12);
    EXPECT_TRUE(std::isnan(summary.volumeVariance));
    EXPECT_TRUE(std::isnan(summary.ratioMin));
    EXPECT_TRUE(std::isnan(summary.ratioMax));
    EXPECT_TRUE(std::isnan(summary.minimumJacobian.minimum));
    EXPECT_TRUE(std::isnan(summary.minimumJacobian.maximum));
    EXPECT_TRUE(std::isnan(summary.corners.volumeVariance));
  }
}

TEST(HexQuality, RatiosOfVeryThinCellsAreDefined)
{
  HexMesh mesh = analytic::cubeLattice(4);
  for (Vector3 & node : mesh.nodes)
  {
    node = node.cwiseProduct(Vector3(1e5, 1.0, 1.0));
  }
  const HexQualitySummary summary = summarizeQuality(mesh);
  EXPECT_NEAR(summary.volumeVariance, 0.0, 1e-12);
  EXPECT_NEAR(summary.ratioMax, 1.0, 1e-9);
}

TEST(HexQuality, CertificateCountsEveryCellOnce)
{
  HexMesh mesh = analytic::cubeLattice(6);
  mesh.nodes[mesh.nodeNumber(2, 2, 2)] += Vector3(0.7, 0.7, 0.7);
  const HexQualitySummary summary = summarizeQuality(mesh);
  EXPECT_EQ(summary.certified.positive + summary.certified.notPositive + summary.certified.undecided, 125U);
  EXPECT_GE(summary.certified.notPositive, summary.concaveCells);
  EXPECT_EQ(summarizeQuality(analytic::cubeLattice(6)).certified.positive, 125U);
}

TEST(HexQuality, ListOfCellsGivesTheLatticesNumbersAndClasses)
{
  const HexMesh           mesh = perturbedLattice(5, 0.4, 9);
  const HexQualitySummary lattice = summarizeQuality(mesh);
  UnstructuredHexMesh     list = unstructured(mesh);
  const HexQualitySummary same = summarizeQuality(list);
  EXPECT_TRUE(same.isLattice);
  EXPECT_EQ(same.corners.scaledJacobianMin, lattice.corners.scaledJacobianMin);
  std::swap(list.cells[0], list.cells[17]);
  const HexQualitySummary other = summarizeQuality(list);
  EXPECT_FALSE(other.isLattice);
  EXPECT_EQ(other.corners.cells + other.edges.cells + other.rest.cells, 0U);
  EXPECT_EQ(other.concaveCells, lattice.concaveCells);
  EXPECT_EQ(other.certified.positive, lattice.certified.positive);
  EXPECT_EQ(other.scaledJacobian.median, lattice.scaledJacobian.median);
  EXPECT_NEAR(other.volumeVariance, lattice.volumeVariance, 1e-12);
}

TEST(HexQuality, ThreadsChangeNoBit)
{
  const HexMesh mesh = perturbedLattice(13, 0.4, 9);
  EXPECT_EQ(summarizeQuality(mesh, 1).skew.mean, summarizeQuality(mesh, 2).skew.mean);
  EXPECT_EQ(summarizeQuality(mesh, 1).volumeVariance, summarizeQuality(mesh, 2).volumeVariance);
}

TEST(HexQuality, MeshWithoutCellsIsRefused)
{
  EXPECT_THROW(static_cast<void>(summarizeQuality(UnstructuredHexMesh{})), InvalidInput);
}
