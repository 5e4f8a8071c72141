#include "moserhex/Numerics/CosineTransform.h"
#include "moserhex/Numerics/CubeTransform.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <string>

using namespace moserhex;

namespace
{
using Basis = CubeTransform::Basis;
using Engine = CubeTransform::Engine;

/** T^-1 diag(symbol) T on three components; arguments: size, threads. Complexity N is the number of points. */
void
applyToThreeComponents(benchmark::State & state, Basis basis, Engine engine)
{
  const int              n = static_cast<int>(state.range(0));
  const Eigen::VectorXd  lambda = laplacianEigenvalues(n, basis);
  const SpectralOperator inverse(CubeTransform(n, basis, engine),
                                 [&](int a, int b, int c) { return 1.0 / (0.3 + lambda[a] + lambda[b] + lambda[c]); });
  const Eigen::Index     points = inverse.symbol().size();
  Eigen::VectorXd        fields = Eigen::VectorXd::LinSpaced(3 * points, -1.0, 1.0);
  for (auto _ : state)
  {
    inverse.applyInPlace(fields, ComponentOrder::Stacked, static_cast<unsigned int>(state.range(1)));
    fields *= 1.0 / fields.norm();
    benchmark::DoNotOptimize(fields.data());
  }
  state.SetLabel(inverse.transform().engine() == Engine::Fast ? "fast" : "dense");
  state.SetItemsProcessed(state.iterations() * points);
  state.SetComplexityN(points);
}

/** n^3 log n, but for a constant factor. */
double
nearLinear(benchmark::IterationCount points)
{
  return static_cast<double>(points) * std::log2(static_cast<double>(points));
}

double
dense(benchmark::IterationCount points)
{
  return std::pow(static_cast<double>(points), 4.0 / 3.0);
}

void
sizes(benchmark::internal::Benchmark * benchmark)
{
  benchmark->ArgNames({ "n", "threads" })->Unit(benchmark::kMillisecond)->UseRealTime();
  for (const int n : { 20, 40, 64 })
  {
    benchmark->Args({ n, 1 })->Args({ n, 2 });
  }
}

/** Sizes whose Fourier transforms are made of radix 4 and 5 alone, so that the fit sees the number of points only. */
template <int TShorter>
void
sizesOfEqualKind(benchmark::internal::Benchmark * benchmark)
{
  benchmark->ArgNames({ "n", "threads" })->Unit(benchmark::kMillisecond)->UseRealTime();
  for (const int n : { 16, 20, 64, 80, 100, 160, 256, 320 })
  {
    benchmark->Args({ n - TShorter, 1 });
  }
}
} // namespace

BENCHMARK_CAPTURE(applyToThreeComponents, CosineAutomatic, Basis::Cosine, Engine::Automatic)->Apply(sizes);
BENCHMARK_CAPTURE(applyToThreeComponents, CosineDense, Basis::Cosine, Engine::Dense)->Apply(sizes);
BENCHMARK_CAPTURE(applyToThreeComponents, CosineFast, Basis::Cosine, Engine::Fast)->Apply(sizes);
BENCHMARK_CAPTURE(applyToThreeComponents, CosineDenseGrowth, Basis::Cosine, Engine::Dense)
  ->Apply(sizesOfEqualKind<0>)
  ->Complexity(dense);
BENCHMARK_CAPTURE(applyToThreeComponents, CosineFastGrowth, Basis::Cosine, Engine::Fast)
  ->Apply(sizesOfEqualKind<0>)
  ->Complexity(nearLinear);
BENCHMARK_CAPTURE(applyToThreeComponents, SineFastGrowth, Basis::Sine, Engine::Fast)
  ->Apply(sizesOfEqualKind<1>)
  ->Complexity(nearLinear);
