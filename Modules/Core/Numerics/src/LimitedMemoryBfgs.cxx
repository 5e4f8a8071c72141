#include "moserhex/Numerics/LimitedMemoryBfgs.h"

#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Stopwatch.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <string>
#include <utility>
#include <vector>

namespace moserhex
{
namespace
{
using Vector = Eigen::VectorXd;

/** A pair is kept when its curvature s.y is at least this part of the expected decrease. */
constexpr double smallestCurvature = 1e-12;

void
require(bool holds, const std::string & what)
{
  if (!holds)
  {
    throw InvalidInput("L-BFGS: " + what);
  }
}

void
requireOptions(const LimitedMemoryBfgsOptions & options)
{
  require(options.maximumSteps >= 0, "number of steps must not be negative");
  require(options.memory >= 1, "memory must be at least 1");
  require(options.window >= 1, "window must be at least 1");
  require(options.smallestDecrease >= 0.0, "smallest decrease must not be negative");
  require(options.sufficientDecrease > 0.0 && options.sufficientDecrease < 0.5, "Armijo's constant must be in (0,1/2)");
  require(options.maximumTrials >= 1, "number of trials must be at least 1");
}

/** The inverse Hessian from the last pairs s = x' - x, y = g' - g. */
class InverseHessian
{
public:
  InverseHessian(const PreconditionerInPlace & preconditioner, int memory)
    : m_Preconditioner(preconditioner), m_Memory(static_cast<std::size_t>(memory))
  {}

  [[nodiscard]] bool
  isInitial() const
  {
    return m_Pairs.empty();
  }

  void
  restart()
  {
    m_Pairs.clear();
  }

  void
  add(Vector s, Vector y)
  {
    const double curvature = s.dot(y);
    Vector       preconditioned = y;
    precondition(preconditioned);
    m_Scale = curvature / y.dot(preconditioned);
    m_Pairs.push_back({ std::move(s), std::move(y), 1.0 / curvature });
    if (m_Pairs.size() > m_Memory)
    {
      m_Pairs.pop_front();
    }
  }

  [[nodiscard]] Vector
  times(const Vector & gradient) const
  {
    Vector              result = gradient;
    std::vector<double> alpha(m_Pairs.size());
    for (std::size_t p = m_Pairs.size(); p-- > 0;)
    {
      alpha[p] = m_Pairs[p].rho * m_Pairs[p].s.dot(result);
      result -= alpha[p] * m_Pairs[p].y;
    }
    precondition(result);
    result *= m_Scale;
    for (std::size_t p = 0; p < m_Pairs.size(); ++p)
    {
      result += (alpha[p] - m_Pairs[p].rho * m_Pairs[p].y.dot(result)) * m_Pairs[p].s;
    }
    return result;
  }

private:
  struct Pair
  {
    Vector s;
    Vector y;
    double rho;
  };

  void
  precondition(Vector & v) const
  {
    if (m_Preconditioner)
    {
      m_Preconditioner(v);
    }
  }

  const PreconditionerInPlace & m_Preconditioner;
  std::size_t                   m_Memory;
  std::deque<Pair>              m_Pairs;
  double                        m_Scale{ 1.0 };
};

/** Where the parabola through f, its slope and the value at `step` is lowest, kept within [0.1, 0.5] of the step. */
double
shorterStep(double step, double slope, double value, double trial)
{
  const double lowest = std::isfinite(trial) ? -slope * step * step / (2.0 * (trial - value - step * slope)) : 0.0;
  return std::min(0.5 * step, std::max(0.1 * step, lowest));
}
} // namespace

LimitedMemoryBfgsResult
minimiseByLimitedMemoryBfgs(const DifferentiableFunction &   f,
                            Vector &                         x,
                            const PreconditionerInPlace &    preconditioner,
                            const LimitedMemoryBfgsOptions & options,
                            const ProgressCallback &         progress)
{
  requireOptions(options);
  const Stopwatch         stopwatch;
  LimitedMemoryBfgsResult result;
  InverseHessian          inverseHessian(preconditioner, options.memory);
  Vector                  gradient(x.size());
  Vector                  trialGradient(x.size());
  double                  value = f(x, gradient);
  double                  windowStart = value;
  result.evaluations = 1;
  require(std::isfinite(value) && gradient.allFinite(), "the function is not finite at the start");

  int & steps = result.report.steps;
  while (steps < options.maximumSteps)
  {
    reportProgress(progress, static_cast<double>(steps) / options.maximumSteps);
    Vector direction = inverseHessian.times(gradient);
    double slope = -gradient.dot(direction);
    if (!(slope < 0.0) && !inverseHessian.isInitial())
    {
      inverseHessian.restart();
      continue;
    }
    if (!(slope < 0.0))
    {
      result.report.converged = true; // the gradient vanishes
      break;
    }
    double step = 1.0;
    double trialValue = 0.0;
    Vector trial;
    int    trials = 0;
    bool   accepted = false;
    for (; trials < options.maximumTrials && !accepted; ++trials)
    {
      trial = x - step * direction;
      trialValue = f(trial, trialGradient);
      ++result.evaluations;
      accepted = std::isfinite(trialValue) && trialValue <= value + options.sufficientDecrease * step * slope;
      if (!accepted)
      {
        step = shorterStep(step, slope, value, trialValue);
      }
    }
    if (!accepted && inverseHessian.isInitial())
    {
      result.report.note = "the line search failed";
      break;
    }
    if (!accepted)
    {
      inverseHessian.restart();
      continue;
    }
    Vector s = trial - x;
    Vector y = trialGradient - gradient;
    if (s.dot(y) > smallestCurvature * std::abs(slope))
    {
      inverseHessian.add(std::move(s), std::move(y));
    }
    x.swap(trial);
    gradient.swap(trialGradient);
    value = trialValue;
    ++steps;
    if (steps % options.window == 0)
    {
      result.report.residual = value != 0.0 ? (windowStart - value) / std::abs(value) : 0.0;
      if (result.report.residual < options.smallestDecrease)
      {
        result.report.converged = true;
        break;
      }
      windowStart = value;
    }
  }
  result.value = value;
  result.gradientNorm = gradient.norm();
  result.report.seconds = stopwatch.seconds();
  return result;
}

} // namespace moserhex
