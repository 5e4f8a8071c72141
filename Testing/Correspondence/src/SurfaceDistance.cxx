#include "moserhex/Correspondence/SurfaceDistance.h"

#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Parallel.h"
#include "moserhex/Geometry/ClosestPoint.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace moserhex
{
namespace
{

constexpr std::size_t pointsAtOnce = 1024;

/** Points on a surface, and the area that each stands for. */
struct SurfaceSamples
{
  Positions           points;
  std::vector<double> areas;
};

/** The middles of the k^2 parts of a triangle. */
void
addSamples(const Vector3 & a, const Vector3 & b, const Vector3 & c, int k, SurfaceSamples & samples)
{
  const Vector3 u = (b - a) / k;
  const Vector3 v = (c - a) / k;
  const double  area = triangleArea(a, b, c) / (static_cast<double>(k) * k);
  for (int i = 0; i < k; ++i)
  {
    for (int j = 0; i + j < k; ++j)
    {
      samples.points.emplace_back(a + (i + 1.0 / 3.0) * u + (j + 1.0 / 3.0) * v);
      samples.areas.push_back(area);
      if (i + j + 1 < k) // the one that stands on its corner
      {
        samples.points.emplace_back(a + (i + 2.0 / 3.0) * u + (j + 2.0 / 3.0) * v);
        samples.areas.push_back(area);
      }
    }
  }
}

SurfaceSamples
samplesOf(const TriangleMesh & surface, double spacing)
{
  SurfaceSamples samples;
  for (const Triangle & triangle : surface.triangles)
  {
    const auto    corner = [&](std::size_t c) { return surface.vertices[static_cast<std::size_t>(triangle[c])]; };
    const Vector3 a = corner(0);
    const Vector3 b = corner(1);
    const Vector3 c = corner(2);
    const double  longest = std::max({ (b - a).norm(), (c - b).norm(), (a - c).norm() });
    addSamples(a, b, c, std::max(1, static_cast<int>(std::ceil(longest / spacing))), samples);
  }
  return samples;
}

/** Adds the distances of `from` and their areas to what is there. */
void
addDistances(const TriangleMesh &           from,
             const TriangleMesh &           to,
             const SurfaceDistanceOptions & options,
             std::vector<double> &          distances,
             std::vector<double> &          areas)
{
  const SurfaceSamples     samples = samplesOf(from, options.spacing);
  const ClosestPointSearch search(to);
  const std::size_t        before = distances.size();
  distances.resize(before + samples.points.size());
  areas.insert(areas.end(), samples.areas.begin(), samples.areas.end());
  parallelForBlocks(samples.points.size(), pointsAtOnce, options.threads, [&](std::size_t begin, std::size_t end) {
    int guess = -1;
    for (std::size_t i = begin; i < end; ++i)
    {
      const ClosestPointOnSurface nearest = search.closest(samples.points[i], guess);
      distances[before + i] = std::sqrt(nearest.squaredDistance);
      guess = nearest.triangle;
    }
  });
}

WeightedDistribution
distributionOf(const std::vector<double> & distances, const std::vector<double> & areas)
{
  const std::optional<WeightedDistribution> distribution = weightedDistribution(distances, areas);
  if (!distribution)
  {
    throw InvalidInput("surface distance: a surface without area");
  }
  return *distribution;
}

void
requireUsable(const SurfaceDistanceOptions & options)
{
  if (!(options.spacing > 0.0))
  {
    throw InvalidInput("surface distance: spacing " + std::to_string(options.spacing) + " mm, need > 0");
  }
}

} // namespace

WeightedDistribution
surfaceDistance(const TriangleMesh & from, const TriangleMesh & to, const SurfaceDistanceOptions & options)
{
  requireUsable(options);
  std::vector<double> distances;
  std::vector<double> areas;
  addDistances(from, to, options, distances, areas);
  return distributionOf(distances, areas);
}

WeightedDistribution
symmetricSurfaceDistance(const TriangleMesh & a, const TriangleMesh & b, const SurfaceDistanceOptions & options)
{
  requireUsable(options);
  std::vector<double> distances;
  std::vector<double> areas;
  addDistances(a, b, options, distances, areas);
  addDistances(b, a, options, distances, areas);
  return distributionOf(distances, areas);
}

} // namespace moserhex
