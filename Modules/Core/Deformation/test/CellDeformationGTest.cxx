// Affine deformations to 1e-12; smooth ones with order 2 within 0.1.
#include "moserhex/Deformation/CellDeformation.h"

#include "TestLattices.h"
#include "moserhex/Analytic/ObservedOrder.h"
#include "moserhex/Analytic/Refusals.h"
#include "moserhex/Deformation/SurfaceMotion.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <cmath>

using namespace moserhex;

namespace
{

const Matrix3 noDeformation = Matrix3::Identity();

CellDeformation
ofAffine(const Matrix3 & A)
{
  const HexMesh baseline = unevenLattice(4);
  return cellDeformation(baseline,
                         mapped(baseline, [&A](const Vector3 & x) { return Vector3(A * x + Vector3(3, 1, -20)); }));
}

Matrix3
someRotation()
{
  return Eigen::AngleAxisd(1.1, Vector3(1, -2, 3).normalized()).toRotationMatrix();
}

/** Integral over the boundary of x n^T, outwards, on the baseline's bilinear quadrilaterals: sum V_X F by the
 * divergence theorem. */
Matrix3
boundaryIntegral(const HexMesh & baseline, const HexMesh & followUp)
{
  constexpr double low = 0.21132486540518711775;
  Matrix3          sum = Matrix3::Zero();
  for (const Quadrilateral & quad : outwardQuads(baseline))
  {
    for (const double v : { low, 1.0 - low })
    {
      for (const double u : { low, 1.0 - low })
      {
        const double weight[4] = { (1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v };
        const double du[4] = { v - 1, 1 - v, v, -v };
        const double dv[4] = { u - 1, -u, u, 1 - u };
        Vector3      x = Vector3::Zero();
        Vector3      Xu = Vector3::Zero();
        Vector3      Xv = Vector3::Zero();
        for (int corner = 0; corner < 4; ++corner)
        {
          x += weight[corner] * followUp.nodes[quad[corner]];
          Xu += du[corner] * baseline.nodes[quad[corner]];
          Xv += dv[corner] * baseline.nodes[quad[corner]];
        }
        sum += 0.25 * x * Xu.cross(Xv).transpose();
      }
    }
  }
  return sum;
}

/** Smooth, of no symmetry. */
Vector3
warped(const Vector3 & x)
{
  return { x[0] + 0.6 * std::sin(0.5 * x[1]), x[1] + 0.4 * std::cos(0.6 * x[2]), 1.1 * x[2] + 0.02 * x[0] * x[0] };
}

/** A block bent to an arc: stretch 1 + X_2 / radius along the arc, none across it. */
Vector3
bent(const Vector3 & X)
{
  constexpr double radius = 30.0;
  const double     angle = X[0] / radius;
  return { (radius + X[1]) * std::sin(angle), (radius + X[1]) * std::cos(angle), X[2] };
}

} // namespace

TEST(CellDeformation, AffineGradientsAreExactInUnevenCells)
{
  Matrix3 A;
  A << 1.2, 0.3, -0.1, 0.05, 0.9, 0.2, 0.0, -0.15, 1.1;
  const CellDeformation deformation = ofAffine(A);
  EXPECT_NEAR(deformation.growth, A.determinant(), 1e-12);
  for (std::size_t cell = 0; cell < deformation.gradient.size(); ++cell)
  {
    EXPECT_LE((deformation.gradient[cell] - A).norm(), 1e-12);
    EXPECT_NEAR(deformation.volumeRatio[cell], A.determinant(), 1e-12);
    EXPECT_NEAR(deformation.volumetric[cell], 0.0, 1e-12);
  }
}

TEST(CellDeformation, TheMeanGradientIsThatOfTheBoundary)
{
  const HexMesh         baseline = unevenLattice(4);
  const HexMesh         followUp = mapped(baseline, warped);
  const CellDeformation deformation = cellDeformation(baseline, followUp);
  const auto            volumes = cellVolumes(baseline);
  Matrix3               sum = Matrix3::Zero();
  for (std::size_t cell = 0; cell < volumes.size(); ++cell)
  {
    sum += volumes[cell] * deformation.gradient[cell];
  }
  EXPECT_LE((sum - boundaryIntegral(baseline, followUp)).norm(), 1e-12 * sum.norm());
}

TEST(CellDeformation, ARotationIsNoStrain)
{
  const CellDeformation deformation = ofAffine(someRotation());
  for (const CellStrain & strain : deformation.strain)
  {
    EXPECT_LE(strain.tensor.norm(), 1e-12);
    EXPECT_LE(strain.deviatoric, 1e-12);
    EXPECT_NEAR(strain.largestStretch, 1.0, 1e-12);
  }
}

TEST(CellDeformation, UniformGrowthIsNoStrainOnceRemoved)
{
  const CellDeformation deformation = ofAffine(1.3 * someRotation());
  EXPECT_NEAR(deformation.growth, 1.3 * 1.3 * 1.3, 1e-11);
  for (std::size_t cell = 0; cell < deformation.strain.size(); ++cell)
  {
    EXPECT_LE(deformation.strain[cell].tensor.norm(), 1e-12);
    EXPECT_NEAR(deformation.volumetric[cell], 0.0, 1e-12);
  }
}

TEST(CellDeformation, StretchAlongAnAxisThenTurned)
{
  // stretches 2, 1/2, 1 of volume 1 along the columns of Q
  const Matrix3    Q = someRotation();
  const Matrix3    stretch = Q * Vector3(2.0, 0.5, 1.0).asDiagonal() * Q.transpose();
  const CellStrain strain = cellStrain(someRotation().transpose() * stretch, 1.0);
  EXPECT_NEAR(strain.principal[0], 1.5, 1e-12);
  EXPECT_NEAR(strain.principal[1], 0.0, 1e-12);
  EXPECT_NEAR(strain.principal[2], -0.375, 1e-12);
  EXPECT_NEAR(strain.largestStretch, 2.0, 1e-12);
  for (int axis = 0; axis < 3; ++axis)
  {
    const int column[3] = { 0, 2, 1 };
    EXPECT_NEAR(std::abs(strain.directions.col(axis).dot(Q.col(column[axis]))), 1.0, 1e-12);
    EXPECT_GT(strain.directions.col(axis).maxCoeff(), -strain.directions.col(axis).minCoeff()); // the largest is > 0
  }
  EXPECT_NEAR(strain.deviatoric, Vector3(1.5 - 0.375, 0.0 - 0.375, -0.375 - 0.375).norm(), 1e-12);
}

TEST(CellDeformation, SimpleShear)
{
  // x_1 = X_1 + s X_2: E_12 = s/2, E_22 = s^2/2
  Matrix3 F = noDeformation;
  F(0, 1) = 0.4;
  const CellStrain strain = cellStrain(F, 1.0);
  Matrix3          expected = Matrix3::Zero();
  expected(0, 1) = expected(1, 0) = 0.2;
  expected(1, 1) = 0.08;
  EXPECT_LE((strain.tensor - expected).norm(), 1e-14);
  const double root = std::sqrt(0.04 * 0.04 + 0.2 * 0.2);
  EXPECT_NEAR(strain.principal[0], 0.04 + root, 1e-13);
  EXPECT_NEAR(strain.principal[1], 0.0, 1e-13);
  EXPECT_NEAR(strain.principal[2], 0.04 - root, 1e-13);
}

TEST(CellDeformation, GrowthOfOnePartShowsInItsVolumes)
{
  // Cells of equal size in a box; the half i < m/2 grows along i to 1.5 of its length.
  const HexMesh         baseline = boxLattice(5, { 8, 8, 8 });
  const CellDeformation deformation = cellDeformation(
    baseline, mapped(baseline, [](const Vector3 & x) { return Vector3(x[0] < 0 ? 1.5 * x[0] : x[0], x[1], x[2]); }));
  EXPECT_NEAR(deformation.growth, 1.25, 1e-12);
  EXPECT_NEAR(deformation.volumetric[0], 1.5 / 1.25 - 1.0, 1e-12);
  EXPECT_NEAR(deformation.volumetric[3], 1.0 / 1.25 - 1.0, 1e-12);
}

TEST(CellDeformation, BendingConvergesWithOrderTwo)
{
  std::vector<double> sizes;
  std::vector<double> errors;
  for (const int n : { 5, 9, 17, 33 })
  {
    const HexMesh         block = boxLattice(n, { 24, 8, 8 });
    const CellDeformation deformation = cellDeformation(block, mapped(block, bent));
    double                largest = 0.0;
    for (std::size_t cell = 0; cell < block.cellCount(); ++cell)
    {
      const HexCorners corners = cellCorners(block, cell);
      const Vector3    centre = 0.5 * (corners[0] + corners[6]);
      const double     expected = std::max(1.0 + centre[1] / 30.0, 1.0);
      const double     found = std::cbrt(deformation.growth) * deformation.strain[cell].largestStretch;
      largest = std::max(largest, std::abs(found - expected));
    }
    sizes.push_back(1.0 / (n - 1));
    errors.push_back(largest);
  }
  EXPECT_NEAR(analytic::observedOrder(sizes, errors), 2.0, 0.1);
}

TEST(CellDeformation, TheDeterminantOfTheMeanTendsToTheRatioOfVolumesWithOrderTwo)
{
  std::vector<double> sizes;
  std::vector<double> errors;
  for (const int n : { 9, 17, 33 })
  {
    const HexMesh         baseline = unevenLattice(n);
    const CellDeformation deformation = cellDeformation(baseline, mapped(baseline, warped));
    double                largest = 0.0;
    for (std::size_t cell = 0; cell < baseline.cellCount(); ++cell)
    {
      largest = std::max(largest, std::abs(deformation.gradient[cell].determinant() - deformation.volumeRatio[cell]));
    }
    sizes.push_back(1.0 / (n - 1));
    errors.push_back(largest);
  }
  EXPECT_NEAR(analytic::observedOrder(sizes, errors), 2.0, 0.1);
}

TEST(CellDeformation, TheSameForAnyNumberOfThreads)
{
  const HexMesh block = boxLattice(12, { 24, 8, 8 });
  const auto    one = cellDeformation(block, mapped(block, bent), 1);
  const auto    three = cellDeformation(block, mapped(block, bent), 3);
  EXPECT_EQ(one.gradient, three.gradient);
  EXPECT_EQ(one.volumetric, three.volumetric);
  EXPECT_EQ(one.strain.back().tensor, three.strain.back().tensor);
}

TEST(CellDeformation, ACellWithoutVolumeIsRefused)
{
  const HexMesh baseline = boxLattice(3, { 8, 8, 8 });
  const HexMesh flat = mapped(baseline, [](const Vector3 & x) { return Vector3(x[0], x[1], std::min(x[2], 0.0)); });
  const auto    refusal = [](const HexMesh & a, const HexMesh & b) {
    return analytic::messageOf([&] { (void)cellDeformation(a, b); });
  };
  EXPECT_NE(refusal(baseline, flat).find("cell 4 of the follow-up has the volume 0"), std::string::npos);
  EXPECT_NE(refusal(flat, baseline).find("cell 4 of the baseline"), std::string::npos);
  EXPECT_NE(refusal(baseline, boxLattice(4, { 8, 8, 8 })), "accepted");
}
