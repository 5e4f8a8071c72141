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

/** The inverse Hessian from the last pairs s = x' - x, y = g' - g. Keeps H0 y of every pair as well, so that one
 * product with H0 a step is enough: that of the gradient. */
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

  /** Keeps a pair; `preconditioned` is H0 y. A pair that is all rounding, y.H0 y <= 0, is dropped. */
  void
  add(Vector s, Vector y, Vector preconditioned)
  {
    const double curvature = s.dot(y);
    const double squaredLength = y.dot(preconditioned);
    if (!(squaredLength > 0.0))
    {
      return;
    }
    m_Scale = curvature / squaredLength;
    m_Pairs.push_back({ std::move(s), std::move(y), std::move(preconditioned), 1.0 / curvature });
    if (m_Pairs.size() > m_Memory)
    {
      m_Pairs.pop_front();
    }
  }

  /** H0 times a vector. */
  [[nodiscard]] Vector
  preconditioned(Vector v) const
  {
    if (m_Preconditioner)
    {
      m_Preconditioner(v);
    }
    return v;
  }

  /** Of the gradient g and H0 g. */
  [[nodiscard]] Vector
  times(const Vector & gradient, const Vector & preconditionedGradient) const
  {
    Vector              rest = gradient;
    Vector              result = preconditionedGradient; // H0 times rest
    std::vector<double> alpha(m_Pairs.size());
    for (std::size_t p = m_Pairs.size(); p-- > 0;)
    {
      alpha[p] = m_Pairs[p].rho * m_Pairs[p].s.dot(rest);
      rest -= alpha[p] * m_Pairs[p].y;
      result -= alpha[p] * m_Pairs[p].preconditioned;
    }
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
    Vector preconditioned; // H0 y
    double rho;
  };

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
  require(std::isfinite(value) && gradient.allFinite(), "the function is not finite at the start");
  Vector preconditioned = inverseHessian.preconditioned(gradient);
  double windowStart = value;
  result.evaluations = 1;

  int & steps = result.report.steps;
  while (steps < options.maximumSteps)
  {
    reportProgress(progress, static_cast<double>(steps) / options.maximumSteps);
    Vector direction = inverseHessian.times(gradient, preconditioned);
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
    Vector trialPreconditioned = inverseHessian.preconditioned(trialGradient);
    if (s.dot(y) > smallestCurvature * std::abs(slope))
    {
      inverseHessian.add(std::move(s), std::move(y), trialPreconditioned - preconditioned);
    }
    x.swap(trial);
    gradient.swap(trialGradient);
    preconditioned.swap(trialPreconditioned);
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
