#include "EdgeSliding.h"

#include "HarmonicExtension.h"
#include "LatticeNodes.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace moserhex
{
namespace
{
using lattice::Index3;

/** Rounds of (1/4, 1/2, 1/4) averaging of the motion along an edge. */
constexpr int averagingRounds = 4;
/** Motion in a hollow (negative curvature) exceeds that on a flat place by at most this factor. */
constexpr double largestActivation = 1.5;

/** One of the 12 edges of the cube and the rows of boundary nodes that cross it. */
struct CubeEdge
{
  int axis; ///< direction of the edge
  int firstLevel;
  int secondLevel; ///< the constant indices along axes axis+1 and axis+2

  /** Node in row i (along the edge), `across` nodes from the edge: positive on the face where index axis+1 varies,
   * negative on the other. */
  [[nodiscard]] Index3
  at(int i, int across) const
  {
    const auto a = static_cast<std::size_t>(axis);
    Index3     index{};
    index[a] = i;
    index[(a + 1) % 3] = firstLevel + (across > 0 ? inward(firstLevel) * across : 0);
    index[(a + 2) % 3] = secondLevel + (across < 0 ? -inward(secondLevel) * across : 0);
    return index;
  }

private:
  static int
  inward(int level)
  {
    return level == 0 ? 1 : -1;
  }
};

std::vector<CubeEdge>
cubeEdges(int nodesPerSide)
{
  std::vector<CubeEdge> edges;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const int second : { 0, nodesPerSide - 1 })
    {
      for (const int first : { 0, nodesPerSide - 1 })
      {
        edges.push_back({ axis, first, second });
      }
    }
  }
  return edges;
}

/** Outward unit normals of the boundary nodes, area-weighted over the incident quadrilaterals; zero elsewhere. */
Positions
boundaryNormals(const HexMesh & mesh)
{
  const int n = mesh.nodesPerSide;
  Positions normals(mesh.nodes.size(), Vector3::Zero());
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    for (const int level : { 0, n - 1 })
    {
      const auto node = [&](int a, int b) {
        Index3 at{};
        at[axis] = level;
        at[(axis + 1) % 3] = a;
        at[(axis + 2) % 3] = b;
        return lattice::number(mesh, at);
      };
      const double outward = level == 0 ? -1.0 : 1.0;
      for (int b = 0; b + 1 < n; ++b)
      {
        for (int a = 0; a + 1 < n; ++a)
        {
          const std::array<std::size_t, 4> quad{ node(a, b), node(a + 1, b), node(a + 1, b + 1), node(a, b + 1) };
          const Vector3                    diagonal = mesh.nodes[quad[2]] - mesh.nodes[quad[0]];
          const Vector3                    area = outward * diagonal.cross(mesh.nodes[quad[3]] - mesh.nodes[quad[1]]);
          for (const std::size_t corner : quad)
          {
            normals[corner] += area;
          }
        }
      }
    }
  }
  for (Vector3 & normal : normals)
  {
    const double length = normal.norm();
    normal = length > 0.0 ? Vector3(normal / length) : Vector3::Zero();
  }
  return normals;
}

/** Cube root of the mean cell volume of the solid that the boundary encloses. */
double
meanCellSize(const HexMesh & mesh)
{
  double sum = 0.0;
  for (const double volume : cellVolumes(mesh))
  {
    sum += volume;
  }
  return std::cbrt(std::max(sum, 0.0) / static_cast<double>(mesh.cellCount()));
}

/** Motion of every node of an edge across it, positive towards `across` > 0 [mean cell sizes]. */
std::vector<double>
motionAcross(const HexMesh &            mesh,
             const Positions &          normals,
             const CubeEdge &           edge,
             double                     size,
             const EdgeSlidingOptions & options)
{
  const int  n = mesh.nodesPerSide;
  const int  window = std::min(options.window, (n - 1) / 2);
  const auto curvature = [&](int i, int across) {
    const std::size_t from = lattice::number(mesh, edge.at(i, across));
    const std::size_t to = lattice::number(mesh, edge.at(i, across + 1));
    const Vector3     step = mesh.nodes[to] - mesh.nodes[from];
    const double      squaredLength = std::max(step.squaredNorm(), 0.01 * size * size);
    return size * (normals[to] - normals[from]).dot(step) / squaredLength;
  };

  std::vector<double> motion(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i)
  {
    double forward = 0.0;
    double backward = 0.0;
    double weights = 0.0;
    for (int o = 0; o < window; ++o)
    {
      const double weight = 1.0 - static_cast<double>(o) / window;
      forward += weight * curvature(i, o);
      backward += weight * curvature(i, -o - 1);
      weights += weight;
    }
    const double here = 0.5 * (curvature(i, 0) + curvature(i, -1));
    const double lacking = (options.sufficientCurvature - here) / options.sufficientCurvature;
    motion[static_cast<std::size_t>(i)] = std::clamp(lacking, 0.0, largestActivation) * options.step *
                                          std::tanh(options.gain * (forward - backward) / weights);
  }

  for (int round = 0; round < averagingRounds; ++round)
  {
    const std::vector<double> before = motion;
    for (std::size_t i = 0; i < motion.size(); ++i)
    {
      const double previous = before[i > 0 ? i - 1 : 0];
      const double next = before[std::min(i + 1, motion.size() - 1)];
      motion[i] = 0.5 * before[i] + 0.25 * (previous + next);
    }
  }
  return motion;
}

/** Unit tangent of the surface across an edge, perpendicular to the edge; zero where it does not exist. */
Vector3
directionAcross(const HexMesh & mesh, const CubeEdge & edge, int i)
{
  const auto    position = [&](int row, int across) { return mesh.nodes[lattice::number(mesh, edge.at(row, across))]; };
  const int     last = mesh.nodesPerSide - 1;
  const Vector3 along = (position(std::min(i + 1, last), 0) - position(std::max(i - 1, 0), 0)).normalized();
  const Vector3 across = position(i, 1) - position(i, -1);
  const Vector3 tangent = across - across.dot(along) * along;
  const double  length = tangent.norm();
  return length > 0.0 ? Vector3(tangent / length) : Vector3::Zero();
}
} // namespace

void
slideCubeEdgesInPlace(HexMesh & mesh, const SurfaceProjection & projection, const EdgeSlidingOptions & options)
{
  const int    n = mesh.nodesPerSide;
  const double size = meanCellSize(mesh);
  if (n < 4 || !(size > 0.0))
  {
    return;
  }
  const Positions normals = boundaryNormals(mesh);
  HexMesh         displacement{ n, Positions(mesh.nodes.size(), Vector3::Zero()) };
  for (const CubeEdge & edge : cubeEdges(n))
  {
    const std::vector<double> motion = motionAcross(mesh, normals, edge, size, options);
    for (int i = 0; i < n; ++i)
    {
      // A corner belongs to three edges and takes half the sum: each edge asks for a motion in its own direction.
      const double share = lattice::isExtreme(n, i) ? 0.5 : 1.0;
      displacement.nodes[lattice::number(mesh, edge.at(i, 0))] +=
        share * motion[static_cast<std::size_t>(i)] * size * directionAcross(mesh, edge, i);
    }
  }
  extendOverFacesInPlace(displacement);
  diffuseInteriorInPlace(displacement, std::numeric_limits<double>::infinity());

  lattice::forEachNode(n, [&](const Index3 & at, std::size_t node) {
    const Vector3 moved = mesh.nodes[node] + displacement.nodes[node];
    mesh.nodes[node] = lattice::isBoundary(n, at) ? projection(moved) : moved;
  });
}

} // namespace moserhex
