#include "moserhex/StructuredGrid/CubeLattice.h"
#include "moserhex/StructuredGrid/CubeToSphere.h"

#include <benchmark/benchmark.h>

using namespace moserhex;

/** All nodes of a lattice of N shells to the sphere. */
static void
BM_CubeToSphere(benchmark::State & state)
{
  const CubeLattice lattice(static_cast<int>(state.range(0)));
  for (auto _ : state)
  {
    for (std::size_t node = 0; node < lattice.nodeCount(); ++node)
    {
      benchmark::DoNotOptimize(cubeToSphere(lattice.positionOnShell(node)));
    }
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(lattice.nodeCount()));
}
BENCHMARK(BM_CubeToSphere)->Arg(6)->Arg(10)->Arg(20);
