#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <memory>

namespace moserhex
{

/** A = P^T L L^T P for sparse symmetric positive definite A, with every step checked.
 *
 * The order of elimination and the pattern of L depend on the pattern of A only: analyse once, factorise many matrices
 * of one pattern. Only the lower triangle of A is read. Deterministic, single-threaded.
 * Throws rather than return numbers that mean nothing. */
class SparseCholesky
{
public:
  using Matrix = Eigen::SparseMatrix<double>; ///< A; its lower triangle is read

  SparseCholesky();
  ~SparseCholesky();
  /** What was moved from may only be assigned to or destroyed. */
  SparseCholesky(SparseCholesky &&) noexcept;
  /** What was moved from may only be assigned to or destroyed. */
  SparseCholesky &
  operator=(SparseCholesky &&) noexcept;

  /** Minimum-degree order of elimination and the pattern of L. \throws InvalidInput  A is empty or not square */
  void
  analyzePattern(const Matrix & A);

  /** The values of L. A has the pattern given to analyzePattern.
   * \throws InvalidInput  analyzePattern was not called, or for another size
   * \throws NotConverged  A is not positive definite, or holds a number that is not finite */
  void
  factorize(const Matrix & A);

  /** analyzePattern, then factorize. */
  void
  compute(const Matrix & A);

  /** X with A X = B, one column for each right-hand side.
   * \throws InvalidInput  nothing was factorised, or the rows of B do not match
   * \throws NotConverged  the solution is not finite */
  [[nodiscard]] Eigen::MatrixXd
  solve(const Eigen::MatrixXd & B) const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> m_Implementation;
};

/** |A X - B| / (|A| |X| + |B|) in the Frobenius norm [1]: of the order of round-off when X was solved well.
 * A is symmetric with its lower triangle stored; entries above the diagonal are not read. */
[[nodiscard]] double
relativeResidual(const SparseCholesky::Matrix & A, const Eigen::MatrixXd & X, const Eigen::MatrixXd & B);

} // namespace moserhex
