#include "moserhex/SphericalMap/SphereHierarchy.h"

#include "HalfEdgeCollapse.h"

#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Stopwatch.h"
#include "moserhex/DiscreteCalculus/TriangleOperators.h"
#include "moserhex/SphericalMap/AreaBarrier.h"
#include "moserhex/SphericalMap/SphereMapQuality.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace moserhex
{
namespace
{

// A narrow range: the triangles of a coarse level say little about the shape they stand for.
constexpr double smallestShapeWeight = 0.2;
constexpr double largestShapeWeight = 2.0;

/** The regular tetrahedron with the orientation of the four triangles that are left. */
void
placeTetrahedron(const std::vector<Triangle> & triangles, Positions & sphere)
{
  const Triangle & base = triangles[0];
  VertexIndex      apex = base[0];
  for (const VertexIndex v : triangles[1])
  {
    apex = v != base[0] && v != base[1] && v != base[2] ? v : apex;
  }
  const double z = -1.0 / 3.0;
  const double radius = std::sqrt(8.0) / 3.0;
  sphere[apex] = Vector3::UnitZ();
  for (int k = 0; k < 3; ++k)
  {
    const double angle = -2.0 * pi / 3.0 * k; // clockwise from above: counter-clockwise from outside, below
    sphere[base[k]] = Vector3(radius * std::cos(angle), radius * std::sin(angle), z);
  }
}

/** Smallest height of v over the sides of its ring, as seen from the centre of the sphere: positive in the kernel. */
double
clearance(const std::vector<VertexIndex> & ring, const Positions & sphere, const Vector3 & v)
{
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < ring.size(); ++k)
  {
    const Vector3 & a = sphere[ring[k]];
    const Vector3 & b = sphere[ring[(k + 1) % ring.size()]];
    smallest = std::min(smallest, v.dot(a.cross(b)) / (a - b).norm());
  }
  return smallest;
}

/** Unit tangent at ring[0] that halves the angle of the fan which replaced the vertex. */
Vector3
fanBisector(const std::vector<VertexIndex> & ring, const Positions & sphere)
{
  const Vector3 & u = sphere[ring[0]];
  const auto      direction = [&](std::size_t k) {
    const Vector3 & s = sphere[ring[k]];
    return Vector3(s - s.dot(u) * u);
  };
  double angle = 0.0;
  for (std::size_t k = 1; k + 1 < ring.size(); ++k)
  {
    const Vector3 a = direction(k);
    const Vector3 b = direction(k + 1);
    angle += std::atan2(a.cross(b).norm(), a.dot(b));
  }
  const Vector3 first = direction(1).normalized();
  return std::cos(0.5 * angle) * first + std::sin(0.5 * angle) * u.cross(first);
}

/** Puts the vertex back where it has most room. False when no place was found. */
bool
insertVertex(const CollapsedVertex & collapsed, Positions & sphere)
{
  const std::vector<VertexIndex> & ring = collapsed.ring;
  Vector3                          best = sphere[ring[0]];
  double                           bestClearance = 0.0;
  const auto                       consider = [&](const Vector3 & place) {
    const Vector3 unit = place.normalized();
    const double  room = clearance(ring, sphere, unit);
    if (room > bestClearance)
    {
      bestClearance = room;
      best = unit;
    }
  };
  const Vector3 bisector = fanBisector(ring, sphere);
  for (double distance = 1.0; distance > 1e-9; distance *= 0.6)
  {
    consider(sphere[ring[0]] + distance * bisector);
  }
  Vector3 middle = Vector3::Zero();
  for (const VertexIndex w : ring)
  {
    middle += sphere[w];
  }
  for (double blend = 1.0; blend > 0.05; blend *= 0.7)
  {
    consider((1.0 - blend) * best + blend * middle.normalized());
  }
  sphere[collapsed.vertex] = best;
  return bestClearance > 0.0;
}

/** Targets of a level: true areas, forced into [mean / c, c mean] with c growing with the level. A coarse
 * triangulation cannot follow unequal areas: its triangles would have to be as long as half a great circle. */
std::vector<double>
levelTargets(std::vector<double> areas, double coarsestContrast)
{
  constexpr double trianglesOfCoarsest = 20.0;
  const double     count = static_cast<double>(areas.size());
  const double     contrast = coarsestContrast * std::sqrt(count / trianglesOfCoarsest);
  double           mean = 0.0;
  for (const double area : areas)
  {
    mean += area / count;
  }
  for (double & area : areas)
  {
    area = std::min(std::max(area, mean / contrast), mean * contrast);
  }
  return targetSolidAngles(std::move(areas), 1e-3);
}

/** A few steps of AreaBarrier on one level. */
void
relaxLevel(const TriangleMesh &           surface,
           const CollapseLevel &          level,
           bool                           finest,
           const SphereHierarchyOptions & options,
           Positions &                    sphere)
{
  std::vector<VertexIndex> localNumber(surface.vertices.size(), -1);
  std::vector<VertexIndex> vertices;
  TriangleMesh             local;
  for (const Triangle & t : level.triangles)
  {
    Triangle renumbered{};
    for (int k = 0; k < 3; ++k)
    {
      if (localNumber[t[k]] < 0)
      {
        localNumber[t[k]] = static_cast<VertexIndex>(vertices.size());
        vertices.push_back(t[k]);
      }
      renumbered[k] = localNumber[t[k]];
    }
    local.triangles.push_back(renumbered);
  }
  Positions start;
  for (const VertexIndex v : vertices)
  {
    local.vertices.push_back(surface.vertices[v]);
    start.push_back(sphere[v]);
  }
  const TriangleTopology    topology = triangleTopology(local);
  const std::vector<double> weights = clampedCotanWeights(local, topology, smallestShapeWeight, largestShapeWeight);
  AreaBarrier        barrier(local.triangles, topology, levelTargets(level.areas, options.coarsestContrast), weights);
  AreaBarrierOptions relaxation;
  relaxation.shapeWeight = options.shapeWeight;
  relaxation.stopAtRms = options.relaxToRms;
  relaxation.maximumSteps = finest ? 1 : options.stepsPerLevel;
  const AreaBarrierResult relaxed = barrier.minimise(start, relaxation);
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    sphere[vertices[i]] = relaxed.positions[i];
  }
}

} // namespace

SphereHierarchyResult
sphereMapByHierarchy(const TriangleMesh &           surface,
                     const SphereHierarchyOptions & options,
                     const ProgressCallback &       progress)
{
  const Stopwatch watch;
  requireSphere(surface, "hierarchy map");
  const CollapseSequence sequence = collapseToTetrahedron(surface, targetSolidAngles(surface));
  SphereHierarchyResult  result;
  result.positions.assign(surface.vertices.size(), Vector3::UnitZ());
  result.report.steps = static_cast<int>(sequence.vertices.size());
  result.report.note = "hierarchy";
  placeTetrahedron(sequence.last, result.positions);

  std::size_t present = sequence.vertices.size();
  for (std::size_t level = sequence.levels.size(); level-- > 0;)
  {
    reportProgress(progress, 1.0 / static_cast<double>(level + 1));
    for (; present > sequence.levels[level].collapsed; --present)
    {
      const CollapsedVertex & collapsed = sequence.vertices[present - 1];
      if (!insertVertex(collapsed, result.positions))
      {
        std::ostringstream message;
        message << "hierarchy map: no room for vertex " << collapsed.vertex << " of " << surface.vertices.size();
        throw NotConverged(message.str(), result.report);
      }
    }
    relaxLevel(surface, sequence.levels[level], level == 0, options, result.positions);
  }
  result.report.residual = countFlippedTriangles(surface.triangles, result.positions);
  result.report.converged = result.report.residual == 0.0;
  result.report.seconds = watch.seconds();
  if (!result.report.converged)
  {
    std::ostringstream message;
    message << "hierarchy map: " << result.report.residual << " flipped triangles, need 0";
    throw NotConverged(message.str(), result.report);
  }
  return result;
}

} // namespace moserhex
