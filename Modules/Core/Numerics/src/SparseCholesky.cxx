#include "moserhex/Numerics/SparseCholesky.h"

#include "moserhex/Common/Errors.h"

#include <Eigen/SparseCholesky>

#include <cmath>
#include <sstream>

namespace moserhex
{
namespace
{

bool
valuesAreFinite(const SparseCholesky::Matrix & A)
{
  for (Eigen::Index column = 0; column < A.outerSize(); ++column)
  {
    for (SparseCholesky::Matrix::InnerIterator entry(A, column); entry; ++entry)
    {
      if (!std::isfinite(entry.value()))
      {
        return false;
      }
    }
  }
  return true;
}

StepReport
failure(const std::string & note)
{
  StepReport report;
  report.note = note;
  return report;
}

} // namespace

struct SparseCholesky::Implementation
{
  Eigen::SimplicialLLT<Matrix, Eigen::Lower, Eigen::AMDOrdering<int>> factor;
  Eigen::Index                                                        size{ 0 };
  bool                                                                factorized{ false };
};

SparseCholesky::SparseCholesky() : m_Implementation(std::make_unique<Implementation>())
{}
SparseCholesky::~SparseCholesky() = default;
SparseCholesky::SparseCholesky(SparseCholesky &&) noexcept = default;
SparseCholesky &
SparseCholesky::operator=(SparseCholesky &&) noexcept = default;

void
SparseCholesky::analyzePattern(const Matrix & A)
{
  if (A.rows() != A.cols() || A.rows() == 0)
  {
    std::ostringstream message;
    message << "matrix of " << A.rows() << " x " << A.cols() << ", need square and not empty";
    throw InvalidInput(message.str());
  }
  m_Implementation->factor.analyzePattern(A);
  m_Implementation->size = A.rows();
  m_Implementation->factorized = false;
}

void
SparseCholesky::factorize(const Matrix & A)
{
  Implementation & self = *m_Implementation;
  if (self.size == 0 || A.rows() != self.size || A.cols() != self.size)
  {
    std::ostringstream message;
    message << "matrix of " << A.rows() << " x " << A.cols() << ", the pattern analysed has " << self.size << " rows";
    throw InvalidInput(message.str());
  }
  self.factorized = false;
  // A pivot that is not a number passes the test "pivot <= 0" inside the factorisation.
  if (!valuesAreFinite(A))
  {
    throw NotConverged("Cholesky factorisation: a matrix entry is not finite", failure("entry not finite"));
  }
  self.factor.factorize(A);
  if (self.factor.info() != Eigen::Success)
  {
    throw NotConverged("Cholesky factorisation: the matrix is not positive definite", failure("not positive definite"));
  }
  self.factorized = true;
}

void
SparseCholesky::compute(const Matrix & A)
{
  analyzePattern(A);
  factorize(A);
}

Eigen::MatrixXd
SparseCholesky::solve(const Eigen::MatrixXd & B) const
{
  if (!m_Implementation->factorized || B.rows() != m_Implementation->size)
  {
    std::ostringstream message;
    message << "right-hand side of " << B.rows() << " rows, need "
            << (m_Implementation->factorized ? m_Implementation->size : 0) << " (0: nothing was factorised)";
    throw InvalidInput(message.str());
  }
  Eigen::MatrixXd X = m_Implementation->factor.solve(B);
  if (!X.allFinite())
  {
    throw NotConverged("Cholesky solution is not finite", failure("solution not finite"));
  }
  return X;
}

double
relativeResidual(const SparseCholesky::Matrix & A, const Eigen::MatrixXd & X, const Eigen::MatrixXd & B)
{
  const Eigen::MatrixXd residual = A.selfadjointView<Eigen::Lower>() * X - B;
  double                squares = 0.0;
  for (Eigen::Index column = 0; column < A.outerSize(); ++column)
  {
    for (SparseCholesky::Matrix::InnerIterator entry(A, column); entry; ++entry)
    {
      const double multiplicity = entry.row() > entry.col() ? 2.0 : entry.row() == entry.col() ? 1.0 : 0.0;
      squares += multiplicity * entry.value() * entry.value();
    }
  }
  const double scale = std::sqrt(squares) * X.norm() + B.norm();
  return scale > 0.0 ? residual.norm() / scale : 0.0;
}

} // namespace moserhex
