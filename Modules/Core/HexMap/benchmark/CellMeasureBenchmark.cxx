#include "moserhex/Common/Random.h"
#include "moserhex/HexMap/MassMeasure.h"
#include "moserhex/LevelSet/DensityImage.h"

#include <benchmark/benchmark.h>

using namespace moserhex;

namespace
{

/** 19^3 cells of 2.4 mm: a prostate at N = 10. */
HexMesh
prostateSizedLattice()
{
  HexMesh mesh{ 20, {} };
  Random  random(1);
  for (int k = 0; k < 20; ++k)
  {
    for (int j = 0; j < 20; ++j)
    {
      for (int i = 0; i < 20; ++i)
      {
        const Vector3 shift(random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5));
        mesh.nodes.push_back(2.4 * Vector3(i, j, k) + shift);
      }
    }
  }
  return mesh;
}

ScalarVolume
noise()
{
  ScalarVolume image;
  image.size = { { 48, 48, 48 } };
  Random random(2);
  for (std::size_t voxel = 0; voxel < image.gridVoxels(); ++voxel)
  {
    image.values.push_back(random.uniform(0.5, 2.0));
  }
  return image;
}

void
evaluateOften(benchmark::State & state, const CellMeasure & measure, CellGradients * gradients)
{
  const HexMesh       mesh = prostateSizedLattice();
  std::vector<double> measures;
  for (auto _ : state)
  {
    measure.evaluate(mesh, 1, measures, gradients);
    benchmark::DoNotOptimize(measures.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(mesh.cellCount()));
}

} // namespace

static void
BM_CellVolumesAndGradients(benchmark::State & state)
{
  CellGradients gradients;
  evaluateOften(state, VolumeMeasure(), &gradients);
}
BENCHMARK(BM_CellVolumesAndGradients)->Unit(benchmark::kMillisecond);

static void
BM_CellMasses(benchmark::State & state)
{
  const DensityImage density(noise());
  evaluateOften(state, MassMeasure(density, { static_cast<int>(state.range(0)) }), nullptr);
}
BENCHMARK(BM_CellMasses)->Arg(2)->Arg(4)->Arg(9)->Unit(benchmark::kMillisecond);

static void
BM_CellMassesAndGradients(benchmark::State & state)
{
  const DensityImage density(noise());
  CellGradients      gradients;
  evaluateOften(state, MassMeasure(density, { static_cast<int>(state.range(0)) }), &gradients);
}
BENCHMARK(BM_CellMassesAndGradients)->Arg(2)->Arg(4)->Arg(9)->Unit(benchmark::kMillisecond);
