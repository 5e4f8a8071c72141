#include "moserhex/HexMap/VolumetricMoserFlow.h"
#include "moserhex/StructuredGrid/CubeLattice.h"
#include "moserhex/StructuredGrid/CubeToSphere.h"

#include <benchmark/benchmark.h>

#include <cmath>

using namespace moserhex;

namespace
{
double
radius(const Vector3 & d)
{
  return 20.0 + 3.0 * d[0] * d[1] + 4.0 * d[2] * d[2];
}

Vector3
project(const Vector3 & p)
{
  const Vector3 direction = p.normalized();
  return radius(direction) * direction;
}

HexMesh
organ(int shells)
{
  const CubeLattice lattice(shells);
  HexMesh           mesh{ lattice.nodesPerSide(), Positions(lattice.nodeCount()) };
  for (std::size_t node = 0; node < lattice.nodeCount(); ++node)
  {
    const Vector3 direction = cubeToSphere(lattice.positionOnShell(node));
    mesh.nodes[node] = lattice.relativeSize(lattice.shellOfNode(node)) * radius(direction) * direction;
  }
  return mesh;
}
} // namespace

static void
BM_SmoothLattice(benchmark::State & state)
{
  const HexMesh mesh = organ(static_cast<int>(state.range(0)));
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(smoothLattice(mesh, project));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(mesh.nodes.size()));
}
BENCHMARK(BM_SmoothLattice)->Arg(6)->Arg(10)->Arg(20)->Unit(benchmark::kMillisecond);

static void
BM_FlowPass(benchmark::State & state)
{
  const HexMesh              mesh = organ(static_cast<int>(state.range(0)));
  VolumetricMoserFlowOptions options;
  options.maximumPasses = 1;
  options.smoothedPasses = 0;
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(volumetricMoserFlow(mesh, project, options));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(mesh.nodes.size()));
}
BENCHMARK(BM_FlowPass)->Arg(6)->Arg(10)->Arg(20)->Unit(benchmark::kMillisecond);

static void
BM_WholeFlow(benchmark::State & state)
{
  const HexMesh              mesh = organ(static_cast<int>(state.range(0)));
  VolumetricMoserFlowOptions options;
  options.targetVariance = 0.0;
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(volumetricMoserFlow(mesh, project, options));
  }
}
BENCHMARK(BM_WholeFlow)->Arg(10)->Unit(benchmark::kMillisecond);
