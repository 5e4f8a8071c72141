#include "moserhex/Numerics/CosineTransform.h"

#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Types.h"

#include <cmath>
#include <string>

namespace moserhex
{
namespace
{

void
requirePositive(int n, const char * what)
{
  if (n < 1)
  {
    throw InvalidInput(std::string(what) + " " + std::to_string(n) + ", must be at least 1");
  }
}

/** One field, not several. */
void
requireCube(const Eigen::VectorXd & field, Eigen::Index n)
{
  if (field.size() != n * n * n)
  {
    throw InvalidInput("field of " + std::to_string(field.size()) + " values, must be " + std::to_string(n) +
                       "^3 = " + std::to_string(n * n * n));
  }
}

Eigen::VectorXd
applied(const SpectralOperator & matrix, Eigen::VectorXd field, unsigned int threads)
{
  requireCube(field, matrix.transform().size());
  matrix.applyInPlace(field, ComponentOrder::Interleaved, threads);
  return field;
}
} // namespace

Eigen::MatrixXd
cosineMatrix(int n)
{
  requirePositive(n, "size of the cosine transform");
  Eigen::MatrixXd matrix(n, n);
  for (int a = 0; a < n; ++a)
  {
    const double scale = std::sqrt((a == 0 ? 1.0 : 2.0) / n);
    for (int i = 0; i < n; ++i)
    {
      matrix(a, i) = scale * std::cos(pi * a * (i + 0.5) / n);
    }
  }
  return matrix;
}

Eigen::MatrixXd
sineMatrix(int n)
{
  requirePositive(n, "size of the sine transform");
  Eigen::MatrixXd matrix(n, n);
  for (int a = 0; a < n; ++a)
  {
    for (int i = 0; i < n; ++i)
    {
      matrix(a, i) = std::sqrt(2.0 / (n + 1)) * std::sin(pi * (a + 1) * (i + 1) / (n + 1));
    }
  }
  return matrix;
}

NeumannPoissonSolver::NeumannPoissonSolver(int cellsPerSide)
  : m_Inverse(functionOfLaplacian(cellsPerSide, CubeTransform::Basis::Cosine, [](double lambda) {
    return lambda > 0.0 ? 1.0 / lambda : 0.0; // the constant has no inverse
  }))
{}

Eigen::VectorXd
NeumannPoissonSolver::solve(const Eigen::VectorXd & f, unsigned int threads) const
{
  return applied(m_Inverse, f, threads);
}

DirichletLatticeSolver::DirichletLatticeSolver(int nodesPerSide)
  : m_Inverse(functionOfLaplacian(nodesPerSide, CubeTransform::Basis::Sine, [](double lambda) { return 1.0 / lambda; }))
{}

Eigen::VectorXd
DirichletLatticeSolver::solvePoisson(const Eigen::VectorXd & f, unsigned int threads) const
{
  return applied(m_Inverse, f, threads);
}

Eigen::VectorXd
DirichletLatticeSolver::solveHeatStep(const Eigen::VectorXd & f, double tau, unsigned int threads) const
{
  if (!(tau >= 0.0))
  {
    throw InvalidInput("diffusion time " + std::to_string(tau) + ", must not be negative");
  }
  const auto symbol = m_Inverse.symbol().array(); // 1 / lambda
  return applied(SpectralOperator(m_Inverse.transform(), (symbol / (symbol + tau)).matrix()), f, threads);
}

} // namespace moserhex
