#include "moserhex/Correspondence/SurfaceDistance.h"

#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Parallel.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace moserhex
{
namespace
{

constexpr std::size_t pointsAtOnce = 1024;

/** Distances, and the areas that they stand for. */
class Distances
{
public:
  void
  add(const SampledSurface & from, const ClosestPointSearch & to, unsigned int threads)
  {
    const std::size_t before = m_Distances.size();
    m_Distances.resize(before + from.points().size());
    m_Areas.insert(m_Areas.end(), from.areas().begin(), from.areas().end());
    parallelForBlocks(from.points().size(), pointsAtOnce, threads, [&](std::size_t begin, std::size_t end) {
      int guess = -1;
      for (std::size_t i = begin; i < end; ++i)
      {
        const ClosestPointOnSurface nearest = to.closest(from.points()[i], guess);
        m_Distances[before + i] = std::sqrt(nearest.squaredDistance);
        guess = nearest.triangle;
      }
    });
  }

  [[nodiscard]] WeightedDistribution
  distribution() const
  {
    const std::optional<WeightedDistribution> found = weightedDistribution(m_Distances, m_Areas);
    if (!found)
    {
      throw InvalidInput("surface distance: a surface without area");
    }
    return *found;
  }

private:
  std::vector<double> m_Distances;
  std::vector<double> m_Areas;
};

} // namespace

SampledSurface::SampledSurface(const TriangleMesh & surface, double spacing) : m_Search(surface)
{
  if (!(spacing > 0.0))
  {
    throw InvalidInput("surface distance: spacing " + std::to_string(spacing) + " mm, need > 0");
  }
  for (const Triangle & triangle : surface.triangles)
  {
    const auto    corner = [&](std::size_t c) { return surface.vertices[static_cast<std::size_t>(triangle[c])]; };
    const Vector3 a = corner(0);
    const Vector3 b = corner(1);
    const Vector3 c = corner(2);
    const double  longest = std::max({ (b - a).norm(), (c - b).norm(), (a - c).norm() });
    addParts(a, b, c, std::max(1, static_cast<int>(std::ceil(longest / spacing))));
  }
}

void
SampledSurface::addParts(const Vector3 & a, const Vector3 & b, const Vector3 & c, int k)
{
  const Vector3 u = (b - a) / k;
  const Vector3 v = (c - a) / k;
  const double  area = triangleArea(a, b, c) / (static_cast<double>(k) * k);
  for (int i = 0; i < k; ++i)
  {
    for (int j = 0; i + j < k; ++j)
    {
      m_Points.emplace_back(a + (i + 1.0 / 3.0) * u + (j + 1.0 / 3.0) * v);
      m_Areas.push_back(area);
      if (i + j + 1 < k) // the one that stands on its corner
      {
        m_Points.emplace_back(a + (i + 2.0 / 3.0) * u + (j + 2.0 / 3.0) * v);
        m_Areas.push_back(area);
      }
    }
  }
}

WeightedDistribution
surfaceDistance(const TriangleMesh & from, const TriangleMesh & to, const SurfaceDistanceOptions & options)
{
  Distances distances;
  distances.add(SampledSurface(from, options.spacing), ClosestPointSearch(to), options.threads);
  return distances.distribution();
}

WeightedDistribution
symmetricSurfaceDistance(const SampledSurface & a, const SampledSurface & b, unsigned int threads)
{
  Distances distances;
  distances.add(a, b.search(), threads);
  distances.add(b, a.search(), threads);
  return distances.distribution();
}

WeightedDistribution
symmetricSurfaceDistance(const TriangleMesh & a, const TriangleMesh & b, const SurfaceDistanceOptions & options)
{
  return symmetricSurfaceDistance(
    SampledSurface(a, options.spacing), SampledSurface(b, options.spacing), options.threads);
}

} // namespace moserhex
