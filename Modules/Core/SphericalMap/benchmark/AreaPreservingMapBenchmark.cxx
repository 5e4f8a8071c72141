#include "moserhex/Analytic/SurfaceShapes.h"
#include "moserhex/SphericalMap/AreaPreservingMap.h"
#include "moserhex/SphericalMap/ConformalMap.h"
#include "moserhex/SphericalMap/SphereHierarchy.h"
#include "moserhex/SphericalMap/SphereLocator.h"

#include <benchmark/benchmark.h>

#include <cmath>

using namespace moserhex;

namespace
{

/** A smooth, asymmetric closed surface of about `triangles` triangles: 20 * 4^level of them. */
TriangleMesh
organ(int level)
{
  TriangleMesh mesh = analytic::starShapedSurface(level, [](const Vector3 & n) {
    return 20.0 * (1.0 + 0.15 * n[1] * n[2] + 0.1 * n[2] + 0.1 * std::sin(3.0 * n[0]) * n[1]);
  });
  for (Vector3 & p : mesh.vertices)
  {
    p = Vector3(1.3 * p[0], p[1], 1.15 * p[2]);
  }
  return mesh;
}

void
count(benchmark::State & state, const TriangleMesh & surface)
{
  const auto triangles = static_cast<std::int64_t>(surface.triangles.size());
  state.SetComplexityN(triangles);
  state.SetItemsProcessed(state.iterations() * triangles);
}

void
BM_ConformalSphereMap(benchmark::State & state)
{
  const TriangleMesh surface = organ(static_cast<int>(state.range(0)));
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(conformalSphereMap(surface));
  }
  count(state, surface);
}
BENCHMARK(BM_ConformalSphereMap)->DenseRange(3, 6)->Unit(benchmark::kMillisecond)->Complexity();

void
BM_SphereMapByHierarchy(benchmark::State & state)
{
  const TriangleMesh surface = organ(static_cast<int>(state.range(0)));
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(sphereMapByHierarchy(surface));
  }
  count(state, surface);
}
BENCHMARK(BM_SphereMapByHierarchy)->DenseRange(3, 5)->Unit(benchmark::kMillisecond)->Complexity();

void
BM_AreaPreservingSphereMap(benchmark::State & state)
{
  const TriangleMesh surface = organ(static_cast<int>(state.range(0)));
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(areaPreservingSphereMap(surface));
  }
  count(state, surface);
}
BENCHMARK(BM_AreaPreservingSphereMap)->DenseRange(3, 6)->Unit(benchmark::kMillisecond)->Complexity();

void
BM_LocateEveryVertex(benchmark::State & state)
{
  const TriangleMesh  sphere = analytic::icosphere(static_cast<int>(state.range(0)));
  const SphereLocator locator(sphere.triangles, sphere.vertices);
  for (auto _ : state)
  {
    for (const Vector3 & s : sphere.vertices)
    {
      benchmark::DoNotOptimize(locator.locate(s));
    }
  }
  count(state, sphere);
}
BENCHMARK(BM_LocateEveryVertex)->DenseRange(3, 6)->Unit(benchmark::kMillisecond)->Complexity();

} // namespace
