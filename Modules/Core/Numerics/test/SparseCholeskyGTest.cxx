// Round-off class: a direct solver has no discretisation error; 1e-10 leaves room for the condition numbers used here.
#include "moserhex/Common/Errors.h"
#include "moserhex/Numerics/SparseCholesky.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <limits>

using namespace moserhex;

namespace
{

/** Five-point Laplacian of an m x m grid plus shift on the diagonal: eigenvalues 4 - 2 cos - 2 cos + shift. */
SparseCholesky::Matrix
gridLaplacian(int m, double shift)
{
  std::vector<Eigen::Triplet<double>> triplets;
  for (int j = 0; j < m; ++j)
  {
    for (int i = 0; i < m; ++i)
    {
      const int v = i + m * j;
      triplets.emplace_back(v, v, 4.0 + shift);
      for (const int w : { i > 0 ? v - 1 : -1, i + 1 < m ? v + 1 : -1, j > 0 ? v - m : -1, j + 1 < m ? v + m : -1 })
      {
        if (w >= 0)
        {
          triplets.emplace_back(v, w, -1.0);
        }
      }
    }
  }
  SparseCholesky::Matrix A(m * m, m * m);
  A.setFromTriplets(triplets.begin(), triplets.end());
  return A;
}

Eigen::MatrixXd
rightHandSides(Eigen::Index rows)
{
  Eigen::MatrixXd B(rows, 2);
  for (Eigen::Index i = 0; i < rows; ++i)
  {
    B(i, 0) = std::sin(0.1 * static_cast<double>(i));
    B(i, 1) = 1.0 / static_cast<double>(i + 1);
  }
  return B;
}

} // namespace

TEST(SparseCholesky, SolutionEqualsTheDenseSolution)
{
  const auto            A = gridLaplacian(12, 0.01);
  const Eigen::MatrixXd B = rightHandSides(A.rows());
  SparseCholesky        cholesky;
  cholesky.compute(A);
  const Eigen::MatrixXd dense = Eigen::MatrixXd(A).ldlt().solve(B);
  EXPECT_LT((cholesky.solve(B) - dense).norm(), 1e-10 * dense.norm());
}

TEST(SparseCholesky, ResidualIsRoundOff)
{
  const auto            A = gridLaplacian(40, 0.0);
  const Eigen::MatrixXd B = rightHandSides(A.rows());
  SparseCholesky        cholesky;
  cholesky.compute(A);
  const Eigen::MatrixXd X = cholesky.solve(B);
  EXPECT_LT(relativeResidual(A, X, B), 1e-14);
  EXPECT_GT(relativeResidual(A, 1.001 * X, B), 1e-6) << "the residual must see an error of one in a thousand";
}

TEST(SparseCholesky, OnlyTheLowerTriangleIsRead)
{
  const auto             A = gridLaplacian(8, 0.1);
  SparseCholesky::Matrix lower = A.triangularView<Eigen::Lower>();
  const Eigen::MatrixXd  B = rightHandSides(A.rows());
  SparseCholesky         whole;
  SparseCholesky         half;
  whole.compute(A);
  half.compute(lower);
  EXPECT_EQ(whole.solve(B), half.solve(B));
  EXPECT_EQ(relativeResidual(A, B, B), relativeResidual(lower, B, B));
}

TEST(SparseCholesky, AnalysisIsReusedForNewValues)
{
  SparseCholesky cholesky;
  cholesky.analyzePattern(gridLaplacian(10, 0.0));
  const Eigen::MatrixXd B = rightHandSides(100);
  for (const double shift : { 0.0, 1.0, 100.0 })
  {
    const auto A = gridLaplacian(10, shift);
    cholesky.factorize(A);
    SparseCholesky fresh;
    fresh.compute(A);
    EXPECT_EQ(cholesky.solve(B), fresh.solve(B)) << "shift " << shift;
  }
}

TEST(SparseCholesky, IndefiniteMatrixIsNotConverged)
{
  SparseCholesky cholesky;
  EXPECT_THROW(cholesky.compute(gridLaplacian(10, -5.0)), NotConverged);
}

TEST(SparseCholesky, EntryThatIsNotFiniteIsNotConverged)
{
  auto A = gridLaplacian(10, 0.0);
  A.coeffRef(37, 37) = std::numeric_limits<double>::quiet_NaN();
  SparseCholesky cholesky;
  EXPECT_THROW(cholesky.compute(A), NotConverged);
}

TEST(SparseCholesky, SolutionThatIsNotFiniteIsNotConverged)
{
  SparseCholesky cholesky;
  cholesky.compute(gridLaplacian(3, 0.0));
  EXPECT_THROW((void)cholesky.solve(Eigen::MatrixXd::Constant(9, 1, std::numeric_limits<double>::infinity())),
               NotConverged);
}

TEST(SparseCholesky, WrongSizesAndOrderOfCallsAreRefused)
{
  SparseCholesky cholesky;
  EXPECT_THROW(cholesky.analyzePattern(SparseCholesky::Matrix(3, 4)), InvalidInput);
  EXPECT_THROW(cholesky.analyzePattern(SparseCholesky::Matrix(0, 0)), InvalidInput);
  EXPECT_THROW(cholesky.factorize(gridLaplacian(3, 0.0)), InvalidInput) << "pattern not analysed";
  cholesky.analyzePattern(gridLaplacian(3, 0.0));
  EXPECT_THROW(cholesky.factorize(gridLaplacian(4, 0.0)), InvalidInput);
  EXPECT_THROW((void)cholesky.solve(Eigen::MatrixXd::Ones(9, 1)), InvalidInput) << "nothing factorised";
  cholesky.factorize(gridLaplacian(3, 0.0));
  EXPECT_THROW((void)cholesky.solve(Eigen::MatrixXd::Ones(8, 1)), InvalidInput);
}
