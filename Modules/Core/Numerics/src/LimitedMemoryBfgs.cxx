#include "moserhex/Numerics/LimitedMemoryBfgs.h"

#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Parallel.h"
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

/** Entries of a vector in one piece of parallel work; sums are taken over pieces first. */
constexpr std::size_t entriesPerBlock = 8192;

/** Products of many vectors with one, read in a single pass. The same bits for any number of threads. */
Vector
innerProducts(const std::vector<const Vector *> & vectors, const Vector & other, unsigned int threads)
{
  const auto        size = static_cast<std::size_t>(other.size());
  const std::size_t blocks = (size + entriesPerBlock - 1) / entriesPerBlock;
  Eigen::MatrixXd   parts(static_cast<Eigen::Index>(vectors.size()), static_cast<Eigen::Index>(blocks));
  parallelForBlocks(size, entriesPerBlock, threads, [&](std::size_t begin, std::size_t end) {
    const auto first = static_cast<Eigen::Index>(begin);
    const auto count = static_cast<Eigen::Index>(end - begin);
    for (std::size_t v = 0; v < vectors.size(); ++v)
    {
      parts(static_cast<Eigen::Index>(v), static_cast<Eigen::Index>(begin / entriesPerBlock)) =
        vectors[v]->segment(first, count).dot(other.segment(first, count));
    }
  });
  Vector sums = Vector::Zero(parts.rows());
  for (Eigen::Index block = 0; block < parts.cols(); ++block)
  {
    sums += parts.col(block);
  }
  return sums;
}

double
innerProduct(const Vector & a, const Vector & b, unsigned int threads)
{
  return innerProducts({ &a }, b, threads)[0];
}

/** The inverse Hessian from the last pairs s = x' - x, y = g' - g.
 *
 * The two loops of algorithm 7.4 only ever combine H0 g, the H0 y and the s, with factors that follow from inner
 * products among them. With the products s.y and y.H0 y of the pairs kept, and s.g and H0 y.g taken anew at every
 * gradient, a step reads each kept vector twice and applies H0 once, to the gradient. */
class InverseHessian
{
public:
  InverseHessian(const PreconditionerInPlace & preconditioner, int memory, unsigned int threads)
    : m_Preconditioner(preconditioner), m_Memory(memory), m_Threads(threads)
  {}

  [[nodiscard]] bool
  isInitial() const
  {
    return m_Pairs.empty();
  }

  /** From gamma H0 with the gamma of the latest pair, the best guess at the scale there is. */
  void
  restart()
  {
    m_Pairs.clear();
    updateProducts();
  }

  /** The first gradient. */
  void
  start(const Vector & gradient)
  {
    m_Gradient = gradient;
    m_Preconditioned = preconditioned(gradient);
  }

  /** The gradient after the step s. The pair is kept when its curvature s.y is above the bound. */
  void
  move(Vector s, const Vector & gradient, double smallestAcceptedCurvature)
  {
    const Vector before = m_Products;
    const Vector y = gradient - m_Gradient;
    Vector       image = preconditioned(gradient); // H0 g', then H0 y
    m_Gradient = gradient;
    m_Preconditioned.swap(image);
    updateProducts();
    const double curvature = innerProduct(s, y, m_Threads);
    if (!(curvature > smallestAcceptedCurvature))
    {
      return;
    }
    image = m_Preconditioned - image;
    const double squaredLength = innerProduct(y, image, m_Threads);
    if (!(squaredLength > 0.0)) // all rounding
    {
      return;
    }
    const Vector change = m_Products - before; // s.y and H0 y.y of the pairs with the new y
    m_Scale = curvature / squaredLength;
    m_Pairs.push_back({ std::move(s), std::move(image), curvature, {}, {} });
    Pair &     latest = m_Pairs.back();
    const auto older = static_cast<Eigen::Index>(m_Pairs.size()) - 1;
    latest.olderSteps = change.head(older);
    latest.images = change.tail(older);
    latest.images.conservativeResize(older + 1);
    latest.images[older] = squaredLength;
    if (m_Pairs.size() > static_cast<std::size_t>(m_Memory))
    {
      forgetOldest();
    }
    updateProducts();
  }

  /** Times the gradient. */
  [[nodiscard]] Vector
  timesGradient() const
  {
    const auto count = static_cast<Eigen::Index>(m_Pairs.size());
    Vector     alpha = Vector::Zero(count);
    for (Eigen::Index p = count; p-- > 0;)
    {
      double product = m_Products[p];
      for (Eigen::Index newer = p + 1; newer < count; ++newer)
      {
        product -= alpha[newer] * pair(newer).olderSteps[p];
      }
      alpha[p] = product / pair(p).curvature;
    }
    Vector ofSteps = Vector::Zero(count);
    for (Eigen::Index p = 0; p < count; ++p)
    {
      double product = m_Products[count + p];
      for (Eigen::Index other = 0; other < count; ++other)
      {
        product -= alpha[other] * pair(std::max(p, other)).images[std::min(p, other)];
      }
      product *= m_Scale;
      for (Eigen::Index older = 0; older < p; ++older)
      {
        product += ofSteps[older] * pair(p).olderSteps[older];
      }
      ofSteps[p] = alpha[p] - product / pair(p).curvature;
    }
    return combination(alpha, ofSteps);
  }

private:
  struct Pair
  {
    Vector s;
    Vector image;      // H0 y
    double curvature;  // s.y
    Vector olderSteps; // s.y with the s of the older pairs and this y
    Vector images;     // y.H0 y with this y and the older ones, and its own
  };

  [[nodiscard]] const Pair &
  pair(Eigen::Index index) const
  {
    return m_Pairs[static_cast<std::size_t>(index)];
  }

  [[nodiscard]] Vector
  preconditioned(Vector v) const
  {
    if (m_Preconditioner)
    {
      m_Preconditioner(v);
    }
    return v;
  }

  /** s.g of every pair, then H0 y.g of every pair. */
  void
  updateProducts()
  {
    std::vector<const Vector *> vectors;
    for (const Pair & p : m_Pairs)
    {
      vectors.push_back(&p.s);
    }
    for (const Pair & p : m_Pairs)
    {
      vectors.push_back(&p.image);
    }
    m_Products = innerProducts(vectors, m_Gradient, m_Threads);
  }

  void
  forgetOldest()
  {
    m_Pairs.pop_front();
    for (Pair & p : m_Pairs)
    {
      const Eigen::Index older = p.olderSteps.size() - 1;
      p.olderSteps = Vector(p.olderSteps.tail(older));
      p.images = Vector(p.images.tail(older + 1));
    }
  }

  /** scale (H0 g - sum of alpha H0 y) + sum of ofSteps s. */
  [[nodiscard]] Vector
  combination(const Vector & alpha, const Vector & ofSteps) const
  {
    Vector result(m_Gradient.size());
    parallelForBlocks(
      static_cast<std::size_t>(result.size()), entriesPerBlock, m_Threads, [&](std::size_t begin, std::size_t end) {
        const auto first = static_cast<Eigen::Index>(begin);
        const auto count = static_cast<Eigen::Index>(end - begin);
        auto       part = result.segment(first, count);
        part = m_Scale * m_Preconditioned.segment(first, count);
        for (Eigen::Index p = 0; p < alpha.size(); ++p)
        {
          part +=
            ofSteps[p] * pair(p).s.segment(first, count) - m_Scale * alpha[p] * pair(p).image.segment(first, count);
        }
      });
    return result;
  }

  const PreconditionerInPlace & m_Preconditioner;
  int                           m_Memory;
  unsigned int                  m_Threads;
  std::deque<Pair>              m_Pairs;
  double                        m_Scale{ 1.0 };
  Vector                        m_Gradient;
  Vector                        m_Preconditioned; // H0 g
  Vector                        m_Products;
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
  InverseHessian          inverseHessian(preconditioner, options.memory, options.threads);
  Vector                  gradient(x.size());
  Vector                  trialGradient(x.size());
  double                  value = f(x, gradient);
  require(std::isfinite(value) && gradient.allFinite(), "the function is not finite at the start");
  inverseHessian.start(gradient);
  double windowStart = value;
  result.evaluations = 1;

  int & steps = result.report.steps;
  while (steps < options.maximumSteps)
  {
    reportProgress(progress, static_cast<double>(steps) / options.maximumSteps);
    Vector direction = inverseHessian.timesGradient();
    double slope = -gradient.dot(direction);
    if (!(slope < 0.0) && !inverseHessian.isInitial())
    {
      inverseHessian.restart();
      continue;
    }
    if (!(slope < 0.0))
    {
      result.report.converged = slope == 0.0; // the gradient vanishes
      result.report.note = result.report.converged ? "" : "the direction does not descend";
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
    inverseHessian.move(trial - x, trialGradient, smallestCurvature * std::abs(slope));
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
  if (!result.report.converged && result.report.note.empty())
  {
    result.report.note = "the steps ran out";
  }
  result.value = value;
  result.gradientNorm = gradient.norm();
  result.report.seconds = stopwatch.seconds();
  return result;
}

} // namespace moserhex
