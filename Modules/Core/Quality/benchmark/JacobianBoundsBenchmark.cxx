#include "moserhex/Quality/JacobianBounds.h"

#include "moserhex/Analytic/Lattices.h"

#include <benchmark/benchmark.h>

using namespace moserhex;

namespace
{

/** A lattice whose 27 coefficients are positive everywhere. */
HexMesh
gentleLattice(int n)
{
  return analytic::lattice(n, [](const Vector3 & x) {
    return Vector3(x[0] + 0.002 * x[1] * x[2], x[1] - 0.003 * x[0] * x[2], x[2] + 0.002 * x[0] * x[1]);
  });
}

} // namespace

static void
BM_SmallestBezierCoefficients(benchmark::State & state)
{
  const HexMesh mesh = gentleLattice(static_cast<int>(state.range(0)));
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(smallestBezierCoefficients(mesh));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(mesh.cellCount()));
}
BENCHMARK(BM_SmallestBezierCoefficients)->Arg(20)->Arg(64)->Unit(benchmark::kMillisecond);

static void
BM_CertifyCells(benchmark::State & state)
{
  const HexMesh mesh = gentleLattice(static_cast<int>(state.range(0)));
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(certifyCells(mesh));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(mesh.cellCount()));
}
BENCHMARK(BM_CertifyCells)->Arg(20)->Arg(64)->Unit(benchmark::kMillisecond);

/** A cell with det J = (1 - 1.7 zeta)^2, which no subdivision decides: the most that one cell can cost. */
static void
BM_CertifyUndecidableCell(benchmark::State & state)
{
  HexCorners corners = cellCorners(gentleLattice(2), 0);
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    corners[corner] -= Vector3(0.5, 0.5, 0.0);
    corners[corner].head<2>() *= corner < 4 ? 1.0 : -0.7;
  }
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(certifyPositive(corners));
  }
}
BENCHMARK(BM_CertifyUndecidableCell)->Unit(benchmark::kMicrosecond);
