// Quadratics: round-off (1e-9 of the first gradient, whose condition number is 100). Minimisers with a closed form:
// 1e-6. What must not rise, and what must be the same, is compared bit for bit.
#include "moserhex/Numerics/LimitedMemoryBfgs.h"

#include "RandomField.h"
#include "moserhex/Common/Errors.h"

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

using namespace moserhex;

namespace
{
using Eigen::VectorXd;

constexpr Eigen::Index size = 12;

/** 1/2 x.A x - b.x, A dense with eigenvalues from 1 to about 100. */
struct Quadratic
{
  Eigen::MatrixXd A = Eigen::MatrixXd::Identity(size, size);
  VectorXd        b = randomField(size, 1);

  Quadratic()
  {
    for (Eigen::Index i = 0; i < size; ++i)
    {
      const VectorXd v = randomField(size, 10 + static_cast<std::uint64_t>(i));
      A += static_cast<double>(i) * v * v.transpose();
    }
  }

  double
  operator()(const VectorXd & x, VectorXd & gradient) const
  {
    gradient = A * x - b;
    return 0.5 * x.dot(A * x) - b.dot(x);
  }

  /** H0 = scale A^-1 */
  [[nodiscard]] PreconditionerInPlace
  inverse(double scale) const
  {
    return [factor = Eigen::LLT<Eigen::MatrixXd>(A), scale](VectorXd & v) { v = scale * factor.solve(v); };
  }
};

/** Chained: sum of 100 (x_{i+1} - x_i^2)^2 + (1 - x_i)^2. */
double
rosenbrock(const VectorXd & x, VectorXd & gradient)
{
  gradient.setZero();
  double sum = 0.0;
  for (Eigen::Index i = 0; i + 1 < x.size(); ++i)
  {
    const double valley = x[i + 1] - x[i] * x[i];
    sum += 100.0 * valley * valley + (1.0 - x[i]) * (1.0 - x[i]);
    gradient[i] += -400.0 * x[i] * valley - 2.0 * (1.0 - x[i]);
    gradient[i + 1] += 200.0 * valley;
  }
  return sum;
}

VectorXd
rosenbrockStart(Eigen::Index count)
{
  VectorXd x(count);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    x[i] = i % 2 == 0 ? -1.2 : 1.0;
  }
  return x;
}

LimitedMemoryBfgsOptions
steps(int maximum)
{
  LimitedMemoryBfgsOptions options;
  options.maximumSteps = maximum;
  options.smallestDecrease = 0.0;
  return options;
}

/** Algorithm 7.4 as the book has it, with full steps: the k-th iterate. */
VectorXd
bookIterate(const DifferentiableFunction & f, VectorXd x, const PreconditionerInPlace & inverse, int k, int memory)
{
  std::vector<VectorXd> s;
  std::vector<VectorXd> y;
  VectorXd              gradient(x.size());
  f(x, gradient);
  for (int step = 0; step < k; ++step)
  {
    const std::size_t   first = s.size() - std::min(s.size(), static_cast<std::size_t>(memory));
    VectorXd            q = gradient;
    std::vector<double> alpha(s.size());
    for (std::size_t p = s.size(); p-- > first;)
    {
      alpha[p] = s[p].dot(q) / s[p].dot(y[p]);
      q -= alpha[p] * y[p];
    }
    inverse(q);
    if (!s.empty())
    {
      VectorXd image = y.back();
      inverse(image);
      q *= s.back().dot(y.back()) / y.back().dot(image);
    }
    for (std::size_t p = first; p < s.size(); ++p)
    {
      q += (alpha[p] - y[p].dot(q) / s[p].dot(y[p])) * s[p];
    }
    VectorXd next(x.size());
    f(x - q, next);
    s.emplace_back(-q);
    y.emplace_back(next - gradient);
    x -= q;
    gradient = next;
  }
  return x;
}

void
expectRefused(const LimitedMemoryBfgsOptions & options)
{
  VectorXd x = VectorXd::Zero(size);
  EXPECT_THROW((void)minimiseByLimitedMemoryBfgs(Quadratic(), x, {}, options), InvalidInput);
}

} // namespace

TEST(LimitedMemoryBfgs, QuadraticWithItsInverseHessianTakesOneStep)
{
  const Quadratic f;
  VectorXd        x = VectorXd::Zero(size);
  const auto      result = minimiseByLimitedMemoryBfgs(f, x, f.inverse(1.0), steps(1));
  EXPECT_EQ(result.report.steps, 1);
  EXPECT_EQ(result.evaluations, 2);
  EXPECT_LT(result.gradientNorm, 1e-12 * f.b.norm() * f.A.norm());
  EXPECT_LT((x - f.A.llt().solve(f.b)).norm(), 1e-12);
}

TEST(LimitedMemoryBfgs, ScaleOfThePreconditionerIsFittedAfterOneStep)
{
  const Quadratic f;
  VectorXd        x = VectorXd::Zero(size);
  const auto      result = minimiseByLimitedMemoryBfgs(f, x, f.inverse(1e-3), steps(2));
  EXPECT_EQ(result.evaluations, 3);
  EXPECT_LT(result.gradientNorm, 1e-9 * f.b.norm());
}

TEST(LimitedMemoryBfgs, TooLongAStepIsShortenedToTheMinimumOfTheParabola)
{
  const Quadratic f;
  VectorXd        x = VectorXd::Zero(size);
  const auto      result = minimiseByLimitedMemoryBfgs(f, x, f.inverse(3.0), steps(1));
  EXPECT_EQ(result.evaluations, 3); // start, overshoot, minimum
  EXPECT_LT(result.gradientNorm, 1e-12 * f.b.norm() * f.A.norm());
}

TEST(LimitedMemoryBfgs, QuadraticIsSolvedWithoutAPreconditioner)
{
  const Quadratic f;
  VectorXd        x = randomField(size, 3);
  const auto      result = minimiseByLimitedMemoryBfgs(f, x, {}, steps(400));
  EXPECT_LT((x - f.A.llt().solve(f.b)).norm(), 1e-6);
  EXPECT_LT(result.gradientNorm, 1e-5);
}

TEST(LimitedMemoryBfgs, RosenbrockIsMinimised)
{
  for (const Eigen::Index count : { 2, 10 })
  {
    VectorXd   x = rosenbrockStart(count);
    const auto result = minimiseByLimitedMemoryBfgs(rosenbrock, x, {}, steps(1000));
    // The chain has a second, local minimum near x_0 = -1 for four numbers and more: only stationarity holds there.
    EXPECT_LT(result.gradientNorm, 1e-6) << count;
    if (count == 2)
    {
      EXPECT_LT((x - VectorXd::Ones(count)).norm(), 1e-6);
      EXPECT_LT(result.value, 1e-12);
    }
  }
}

TEST(LimitedMemoryBfgs, ValueNeverRisesFromStepToStep)
{
  double previous = std::numeric_limits<double>::infinity();
  for (int count = 0; count <= 40; ++count)
  {
    VectorXd   x = rosenbrockStart(4);
    const auto result = minimiseByLimitedMemoryBfgs(rosenbrock, x, {}, steps(count));
    VectorXd   gradient(4);
    EXPECT_EQ(result.value, rosenbrock(x, gradient)) << count;
    EXPECT_EQ(result.gradientNorm, gradient.norm()) << count;
    EXPECT_LE(result.value, previous) << count;
    previous = result.value;
  }
}

TEST(LimitedMemoryBfgs, FunctionWithADomainIsMinimisedInsideIt)
{
  // Analytic centre of the simplex: -sum log x_i - log(1 - sum x_i) is least where all n + 1 terms are equal.
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double outside : { std::numeric_limits<double>::quiet_NaN(), infinity, -infinity })
  {
    int        calls = 0;
    int        callsOutside = 0;
    const auto barrier = [&](const VectorXd & x, VectorXd & gradient) {
      ++calls;
      const double rest = 1.0 - x.sum();
      if (x.minCoeff() <= 0.0 || rest <= 0.0)
      {
        ++callsOutside;
        return outside;
      }
      gradient = (-x.cwiseInverse()).array() + 1.0 / rest;
      return -x.array().log().sum() - std::log(rest);
    };
    VectorXd x = VectorXd::Constant(5, 1e-3);
    x[2] = 0.9;
    const auto result = minimiseByLimitedMemoryBfgs(barrier, x, {}, steps(200));
    EXPECT_GT(callsOutside, 0); // else nothing was tested
    EXPECT_LT((x - VectorXd::Constant(5, 1.0 / 6.0)).norm(), 1e-6) << outside;
    EXPECT_NEAR(result.value, 6.0 * std::log(6.0), 1e-12) << outside;
    EXPECT_EQ(result.evaluations, calls);
  }
}

TEST(LimitedMemoryBfgs, StartAtTheMinimumConvergesInNoStep)
{
  VectorXd   x = VectorXd::Ones(3);
  const auto result = minimiseByLimitedMemoryBfgs(rosenbrock, x);
  EXPECT_TRUE(result.report.converged);
  EXPECT_EQ(result.report.steps, 0);
  EXPECT_EQ(x, VectorXd::Ones(3));
}

TEST(LimitedMemoryBfgs, StoppingToFallIsConvergence)
{
  const Quadratic          f;
  LimitedMemoryBfgsOptions options;
  options.maximumSteps = 1000;
  for (const bool isPreconditioned : { false, true })
  {
    VectorXd   x = VectorXd::Zero(size);
    const auto inverse = isPreconditioned ? f.inverse(1.0) : PreconditionerInPlace();
    const auto result = minimiseByLimitedMemoryBfgs(f, x, inverse, options);
    EXPECT_TRUE(result.report.converged) << isPreconditioned << " " << result.report.note;
    EXPECT_EQ(result.report.note, "") << isPreconditioned;
    EXPECT_LT(result.report.residual, options.smallestDecrease) << isPreconditioned;
    EXPECT_LT(result.report.steps, 200) << isPreconditioned;
  }
}

TEST(LimitedMemoryBfgs, RunningOutOfStepsIsSaidNotThrown)
{
  VectorXd   x = rosenbrockStart(2);
  const auto result = minimiseByLimitedMemoryBfgs(rosenbrock, x, {}, steps(5));
  EXPECT_FALSE(result.report.converged);
  EXPECT_EQ(result.report.steps, 5);
  EXPECT_EQ(result.report.note, "the steps ran out");
}

TEST(LimitedMemoryBfgs, NoStepsAtAllIsSaidToo)
{
  VectorXd x = rosenbrockStart(2);
  EXPECT_EQ(minimiseByLimitedMemoryBfgs(rosenbrock, x, {}, steps(0)).report.note, "the steps ran out");
}

TEST(LimitedMemoryBfgs, ARestartKeepsTheScaleOfTheLatestPair)
{
  // f = 2 x^2 with H0 = 0.1: the step from 1 to 0.6 gives gamma H0 = 1/4, Newton's step. The search there fails.
  std::vector<double>      points;
  LimitedMemoryBfgsOptions options = steps(2);
  options.maximumTrials = 3;
  const auto f = [&points](const VectorXd & x, VectorXd & gradient) {
    points.push_back(x[0]);
    gradient = 4.0 * x;
    const bool isOfTheSearchThatFails = points.size() >= 3 && points.size() <= 5;
    return isOfTheSearchThatFails ? std::numeric_limits<double>::quiet_NaN() : 2.0 * x.squaredNorm();
  };
  VectorXd x = VectorXd::Ones(1);
  (void)minimiseByLimitedMemoryBfgs(
    f, x, [](VectorXd & v) { v *= 0.1; }, options);
  ASSERT_GE(points.size(), 6u);
  EXPECT_NEAR(points[1], 0.6, 1e-15);
  EXPECT_NEAR(points[5], 0.0, 1e-15); // from H0 alone: 0.36
}

TEST(LimitedMemoryBfgs, DirectionThatDoesNotDescendIsSaidAndNoConvergence)
{
  const Quadratic f;
  VectorXd        x = VectorXd::Zero(size);
  const auto      result = minimiseByLimitedMemoryBfgs(f, x, f.inverse(-1.0));
  EXPECT_FALSE(result.report.converged);
  EXPECT_NE(result.report.note.find("does not descend"), std::string::npos) << result.report.note;
  EXPECT_EQ(x, VectorXd::Zero(size));
}

TEST(LimitedMemoryBfgs, GradientThatIsNotFiniteOnTheWayIsNoConvergence)
{
  const auto f = [](const VectorXd & x, VectorXd & gradient) {
    gradient = x.norm() < 0.5 ? VectorXd::Constant(size, std::numeric_limits<double>::quiet_NaN()) : VectorXd(x);
    return 0.5 * x.squaredNorm();
  };
  VectorXd   x = VectorXd::Ones(size);
  const auto result = minimiseByLimitedMemoryBfgs(f, x);
  EXPECT_FALSE(result.report.converged);
  EXPECT_FALSE(result.report.note.empty());
}

TEST(LimitedMemoryBfgs, ProgressIsToldOfEveryStep)
{
  std::vector<double> fractions;
  VectorXd            x = rosenbrockStart(2);
  const auto          result = minimiseByLimitedMemoryBfgs(rosenbrock, x, {}, steps(15), [&](double fraction) {
    fractions.push_back(fraction);
    return true;
  });
  ASSERT_GE(fractions.size(), static_cast<std::size_t>(result.report.steps));
  for (std::size_t i = 0; i < fractions.size(); ++i)
  {
    EXPECT_GE(fractions[i], i == 0 ? 0.0 : fractions[i - 1]);
    EXPECT_LE(fractions[i], 1.0);
  }
}

TEST(LimitedMemoryBfgs, CallbackCancels)
{
  VectorXd x = rosenbrockStart(2);
  int      calls = 0;
  EXPECT_THROW((void)minimiseByLimitedMemoryBfgs(rosenbrock, x, {}, steps(50), [&](double) { return ++calls < 4; }),
               Cancelled);
  EXPECT_EQ(calls, 4);
}

TEST(LimitedMemoryBfgs, IteratesAreThoseOfTheTwoLoops)
{
  const Quadratic f;
  const auto      inverse = [approximate = f.inverse(0.5)](VectorXd & v) {
    const VectorXd exact = v;
    approximate(v);
    v += 0.002 * exact; // near enough that full steps are taken, and not the inverse itself
  };
  LimitedMemoryBfgsOptions options = steps(0);
  options.memory = 3;
  for (const int k : { 1, 2, 3, 4, 7, 9 })
  {
    options.maximumSteps = k;
    VectorXd       x = VectorXd::Zero(size);
    const VectorXd expected = bookIterate(f, x, inverse, k, options.memory);
    const auto     result = minimiseByLimitedMemoryBfgs(f, x, inverse, options);
    ASSERT_EQ(result.evaluations, k + 1) << "a step was shortened";
    EXPECT_LE((x - expected).norm(), 1e-11 * expected.norm()) << k;
  }
}

TEST(LimitedMemoryBfgs, ThreadsDoNotChangeABit)
{
  VectorXd first = rosenbrockStart(20000);
  VectorXd second = first;
  auto     options = steps(12);
  (void)minimiseByLimitedMemoryBfgs(rosenbrock, first, {}, options);
  options.threads = 3;
  (void)minimiseByLimitedMemoryBfgs(rosenbrock, second, {}, options);
  EXPECT_TRUE(first == second);
}

TEST(LimitedMemoryBfgs, TwoRunsAreTheSame)
{
  VectorXd first = rosenbrockStart(6);
  VectorXd second = first;
  (void)minimiseByLimitedMemoryBfgs(rosenbrock, first, {}, steps(37));
  (void)minimiseByLimitedMemoryBfgs(rosenbrock, second, {}, steps(37));
  EXPECT_EQ(first, second);
}

TEST(LimitedMemoryBfgs, StartOutsideTheDomainIsRefused)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  VectorXd     x = VectorXd::Zero(2);
  EXPECT_THROW((void)minimiseByLimitedMemoryBfgs(
                 [&](const VectorXd &, VectorXd & gradient) {
                   gradient.setZero();
                   return nan;
                 },
                 x),
               InvalidInput);
  EXPECT_THROW((void)minimiseByLimitedMemoryBfgs(
                 [&](const VectorXd &, VectorXd & gradient) {
                   gradient.setConstant(nan);
                   return 1.0;
                 },
                 x),
               InvalidInput);
}

TEST(LimitedMemoryBfgs, NegativeNumberOfStepsIsRefused)
{
  expectRefused(steps(-1));
}

TEST(LimitedMemoryBfgs, EmptyMemoryIsRefused)
{
  LimitedMemoryBfgsOptions options;
  options.memory = 0;
  expectRefused(options);
}

TEST(LimitedMemoryBfgs, EmptyWindowIsRefused)
{
  LimitedMemoryBfgsOptions options;
  options.window = 0;
  expectRefused(options);
}

TEST(LimitedMemoryBfgs, DecreaseThatIsNegativeOrNoNumberIsRefused)
{
  LimitedMemoryBfgsOptions options;
  for (const double decrease : { -1e-9, std::numeric_limits<double>::quiet_NaN() })
  {
    options.smallestDecrease = decrease;
    expectRefused(options);
  }
}

TEST(LimitedMemoryBfgs, ArmijoConstantOutsideItsRangeIsRefused)
{
  LimitedMemoryBfgsOptions options;
  for (const double constant : { 0.0, 0.5, std::numeric_limits<double>::quiet_NaN() })
  {
    options.sufficientDecrease = constant;
    expectRefused(options);
  }
}

TEST(LimitedMemoryBfgs, LineSearchWithoutATrialIsRefused)
{
  LimitedMemoryBfgsOptions options;
  options.maximumTrials = 0;
  expectRefused(options);
}
