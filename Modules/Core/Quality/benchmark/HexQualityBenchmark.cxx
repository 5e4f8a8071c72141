#include "moserhex/Quality/HexQuality.h"

#include "moserhex/Analytic/Lattices.h"

#include <benchmark/benchmark.h>

using namespace moserhex;

static void
BM_SummarizeQuality(benchmark::State & state)
{
  const HexMesh mesh = analytic::lattice(static_cast<int>(state.range(0)), [](const Vector3 & x) {
    return Vector3(x[0] + 0.01 * x[1] * x[2], x[1] - 0.02 * x[0] * x[2], x[2] + 0.01 * x[0] * x[1]);
  });
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(summarizeQuality(mesh));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(mesh.cellCount()));
}
BENCHMARK(BM_SummarizeQuality)->Arg(12)->Arg(20)->Arg(40);
