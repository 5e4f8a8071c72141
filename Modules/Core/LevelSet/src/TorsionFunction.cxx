#include "moserhex/LevelSet/TorsionFunction.h"

#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Stopwatch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <sstream>

namespace moserhex
{
namespace
{

/** The matrix of h^2 (-Lap) on the nodes inside. All off-diagonal entries are -1, so only their columns are stored;
 * a neighbour outside has the column of a ghost entry that is always zero. */
struct SevenPointOperator
{
  std::vector<std::size_t>                 nodes; ///< grid node of each row
  std::vector<std::array<std::int32_t, 6>> columns;
  std::vector<double>                      diagonal;

  [[nodiscard]] std::size_t
  size() const
  {
    return nodes.size();
  }

  /** y = A x; x has size() + 1 entries, the last one 0. Returns x.y. */
  double
  multiply(const std::vector<double> & x, std::vector<double> & y) const
  {
    double product = 0.0;
    for (std::size_t row = 0; row < size(); ++row)
    {
      const auto & c = columns[row];
      y[row] = diagonal[row] * x[row] - ((x[c[0]] + x[c[1]]) + (x[c[2]] + x[c[3]]) + (x[c[4]] + x[c[5]]));
      product += x[row] * y[row];
    }
    return product;
  }
};

void
requireUsable(const LevelSet & phi, const TorsionFunctionOptions & options)
{
  requireValid(phi, "torsion function");
  if (!(options.relativeTolerance > 0.0 && options.relativeTolerance < 1.0) || options.maximumIterations < 1 ||
      !(options.smallestFraction > 0.0 && options.smallestFraction < 1.0))
  {
    std::ostringstream message;
    message << "torsion function: relativeTolerance = " << options.relativeTolerance
            << " (need (0,1)), maximumIterations = " << options.maximumIterations
            << " (need >= 1), smallestFraction = " << options.smallestFraction << " (need (0,1))";
    throw InvalidInput(message.str());
  }
}

SevenPointOperator
assemble(const LevelSet & phi, double smallestFraction)
{
  const RegularGrid &       grid = phi.grid;
  SevenPointOperator        matrix;
  std::vector<std::int32_t> rowOfNode(phi.values.size(), -1);
  for (std::size_t node = 0; node < phi.values.size(); ++node)
  {
    if (phi.values[node] < 0.0)
    {
      if (grid.isBorder(node))
      {
        throw InvalidInput("torsion function: border node " + std::to_string(node) + " lies inside the organ");
      }
      rowOfNode[node] = static_cast<std::int32_t>(matrix.nodes.size());
      matrix.nodes.push_back(node);
    }
  }
  if (matrix.nodes.empty())
  {
    throw InvalidInput("torsion function: 0 nodes inside the organ, need at least 1");
  }
  const auto                          ghost = static_cast<std::int32_t>(matrix.nodes.size());
  const std::array<std::ptrdiff_t, 6> strides{ grid.stride(1, 0, 0),  grid.stride(-1, 0, 0), grid.stride(0, 1, 0),
                                               grid.stride(0, -1, 0), grid.stride(0, 0, 1),  grid.stride(0, 0, -1) };
  matrix.columns.resize(matrix.size());
  matrix.diagonal.assign(matrix.size(), 0.0);
  for (std::size_t row = 0; row < matrix.size(); ++row)
  {
    const double inside = phi.values[matrix.nodes[row]];
    for (std::size_t e = 0; e < strides.size(); ++e)
    {
      const std::size_t  neighbour = matrix.nodes[row] + static_cast<std::size_t>(strides[e]);
      const std::int32_t column = rowOfNode[neighbour];
      matrix.columns[row][e] = column >= 0 ? column : ghost;
      // An infinite value outside gives the fraction 0, bounded like any other.
      const double fraction = inside / (inside - phi.values[neighbour]);
      matrix.diagonal[row] += column >= 0 ? 1.0 : 1.0 / std::max(smallestFraction, fraction);
    }
  }
  return matrix;
}

double
residualNorm(const SevenPointOperator & matrix, const std::vector<double> & x, double rightHandSide)
{
  std::vector<double> product(matrix.size());
  matrix.multiply(x, product);
  double sum = 0.0;
  for (const double value : product)
  {
    sum += (rightHandSide - value) * (rightHandSide - value);
  }
  return std::sqrt(sum);
}

/** Solves A x = b for the constant right-hand side b; x gets the ghost entry at its end. */
std::vector<double>
conjugateGradients(const SevenPointOperator &     matrix,
                   double                         b,
                   const TorsionFunctionOptions & options,
                   StepReport &                   report)
{
  const std::size_t   n = matrix.size();
  std::vector<double> x(n + 1, 0.0);
  std::vector<double> p(n + 1, 0.0);
  std::vector<double> r(n, b);
  std::vector<double> q(n);
  double              rho = 0.0;
  for (std::size_t i = 0; i < n; ++i)
  {
    p[i] = r[i] / matrix.diagonal[i];
    rho += r[i] * p[i];
  }
  const double norm = b * std::sqrt(static_cast<double>(n));
  double       squaredResidual = norm * norm;
  while (squaredResidual > std::pow(options.relativeTolerance * norm, 2) && report.steps < options.maximumIterations)
  {
    const double alpha = rho / matrix.multiply(p, q);
    double       nextRho = 0.0;
    squaredResidual = 0.0;
    for (std::size_t i = 0; i < n; ++i)
    {
      x[i] += alpha * p[i];
      r[i] -= alpha * q[i];
      squaredResidual += r[i] * r[i];
      nextRho += r[i] * r[i] / matrix.diagonal[i];
    }
    const double beta = nextRho / rho;
    rho = nextRho;
    for (std::size_t i = 0; i < n; ++i)
    {
      p[i] = r[i] / matrix.diagonal[i] + beta * p[i];
    }
    ++report.steps;
  }
  report.residual = residualNorm(matrix, x, b) / norm;
  return x;
}

} // namespace

TorsionFunctionResult
torsionFunction(const LevelSet & phi, const TorsionFunctionOptions & options)
{
  requireUsable(phi, options);
  const Stopwatch          watch;
  const SevenPointOperator matrix = assemble(phi, options.smallestFraction);
  const double             h = phi.grid.spacing;

  TorsionFunctionResult     result;
  const std::vector<double> x = conjugateGradients(matrix, h * h, options, result.report);
  result.report.seconds = watch.seconds();
  // The recursive residual that stops the iteration and the true one part by round-off only.
  result.report.converged = result.report.residual <= 2 * options.relativeTolerance;
  if (!result.report.converged)
  {
    std::ostringstream message;
    message << "torsion function: relative residual " << result.report.residual << " after " << result.report.steps
            << " steps of conjugate gradients, need " << options.relativeTolerance;
    throw NotConverged(message.str(), result.report);
  }
  result.levelSet = { phi.grid, std::vector<double>(phi.values.size(), 0.0) };
  for (std::size_t row = 0; row < matrix.size(); ++row)
  {
    result.levelSet.values[matrix.nodes[row]] = std::max(0.0, x[row]);
  }
  return result;
}

} // namespace moserhex
