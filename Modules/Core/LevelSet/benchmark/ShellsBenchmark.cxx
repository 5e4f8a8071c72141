// From the voxels of a bumpy ball to nested surfaces: stage A over the size of its image, stages B and C (the front,
// the ordering by volume, the surfaces of the shells) for the 3 shells of the fast way and for 10.
#include "moserhex/Analytic/SolidShapes.h"
#include "moserhex/LevelSet/EikonalArrival.h"
#include "moserhex/LevelSet/LabelConditioning.h"
#include "moserhex/LevelSet/ShellOrdering.h"
#include "moserhex/LevelSet/ShellSurfaces.h"

#include <benchmark/benchmark.h>

using namespace moserhex;

namespace
{

LabelVolume
bumpyBall(int voxelsPerSide)
{
  analytic::GridPlacement placement;
  placement.spacing = Vector3::Constant(52.0 / voxelsPerSide);
  return analytic::labelVolume(analytic::bumpyBall(), placement);
}

ShellOrdering
orderingOf(const LevelSet & phi)
{
  const FrontWeight          front = frontWeight(phi);
  const EikonalArrivalResult arrival = eikonalArrival(phi, front.weight, front.seed);
  return shellOrdering(phi, arrival.levelSet, front.seed);
}

void
BM_ConditionLabel(benchmark::State & state)
{
  const LabelVolume label = bumpyBall(static_cast<int>(state.range(0)));
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(conditionLabel(label));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(label.inside.size()));
}

void
BM_OrderByVolume(benchmark::State & state)
{
  const LevelSet phi = conditionLabel(bumpyBall(64)).levelSet;
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(orderingOf(phi));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(phi.grid.nodeCount()));
}

void
BM_ExtractShellSurfaces(benchmark::State & state)
{
  const auto             shells = static_cast<int>(state.range(0));
  const LabelVolume      label = bumpyBall(64);
  const ConditionedSolid solid = conditionLabel(label);
  const LevelSet         ordering = orderingOf(solid.levelSet).levelSet;
  const double           volume = analytic::volumeOfVoxels(label);
  ShellSurfaceOptions    options;
  options.threads = static_cast<unsigned int>(state.range(1));
  std::size_t triangles = 0;
  for (auto _ : state)
  {
    triangles += summarizeShells(extractShellSurfaces(ordering, solid.levelSet, volume, shells, options)).triangles;
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(triangles));
}

} // namespace

BENCHMARK(BM_ConditionLabel)->Arg(32)->Arg(64)->Arg(128)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_OrderByVolume)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_ExtractShellSurfaces)
  ->ArgNames({ "shells", "threads" })
  ->Args({ 3, 1 })
  ->Args({ 10, 1 })
  ->Args({ 10, 2 })
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime();
