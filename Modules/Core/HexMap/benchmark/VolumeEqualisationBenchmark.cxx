// The equalisation of a ball and the pieces that it is made of. Arguments: nodes a side, threads.
#include "ShapeEnergy.h"
#include "moserhex/HexMap/VolumeEqualisation.h"
#include "moserhex/Quality/JacobianBounds.h"
#include "moserhex/StructuredGrid/CubeLattice.h"
#include "moserhex/StructuredGrid/CubeToSphere.h"

#include <benchmark/benchmark.h>

#include <cmath>

using namespace moserhex;

namespace
{
constexpr double radius = 20.0;

double
ballVolume()
{
  return 4.0 / 3.0 * pi * radius * radius * radius;
}

double
ballDistance(const Vector3 & point, Vector3 & gradient)
{
  const double length = point.norm();
  gradient = length > 0.0 ? Vector3(point / length) : Vector3::UnitX();
  return length - radius;
}

/** Homothetic shells: volumes uneven, no cell inverted. */
HexMesh
ballLattice(int nodesPerSide)
{
  const CubeLattice lattice(nodesPerSide / 2);
  HexMesh           mesh{ nodesPerSide, Positions(lattice.nodeCount()) };
  for (std::size_t node = 0; node < lattice.nodeCount(); ++node)
  {
    const double size = radius * lattice.relativeSize(lattice.shellOfNode(node));
    mesh.nodes[node] = size * cubeToSphere(lattice.positionOnShell(node));
  }
  return mesh;
}

/** A unit cube's lattice with smoothly uneven cells, as near to equal ones as a minimisation leaves them: rms 2 %. */
HexMesh
unevenCube(int nodesPerSide)
{
  const double wave = pi;
  HexMesh      mesh{ nodesPerSide, {} };
  for (int k = 0; k < nodesPerSide; ++k)
  {
    for (int j = 0; j < nodesPerSide; ++j)
    {
      for (int i = 0; i < nodesPerSide; ++i)
      {
        const Vector3 x = Vector3(i, j, k) / (nodesPerSide - 1.0);
        const Vector3 shift(std::sin(wave * x[0]) * std::cos(wave * x[1]), std::sin(wave * x[1]) * x[2], 0.0);
        mesh.nodes.push_back(x + 0.01 * shift);
      }
    }
  }
  return mesh;
}

/** Signed distance near the faces of the unit cube, which is all that the projection asks for: its normals. */
double
cubeDistance(const Vector3 & point, Vector3 & gradient)
{
  const Vector3 p = point - Vector3::Constant(0.5);
  Eigen::Index  axis = 0;
  const double  farthest = p.cwiseAbs().maxCoeff(&axis);
  gradient = Vector3::Zero();
  gradient[axis] = p[axis] < 0.0 ? -1.0 : 1.0;
  return farthest - 0.5;
}

double
cellsOf(const benchmark::State & state)
{
  return std::pow(static_cast<double>(state.range(0) - 1), 3);
}

void
countCells(benchmark::State & state)
{
  const auto cells = static_cast<std::int64_t>(cellsOf(state));
  state.SetItemsProcessed(state.iterations() * cells);
  state.SetComplexityN(cells);
}

void
sizesAndThreads(benchmark::internal::Benchmark * benchmark)
{
  benchmark->ArgsProduct({ { 10, 20, 40, 64 }, { 1, 2 } })
    ->ArgNames({ "n", "threads" })
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
}
} // namespace

static void
BM_ShapeEnergy(benchmark::State & state)
{
  const HexMesh         mesh = ballLattice(static_cast<int>(state.range(0)));
  const LatticeLayout   layout(mesh.nodesPerSide);
  const double          unit = std::cbrt(ballVolume() / cellsOf(state));
  const Eigen::VectorXd x = latticeVector(layout, mesh.nodes, Vector3::Zero(), unit);
  const Eigen::VectorXd targets = unitTargetVolumes(layout);
  Eigen::VectorXd       gradient = Eigen::VectorXd::Zero(layout.size());
  for (auto _ : state)
  {
    const auto threads = static_cast<unsigned int>(state.range(1));
    benchmark::DoNotOptimize(addShapeEnergy(layout, x, targets, { 0.05, 50.0, 1 }, threads, gradient));
  }
  countCells(state);
}
BENCHMARK(BM_ShapeEnergy)->Apply(sizesAndThreads)->Complexity(benchmark::oN);

static void
BM_EqualMeasureProjection(benchmark::State & state)
{
  const HexMesh       mesh = unevenCube(static_cast<int>(state.range(0)));
  const double        target = measureEquality(mesh, VolumeMeasure()).total / cellsOf(state);
  EqualMeasureOptions options;
  options.threads = static_cast<unsigned int>(state.range(1));
  EqualMeasureResult result;
  for (auto _ : state)
  {
    result = projectOntoEqualMeasure(mesh, VolumeMeasure(), target, cubeDistance, options);
  }
  int solverSteps = 0;
  for (const EqualMeasureStep & step : result.steps)
  {
    solverSteps += step.solverSteps;
  }
  state.counters["newton"] = result.report.steps;
  state.counters["cg"] = solverSteps;
  state.counters["converged"] = result.report.converged ? 1 : 0;
  countCells(state);
}
BENCHMARK(BM_EqualMeasureProjection)->Apply(sizesAndThreads);

static void
BM_Certificate(benchmark::State & state)
{
  const HexMesh mesh = ballLattice(static_cast<int>(state.range(0)));
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(certifyCells(mesh, {}, static_cast<unsigned int>(state.range(1))));
  }
  countCells(state);
}
BENCHMARK(BM_Certificate)->Apply(sizesAndThreads);

/** From six nodes a side, the fast way. */
static void
BM_EqualiseBall(benchmark::State & state)
{
  const HexMesh       start = ballLattice(6);
  EqualisationOptions options;
  options.nodesPerSide = static_cast<int>(state.range(0));
  options.threads = static_cast<unsigned int>(state.range(1));
  EqualisationResult result;
  for (auto _ : state)
  {
    result = equaliseVolumes(start, ballDistance, ballVolume(), options);
  }
  int evaluations = 0;
  for (const EqualisationStep & step : result.steps)
  {
    evaluations += step.name == "project" ? 0 : step.evaluations;
  }
  state.counters["evaluations"] = evaluations;
  state.counters["exact"] = result.exact ? 1 : 0;
  countCells(state);
}
BENCHMARK(BM_EqualiseBall)
  ->ArgsProduct({ { 10, 20 }, { 1, 2 } })
  ->ArgNames({ "n", "threads" })
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime();
