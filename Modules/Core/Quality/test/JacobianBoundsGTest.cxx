// Closed forms and two roads to one number (round-off, 1e-13 for cells of size 1); the signs on cells whose smallest
// det J is known in closed form (exact); counts and thread numbers (exact).
#include "moserhex/Quality/JacobianBounds.h"

#include "TestHexahedra.h"
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
randomHex(Random & random, double amplitude)
{
  HexCorners corners = unitCube();
  for (Vector3 & corner : corners)
  {
    corner += amplitude * Vector3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
  }
  return corners;
}

/** det J from the shape functions, another road than the product of Bezier forms. */
double
jacobianAt(const HexCorners & corners, const Vector3 & at)
{
  Matrix3 jacobian = Matrix3::Zero();
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    const Vector3 end = unitCube()[corner];
    Vector3       factor;
    for (int axis = 0; axis < 3; ++axis)
    {
      factor[axis] = end[axis] > 0.5 ? at[axis] : 1.0 - at[axis];
    }
    const Vector3 sign = 2.0 * end - Vector3::Ones();
    const Vector3 gradient(
      sign[0] * factor[1] * factor[2], factor[0] * sign[1] * factor[2], factor[0] * factor[1] * sign[2]);
    jacobian += corners[corner] * gradient.transpose();
  }
  return jacobian.determinant();
}

double
bernstein(int number, double t)
{
  return number == 0 ? (1 - t) * (1 - t) : number == 1 ? 2 * t * (1 - t) : t * t;
}

double
polynomialAt(const BezierCoefficients & coefficients, const Vector3 & at)
{
  double sum = 0.0;
  for (int i = 0; i < 27; ++i)
  {
    sum += coefficients[static_cast<std::size_t>(i)] * bernstein(i % 3, at[0]) * bernstein(i / 3 % 3, at[1]) *
           bernstein(i / 9, at[2]);
  }
  return sum;
}

/** The unit cube about the z-axis with its upper face mapped by `top`: det J = det((1 - zeta) I + zeta top). */
HexCorners
withTopMapped(const Eigen::Matrix2d & top)
{
  HexCorners corners = unitCube();
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    corners[corner].head<2>().array() -= 0.5;
    if (corner >= 4)
    {
      corners[corner].head<2>() = (top * corners[corner].head<2>()).eval();
    }
  }
  return corners;
}

/** Upper face turned by `angle` and scaled: min det J = s^2 sin^2 / (1 + s^2 - 2 s cos), all corners positive. */
HexCorners
twisted(double angle, double scale)
{
  return withTopMapped(scale * Eigen::Rotation2Dd(angle).toRotationMatrix());
}

/** Upper face turned by 180 degrees and scaled: det J = (1 - zeta (1 + a)) (1 - zeta (1 + b)), all corners positive. */
HexCorners
turnedOver(double a, double b)
{
  return withTopMapped(Eigen::Vector2d(-a, -b).asDiagonal());
}

bool
isConcave(const HexCorners & corners)
{
  const auto jacobians = cornerJacobians(corners);
  return *std::min_element(jacobians.begin(), jacobians.end()) <= 0.0;
}

} // namespace

TEST(BezierCoefficients, UnitCubeHasOnesOnly)
{
  for (const double coefficient : bezierJacobianCoefficients(unitCube()))
  {
    EXPECT_EQ(coefficient, 1.0);
  }
}

TEST(BezierCoefficients, PolynomialEqualsTheJacobianEverywhere)
{
  Random random(1);
  for (int trial = 0; trial < 200; ++trial)
  {
    const HexCorners         corners = randomHex(random, 0.5);
    const BezierCoefficients coefficients = bezierJacobianCoefficients(corners);
    const Vector3            at(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1));
    EXPECT_NEAR(polynomialAt(coefficients, at), jacobianAt(corners, at), 1e-13) << trial;
  }
}

TEST(BezierCoefficients, InterpolationAtThe27PointsGivesTheSame)
{
  // b1 = 2 f(1/2) - (f(0) + f(1)) / 2 per direction, from the values at {0, 1/2, 1}^3.
  Random             random(2);
  const HexCorners   corners = randomHex(random, 0.4);
  BezierCoefficients values;
  for (int i = 0; i < 27; ++i)
  {
    values[static_cast<std::size_t>(i)] = jacobianAt(corners, 0.5 * Vector3(i % 3, i / 3 % 3, i / 9));
  }
  for (const int stride : { 1, 3, 9 })
  {
    for (int i = 0; i < 27; ++i)
    {
      if (i / stride % 3 == 1)
      {
        const auto at = static_cast<std::size_t>(i);
        const auto step = static_cast<std::size_t>(stride);
        values[at] = 2.0 * values[at] - 0.5 * (values[at - step] + values[at + step]);
      }
    }
  }
  const BezierCoefficients coefficients = bezierJacobianCoefficients(corners);
  for (std::size_t i = 0; i < 27; ++i)
  {
    EXPECT_NEAR(coefficients[i], values[i], 1e-13) << i;
  }
}

TEST(BezierCoefficients, MeanIsTheVolume)
{
  // Every Bernstein polynomial of degree 2 has the integral 1/3.
  Random random(3);
  for (int trial = 0; trial < 50; ++trial)
  {
    const HexCorners corners = randomHex(random, 0.5);
    double           sum = 0.0;
    for (const double coefficient : bezierJacobianCoefficients(corners))
    {
      sum += coefficient;
    }
    EXPECT_NEAR(sum / 27.0, hexVolume(corners), 1e-14) << trial;
  }
}

TEST(CertifyPositive, CubeIsPositiveWithEqualBounds)
{
  const JacobianCertificate certificate = certifyPositive(unitCube());
  EXPECT_EQ(certificate.sign, JacobianSign::Positive);
  EXPECT_NEAR(certificate.lowerBound, 1.0, 2e-13);
  EXPECT_EQ(certificate.upperBound, 1.0);
}

TEST(CertifyPositive, TwistedCellNeedsSubdivisionAndItsMinimumIsBracketed)
{
  for (const double angle : { 1.0, 2.0, 3.0, 3.1, 3.14, 3.1415 })
  {
    const double              s = 0.7;
    const double              minimum = std::pow(s * std::sin(angle), 2) / (1 + s * s - 2 * s * std::cos(angle));
    const JacobianCertificate certificate = certifyPositive(twisted(angle, s));
    EXPECT_EQ(certificate.sign, JacobianSign::Positive) << angle;
    EXPECT_GT(certificate.lowerBound, 0.0) << angle;
    EXPECT_LE(certificate.lowerBound, std::min(minimum, s * s)) << angle;
    EXPECT_GE(certificate.upperBound, std::min(minimum, s * s) * (1 - 1e-12)) << angle;
  }
  const auto coefficients = bezierJacobianCoefficients(twisted(3.1, 0.7));
  EXPECT_LT(*std::min_element(coefficients.begin(), coefficients.end()), 0.0);
}

TEST(CertifyPositive, FoldInsideIsFoundThoughAllCornersArePositive)
{
  const HexCorners corners = turnedOver(1.0, 1.2);
  EXPECT_FALSE(isConcave(corners));
  const JacobianCertificate certificate = certifyPositive(corners);
  EXPECT_EQ(certificate.sign, JacobianSign::NotPositive);
  EXPECT_LE(certificate.upperBound, 0.0);
  EXPECT_GE(certificate.point[2], 1.0 / 2.2);
  EXPECT_LE(certificate.point[2], 0.5);
  EXPECT_NEAR(jacobianAt(corners, certificate.point), certificate.upperBound, 1e-13);
  EXPECT_LE(certificate.lowerBound, -0.25 * 0.04 / 4.4);
}

TEST(CertifyPositive, NarrowFoldIsFound)
{
  // det J <= 0 for zeta in [1/2.001, 1/2] only, at least -6e-8.
  EXPECT_EQ(certifyPositive(turnedOver(1.0, 1.001)).sign, JacobianSign::NotPositive);
  EXPECT_EQ(certifyPositive(turnedOver(0.7, 0.72)).sign, JacobianSign::NotPositive);
}

TEST(CertifyPositive, ZeroInsideIsUndecided)
{
  // det J = (1 - (1 + a) zeta)^2: nowhere negative, zero on a plane. Rounding alone must not decide.
  for (const double a : { 0.7, 1.0 })
  {
    const JacobianCertificate certificate = certifyPositive(turnedOver(a, a));
    EXPECT_EQ(certificate.sign, JacobianSign::Undecided) << a;
    EXPECT_LE(certificate.lowerBound, 0.0) << a;
    EXPECT_NEAR(certificate.upperBound, 0.0, 1e-9) << a;
  }
}

TEST(CertifyPositive, ShallowerDepthSaysUndecidedInsteadOfGuessing)
{
  EXPECT_EQ(certifyPositive(twisted(3.0, 0.7), { 0, 4000 }).sign, JacobianSign::Undecided);
  EXPECT_EQ(certifyPositive(twisted(3.0, 0.7), { 36, 1 }).sign, JacobianSign::Undecided);
}

TEST(CertifyPositive, FlatAndInvertedCellsAreNotPositive)
{
  HexCorners corners = unitCube();
  for (std::size_t corner = 4; corner < 8; ++corner)
  {
    corners[corner].z() = 0.0;
  }
  EXPECT_EQ(certifyPositive(corners).sign, JacobianSign::NotPositive);
  for (std::size_t corner = 4; corner < 8; ++corner)
  {
    corners[corner].z() = -1.0;
  }
  EXPECT_EQ(certifyPositive(corners).sign, JacobianSign::NotPositive);
  EXPECT_EQ(certifyPositive(HexCorners{}).sign, JacobianSign::NotPositive);
}

TEST(CertifyPositive, CornerOnTheFarDiagonalPlaneIsNeverPositive)
{
  // Exactly on the plane through its three neighbours, and one step of rounding on either side.
  HexCorners corners = unitCube();
  for (const double third : { 1.0 / 3.0, std::nextafter(1.0 / 3.0, 0.0), std::nextafter(1.0 / 3.0, 1.0) })
  {
    corners[0] = Vector3::Constant(third);
    EXPECT_NE(certifyPositive(corners).sign, JacobianSign::Positive);
  }
}

TEST(CertifyPositive, AgreesWithDenseSampling)
{
  Random             random(7);
  std::array<int, 3> count{};
  for (int trial = 0; trial < 150; ++trial)
  {
    const HexCorners          corners = randomHex(random, 0.45);
    const JacobianCertificate certificate = certifyPositive(corners);
    double                    smallest = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 16 * 16 * 16; ++i)
    {
      smallest = std::min(smallest, jacobianAt(corners, Vector3(i % 16, i / 16 % 16, i / 256) / 15.0));
    }
    ++count[static_cast<std::size_t>(certificate.sign)];
    EXPECT_GE(smallest, certificate.lowerBound) << trial;
    EXPECT_TRUE(certificate.sign != JacobianSign::Positive || smallest > 0.0) << trial;
    EXPECT_TRUE(certificate.sign == JacobianSign::NotPositive || smallest > 0.0) << trial;
  }
  EXPECT_GT(count[0], 20); // both kinds were met
  EXPECT_GT(count[1], 20);
  EXPECT_EQ(count[2], 0);
}

TEST(CertifyPositive, ScaleAndPlaceChangeNoSign)
{
  for (const double scale : { 1e-8, 1.0, 1e8 })
  {
    for (const auto & [corners, sign] : { std::pair{ twisted(3.1, 0.7), JacobianSign::Positive },
                                          std::pair{ turnedOver(1.0, 1.2), JacobianSign::NotPositive } })
    {
      HexCorners moved = corners;
      for (Vector3 & corner : moved)
      {
        corner = scale * (corner + Vector3(100, -200, 300));
      }
      EXPECT_EQ(certifyPositive(moved).sign, sign) << scale;
    }
  }
}

TEST(CertifyCells, CountsAgreeWithTheCellsOneByOne)
{
  const HexMesh      mesh = perturbedLattice(9, 0.3, 5);
  std::array<int, 3> expected{};
  std::size_t        concave = 0;
  for (std::size_t cell = 0; cell < mesh.cellCount(); ++cell)
  {
    ++expected[static_cast<std::size_t>(certifyPositive(cellCorners(mesh, cell)).sign)];
    concave += isConcave(cellCorners(mesh, cell)) ? 1 : 0;
  }
  const CertificateCounts counts = certifyCells(mesh);
  EXPECT_EQ(counts.positive, static_cast<std::size_t>(expected[0]));
  EXPECT_EQ(counts.notPositive, static_cast<std::size_t>(expected[1]));
  EXPECT_EQ(counts.undecided, static_cast<std::size_t>(expected[2]));
  EXPECT_GE(counts.notPositive, concave);
  EXPECT_GT(concave, 0U);
  EXPECT_GT(counts.positive, 0U);
}

TEST(CertifyCells, LatticeAndItsListOfCellsAgreeForAnyNumberOfThreads)
{
  const HexMesh mesh = perturbedLattice(13, 0.3, 6); // 1728 cells: two blocks
  const auto    smallest = smallestBezierCoefficients(mesh);
  EXPECT_EQ(smallest, smallestBezierCoefficients(mesh, 2));
  EXPECT_EQ(smallest, smallestBezierCoefficients(unstructured(mesh), 3));
  EXPECT_EQ(certifyCells(mesh).positive, certifyCells(unstructured(mesh), {}, 2).positive);
}

TEST(CertifyCells, SmallestCoefficientIsThatOfTheCell)
{
  const HexMesh mesh = perturbedLattice(4, 0.3, 8); // 27 cells: not a multiple of the lanes
  const auto    smallest = smallestBezierCoefficients(mesh);
  ASSERT_EQ(smallest.size(), 27U);
  for (std::size_t cell = 0; cell < 27; ++cell)
  {
    const auto coefficients = bezierJacobianCoefficients(cellCorners(mesh, cell));
    EXPECT_EQ(smallest[cell], *std::min_element(coefficients.begin(), coefficients.end())) << cell;
  }
}

TEST(CertifyPositive, DepthBeyondTheLimitIsRefused)
{
  EXPECT_THROW((void)certifyPositive(unitCube(), { 61, 4000 }), InvalidInput);
  EXPECT_THROW((void)certifyCells(perturbedLattice(3, 0.0, 1), { 61, 4000 }), InvalidInput);
}

TEST(CertifyPositive, CoordinateThatIsNotFiniteIsRefused)
{
  HexCorners corners = unitCube();
  corners[3].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)certifyPositive(corners), InvalidInput);
}
