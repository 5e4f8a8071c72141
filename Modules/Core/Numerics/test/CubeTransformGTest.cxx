// Against the triple sum, closed forms, each other and themselves undone: round-off, 1e-12 for values of order one.
// Any number of threads: the same bytes.
#include "moserhex/Numerics/CubeTransform.h"

#include "RandomField.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Parallel.h"
#include "moserhex/Numerics/CosineTransform.h"

#include <gtest/gtest.h>

#include <array>
#include <utility>
#include <vector>

using namespace moserhex;

namespace
{
using Basis = CubeTransform::Basis;
using Engine = CubeTransform::Engine;

constexpr double roundOff = 1e-12;

constexpr std::array<Basis, 2>  bases{ Basis::Cosine, Basis::Sine };
constexpr std::array<Engine, 2> engines{ Engine::Dense, Engine::Fast };

double
largest(const Eigen::VectorXd & difference)
{
  return difference.cwiseAbs().maxCoeff();
}

/** The definition: one sum over the field for each frequency. */
Eigen::VectorXd
tripleSum(const Eigen::MatrixXd & matrix, const Eigen::VectorXd & field)
{
  const Eigen::Index n = matrix.rows();
  Eigen::VectorXd    result = Eigen::VectorXd::Zero(field.size());
  for (Eigen::Index frequency = 0; frequency < field.size(); ++frequency)
  {
    for (Eigen::Index point = 0; point < field.size(); ++point)
    {
      result[frequency] += matrix(frequency % n, point % n) * matrix(frequency / n % n, point / n % n) *
                           matrix(frequency / (n * n), point / (n * n)) * field[point];
    }
  }
  return result;
}

Eigen::VectorXd
forward(const CubeTransform & transform, Eigen::VectorXd field, unsigned int threads = 1)
{
  transform.forwardInPlace(field, ComponentOrder::Interleaved, threads);
  return field;
}

Eigen::VectorXd
inverse(const CubeTransform & transform, Eigen::VectorXd field)
{
  transform.inverseInPlace(field);
  return field;
}

/** Component c of C on P points, from one order to the other. */
Eigen::VectorXd
stackedFromInterleaved(const Eigen::VectorXd & interleaved, Eigen::Index components)
{
  const Eigen::Index points = interleaved.size() / components;
  Eigen::VectorXd    stacked(interleaved.size());
  for (Eigen::Index point = 0; point < points; ++point)
  {
    for (Eigen::Index c = 0; c < components; ++c)
    {
      stacked[point + points * c] = interleaved[c + components * point];
    }
  }
  return stacked;
}
} // namespace

TEST(CubeTransform, IsTheTripleSumOfItsDefinition)
{
  for (const int n : { 1, 2, 3, 4, 5, 7, 8 })
  {
    const Eigen::VectorXd field = randomField(n * n * n, 1);
    for (const Engine engine : engines)
    {
      const auto error = [&](Basis basis, const Eigen::MatrixXd & matrix) {
        return largest(forward(CubeTransform(n, basis, engine), field) - tripleSum(matrix, field));
      };
      EXPECT_LT(error(Basis::Cosine, cosineMatrix(n)), roundOff) << n;
      EXPECT_LT(error(Basis::Sine, sineMatrix(n)), roundOff) << n;
    }
  }
}

TEST(CubeTransform, EnginesAgreeForAllSizesUpToSeventy)
{
  for (int n = 1; n <= 70; ++n)
  {
    const Eigen::VectorXd field = randomField(static_cast<Eigen::Index>(n) * n * n, 2);
    for (const Basis basis : bases)
    {
      const CubeTransform   dense(n, basis, Engine::Dense);
      const CubeTransform   fast(n, basis, Engine::Fast);
      const Eigen::VectorXd spectrum = forward(dense, field);
      EXPECT_LT(largest(spectrum - forward(fast, field)), roundOff) << n;
      EXPECT_LT(largest(field - inverse(fast, spectrum)), roundOff) << n;
    }
  }
}

TEST(CubeTransform, InverseUndoesForward)
{
  for (const int n : { 1, 2, 3, 20, 31, 64, 100 })
  {
    const Eigen::VectorXd field = randomField(static_cast<Eigen::Index>(n) * n * n, 3);
    for (const Basis basis : bases)
    {
      for (const Engine engine : engines)
      {
        const CubeTransform transform(n, basis, engine);
        EXPECT_LT(largest(inverse(transform, forward(transform, field)) - field), roundOff) << n;
      }
    }
  }
}

TEST(CubeTransform, KeepsTheSumOfSquares)
{
  const Eigen::VectorXd field = randomField(36 * 36 * 36, 4);
  for (const Basis basis : bases)
  {
    for (const Engine engine : engines)
    {
      EXPECT_NEAR(forward(CubeTransform(36, basis, engine), field).norm() / field.norm(), 1.0, roundOff);
    }
  }
}

TEST(CubeTransform, SpectrumOfOneBasisFieldIsOnePeak)
{
  const int             n = 48;
  const Eigen::MatrixXd cosines = cosineMatrix(n);
  const Eigen::MatrixXd sines = sineMatrix(n);
  for (const Basis basis : bases)
  {
    const Eigen::MatrixXd & matrix = basis == Basis::Cosine ? cosines : sines;
    Eigen::VectorXd         field(n * n * n);
    Eigen::VectorXd         peak = Eigen::VectorXd::Zero(n * n * n);
    for (Eigen::Index point = 0; point < field.size(); ++point)
    {
      field[point] = matrix(5, point % n) * matrix(0, point / n % n) * matrix(n - 1, point / (n * n));
    }
    peak[5 + n * (0 + n * (n - 1))] = 1.0;
    for (const Engine engine : engines)
    {
      EXPECT_LT(largest(forward(CubeTransform(n, basis, engine), field) - peak), roundOff);
    }
  }
}

TEST(CubeTransform, ComponentsAreTransformedEachOnItsOwn)
{
  for (const int n : { 1, 5, 6, 19 })
  {
    const Eigen::Index    points = n * n * n;
    const Eigen::VectorXd interleaved = randomField(3 * points, 5);
    const Eigen::VectorXd stacked = stackedFromInterleaved(interleaved, 3);
    for (const Basis basis : bases)
    {
      for (const Engine engine : engines)
      {
        const CubeTransform transform(n, basis, engine);
        Eigen::VectorXd     result = stacked;
        transform.forwardInPlace(result, ComponentOrder::Stacked);
        for (Eigen::Index c = 0; c < 3; ++c)
        {
          const Eigen::VectorXd one = forward(transform, stacked.segment(c * points, points));
          EXPECT_LT(largest(result.segment(c * points, points) - one), roundOff) << n;
        }
        EXPECT_LT(largest(stackedFromInterleaved(forward(transform, interleaved), 3) - result), roundOff) << n;
      }
    }
  }
}

TEST(CubeTransform, MultipliedSpectrumIsThereTimesSymbolAndBack)
{
  for (const int n : { 1, 4, 15, 22 })
  {
    const Eigen::Index    points = n * n * n;
    const Eigen::VectorXd symbol = randomField(points, 6);
    const Eigen::VectorXd fields = randomField(3 * points, 7);
    for (const Basis basis : bases)
    {
      for (const Engine engine : engines)
      {
        const CubeTransform transform(n, basis, engine);
        const auto          oneByOne = [&](Eigen::VectorXd field) {
          return inverse(transform, forward(transform, std::move(field)).cwiseProduct(symbol));
        };
        Eigen::VectorXd stacked = fields;
        transform.multiplySpectrumInPlace(stacked, symbol, ComponentOrder::Stacked);
        for (Eigen::Index c = 0; c < 3; ++c)
        {
          const Eigen::VectorXd expected = oneByOne(fields.segment(c * points, points));
          EXPECT_LT(largest(stacked.segment(c * points, points) - expected), roundOff) << n;
        }
        Eigen::VectorXd       interleaved = fields;
        const Eigen::VectorXd split = stackedFromInterleaved(fields, 3);
        transform.multiplySpectrumInPlace(interleaved, symbol, ComponentOrder::Interleaved);
        const Eigen::VectorXd result = stackedFromInterleaved(interleaved, 3);
        for (Eigen::Index c = 0; c < 3; ++c)
        {
          const Eigen::VectorXd expected = oneByOne(split.segment(c * points, points));
          EXPECT_LT(largest(result.segment(c * points, points) - expected), roundOff) << n;
        }
      }
    }
  }
}

TEST(CubeTransform, ColumnsMayStandApart)
{
  const int             n = 6;
  const Eigen::Index    points = n * n * n;
  const Eigen::Index    stride = points + 7;
  const Eigen::VectorXd symbol = randomField(points, 12);
  const Eigen::VectorXd before = randomField(3 * stride, 13);
  Eigen::VectorXd       fields = before;
  const CubeTransform   transform(n, Basis::Cosine);
  transform.multiplySpectraOfColumnsInPlace(
    Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>>(fields.data(), points, 3, Eigen::OuterStride<>(stride)),
    symbol);
  for (Eigen::Index c = 0; c < 3; ++c)
  {
    Eigen::VectorXd alone = before.segment(c * stride, points);
    transform.multiplySpectrumInPlace(alone, symbol);
    EXPECT_TRUE((fields.segment(c * stride, points).array() == alone.array()).all());
    EXPECT_TRUE(
      (fields.segment(c * stride + points, 7).array() == before.segment(c * stride + points, 7).array()).all());
  }
}

TEST(CubeTransform, AnyNumberOfThreadsGivesTheSameBytes)
{
  for (const int n : { 1, 7, 22, 33 })
  {
    const Eigen::VectorXd symbol = randomField(static_cast<Eigen::Index>(n) * n * n, 8);
    const Eigen::VectorXd fields = randomField(3 * symbol.size(), 9);
    for (const Basis basis : bases)
    {
      for (const Engine engine : engines)
      {
        const CubeTransform transform(n, basis, engine);
        const auto          applied = [&](unsigned int threads, ComponentOrder order) {
          Eigen::VectorXd result = fields;
          transform.multiplySpectrumInPlace(result, symbol, order, threads);
          return result;
        };
        for (const ComponentOrder order : { ComponentOrder::Interleaved, ComponentOrder::Stacked })
        {
          const Eigen::VectorXd one = applied(1, order);
          for (const unsigned int threads : { 2u, 3u, 8u, 0u })
          {
            EXPECT_TRUE((applied(threads, order).array() == one.array()).all()) << n << " threads " << threads;
          }
        }
        EXPECT_TRUE((forward(transform, fields, 1).array() == forward(transform, fields, 4).array()).all()) << n;
      }
    }
  }
}

TEST(CubeTransform, OneTransformServesSeveralCallersAtOnce)
{
  const CubeTransform          transform(22, Basis::Cosine, Engine::Fast);
  const Eigen::VectorXd        field = randomField(22 * 22 * 22, 10);
  const Eigen::VectorXd        expected = forward(transform, field);
  std::vector<Eigen::VectorXd> results(16, field);
  parallelFor(results.size(), 4, [&](std::size_t i) { transform.forwardInPlace(results[i]); });
  for (const Eigen::VectorXd & result : results)
  {
    EXPECT_TRUE((result.array() == expected.array()).all());
  }
}

TEST(CubeTransform, AutomaticIsDenseForSmallAndForPrimeSizesAndFastForLargeOnes)
{
  const auto engineOf = [](int n, Basis basis) { return CubeTransform(n, basis).engine(); };
  EXPECT_EQ(engineOf(20, Basis::Cosine), Engine::Dense);
  EXPECT_EQ(engineOf(64, Basis::Cosine), Engine::Dense);
  EXPECT_EQ(engineOf(251, Basis::Cosine), Engine::Dense);
  EXPECT_EQ(engineOf(256, Basis::Cosine), Engine::Fast);
  EXPECT_EQ(engineOf(19, Basis::Sine), Engine::Dense);
  EXPECT_EQ(engineOf(250, Basis::Sine), Engine::Dense);
  EXPECT_EQ(engineOf(255, Basis::Sine), Engine::Fast);
}

TEST(SpectralOperator, SymbolByFunctionIsTheSymbolByNumbers)
{
  const int              n = 6;
  const CubeTransform    transform(n, Basis::Sine);
  const auto             symbol = [](int a, int b, int c) { return 1.0 / (1.0 + a + 10.0 * b + 100.0 * c); };
  const SpectralOperator byFunction(transform, symbol);
  Eigen::VectorXd        numbers(n * n * n);
  for (int entry = 0; entry < n * n * n; ++entry)
  {
    numbers[entry] = symbol(entry % n, entry / n % n, entry / (n * n));
  }
  const SpectralOperator byNumbers(transform, numbers);
  Eigen::VectorXd        one = randomField(3 * n * n * n, 11);
  Eigen::VectorXd        other = one;
  byFunction.applyInPlace(one);
  byNumbers.applyInPlace(other);
  EXPECT_TRUE((one.array() == other.array()).all());
}

TEST(SpectralOperator, IdentityFunctionOfTheLaplacianIsItsStencil)
{
  const int       n = 9;
  const int       centre = 4 + n * (0 + n * 5);
  Eigen::VectorXd impulse = Eigen::VectorXd::Zero(n * n * n);
  impulse[centre] = 1.0;
  for (const Basis basis : bases)
  {
    const SpectralOperator laplacian = functionOfLaplacian(n, basis, [](double lambda) { return lambda; });
    Eigen::VectorXd        stencil = Eigen::VectorXd::Zero(n * n * n);
    stencil[centre] = basis == Basis::Cosine ? 5.0 : 6.0; // j = 0: a free end, or a zero value beyond
    for (const int step : { 1, -1, n, n * n, -n * n })
    {
      stencil[centre + step] = -1.0;
    }
    Eigen::VectorXd result = impulse;
    laplacian.applyInPlace(result);
    EXPECT_LT(largest(result - stencil), roundOff);
  }
}

TEST(SpectralOperator, InverseOfTheShiftedLaplacianSolvesForThreeComponents)
{
  const int              n = 20;
  const double           shift = 0.3;
  const SpectralOperator matrix = functionOfLaplacian(n, Basis::Cosine, [&](double lambda) { return lambda + shift; });
  const SpectralOperator inverse =
    functionOfLaplacian(n, Basis::Cosine, [&](double lambda) { return 1.0 / (lambda + shift); });
  const Eigen::VectorXd f = randomField(3 * n * n * n, 14);
  Eigen::VectorXd       result = f;
  inverse.applyInPlace(result, ComponentOrder::Interleaved, 2);
  matrix.applyInPlace(result, ComponentOrder::Interleaved, 2);
  EXPECT_LT(largest(result - f), roundOff);
}

TEST(SpectralOperator, ConstantIsDividedByTheShiftAlone)
{
  const SpectralOperator inverse =
    functionOfLaplacian(7, Basis::Cosine, [](double lambda) { return 1.0 / (lambda + 0.25); });
  Eigen::VectorXd constant = Eigen::VectorXd::Constant(343, 2.0);
  inverse.applyInPlace(constant);
  EXPECT_LT(largest((constant.array() - 8.0).matrix()), roundOff);
}

TEST(CubeTransform, SizesBelowOneAreRefused)
{
  EXPECT_THROW(CubeTransform(0, Basis::Cosine), InvalidInput);
  EXPECT_THROW(CubeTransform(-2, Basis::Sine, Engine::Fast), InvalidInput);
  EXPECT_THROW(static_cast<void>(laplacianEigenvalues(0, Basis::Sine)), InvalidInput);
  EXPECT_THROW(static_cast<void>(functionOfLaplacian(0, Basis::Sine, [](double lambda) { return lambda; })),
               InvalidInput);
}

TEST(CubeTransform, FieldsThatAreNoMultipleOfTheCubeAreRefused)
{
  const CubeTransform transform(3, Basis::Cosine);
  Eigen::VectorXd     nothing;
  Eigen::VectorXd     tooLong = Eigen::VectorXd::Zero(28);
  EXPECT_THROW(transform.forwardInPlace(nothing), InvalidInput);
  EXPECT_THROW(transform.forwardInPlace(tooLong), InvalidInput);
  EXPECT_THROW(transform.inverseInPlace(tooLong), InvalidInput);
  EXPECT_THROW(transform.multiplySpectrumInPlace(tooLong, Eigen::VectorXd::Ones(27)), InvalidInput);
  const SpectralOperator identity(transform, Eigen::VectorXd::Ones(27));
  Eigen::MatrixXd        columns = Eigen::MatrixXd::Zero(26, 2);
  EXPECT_THROW(identity.applyInPlace(tooLong), InvalidInput);
  EXPECT_THROW(identity.applyToColumnsInPlace(columns), InvalidInput);
}

TEST(CubeTransform, SymbolOfAnotherSizeIsRefused)
{
  const CubeTransform transform(3, Basis::Cosine);
  Eigen::VectorXd     field = Eigen::VectorXd::Zero(27);
  EXPECT_THROW(transform.multiplySpectrumInPlace(field, Eigen::VectorXd::Ones(26)), InvalidInput);
  EXPECT_THROW(SpectralOperator(transform, Eigen::VectorXd::Ones(28)), InvalidInput);
}
