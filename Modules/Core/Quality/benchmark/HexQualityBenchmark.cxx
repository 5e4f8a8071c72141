#include "moserhex/Quality/HexQuality.h"

#include <benchmark/benchmark.h>

using namespace moserhex;

static void
BM_SummarizeQuality(benchmark::State & state)
{
  const int n = static_cast<int>(state.range(0));
  HexMesh   mesh{ n, {} };
  for (int k = 0; k < n; ++k)
  {
    for (int j = 0; j < n; ++j)
    {
      for (int i = 0; i < n; ++i)
      {
        mesh.nodes.emplace_back(i + 0.01 * j * k, j - 0.02 * i * k, k + 0.01 * i * j);
      }
    }
  }
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(summarizeQuality(mesh));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(mesh.cellCount()));
}
BENCHMARK(BM_SummarizeQuality)->Arg(12)->Arg(20)->Arg(40);
