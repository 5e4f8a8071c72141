#pragma once

#include <Eigen/Core>

namespace moserhex
{

/** Orthonormal DCT-II matrix, n x n: C(a,i) = s_a cos(pi a (i + 1/2) / n), s_0 = sqrt(1/n), else sqrt(2/n).
 * Its rows are the eigenvectors of the one-dimensional Laplacian of n cells with zero flux at both ends, eigenvalue
 * 2 - 2 cos(pi a / n); its transpose is the DCT-III and its inverse. \throws InvalidInput  n < 1 */
[[nodiscard]] Eigen::MatrixXd
cosineMatrix(int n);

/** Orthonormal DST-I matrix, n x n, symmetric and its own inverse: S(a,i) = sqrt(2/(n+1)) sin(pi (a+1)(i+1) / (n+1)).
 * Eigenvectors of the Laplacian of n interior nodes with zero values at both ends, eigenvalue
 * 2 - 2 cos(pi (a+1) / (n+1)). \throws InvalidInput  n < 1 */
[[nodiscard]] Eigen::MatrixXd
sineMatrix(int n);

/** Applies an n x n matrix along all three axes of a field of n^3 values, entry (i,j,k) at i + n (j + n k):
 * out(a,b,c) = sum M(a,i) M(b,j) M(c,k) in(i,j,k). O(n^4), meant for n <= 64. */
[[nodiscard]] Eigen::VectorXd
transformAllAxes(const Eigen::MatrixXd & matrix, const Eigen::VectorXd & field);

/** Solves L theta = f on m^3 unit cells, L = d2 *2^-1 d2^T the Laplacian of 3-forms with zero flux through the
 * boundary:
 *
 *   (L theta)(cell) = sum over its face neighbours of (theta(cell) - theta(neighbour))      positive semidefinite
 *
 * exactly (to round-off) by cosine transforms. Built once, used for every right-hand side. */
class NeumannPoissonSolver
{
public:
  /** \throws InvalidInput  cellsPerSide < 1 */
  explicit NeumannPoissonSolver(int cellsPerSide);

  /** The solution of mean zero. The mean of f, for which no solution exists, is removed first.
   * \throws InvalidInput  f does not have m^3 entries */
  [[nodiscard]] Eigen::VectorXd
  solve(const Eigen::VectorXd & f) const;

private:
  Eigen::MatrixXd m_Cosines;
  Eigen::MatrixXd m_CosinesTransposed;
  Eigen::VectorXd m_InverseEigenvalues; // 0 for the constant
};

/** Solves (1 + tau L) u = f or L u = f on m^3 interior nodes with zero values on the surrounding nodes,
 *
 *   (L u)(node) = 6 u(node) - sum over its six neighbours of u(neighbour)                     positive definite
 *
 * exactly by sine transforms. */
class DirichletLatticeSolver
{
public:
  /** \throws InvalidInput  nodesPerSide < 1 */
  explicit DirichletLatticeSolver(int nodesPerSide);

  [[nodiscard]] Eigen::VectorXd
  solvePoisson(const Eigen::VectorXd & f) const;

  /** \throws InvalidInput  tau < 0 */
  [[nodiscard]] Eigen::VectorXd
  solveHeatStep(const Eigen::VectorXd & f, double tau) const;

private:
  Eigen::MatrixXd m_Sines;
  Eigen::VectorXd m_Eigenvalues;
};

} // namespace moserhex
