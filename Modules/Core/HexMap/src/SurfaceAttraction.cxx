#include "SurfaceAttraction.h"

#include "SpringLengths.h"
#include "moserhex/Common/Parallel.h"
#include "moserhex/Geometry/HexMeshNumbering.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace moserhex
{
namespace
{
constexpr double smallestSlope = 0.3;
constexpr double largestSlope = 2.0;

/** Springs in one piece of parallel work. */
constexpr std::size_t springsPerBlock = 256;

constexpr int newtonSteps = 2;

/** Smallest square of a slope a Newton step divides by. */
constexpr double smallestSquaredSlope = 0.1;

/** To the point of {phi = 0} that Newton steps along the gradient lead to, and what is left of it there: never less
 * than to the nearest point, but for what phi's slope may be wrong by at the end, where phi is about 0. */
double
distanceToSurface(const SignedDistance & phi, const Vector3 & point)
{
  constexpr int steps = 4;
  Vector3       place = point;
  Vector3       gradient;
  double        value = phi(place, gradient);
  for (int step = 0; step < steps; ++step)
  {
    place -= value / std::max(gradient.squaredNorm(), smallestSlope * smallestSlope) * gradient;
    value = phi(place, gradient);
  }
  return (place - point).norm() + std::abs(value) / std::max(gradient.norm(), smallestSlope);
}

} // namespace

SurfaceAttraction::SurfaceAttraction(const LatticeLayout & layout, SignedDistance phi, unsigned int threads)
  : m_Layout(layout)
  , m_Phi(std::move(phi))
  , m_Threads(threads)
  , m_Nodes(boundaryNodes(layout.connectivity()))
  , m_Quads(boundaryQuads(layout.connectivity()))
{
  m_InverseSlope.assign(springCount(), 1.0);
  m_Weights.assign(springCount(), 1.0);
}

Vector3
SurfaceAttraction::place(const Eigen::VectorXd & x, std::size_t spring) const
{
  if (spring < m_Nodes.size())
  {
    return m_Layout.at(x, m_Nodes[spring]);
  }
  const auto & quad = m_Quads[spring - m_Nodes.size()];
  return 0.25 * (m_Layout.at(x, quad[0]) + m_Layout.at(x, quad[1]) + m_Layout.at(x, quad[2]) + m_Layout.at(x, quad[3]));
}

void
SurfaceAttraction::freeze(const Eigen::VectorXd & x)
{
  parallelForBlocks(springCount(), springsPerBlock, m_Threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t spring = begin; spring < end; ++spring)
    {
      Vector3 gradient;
      m_Phi(place(x, spring), gradient);
      m_InverseSlope[spring] = 1.0 / std::min(std::max(gradient.norm(), smallestSlope), largestSlope);
    }
  });
}

double
SurfaceAttraction::addEnergy(const Eigen::VectorXd & x, double weight, Eigen::VectorXd & gradient) const
{
  std::vector<Spring> springs(springCount());
  parallelForBlocks(springCount(), springsPerBlock, m_Threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t spring = begin; spring < end; ++spring)
    {
      Spring & s = springs[spring];
      s.distance = m_Phi(place(x, spring), s.gradient) * m_InverseSlope[spring] - m_Level;
      s.gradient *= m_InverseSlope[spring];
    }
  });
  double squares = 0.0;
  for (std::size_t spring = 0; spring < springs.size(); ++spring)
  {
    const Spring & s = springs[spring];
    squares += m_Weights[spring] * s.distance * s.distance;
    const Vector3 pull = weight * m_Weights[spring] * s.distance * s.gradient;
    if (spring < m_Nodes.size())
    {
      m_Layout.add(gradient, m_Nodes[spring], pull);
      continue;
    }
    for (const std::size_t node : m_Quads[spring - m_Nodes.size()])
    {
      m_Layout.add(gradient, node, 0.25 * pull);
    }
  }
  return 0.5 * weight * squares;
}

double
SurfaceAttraction::area(const Eigen::VectorXd & x) const
{
  double sum = 0.0;
  for (const auto & quad : m_Quads)
  {
    const Vector3 diagonal = m_Layout.at(x, quad[2]) - m_Layout.at(x, quad[0]);
    sum += 0.5 * diagonal.cross(m_Layout.at(x, quad[3]) - m_Layout.at(x, quad[1])).norm();
  }
  return sum;
}

double
SurfaceAttraction::levelOfVolume(const Eigen::VectorXd & x, double volume, double enclosedVolume) const
{
  double  sum = 0.0;
  Vector3 unused;
  for (std::size_t spring = 0; spring < springCount(); ++spring)
  {
    sum += m_Phi(place(x, spring), unused) * m_InverseSlope[spring];
  }
  return sum / static_cast<double>(springCount()) + (volume - enclosedVolume) / area(x);
}

void
SurfaceAttraction::moveNodesToLevel(Eigen::VectorXd & x) const
{
  for (const std::size_t node : m_Nodes)
  {
    for (int step = 0; step < newtonSteps; ++step)
    {
      Vector3      gradient;
      const double value = m_Phi(m_Layout.at(x, node), gradient);
      const double squared = gradient.squaredNorm();
      const double excess = value - m_Level * std::sqrt(squared);
      m_Layout.add(x, node, -excess / std::max(squared, smallestSquaredSlope) * gradient);
    }
  }
}

std::vector<Vector3>
SurfaceAttraction::normals(const Eigen::VectorXd & x) const
{
  std::vector<Vector3> result;
  result.reserve(m_Nodes.size());
  for (const std::size_t node : m_Nodes)
  {
    Vector3 gradient;
    m_Phi(m_Layout.at(x, node), gradient);
    const double length = gradient.norm();
    result.push_back(length > 0.0 ? Vector3(gradient / length) : Vector3::Zero());
  }
  return result;
}

std::vector<double>
SurfaceAttraction::distances(const Eigen::VectorXd & x) const
{
  std::vector<double> result(springCount());
  parallelForBlocks(springCount(), springsPerBlock, m_Threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t spring = begin; spring < end; ++spring)
    {
      result[spring] = distanceToSurface(m_Phi, place(x, spring));
    }
  });
  return result;
}

double
SurfaceAttraction::largestDistance(const Eigen::VectorXd & x) const
{
  return largestOf(distances(x));
}

std::size_t
SurfaceAttraction::strengthen(const Eigen::VectorXd & x, double tolerance, double factor)
{
  return strengthenBeyond(tolerance, factor, distances(x), m_Weights);
}

} // namespace moserhex
