// Whole runs on a ball sampled at 32^3, 64^3 and 128^3 voxels, and over the number of shells: time per mesh and per
// cell.
#include "itkMassPreservingHexahedralMeshFilter.h"

#include "moserhex/Analytic/SolidShapes.h"
#include "moserhex/HexMeshIO/LabelImageReader.h"

#include <benchmark/benchmark.h>

using namespace moserhex;

namespace
{

LabelImageType::Pointer
bumpyBallImage(int voxelsPerSide)
{
  analytic::GridPlacement placement;
  placement.spacing = Vector3::Constant(52.0 / voxelsPerSide);
  return labelImageOf(analytic::labelVolume(analytic::bumpyBall(), placement));
}

void
run(benchmark::State & state, const LabelImageType * image, int shells)
{
  std::size_t cells = 0;
  for (auto _ : state)
  {
    auto pipeline = itk::MassPreservingHexahedralMeshFilter<LabelImageType>::New();
    pipeline->SetInput(image);
    pipeline->SetNumberOfShells(shells);
    pipeline->Update();
    cells += pipeline->GetHexMesh().cellCount();
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(cells));
}

void
BM_PipelineOverVoxels(benchmark::State & state)
{
  const auto image = bumpyBallImage(static_cast<int>(state.range(0)));
  run(state, image, 10);
  state.SetComplexityN(state.range(0));
}

void
BM_PipelineOverShells(benchmark::State & state)
{
  const auto image = bumpyBallImage(64);
  run(state, image, static_cast<int>(state.range(0)));
  state.SetComplexityN(state.range(0));
}

} // namespace

BENCHMARK(BM_PipelineOverVoxels)
  ->Arg(32)
  ->Arg(64)
  ->Arg(128)
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime()
  ->Complexity();
BENCHMARK(BM_PipelineOverShells)
  ->Arg(4)
  ->Arg(6)
  ->Arg(10)
  ->Arg(16)
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime()
  ->Complexity();
