#include "moserhex/HexMap/VolumetricMoserFlow.h"

#include "TestLattices.h"

#include <benchmark/benchmark.h>

using namespace moserhex;
using namespace moserhex::testing;

namespace
{
double
radius(const Vector3 & d)
{
  return 20.0 + 3.0 * d[0] * d[1] + 4.0 * d[2] * d[2];
}

} // namespace

static void
BM_SmoothLattice(benchmark::State & state)
{
  const HexMesh mesh = starShapedMesh(static_cast<int>(state.range(0)), radius);
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(smoothLattice(mesh, alongRays(radius)));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(mesh.nodes.size()));
}
BENCHMARK(BM_SmoothLattice)->Arg(6)->Arg(10)->Arg(20)->Unit(benchmark::kMillisecond);

static void
BM_FlowPass(benchmark::State & state)
{
  const HexMesh              mesh = starShapedMesh(static_cast<int>(state.range(0)), radius);
  VolumetricMoserFlowOptions options;
  options.maximumPasses = 1;
  options.smoothedPasses = 0;
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(volumetricMoserFlow(mesh, alongRays(radius), options));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(mesh.nodes.size()));
}
BENCHMARK(BM_FlowPass)->Arg(6)->Arg(10)->Arg(20)->Unit(benchmark::kMillisecond);

static void
BM_WholeFlow(benchmark::State & state)
{
  const HexMesh              mesh = starShapedMesh(static_cast<int>(state.range(0)), radius);
  VolumetricMoserFlowOptions options;
  options.targetVariance = 0.0;
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(volumetricMoserFlow(mesh, alongRays(radius), options));
  }
}
BENCHMARK(BM_WholeFlow)->Arg(10)->Unit(benchmark::kMillisecond);
