#include "moserhex/Numerics/CosineTransform.h"

#include "moserhex/Common/Errors.h"

#include <cmath>
#include <string>

namespace moserhex
{
namespace
{
const double pi = std::acos(-1.0);

void
requirePositive(int n, const char * what)
{
  if (n < 1)
  {
    throw InvalidInput(std::string(what) + " " + std::to_string(n) + ", must be at least 1");
  }
}

void
requireCube(const Eigen::VectorXd & field, Eigen::Index n)
{
  if (field.size() != n * n * n)
  {
    throw InvalidInput("field of " + std::to_string(field.size()) + " values, must be " + std::to_string(n) +
                       "^3 = " + std::to_string(n * n * n));
  }
}

/** values(a + n (b + n c)) = one[a] + one[b] + one[c]. */
Eigen::VectorXd
sumOverAxes(const Eigen::VectorXd & one)
{
  const Eigen::Index n = one.size();
  Eigen::VectorXd    values(n * n * n);
  for (Eigen::Index c = 0; c < n; ++c)
  {
    for (Eigen::Index b = 0; b < n; ++b)
    {
      values.segment(n * (b + n * c), n) = one.array() + (one[b] + one[c]);
    }
  }
  return values;
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

Eigen::VectorXd
transformAllAxes(const Eigen::MatrixXd & matrix, const Eigen::VectorXd & field)
{
  const Eigen::Index n = matrix.rows();
  requireCube(field, n);
  using ConstMap = Eigen::Map<const Eigen::MatrixXd>;
  using Map = Eigen::Map<Eigen::MatrixXd>;

  Eigen::VectorXd alongI(field.size());
  Map(alongI.data(), n, n * n).noalias() = matrix * ConstMap(field.data(), n, n * n);
  Eigen::VectorXd alongJ(field.size());
  for (Eigen::Index k = 0; k < n; ++k)
  {
    Map(alongJ.data() + n * n * k, n, n).noalias() = ConstMap(alongI.data() + n * n * k, n, n) * matrix.transpose();
  }
  Map(alongI.data(), n * n, n).noalias() = ConstMap(alongJ.data(), n * n, n) * matrix.transpose();
  return alongI;
}

NeumannPoissonSolver::NeumannPoissonSolver(int cellsPerSide)
  : m_Cosines(cosineMatrix(cellsPerSide)), m_CosinesTransposed(m_Cosines.transpose())
{
  Eigen::VectorXd eigenvalues(cellsPerSide);
  for (int a = 0; a < cellsPerSide; ++a)
  {
    eigenvalues[a] = 2.0 - 2.0 * std::cos(pi * a / cellsPerSide);
  }
  m_InverseEigenvalues = sumOverAxes(eigenvalues);
  m_InverseEigenvalues[0] = 1.0;
  m_InverseEigenvalues = m_InverseEigenvalues.cwiseInverse().eval();
  m_InverseEigenvalues[0] = 0.0;
}

Eigen::VectorXd
NeumannPoissonSolver::solve(const Eigen::VectorXd & f) const
{
  const Eigen::VectorXd spectrum = transformAllAxes(m_Cosines, f);
  return transformAllAxes(m_CosinesTransposed, spectrum.cwiseProduct(m_InverseEigenvalues));
}

DirichletLatticeSolver::DirichletLatticeSolver(int nodesPerSide) : m_Sines(sineMatrix(nodesPerSide))
{
  Eigen::VectorXd eigenvalues(nodesPerSide);
  for (int a = 0; a < nodesPerSide; ++a)
  {
    eigenvalues[a] = 2.0 - 2.0 * std::cos(pi * (a + 1) / (nodesPerSide + 1));
  }
  m_Eigenvalues = sumOverAxes(eigenvalues);
}

Eigen::VectorXd
DirichletLatticeSolver::solvePoisson(const Eigen::VectorXd & f) const
{
  return transformAllAxes(m_Sines, transformAllAxes(m_Sines, f).cwiseQuotient(m_Eigenvalues));
}

Eigen::VectorXd
DirichletLatticeSolver::solveHeatStep(const Eigen::VectorXd & f, double tau) const
{
  if (!(tau >= 0.0))
  {
    throw InvalidInput("diffusion time " + std::to_string(tau) + ", must not be negative");
  }
  const Eigen::VectorXd spectrum = transformAllAxes(m_Sines, f);
  return transformAllAxes(m_Sines, (spectrum.array() / (1.0 + tau * m_Eigenvalues.array())).matrix());
}

} // namespace moserhex
