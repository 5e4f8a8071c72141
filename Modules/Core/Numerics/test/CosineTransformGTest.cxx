// Orthogonality and solves: round-off (1e-12 relative to the field). Two roads: a sparse factorisation of the same
// Laplacian gives the same potential (1e-11).
#include "moserhex/Numerics/CosineTransform.h"

#include "RandomField.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Types.h"

#include <Eigen/SparseCholesky>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace moserhex;

namespace
{
/** Graph Laplacian of m^3 lattice points; `degree` 6 everywhere (zero values around) or the number of neighbours. */
Eigen::SparseMatrix<double>
latticeLaplacian(int m, bool zeroAround)
{
  std::vector<Eigen::Triplet<double>> triplets;
  const auto                          number = [m](int i, int j, int k) { return i + m * (j + m * k); };
  const int steps[6][3] = { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } };
  for (int k = 0; k < m; ++k)
  {
    for (int j = 0; j < m; ++j)
    {
      for (int i = 0; i < m; ++i)
      {
        for (const auto & step : steps)
        {
          const int  a = i + step[0];
          const int  b = j + step[1];
          const int  c = k + step[2];
          const bool exists = a >= 0 && b >= 0 && c >= 0 && a < m && b < m && c < m;
          if (exists)
          {
            triplets.emplace_back(number(i, j, k), number(a, b, c), -1.0);
          }
          if (exists || zeroAround)
          {
            triplets.emplace_back(number(i, j, k), number(i, j, k), 1.0);
          }
        }
      }
    }
  }
  Eigen::SparseMatrix<double> matrix(m * m * m, m * m * m);
  matrix.setFromTriplets(triplets.begin(), triplets.end());
  return matrix;
}
} // namespace

TEST(CosineTransform, MatricesAreOrthonormal)
{
  for (const int n : { 1, 2, 3, 7, 19, 64 })
  {
    const Eigen::MatrixXd cosines = cosineMatrix(n);
    const Eigen::MatrixXd sines = sineMatrix(n);
    const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(n, n);
    EXPECT_LT((cosines * cosines.transpose() - identity).cwiseAbs().maxCoeff(), 1e-13) << n;
    EXPECT_LT((sines * sines - identity).cwiseAbs().maxCoeff(), 1e-13) << n;
    EXPECT_LT((sines - sines.transpose()).cwiseAbs().maxCoeff(), 1e-13) << n;
  }
}

TEST(CosineTransform, RowsAreEigenvectorsOfTheOneDimensionalLaplacian)
{
  const int             n = 9;
  const Eigen::MatrixXd cosines = cosineMatrix(n);
  for (int a = 0; a < n; ++a)
  {
    const double eigenvalue = 2.0 - 2.0 * std::cos(pi * a / n);
    for (int i = 0; i < n; ++i)
    {
      double laplacian = 0.0;
      laplacian += i > 0 ? cosines(a, i) - cosines(a, i - 1) : 0.0;
      laplacian += i + 1 < n ? cosines(a, i) - cosines(a, i + 1) : 0.0;
      EXPECT_NEAR(laplacian, eigenvalue * cosines(a, i), 1e-13);
    }
  }
}

TEST(NeumannPoisson, SolutionSatisfiesTheEquationAndHasMeanZero)
{
  for (const int m : { 1, 2, 5, 19 })
  {
    Eigen::VectorXd f = randomField(m * m * m, 7);
    f.array() -= f.mean();
    const Eigen::VectorXd theta = NeumannPoissonSolver(m).solve(f);
    EXPECT_LT((latticeLaplacian(m, false) * theta - f).cwiseAbs().maxCoeff(), 1e-12) << m;
    EXPECT_NEAR(theta.mean(), 0.0, 1e-13) << m;
  }
}

TEST(NeumannPoisson, AgreesWithASparseFactorisation)
{
  const int       m = 8;
  Eigen::VectorXd f = randomField(m * m * m, 8);
  f.array() -= f.mean();
  // Fix the constant by adding 1 to one diagonal entry, then remove the mean.
  Eigen::SparseMatrix<double> matrix = latticeLaplacian(m, false);
  matrix.coeffRef(0, 0) += 1.0;
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(matrix);
  ASSERT_EQ(factor.info(), Eigen::Success);
  Eigen::VectorXd direct = factor.solve(f);
  direct.array() -= direct.mean();
  EXPECT_LT((NeumannPoissonSolver(m).solve(f) - direct).cwiseAbs().maxCoeff(), 1e-11);
}

TEST(NeumannPoisson, TheMeanOfTheRightHandSideIsIgnored)
{
  const NeumannPoissonSolver solver(6);
  const Eigen::VectorXd      f = randomField(216, 9);
  const Eigen::VectorXd      shifted = f.array() + 5.0;
  EXPECT_LT((solver.solve(f) - solver.solve(shifted)).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(DirichletLattice, PoissonSolutionSatisfiesTheEquation)
{
  for (const int m : { 1, 4, 18 })
  {
    const Eigen::VectorXd f = randomField(m * m * m, 10);
    const Eigen::VectorXd u = DirichletLatticeSolver(m).solvePoisson(f);
    EXPECT_LT((latticeLaplacian(m, true) * u - f).cwiseAbs().maxCoeff(), 1e-12) << m;
  }
}

TEST(DirichletLattice, HeatStepSatisfiesTheEquation)
{
  const int             m = 7;
  const Eigen::VectorXd f = randomField(m * m * m, 11);
  for (const double tau : { 0.0, 0.3, 50.0 })
  {
    const Eigen::VectorXd u = DirichletLatticeSolver(m).solveHeatStep(f, tau);
    EXPECT_LT((u + tau * (latticeLaplacian(m, true) * u) - f).cwiseAbs().maxCoeff(), 1e-12) << tau;
  }
}

TEST(CosineTransform, SizesBelowOneAreRefused)
{
  EXPECT_THROW(static_cast<void>(cosineMatrix(0)), InvalidInput);
  EXPECT_THROW(static_cast<void>(sineMatrix(-1)), InvalidInput);
  EXPECT_THROW(NeumannPoissonSolver(0), InvalidInput);
  EXPECT_THROW(DirichletLatticeSolver(0), InvalidInput);
}

TEST(CosineTransform, FieldOfAnotherSizeIsRefused)
{
  EXPECT_THROW(static_cast<void>(NeumannPoissonSolver(3).solve(Eigen::VectorXd::Zero(9))), InvalidInput);
  EXPECT_THROW(static_cast<void>(DirichletLatticeSolver(3).solvePoisson(Eigen::VectorXd::Zero(9))), InvalidInput);
}

TEST(DirichletLattice, NegativeTimeIsRefused)
{
  EXPECT_THROW(static_cast<void>(DirichletLatticeSolver(2).solveHeatStep(Eigen::VectorXd::Zero(8), -0.1)),
               InvalidInput);
}
