#include "moserhex/HexMap/CubeShellMaps.h"
#include "moserhex/HexMap/FramePlacement.h"

#include <benchmark/benchmark.h>

using namespace moserhex;

namespace
{

/** A lobed surface over the directions of a subdivided cube, with those directions as its map. */
struct Organ
{
  TriangleMesh surface = cubeSurfaceMesh(24);
  Positions    map;

  Organ()
  {
    for (Vector3 & vertex : surface.vertices)
    {
      const Vector3 d = vertex.normalized();
      map.push_back(d);
      vertex = (20.0 + 5.0 * d[0] * d[1] + 4.0 * d[2] * d[2] * d[0]) * d;
    }
  }
};

} // namespace

static void
BM_EdgeScore(benchmark::State & state)
{
  const Organ           organ;
  FramePlacementOptions options;
  options.nodesPerSide = static_cast<int>(state.range(0));
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(edgeScore(organ.surface, organ.map, {}, options));
  }
}
BENCHMARK(BM_EdgeScore)->Arg(10)->Arg(20)->Arg(40)->Unit(benchmark::kMillisecond);

/** Argument: the bound on the boost, in hundredths. */
static void
BM_PlaceFrame(benchmark::State & state)
{
  const Organ           organ;
  FramePlacementOptions options;
  options.maximumBoost = 0.01 * static_cast<double>(state.range(0));
  int evaluations = 0;
  for (auto _ : state)
  {
    evaluations = placeFrame(organ.surface, organ.map, options).evaluations;
  }
  state.counters["evaluations"] = evaluations;
}
BENCHMARK(BM_PlaceFrame)->Arg(0)->Arg(5)->Unit(benchmark::kMillisecond);
