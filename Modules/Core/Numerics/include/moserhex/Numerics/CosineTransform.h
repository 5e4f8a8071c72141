#pragma once

#include "moserhex/Numerics/CubeTransform.h"

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

/** Solves L theta = f on m^3 unit cells, L = d2 *2^-1 d2^T the Laplacian of 3-forms with zero flux through the
 * boundary:
 *
 *   (L theta)(cell) = sum over its face neighbours of (theta(cell) - theta(neighbour))      positive semidefinite
 *
 * exactly (to round-off) by cosine transforms. Built once, used for every right-hand side, by any number of threads at
 * once. */
class NeumannPoissonSolver
{
public:
  /** \throws InvalidInput  cellsPerSide < 1 */
  explicit NeumannPoissonSolver(int cellsPerSide);

  /** The solution of mean zero. The mean of f, for which no solution exists, is removed first. \param threads  0: all.
   * \throws InvalidInput  f does not have m^3 entries */
  [[nodiscard]] Eigen::VectorXd
  solve(const Eigen::VectorXd & f, unsigned int threads = 1) const;

private:
  SpectralOperator m_Inverse;
};

/** Solves (1 + tau L) u = f or L u = f on m^3 interior nodes with zero values on the surrounding nodes,
 *
 *   (L u)(node) = 6 u(node) - sum over its six neighbours of u(neighbour)                     positive definite
 *
 * exactly by sine transforms. Built once, used for every right-hand side, by any number of threads at once. */
class DirichletLatticeSolver
{
public:
  /** \throws InvalidInput  nodesPerSide < 1 */
  explicit DirichletLatticeSolver(int nodesPerSide);

  /** \throws InvalidInput  f does not have m^3 entries */
  [[nodiscard]] Eigen::VectorXd
  solvePoisson(const Eigen::VectorXd & f, unsigned int threads = 1) const;

  /** \throws InvalidInput  f does not have m^3 entries, or tau < 0 */
  [[nodiscard]] Eigen::VectorXd
  solveHeatStep(const Eigen::VectorXd & f, double tau, unsigned int threads = 1) const;

private:
  SpectralOperator m_Inverse; // of L
};

} // namespace moserhex
