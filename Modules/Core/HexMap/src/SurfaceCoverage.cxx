#include "SurfaceCoverage.h"

#include "SpringLengths.h"
#include "moserhex/Common/Parallel.h"
#include "moserhex/Geometry/ClosestPoint.h"
#include "moserhex/Geometry/HexMeshNumbering.h"
#include "moserhex/Geometry/QuadFans.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace moserhex
{
namespace
{
/** d, in cell edges. */
constexpr double freeDistance = 0.5;
/** Points farther away than this part of d keep a spring, slack for now. */
constexpr double watchedPartOfFreeDistance = 0.5;

constexpr std::size_t pointsPerBlock = 64;

/** More points than these pull together as these do. */
constexpr double usualNumberOfPoints = 2000.0;

} // namespace

SurfaceCoverage::SurfaceCoverage(const LatticeLayout & layout, Positions surfacePoints, unsigned int threads)
  : m_Layout(layout)
  , m_SurfacePoints(std::move(surfacePoints))
  , m_Threads(threads)
  , m_Quads(boundaryQuads(layout.connectivity()))
{
  const auto count = static_cast<double>(m_SurfacePoints.size());
  m_Stiffness.assign(m_SurfacePoints.size(), usualNumberOfPoints / std::max(usualNumberOfPoints, count));
}

void
SurfaceCoverage::associate(const Eigen::VectorXd & x)
{
  const ClosestPointSearch search(quadFans(m_Quads, [this, &x](std::size_t node) { return m_Layout.at(x, node); }));
  std::vector<ClosestPointOnSurface> nearest(m_SurfacePoints.size());
  m_Nearest.resize(nearest.size(), -1);
  parallelForBlocks(nearest.size(), pointsPerBlock, m_Threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p)
    {
      nearest[p] = search.closest(m_SurfacePoints[p], m_Nearest[p]);
      m_Nearest[p] = nearest[p].triangle;
    }
  });
  m_Springs.clear();
  m_Distances.resize(nearest.size());
  for (std::size_t p = 0; p < nearest.size(); ++p)
  {
    m_Distances[p] = std::sqrt(nearest[p].squaredDistance);
    if (m_Distances[p] > watchedPartOfFreeDistance * freeDistance)
    {
      const auto      triangle = static_cast<std::size_t>(nearest[p].triangle);
      const Vector3 & weights = nearest[p].barycentric;
      m_Springs.push_back({ p, triangle / 4, triangle % 4, { weights[0], weights[1], weights[2] } });
    }
  }
}

double
SurfaceCoverage::largestDistance() const
{
  return largestOf(m_Distances);
}

bool
SurfaceCoverage::isInDoubt() const
{
  return !m_Springs.empty();
}

std::size_t
SurfaceCoverage::strengthen(double tolerance, double factor)
{
  return strengthenBeyond(tolerance, factor, m_Distances, m_Stiffness);
}

Vector3
SurfaceCoverage::boundaryPoint(const Eigen::VectorXd & x, const Spring & spring) const
{
  const auto & quad = m_Quads[spring.quad];
  Vector3      point = Vector3::Zero();
  for (const std::size_t node : quad)
  {
    point += 0.25 * spring.weights[2] * m_Layout.at(x, node);
  }
  point += spring.weights[0] * m_Layout.at(x, quad[spring.side]);
  return point + spring.weights[1] * m_Layout.at(x, quad[(spring.side + 1) % 4]);
}

double
SurfaceCoverage::addEnergy(const Eigen::VectorXd & x, double weight, Eigen::VectorXd & gradient) const
{
  double energy = 0.0;
  for (const Spring & spring : m_Springs)
  {
    const Vector3 away = boundaryPoint(x, spring) - m_SurfacePoints[spring.surfacePoint];
    const double  distance = away.norm();
    const double  excess = distance - freeDistance;
    if (excess <= 0.0)
    {
      continue;
    }
    const double stiffness = weight * m_Stiffness[spring.surfacePoint];
    energy += 0.5 * stiffness * excess * excess;
    const Vector3 pull = stiffness * excess / distance * away;
    const auto &  quad = m_Quads[spring.quad];
    for (const std::size_t node : quad)
    {
      m_Layout.add(gradient, node, 0.25 * spring.weights[2] * pull);
    }
    m_Layout.add(gradient, quad[spring.side], spring.weights[0] * pull);
    m_Layout.add(gradient, quad[(spring.side + 1) % 4], spring.weights[1] * pull);
  }
  return energy;
}

} // namespace moserhex
