#include "moserhex/SphericalMap/SphereLocator.h"

#include "moserhex/Common/Errors.h"
#include "moserhex/Geometry/TriangleTopology.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <sstream>

namespace moserhex
{
namespace
{

double
determinant(const Vector3 & a, const Vector3 & b, const Vector3 & c)
{
  return a.dot(b.cross(c));
}

void
requireFinite(const Positions & sphere)
{
  for (std::size_t v = 0; v < sphere.size(); ++v)
  {
    if (!sphere[v].allFinite())
    {
      std::ostringstream message;
      message << "position of vertex " << v << " is not finite";
      throw InvalidInput(message.str());
    }
  }
}

Vector3
unitDirection(const Vector3 & direction)
{
  const double length = direction.norm();
  if (!(length > 0.0) || !std::isfinite(length))
  {
    throw InvalidInput("direction is zero or not finite");
  }
  return direction / length;
}

} // namespace

SphereLocator::SphereLocator(const std::vector<Triangle> & triangles, const Positions & sphere)
  : m_Triangles(triangles), m_Sphere(sphere)
{
  requireFinite(sphere);
  if (triangles.empty())
  {
    throw InvalidInput("sphere locator: no triangles");
  }
  m_Neighbours = triangleTopology({ sphere, triangles }).neighbours;
  // About four triangles a cell: a smaller table costs steps, a larger one memory.
  m_CellsPerSide = std::max(2, static_cast<int>(std::sqrt(static_cast<double>(triangles.size()) / 24.0)));
  m_FirstTriangle.assign(static_cast<std::size_t>(6) * m_CellsPerSide * m_CellsPerSide, -1);
  for (std::size_t f = 0; f < triangles.size(); ++f)
  {
    const Triangle & t = triangles[f];
    m_FirstTriangle[cell(sphere[t[0]] + sphere[t[1]] + sphere[t[2]])] = static_cast<int>(f);
  }
  int last = 0;
  for (int & first : m_FirstTriangle)
  {
    first = first < 0 ? last : first;
    last = first;
  }
}

int
SphereLocator::cell(const Vector3 & direction) const
{
  int          axis = 0;
  const double largest = std::max(direction.cwiseAbs().maxCoeff(&axis), std::numeric_limits<double>::min());
  const auto   step = [&](double coordinate) {
    const int i = static_cast<int>((coordinate / largest + 1.0) * 0.5 * m_CellsPerSide);
    return std::min(std::max(i, 0), m_CellsPerSide - 1);
  };
  const int side = axis * 2 + (direction[axis] < 0.0 ? 1 : 0);
  return (side * m_CellsPerSide + step(direction[(axis + 1) % 3])) * m_CellsPerSide + step(direction[(axis + 2) % 3]);
}

int
SphereLocator::walk(const Vector3 & direction, int triangle) const
{
  // A side separates only by more than round-off, so that a direction on a side belongs to both triangles there.
  constexpr double roundOff = 1e-15;
  std::uint32_t    sequence = 0;
  for (std::size_t step = 0; step < m_Triangles.size(); ++step)
  {
    const Triangle & t = m_Triangles[triangle];
    sequence = sequence * 1664525u + 1013904223u;
    const int first = static_cast<int>((sequence >> 16) % 3u);
    int       across = -1;
    for (int q = 0; q < 3 && across < 0; ++q)
    {
      const int k = (q + first) % 3;
      if (determinant(m_Sphere[t[k]], m_Sphere[t[(k + 1) % 3]], direction) < -roundOff)
      {
        across = m_Neighbours[triangle][k];
      }
    }
    if (across < 0)
    {
      // All three signs agree on the far side of the sphere too.
      if (direction.dot(m_Sphere[t[0]] + m_Sphere[t[1]] + m_Sphere[t[2]]) > 0.0)
      {
        return triangle;
      }
      across = m_Neighbours[triangle][first];
    }
    triangle = across;
  }
  return -1;
}

int
SphereLocator::scan(const Vector3 & direction) const
{
  double best = -std::numeric_limits<double>::infinity();
  int    found = 0;
  for (std::size_t f = 0; f < m_Triangles.size(); ++f)
  {
    const Vector3 & a = m_Sphere[m_Triangles[f][0]];
    const Vector3 & b = m_Sphere[m_Triangles[f][1]];
    const Vector3 & c = m_Sphere[m_Triangles[f][2]];
    if (!(direction.dot(a + b + c) > 0.0))
    {
      continue;
    }
    const double inside =
      std::min({ determinant(a, b, direction), determinant(b, c, direction), determinant(c, a, direction) });
    if (inside > best)
    {
      best = inside;
      found = static_cast<int>(f);
    }
  }
  return found;
}

Vector3
SphereLocator::barycentricIn(const Vector3 & direction, int triangle) const
{
  const Vector3 & a = m_Sphere[m_Triangles[triangle][0]];
  const Vector3 & b = m_Sphere[m_Triangles[triangle][1]];
  const Vector3 & c = m_Sphere[m_Triangles[triangle][2]];
  const Vector3   weights =
    Vector3(determinant(direction, b, c), determinant(a, direction, c), determinant(a, b, direction)).cwiseMax(0.0);
  const double sum = weights.sum();
  return sum > 0.0 ? Vector3(weights / sum) : Vector3(Vector3::Constant(1.0 / 3.0));
}

SphereLocator::Hit
SphereLocator::locate(const Vector3 & direction) const
{
  const Vector3 unit = unitDirection(direction);
  return locateFrom(unit, m_FirstTriangle[cell(unit)]);
}

SphereLocator::Hit
SphereLocator::locateFrom(const Vector3 & direction, int startTriangle) const
{
  if (startTriangle < 0 || static_cast<std::size_t>(startTriangle) >= m_Triangles.size())
  {
    std::ostringstream message;
    message << "start triangle " << startTriangle << ", need 0 to " << m_Triangles.size() - 1;
    throw InvalidInput(message.str());
  }
  const Vector3 unit = unitDirection(direction);
  Hit           hit;
  hit.triangle = walk(unit, startTriangle);
  if (hit.triangle < 0)
  {
    hit.triangle = scan(unit);
  }
  hit.barycentric = barycentricIn(unit, hit.triangle);
  return hit;
}

} // namespace moserhex
