// d d = 0, the form of the Laplacians and discrete divergence theorem: exact or round-off (1e-12). Manufactured field:
// second order in the spacing, slope within 0.1 of 2.
#include "moserhex/DiscreteCalculus/CubeLatticeOperators.h"

#include "moserhex/Analytic/ObservedOrder.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Types.h"
#include "moserhex/Numerics/CosineTransform.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

using namespace moserhex;

namespace
{
using SparseMatrix = CubeLatticeOperators::SparseMatrix;

double
largestEntry(const SparseMatrix & matrix)
{
  double largest = 0.0;
  for (Eigen::Index column = 0; column < matrix.outerSize(); ++column)
  {
    for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry)
    {
      largest = std::max(largest, std::abs(entry.value()));
    }
  }
  return largest;
}
} // namespace

TEST(CubeLatticeOperators, CountsSatisfyEulersFormula)
{
  const CubeLatticeOperators lattice(5);
  EXPECT_EQ(lattice.nodeCount(), 125U);
  EXPECT_EQ(lattice.edgeCount(), 3U * 4U * 25U);
  EXPECT_EQ(lattice.faceCount(), 3U * 5U * 16U);
  EXPECT_EQ(lattice.cellCount(), 64U);
  EXPECT_EQ(lattice.nodeCount() + lattice.faceCount(), lattice.edgeCount() + lattice.cellCount() + 1U);
}

TEST(CubeLatticeOperators, CurlOfAGradientIsZero)
{
  const CubeLatticeOperators lattice(5);
  EXPECT_EQ(largestEntry(lattice.d1() * lattice.d0()), 0.0);
}

TEST(CubeLatticeOperators, DivergenceOfACurlIsZero)
{
  const CubeLatticeOperators lattice(5);
  EXPECT_EQ(largestEntry(lattice.d2() * lattice.d1()), 0.0);
}

TEST(CubeLatticeOperators, GradientOfACoordinateIsItsStep)
{
  const CubeLatticeOperators lattice(4, 0.5);
  Eigen::VectorXd            y(static_cast<Eigen::Index>(lattice.nodeCount()));
  for (int k = 0; k < 4; ++k)
  {
    for (int j = 0; j < 4; ++j)
    {
      for (int i = 0; i < 4; ++i)
      {
        y[static_cast<Eigen::Index>(lattice.nodeNumber(i, j, k))] = 0.5 * j;
      }
    }
  }
  const Eigen::VectorXd gradient = lattice.d0() * y;
  EXPECT_EQ(gradient[static_cast<Eigen::Index>(lattice.edgeNumber(1, 2, 1, 3))], 0.5);
  EXPECT_EQ(gradient[static_cast<Eigen::Index>(lattice.edgeNumber(0, 2, 1, 3))], 0.0);
  EXPECT_EQ(gradient[static_cast<Eigen::Index>(lattice.edgeNumber(2, 2, 1, 2))], 0.0);
}

TEST(CubeLatticeOperators, CurlOfARotationIsTwiceTheFaceArea)
{
  // a = -y dx + x dy about the z axis: d a = 2 dx dy, integrated over every z-face 2 h^2, over others 0.
  const int                  n = 4;
  const double               h = 0.5;
  const CubeLatticeOperators lattice(n, h);
  Eigen::VectorXd            a = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(lattice.edgeCount()));
  for (int k = 0; k < n; ++k)
  {
    for (int j = 0; j < n; ++j)
    {
      for (int i = 0; i < n; ++i)
      {
        if (i + 1 < n)
        {
          a[static_cast<Eigen::Index>(lattice.edgeNumber(0, i, j, k))] = -h * j * h;
        }
        if (j + 1 < n)
        {
          a[static_cast<Eigen::Index>(lattice.edgeNumber(1, i, j, k))] = h * i * h;
        }
      }
    }
  }
  const Eigen::VectorXd curl = lattice.d1() * a;
  EXPECT_NEAR(curl[static_cast<Eigen::Index>(lattice.faceNumber(2, 1, 2, 3))], 2 * h * h, 1e-15);
  EXPECT_NEAR(curl[static_cast<Eigen::Index>(lattice.faceNumber(0, 1, 2, 2))], 0.0, 1e-15);
  EXPECT_NEAR(curl[static_cast<Eigen::Index>(lattice.faceNumber(1, 1, 2, 2))], 0.0, 1e-15);
}

TEST(CubeLatticeOperators, HodgeStarsMeasureTheDual)
{
  const int                  n = 6;
  const double               h = 0.3;
  const double               volume = std::pow(h * (n - 1), 3);
  const CubeLatticeOperators lattice(n, h);
  // Dual volumes fill the cube; primal measure x dual measure over all elements of a dimension is 3 times the volume.
  EXPECT_NEAR(lattice.star0().sum(), volume, 1e-12);
  EXPECT_NEAR(lattice.star1().sum() * h * h, 3 * volume, 1e-12);
  EXPECT_NEAR(lattice.star2().sum() * std::pow(h, 4), 3 * volume, 1e-12);
  EXPECT_NEAR(lattice.star3().sum() * std::pow(h, 6), volume, 1e-12);
}

TEST(CubeLatticeOperators, LaplacianOfTheNodesKillsConstants)
{
  const CubeLatticeOperators lattice(5, 0.7);
  const SparseMatrix         d0 = lattice.d0();
  const SparseMatrix         transposed = d0.transpose();
  const SparseMatrix         weighted = lattice.star1().asDiagonal() * d0;
  const SparseMatrix         laplacian = transposed * weighted;
  const Eigen::VectorXd      ones = Eigen::VectorXd::Ones(laplacian.cols());
  EXPECT_LT((laplacian * ones).cwiseAbs().maxCoeff(), 1e-14);
  const Eigen::Index centre = static_cast<Eigen::Index>(lattice.nodeNumber(2, 2, 2));
  EXPECT_NEAR(laplacian.coeff(centre, centre), 6 * 0.7, 1e-14);
}

TEST(CubeLatticeOperators, CellLaplacianIsTheOneTheCosineTransformInverts)
{
  const CubeLatticeOperators lattice(6);
  Eigen::VectorXd            f(125);
  for (Eigen::Index i = 0; i < f.size(); ++i)
  {
    f[i] = std::sin(1.0 + 3.0 * static_cast<double>(i));
  }
  f.array() -= f.mean();
  const Eigen::VectorXd theta = NeumannPoissonSolver(5).solve(f);
  EXPECT_LT((lattice.d2() * (lattice.fluxFromPotential() * theta) - f).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(CubeLatticeOperators, FluxFromPotentialIsZeroOnTheBoundaryAndSumsToNothing)
{
  const CubeLatticeOperators lattice(5);
  Eigen::VectorXd            theta(64);
  for (Eigen::Index i = 0; i < theta.size(); ++i)
  {
    theta[i] = std::cos(2.0 * static_cast<double>(i));
  }
  const Eigen::VectorXd flux = lattice.fluxFromPotential() * theta;
  EXPECT_EQ(flux.cwiseProduct(Eigen::VectorXd::Ones(flux.size()) - lattice.interiorFaces()).cwiseAbs().maxCoeff(), 0.0);
  EXPECT_NEAR((lattice.d2() * flux).sum(), 0.0, 1e-12);
}

TEST(CubeLatticeOperators, FluxOfAManufacturedDivergenceConvergesWithOrderTwo)
{
  // v = grad q, q = cos(pi x) cos(2 pi y) cos(pi z) on the unit cube, v.n = 0: div v = -6 pi^2 q.
  std::vector<double> spacings;
  std::vector<double> errors;
  for (const int n : { 9, 17, 33, 49 })
  {
    const double               h = 1.0 / (n - 1);
    const CubeLatticeOperators lattice(n, h);
    const int                  m = n - 1;
    // Divergence as a 3-form: integral over each cell in closed form, one factor per axis.
    const auto integral = [h](double frequency, int i) {
      return (std::sin(frequency * pi * h * (i + 1)) - std::sin(frequency * pi * h * i)) / (frequency * pi);
    };
    Eigen::VectorXd divergence(static_cast<Eigen::Index>(lattice.cellCount()));
    for (int k = 0; k < m; ++k)
    {
      for (int j = 0; j < m; ++j)
      {
        for (int i = 0; i < m; ++i)
        {
          divergence[static_cast<Eigen::Index>(lattice.cellNumber(i, j, k))] =
            -6.0 * pi * pi * integral(1, i) * integral(2, j) * integral(1, k);
        }
      }
    }
    // d2 *2^-1 d2^T theta = div: the solver is for unit cells, *2 = 1/h.
    const Eigen::VectorXd theta = NeumannPoissonSolver(m).solve(divergence) / h;
    const Eigen::VectorXd flux = lattice.fluxFromPotential() * theta;
    EXPECT_LT((lattice.d2() * flux - divergence).cwiseAbs().maxCoeff(), 1e-12);

    double squares = 0.0;
    for (int k = 0; k < m; ++k)
    {
      for (int j = 0; j < m; ++j)
      {
        for (int i = 0; i < n; ++i)
        {
          const double exact = -pi * std::sin(pi * h * i) * integral(2, j) * integral(1, k);
          const double difference = flux[static_cast<Eigen::Index>(lattice.faceNumber(0, i, j, k))] - exact;
          squares += difference * difference / (h * h * h * h) * h * h * h;
        }
      }
    }
    spacings.push_back(h);
    errors.push_back(std::sqrt(squares));
  }
  EXPECT_NEAR(analytic::observedOrder(spacings, errors), 2.0, 0.1);
}

TEST(CubeLatticeOperators, FewerThanTwoNodesAreRefused)
{
  EXPECT_THROW(CubeLatticeOperators(1), InvalidInput);
}

TEST(CubeLatticeOperators, SpacingThatIsNotPositiveIsRefused)
{
  EXPECT_THROW(CubeLatticeOperators(4, 0.0), InvalidInput);
  EXPECT_THROW(CubeLatticeOperators(4, -1.0), InvalidInput);
  EXPECT_THROW(CubeLatticeOperators(4, std::numeric_limits<double>::infinity()), InvalidInput);
}
