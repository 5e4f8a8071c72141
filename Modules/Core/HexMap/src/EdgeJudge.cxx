#include "EdgeJudge.h"

#include "moserhex/StructuredGrid/CubeLattice.h"
#include "moserhex/StructuredGrid/CubeToSphere.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace moserhex
{
namespace
{

using CellCorner = EdgeJudge::CellCorner;

/** Part of the way from a flat triangle to its corners' tangent planes (Phong tessellation; Boubekeur and Alexa, 2008):
 * without it the kinks of the triangulation would decide. */
constexpr double tessellation = 0.75;

/** The nodes on the cube's edges and next to them, and the cell corners that they make. */
class EdgeNodes
{
public:
  explicit EdgeNodes(int nodesPerSide) : m_Lattice(nodesPerSide / 2), m_Last(nodesPerSide - 1)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      for (const int first : { 0, m_Last })
      {
        for (const int second : { 0, m_Last })
        {
          addEdge(axis, first, second);
        }
      }
    }
  }

  /** On the sphere, in the lattice's frame. */
  [[nodiscard]] const Positions &
  directions() const
  {
    return m_Directions;
  }

  /** Entries of directions(). */
  [[nodiscard]] const std::vector<CellCorner> &
  corners() const
  {
    return m_Corners;
  }

private:
  using Index3 = std::array<int, 3>;

  /** The edge along `axis` with the constant indices `first` and `second` along the next two axes. */
  void
  addEdge(std::size_t axis, int first, int second)
  {
    Index3 at{};
    Index3 steps{};
    at[(axis + 1) % 3] = first;
    at[(axis + 2) % 3] = second;
    steps[(axis + 1) % 3] = first == 0 ? 1 : -1;
    steps[(axis + 2) % 3] = second == 0 ? 1 : -1;
    for (int i = 0; i < m_Last; ++i) // both ends of every side
    {
      at[axis] = i;
      steps[axis] = 1;
      addCorner(at, steps);
      at[axis] = i + 1;
      steps[axis] = -1;
      addCorner(at, steps);
    }
  }

  void
  addCorner(const Index3 & at, const Index3 & steps)
  {
    CellCorner corner{ { entry(at), 0, 0, 0 } };
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      Index3 neighbour = at;
      neighbour[axis] += steps[axis];
      corner[axis + 1] = entry(neighbour);
    }
    if (steps[0] * steps[1] * steps[2] < 0)
    {
      std::swap(corner[2], corner[3]);
    }
    m_Corners.push_back(corner);
  }

  std::size_t
  entry(const Index3 & at)
  {
    const std::size_t node = m_Lattice.nodeNumber(at[0], at[1], at[2]);
    const auto        found = m_Entries.emplace(node, m_Directions.size());
    if (found.second)
    {
      m_Directions.push_back(cubeToSphere(m_Lattice.positionOnShell(node)));
    }
    return found.first->second;
  }

  CubeLattice                        m_Lattice;
  int                                m_Last;
  std::map<std::size_t, std::size_t> m_Entries;
  Positions                          m_Directions;
  std::vector<CellCorner>            m_Corners;
};

/** Worst where two nodes coincide. */
double
scaledJacobian(const Positions & points, const CellCorner & corner)
{
  const Vector3 a = points[corner[1]] - points[corner[0]];
  const Vector3 b = points[corner[2]] - points[corner[0]];
  const Vector3 c = points[corner[3]] - points[corner[0]];
  const double  lengths = a.norm() * b.norm() * c.norm();
  return lengths > 0.0 ? a.dot(b.cross(c)) / lengths : -1.0;
}

} // namespace

EdgeJudge::EdgeJudge(const TriangleMesh & surface, const Positions & sphereMap, const FramePlacementOptions & options)
  : m_Surface(surface)
  , m_Normals(vertexNormals(surface))
  , m_Locator(surface.triangles, sphereMap)
  , m_Sharpness(options.sharpness)
{
  const EdgeNodes nodes(options.nodesPerSide);
  m_Directions = nodes.directions();
  m_Corners = nodes.corners();
  for (const Vector3 & direction : m_Directions)
  {
    m_Start.push_back(m_Locator.locate(direction).triangle);
  }
}

EdgeScore
EdgeJudge::judge(const FramePlacement & placement) const
{
  Positions points(m_Directions.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    points[i] = pointOn(m_Locator.locateFrom(unplaced(m_Directions[i], placement), m_Start[i]));
  }
  EdgeScore result{ 0.0, std::numeric_limits<double>::infinity() };
  for (const CellCorner & corner : m_Corners)
  {
    const double quality = scaledJacobian(points, corner);
    result.score += std::exp(-m_Sharpness * quality) / static_cast<double>(m_Corners.size());
    result.smallestScaledJacobian = std::min(result.smallestScaledJacobian, quality);
  }
  return result;
}

Vector3
EdgeJudge::pointOn(const SphereLocator::Hit & hit) const
{
  const Triangle & triangle = m_Surface.triangles[static_cast<std::size_t>(hit.triangle)];
  Vector3          flat = Vector3::Zero();
  for (Eigen::Index c = 0; c < 3; ++c)
  {
    flat += hit.barycentric[c] * m_Surface.vertices[static_cast<std::size_t>(triangle[static_cast<std::size_t>(c)])];
  }
  Vector3 point = flat;
  for (Eigen::Index c = 0; c < 3; ++c)
  {
    const auto      v = static_cast<std::size_t>(triangle[static_cast<std::size_t>(c)]);
    const Vector3 & normal = m_Normals[v];
    point -= tessellation * hit.barycentric[c] * (flat - m_Surface.vertices[v]).dot(normal) * normal;
  }
  return point;
}

} // namespace moserhex
