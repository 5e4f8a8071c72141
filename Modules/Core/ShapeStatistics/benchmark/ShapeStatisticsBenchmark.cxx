#include "TestShapes.h"
#include "moserhex/ShapeStatistics/ModelQuality.h"
#include "moserhex/ShapeStatistics/PermutationTest.h"
#include "moserhex/ShapeStatistics/Procrustes.h"
#include "moserhex/ShapeStatistics/ShapeModel.h"

#include <benchmark/benchmark.h>

// Subjects of 20^3 nodes that differ in three semi-axes and in noise; the argument is their number.

namespace
{

using namespace moserhex;
using namespace moserhex::testing;

std::vector<Positions>
subjectsOf(std::size_t count)
{
  Random                 random(1);
  std::vector<Positions> subjects;
  for (std::size_t i = 0; i < count; ++i)
  {
    subjects.push_back(softCube(20, { random.uniform(20, 28), random.uniform(15, 21), random.uniform(18, 24) }).nodes);
    for (Vector3 & p : subjects.back())
    {
      p += 0.1 * Vector3(normalNumber(random), normalNumber(random), normalNumber(random));
    }
  }
  return subjects;
}

Eigen::MatrixXd
matrixOf(const std::vector<Positions> & subjects)
{
  Eigen::MatrixXd values(static_cast<Eigen::Index>(subjects.size()),
                         3 * static_cast<Eigen::Index>(subjects.front().size()));
  for (std::size_t i = 0; i < subjects.size(); ++i)
  {
    values.row(static_cast<Eigen::Index>(i)) = coordinatesOf(subjects[i]).transpose();
  }
  return values;
}

void
BM_GeneralisedProcrustes(benchmark::State & state)
{
  const auto subjects = subjectsOf(static_cast<std::size_t>(state.range(0)));
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(
      generalisedProcrustes(subjects.size(), [&](std::size_t subject) { return subjects[subject]; }));
  }
}
BENCHMARK(BM_GeneralisedProcrustes)->Arg(50)->Arg(200)->Unit(benchmark::kMillisecond)->UseRealTime();

void
BM_ShapeModel(benchmark::State & state)
{
  const MatrixTable table(matrixOf(subjectsOf(static_cast<std::size_t>(state.range(0)))));
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(fitShapeModel(table));
  }
}
BENCHMARK(BM_ShapeModel)->Arg(50)->Arg(200)->Unit(benchmark::kMillisecond)->UseRealTime();

void
BM_ModelQuality(benchmark::State & state)
{
  const auto fit = fitShapeModel(MatrixTable(matrixOf(subjectsOf(static_cast<std::size_t>(state.range(0))))));
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(modelQuality(fit.scores, 8000));
  }
}
BENCHMARK(BM_ModelQuality)->Arg(50)->Arg(200)->Unit(benchmark::kMillisecond)->UseRealTime();

/** 1000 permutations of two groups with one covariate. */
void
BM_PermutationTest(benchmark::State & state)
{
  const Eigen::Index count = state.range(0);
  const MatrixTable  table(matrixOf(subjectsOf(static_cast<std::size_t>(count))));
  Random             random(2);
  LinearDesign       design{ Eigen::VectorXd::Zero(count), normalMatrix(count, 1, random) };
  design.effect.bottomRows(count / 2).setOnes();
  PermutationOptions options;
  options.permutations = 1000;
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(permutationTest(table, design, options));
  }
}
BENCHMARK(BM_PermutationTest)->Arg(50)->Arg(200)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
