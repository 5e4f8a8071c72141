#include "moserhex/HexMap/FramePlacement.h"

#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Parallel.h"
#include "moserhex/Common/Stopwatch.h"
#include "moserhex/SphericalMap/FrameAlignment.h"
#include "moserhex/SphericalMap/MoebiusCentring.h"
#include "moserhex/SphericalMap/SphereLocator.h"
#include "moserhex/StructuredGrid/CubeLattice.h"
#include "moserhex/StructuredGrid/CubeToSphere.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>
#include <string>

namespace moserhex
{
namespace
{

constexpr double degree = 0.017453292519943295;

/** Part of the way from a flat triangle to its corners' tangent planes (Phong tessellation; Boubekeur and Alexa, 2008):
 * without it the kinks of the triangulation would decide. */
constexpr double tessellation = 0.75;

/** Rotation vector and boost, each divided by its bound: both lie in the unit ball. */
using Coordinates = Eigen::Matrix<double, 6, 1>;

void
require(bool holds, const std::string & quantity, double value, const std::string & range)
{
  if (!holds)
  {
    std::ostringstream message;
    message << quantity << " is " << value << ", need " << range;
    throw InvalidInput(message.str());
  }
}

void
requireOptions(const FramePlacementOptions & o)
{
  require(o.nodesPerSide >= 4 && o.nodesPerSide <= 1000 && o.nodesPerSide % 2 == 0,
          "nodesPerSide",
          o.nodesPerSide,
          "an even number from 4 to 1000");
  require(o.maximumAngle >= 0.0 && o.maximumAngle <= 180.0, "maximumAngle", o.maximumAngle, "0 to 180 degrees");
  require(o.maximumBoost >= 0.0 && o.maximumBoost < 0.5, "maximumBoost", o.maximumBoost, "0 <= boost < 0.5");
  require(o.sharpness > 0.0 && o.sharpness <= 100.0, "sharpness", o.sharpness, "above 0, at most 100");
  require(o.anchor >= 0.0 && std::isfinite(o.anchor), "anchor", o.anchor, "a finite number >= 0");
  require(o.firstStep > 0.0 && o.firstStep <= 1.0, "firstStep", o.firstStep, "above 0, at most 1");
  require(o.smallestStep > 0.0 && o.smallestStep <= o.firstStep, "smallestStep", o.smallestStep, "0 to firstStep");
  require(o.maximumRounds >= 1, "maximumRounds", o.maximumRounds, "at least 1");
}

FramePlacement
placementAt(const Coordinates & x, const FramePlacementOptions & options)
{
  const Vector3  turn = options.maximumAngle * degree * x.head<3>();
  const double   angle = turn.norm();
  FramePlacement placement;
  if (angle > 0.0)
  {
    placement.rotation = Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix();
  }
  placement.boost = options.maximumBoost * x.tail<3>();
  return placement;
}

/** Both parts back into the unit ball, so that the search slides along the bounds. */
Coordinates
withinBounds(Coordinates x)
{
  x.head<3>() /= std::max(1.0, x.head<3>().norm());
  x.tail<3>() /= std::max(1.0, x.tail<3>().norm());
  return x;
}

/** Four nodes of a cell's corner on an edge of the cube: the corner itself and its neighbours, right-handed. */
using CellCorner = std::array<std::size_t, 4>;

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

/** Places the edge nodes on the surface and scores them. */
class EdgeJudge
{
public:
  EdgeJudge(const TriangleMesh & surface, const Positions & sphereMap, const FramePlacementOptions & options)
    : m_Surface(surface)
    , m_Normals(vertexNormals(surface))
    , m_Locator(surface.triangles, sphereMap)
    , m_Nodes(options.nodesPerSide)
    , m_Sharpness(options.sharpness)
  {
    for (const Vector3 & direction : m_Nodes.directions())
    {
      m_Start.push_back(m_Locator.locate(direction).triangle);
    }
  }

  /** May be called from many threads. The searches start from the triangles of the identity, whoever asks. */
  [[nodiscard]] EdgeScore
  judge(const FramePlacement & placement) const
  {
    Positions points(m_Nodes.directions().size());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      points[i] = pointOn(m_Locator.locateFrom(unplaced(m_Nodes.directions()[i], placement), m_Start[i]));
    }
    EdgeScore result{ 0.0, std::numeric_limits<double>::infinity() };
    for (const CellCorner & corner : m_Nodes.corners())
    {
      const double quality = scaledJacobian(points, corner);
      result.score += std::exp(-m_Sharpness * quality) / static_cast<double>(m_Nodes.corners().size());
      result.smallestScaledJacobian = std::min(result.smallestScaledJacobian, quality);
    }
    return result;
  }

private:
  [[nodiscard]] Vector3
  pointOn(const SphereLocator::Hit & hit) const
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

  /** Worst where two nodes coincide. */
  static double
  scaledJacobian(const Positions & points, const CellCorner & corner)
  {
    const Vector3 a = points[corner[1]] - points[corner[0]];
    const Vector3 b = points[corner[2]] - points[corner[0]];
    const Vector3 c = points[corner[3]] - points[corner[0]];
    const double  lengths = a.norm() * b.norm() * c.norm();
    return lengths > 0.0 ? a.dot(b.cross(c)) / lengths : -1.0;
  }

  const TriangleMesh & m_Surface;
  Positions            m_Normals;
  SphereLocator        m_Locator;
  EdgeNodes            m_Nodes;
  double               m_Sharpness;
  std::vector<int>     m_Start;
};

void
requireInput(const TriangleMesh & surface, const Positions & sphereMap, const FramePlacementOptions & options)
{
  if (surface.vertices.size() != sphereMap.size())
  {
    throw InvalidInput("surface has " + std::to_string(surface.vertices.size()) + " vertices, its sphere map " +
                       std::to_string(sphereMap.size()));
  }
  requireOptions(options);
}

/** Compass search with complete polling; see placeFrame. */
class CompassSearch
{
public:
  CompassSearch(const EdgeJudge & judge, const FramePlacementOptions & options) : m_Judge(judge), m_Options(options)
  {
    for (Eigen::Index axis = 0; axis < 6; ++axis)
    {
      if ((axis < 3 ? options.maximumAngle : options.maximumBoost) > 0.0)
      {
        m_Axes.push_back(axis);
      }
    }
  }

  void
  run(const ProgressCallback & progress)
  {
    m_Best = evaluate({ Coordinates::Zero() }).front();
    double step = m_Options.firstStep;
    while (!m_Axes.empty() && step >= m_Options.smallestStep && m_Report.steps < m_Options.maximumRounds)
    {
      reportProgress(
        progress, std::log(step / m_Options.firstStep) / std::log(0.5 * m_Options.smallestStep / m_Options.firstStep));
      step = poll(step) ? step : 0.5 * step;
      ++m_Report.steps;
    }
    m_Report.residual = step;
    m_Report.converged = m_Axes.empty() || step < m_Options.smallestStep;
  }

  struct Candidate
  {
    Coordinates    x{ Coordinates::Zero() };
    FramePlacement placement;
    EdgeScore      score;
    double         objective{ 0.0 };
  };

  [[nodiscard]] const Candidate &
  best() const
  {
    return m_Best;
  }
  [[nodiscard]] int
  evaluations() const
  {
    return m_Evaluations;
  }
  [[nodiscard]] const StepReport &
  report() const
  {
    return m_Report;
  }

private:
  /** Goes to the best neighbour when it is better; false when none is. */
  bool
  poll(double step)
  {
    std::vector<Coordinates> neighbours;
    for (const Eigen::Index axis : m_Axes)
    {
      for (const double sign : { -1.0, 1.0 })
      {
        neighbours.push_back(withinBounds(m_Best.x + sign * step * Coordinates::Unit(axis)));
      }
    }
    bool moved = false;
    for (const Candidate & candidate : evaluate(neighbours))
    {
      if (candidate.objective < m_Best.objective)
      {
        m_Best = candidate;
        moved = true;
      }
    }
    return moved;
  }

  std::vector<Candidate>
  evaluate(const std::vector<Coordinates> & points)
  {
    std::vector<Candidate> candidates(points.size());
    parallelFor(points.size(), m_Options.threads, [&](std::size_t i) {
      Candidate & candidate = candidates[i];
      candidate.x = points[i];
      candidate.placement = placementAt(points[i], m_Options);
      candidate.score = m_Judge.judge(candidate.placement);
      candidate.objective = std::log(candidate.score.score) + m_Options.anchor * points[i].squaredNorm();
    });
    m_Evaluations += static_cast<int>(points.size());
    return candidates;
  }

  const EdgeJudge &             m_Judge;
  const FramePlacementOptions & m_Options;
  std::vector<Eigen::Index>     m_Axes;
  Candidate                     m_Best;
  int                           m_Evaluations{ 0 };
  StepReport                    m_Report;
};

} // namespace

Vector3
placed(const Vector3 & direction, const FramePlacement & placement)
{
  return moebiusBoost((placement.rotation * direction).normalized(), placement.boost).normalized();
}

Vector3
unplaced(const Vector3 & direction, const FramePlacement & placement)
{
  return placement.rotation.transpose() * moebiusBoost(direction.normalized(), -placement.boost).normalized();
}

std::vector<Positions>
placed(const std::vector<Positions> & sphereMaps, const FramePlacement & placement)
{
  std::vector<Positions> result = sphereMaps;
  for (Positions & map : result)
  {
    for (Vector3 & direction : map)
    {
      direction = placed(direction, placement);
    }
  }
  return result;
}

EdgeScore
edgeScore(const TriangleMesh &          surface,
          const Positions &             sphereMap,
          const FramePlacement &        placement,
          const FramePlacementOptions & options)
{
  requireInput(surface, sphereMap, options);
  return EdgeJudge(surface, sphereMap, options).judge(placement);
}

std::vector<EdgeScore>
edgeScores(const TriangleMesh &                surface,
           const Positions &                   sphereMap,
           const std::vector<FramePlacement> & placements,
           const FramePlacementOptions &       options)
{
  requireInput(surface, sphereMap, options);
  const EdgeJudge        judge(surface, sphereMap, options);
  std::vector<EdgeScore> scores(placements.size());
  parallelFor(placements.size(), options.threads, [&](std::size_t p) { scores[p] = judge.judge(placements[p]); });
  return scores;
}

FramePlacementResult
placeFrame(const TriangleMesh &          surface,
           const Positions &             sphereMap,
           const FramePlacementOptions & options,
           const ProgressCallback &      progress)
{
  requireInput(surface, sphereMap, options);
  const Stopwatch watch;
  const EdgeJudge judge(surface, sphereMap, options);
  CompassSearch   search(judge, options);
  search.run(progress);

  FramePlacementResult result;
  result.placement = search.best().placement;
  result.before = judge.judge({});
  result.after = search.best().score;
  result.angle = options.maximumAngle * search.best().x.head<3>().norm();
  result.evaluations = search.evaluations();
  result.report = search.report();
  result.report.seconds = watch.seconds();
  result.report.note = "frame placement";
  reportProgress(progress, 1.0);
  return result;
}

} // namespace moserhex
