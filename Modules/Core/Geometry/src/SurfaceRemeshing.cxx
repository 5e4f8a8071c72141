#include "moserhex/Geometry/SurfaceRemeshing.h"

#include "EditableTriangulation.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Stopwatch.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

namespace moserhex
{
namespace
{

/** A collapse may turn a triangle by at most acos of this, a flip by acos of the second. */
constexpr double collapseNormalCosine = 0.3;
constexpr double flipNormalCosine = 0.2;
/** A collapse must not make a side longer than this times L, or the next round splits it again. */
constexpr double longestAfterCollapse = 1.5;
/** Cotangent sums above minus this count as Delaunay. */
constexpr double delaunayTolerance = 1e-9;
/** The first rounds spread the vertices of an uneven input, so they move further. */
constexpr double firstRelaxation = 0.9;
constexpr double laterRelaxation = 0.7;
/** Flips per side and pass after which the search for a Delaunay triangulation gives up (it may cycle in space). */
constexpr int flipsPerSide = 8;

Vector3
areaVector(const Vector3 & a, const Vector3 & b, const Vector3 & c)
{
  return (b - a).cross(c - a);
}

/** cot of the angle at p in the triangle p a b. */
double
cotangent(const Vector3 & p, const Vector3 & a, const Vector3 & b)
{
  return (a - p).dot(b - p) / std::max(1e-300, areaVector(p, a, b).norm());
}

bool
directionsAgree(const Vector3 & before, const Vector3 & after, double cosine)
{
  const double dot = before.dot(after);
  return dot > 0.0 && dot * dot > cosine * cosine * before.squaredNorm() * after.squaredNorm();
}

class Remesher
{
public:
  Remesher(const TriangleMesh & surface, const SurfaceRemeshingOptions & options, const PointProjection & project)
    : m_Surface(surface), m_Options(options), m_Project(project)
  {}

  SurfaceRemeshingResult
  run()
  {
    const Stopwatch        watch;
    SurfaceRemeshingResult result;
    for (int round = 0; round < m_Options.sizingRounds; ++round)
    {
      result.splits += splitLongSides();
      result.collapses += collapseShortSides();
      result.flips += flipToDelaunay();
      relax(round < 2 ? firstRelaxation : laterRelaxation);
    }
    for (int round = 0; round < m_Options.smoothingRounds; ++round)
    {
      result.flips += flipToDelaunay();
      relax(m_Options.relaxation);
    }
    result.flips += flipToDelaunay();
    result.mesh = m_Surface.mesh();
    const std::size_t left = countSidesToFlip();
    result.report.converged = left == 0;
    result.report.steps = m_Options.sizingRounds + m_Options.smoothingRounds;
    result.report.residual = static_cast<double>(left);
    result.report.seconds = watch.seconds();
    return result;
  }

private:
  [[nodiscard]] const Vector3 &
  at(VertexIndex v) const
  {
    return m_Surface.vertices[v];
  }
  [[nodiscard]] double
  squaredLength(int e) const
  {
    return (at(m_Surface.origin(e)) - at(m_Surface.target(e))).squaredNorm();
  }
  [[nodiscard]] Vector3
  normalOfTriangle(int e) const
  {
    return areaVector(at(m_Surface.origin(e)), at(m_Surface.target(e)), at(m_Surface.apex(e)));
  }

  std::size_t
  splitLongSides()
  {
    const double longest = m_Options.splitRatio * m_Options.targetEdgeLength;
    const int    count = m_Surface.halfEdgeCount();
    std::size_t  splits = 0;
    for (int e = 0; e < count; ++e)
    {
      if (m_Surface.halfEdgeIsAlive(e) && e < m_Surface.twin(e) && squaredLength(e) > longest * longest)
      {
        m_Surface.split(e, 0.5 * (at(m_Surface.origin(e)) + at(m_Surface.target(e))));
        ++splits;
      }
    }
    return splits;
  }

  std::size_t
  collapseShortSides()
  {
    const double                        shortest = m_Options.collapseRatio * m_Options.targetEdgeLength;
    std::vector<std::pair<double, int>> candidates;
    for (int e = 0; e < m_Surface.halfEdgeCount(); ++e)
    {
      if (m_Surface.halfEdgeIsAlive(e) && e < m_Surface.twin(e) && squaredLength(e) < shortest * shortest)
      {
        candidates.emplace_back(squaredLength(e), e);
      }
    }
    std::sort(candidates.begin(), candidates.end());
    std::size_t collapses = 0;
    for (const auto & candidate : candidates)
    {
      const int e = candidate.second;
      if (m_Surface.halfEdgeIsAlive(e) && squaredLength(e) < shortest * shortest && m_Surface.collapseKeepsTopology(e))
      {
        const Vector3 middle = 0.5 * (at(m_Surface.origin(e)) + at(m_Surface.target(e)));
        if (collapseKeepsShape(e, middle))
        {
          m_Surface.vertices[m_Surface.origin(e)] = middle;
          m_Surface.collapse(e);
          ++collapses;
        }
      }
    }
    return collapses;
  }

  /** No side around the merged vertex becomes too long and no triangle turns over. */
  [[nodiscard]] bool
  collapseKeepsShape(int e, const Vector3 & middle) const
  {
    const double longest = longestAfterCollapse * m_Options.targetEdgeLength;
    const int    f = m_Surface.twin(e);
    bool         keeps = true;
    for (const int start : { e, f })
    {
      m_Surface.forEachOutgoing(m_Surface.origin(start), [&](int q) {
        if (!keeps || q / 3 == e / 3 || q / 3 == f / 3)
        {
          return;
        }
        const Vector3 & p = at(m_Surface.target(q));
        keeps =
          (p - middle).squaredNorm() <= longest * longest &&
          directionsAgree(normalOfTriangle(q), areaVector(middle, p, at(m_Surface.apex(q))), collapseNormalCosine);
      });
    }
    return keeps;
  }

  [[nodiscard]] bool
  wantsFlip(int e) const
  {
    const Vector3 & a = at(m_Surface.origin(e));
    const Vector3 & b = at(m_Surface.target(e));
    return cotangent(at(m_Surface.apex(e)), a, b) + cotangent(at(m_Surface.apex(m_Surface.twin(e))), a, b) <
           -delaunayTolerance;
  }

  [[nodiscard]] bool
  mayFlip(int e) const
  {
    const int         f = m_Surface.twin(e);
    const VertexIndex a = m_Surface.origin(e);
    const VertexIndex b = m_Surface.target(e);
    const VertexIndex c = m_Surface.apex(e);
    const VertexIndex d = m_Surface.apex(f);
    if (c == d || m_Surface.valence(a) <= 3 || m_Surface.valence(b) <= 3 || m_Surface.areNeighbours(c, d))
    {
      return false;
    }
    const Vector3 before = normalOfTriangle(e) + normalOfTriangle(f);
    return directionsAgree(before, areaVector(at(c), at(a), at(d)), flipNormalCosine) &&
           directionsAgree(before, areaVector(at(d), at(b), at(c)), flipNormalCosine);
  }

  std::size_t
  flipToDelaunay()
  {
    std::vector<int>  pending;
    std::vector<char> queued(m_Surface.halfEdgeCount(), 0);
    const auto        push = [&](int e) {
      const int representative = std::min(e, m_Surface.twin(e));
      if (!queued[representative])
      {
        queued[representative] = 1;
        pending.push_back(representative);
      }
    };
    for (int e = m_Surface.halfEdgeCount(); e-- > 0;)
    {
      if (m_Surface.halfEdgeIsAlive(e))
      {
        push(e);
      }
    }
    const std::size_t limit = flipsPerSide * pending.size();
    std::size_t       flips = 0;
    while (!pending.empty() && flips < limit)
    {
      const int e = pending.back();
      pending.pop_back();
      queued[e] = 0;
      if (wantsFlip(e) && mayFlip(e))
      {
        m_Surface.flip(e);
        ++flips;
        const int f = m_Surface.twin(e);
        for (const int q : { m_Surface.next(e), m_Surface.previous(e), m_Surface.next(f), m_Surface.previous(f) })
        {
          push(q);
        }
      }
    }
    return flips;
  }

  [[nodiscard]] std::size_t
  countSidesToFlip() const
  {
    std::size_t count = 0;
    for (int e = 0; e < m_Surface.halfEdgeCount(); ++e)
    {
      count += m_Surface.halfEdgeIsAlive(e) && e < m_Surface.twin(e) && wantsFlip(e) ? 1 : 0;
    }
    return count;
  }

  /** Moves all vertices at once: in the tangent plane towards the area-weighted centroid of the triangles around. */
  void
  relax(double step)
  {
    const std::size_t   count = m_Surface.vertices.size();
    Positions           normals(count, Vector3::Zero());
    Positions           moments(count, Vector3::Zero());
    std::vector<double> weights(count, 0.0);
    for (std::size_t t = 0; t < m_Surface.triangles().size(); ++t)
    {
      if (!m_Surface.triangleIsAlive(t))
      {
        continue;
      }
      const Triangle & corners = m_Surface.triangles()[t];
      const Vector3    normal = areaVector(at(corners[0]), at(corners[1]), at(corners[2]));
      const double     weight = normal.norm();
      const Vector3    moment = weight / 3 * (at(corners[0]) + at(corners[1]) + at(corners[2]));
      for (const VertexIndex v : corners)
      {
        normals[v] += normal;
        moments[v] += moment;
        weights[v] += weight;
      }
    }
    for (std::size_t v = 0; v < count; ++v)
    {
      if (!m_Surface.vertexIsAlive(static_cast<VertexIndex>(v)) || !(weights[v] > 0.0))
      {
        continue;
      }
      const Vector3 normal = normals[v].normalized();
      const Vector3 move = step * (moments[v] / weights[v] - m_Surface.vertices[v]);
      const Vector3 moved = m_Surface.vertices[v] + move - normal.dot(move) * normal;
      m_Surface.vertices[v] = m_Project ? m_Project(moved) : moved;
    }
  }

  EditableTriangulation           m_Surface;
  const SurfaceRemeshingOptions & m_Options;
  const PointProjection &         m_Project;
};

void
requireValid(const SurfaceRemeshingOptions & options)
{
  const auto refuse = [](const char * what, double value, const char * range) {
    std::ostringstream message;
    message << "surface remeshing: " << what << " = " << value << ", need " << range;
    throw InvalidInput(message.str());
  };
  if (options.sizingRounds < 0)
  {
    refuse("sizingRounds", options.sizingRounds, ">= 0");
  }
  if (options.smoothingRounds < 0)
  {
    refuse("smoothingRounds", options.smoothingRounds, ">= 0");
  }
  if (options.sizingRounds > 0 && !(options.targetEdgeLength > 0.0))
  {
    refuse("targetEdgeLength", options.targetEdgeLength, "> 0 mm");
  }
  if (!(options.collapseRatio > 0.0 && options.collapseRatio < 1.0))
  {
    refuse("collapseRatio", options.collapseRatio, "in (0,1)");
  }
  if (!(options.splitRatio > 1.0))
  {
    refuse("splitRatio", options.splitRatio, "> 1");
  }
  if (!(options.relaxation > 0.0 && options.relaxation <= 1.0))
  {
    refuse("relaxation", options.relaxation, "in (0,1]");
  }
}

double
angleInDegrees(const Vector3 & a, const Vector3 & b)
{
  constexpr double degreesPerRadian = 57.295779513082320877;
  return degreesPerRadian * std::atan2(a.cross(b).norm(), a.dot(b));
}

} // namespace

SurfaceRemeshingResult
remeshSurface(const TriangleMesh & surface, const SurfaceRemeshingOptions & options, const PointProjection & project)
{
  requireValid(options);
  return Remesher(surface, options, project).run();
}

SurfaceQualitySummary
summarizeSurfaceQuality(const TriangleMesh & surface)
{
  const EditableTriangulation connected(surface);
  SurfaceQualitySummary       summary;
  if (surface.triangles.empty())
  {
    return summary;
  }
  const auto at = [&](VertexIndex v) -> const Vector3 & { return surface.vertices[v]; };
  summary.minimumAngle = 180.0;
  double smallest = std::numeric_limits<double>::infinity();
  double total = 0.0;
  for (const Triangle & t : surface.triangles)
  {
    const double area = triangleArea(at(t[0]), at(t[1]), at(t[2]));
    total += area;
    smallest = std::min(smallest, area);
    summary.largestArea = std::max(summary.largestArea, area);
    for (int k = 0; k < 3; ++k)
    {
      const Vector3 & p = at(t[k]);
      summary.minimumAngle =
        std::min(summary.minimumAngle, angleInDegrees(at(t[(k + 1) % 3]) - p, at(t[(k + 2) % 3]) - p));
    }
  }
  const double mean = total / static_cast<double>(surface.triangles.size());
  summary.smallestArea = smallest / mean;
  summary.largestArea /= mean;
  for (int e = 0; e < connected.halfEdgeCount(); ++e)
  {
    const int f = connected.twin(e);
    if (e > f)
    {
      continue;
    }
    const Vector3 & a = at(connected.origin(e));
    const Vector3 & b = at(connected.target(e));
    const Vector3 & c = at(connected.apex(e));
    const Vector3 & d = at(connected.apex(f));
    summary.negativeCotangents += cotangent(c, a, b) + cotangent(d, a, b) < -delaunayTolerance ? 1 : 0;
    summary.largestCrease = std::max(summary.largestCrease, angleInDegrees(areaVector(a, b, c), areaVector(b, a, d)));
  }
  return summary;
}

} // namespace moserhex
