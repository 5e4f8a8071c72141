#include "HalfEdgeCollapse.h"

#include "moserhex/Common/Errors.h"

#include <algorithm>
#include <limits>
#include <sstream>

namespace moserhex
{
namespace
{

constexpr int smallDegree = 6; ///< passes take vertices of this degree at most, unless there is none

class Collapser
{
public:
  Collapser(const TriangleMesh & surface, const std::vector<double> & areas)
    : m_Positions(surface.vertices)
    , m_Triangles(surface.triangles)
    , m_Areas(areas)
    , m_TriangleAlive(surface.triangles.size(), 1)
    , m_TrianglesOf(surface.vertices.size())
    , m_LockedInPass(surface.vertices.size(), -1)
  {
    for (std::size_t f = 0; f < m_Triangles.size(); ++f)
    {
      for (const VertexIndex v : m_Triangles[f])
      {
        m_TrianglesOf[v].push_back(static_cast<int>(f));
      }
    }
    m_Alive = static_cast<std::size_t>(std::count_if(
      m_TrianglesOf.begin(), m_TrianglesOf.end(), [](const std::vector<int> & star) { return !star.empty(); }));
    m_AliveAtLastLevel = m_Alive;
  }

  CollapseSequence
  run()
  {
    saveLevel();
    for (int pass = 0; m_Alive > 4; ++pass)
    {
      const std::size_t before = m_Sequence.vertices.size();
      for (int degree = smallDegree; m_Sequence.vertices.size() == before; degree *= 4)
      {
        collapseIndependent(pass, degree);
        if (m_Sequence.vertices.size() == before && degree > static_cast<int>(m_TrianglesOf.size()))
        {
          StepReport report;
          report.steps = static_cast<int>(before);
          std::ostringstream message;
          message << "collapse stopped at " << m_Alive << " vertices, need 4";
          throw NotConverged(message.str(), report);
        }
      }
    }
    m_Sequence.last = aliveTriangles().first;
    return std::move(m_Sequence);
  }

private:
  [[nodiscard]] int
  degree(VertexIndex v) const
  {
    return static_cast<int>(m_TrianglesOf[v].size());
  }

  std::pair<std::vector<Triangle>, std::vector<double>>
  aliveTriangles() const
  {
    std::pair<std::vector<Triangle>, std::vector<double>> result;
    for (std::size_t f = 0; f < m_Triangles.size(); ++f)
    {
      if (m_TriangleAlive[f] != 0)
      {
        result.first.push_back(m_Triangles[f]);
        result.second.push_back(m_Areas[f]);
      }
    }
    return result;
  }

  void
  saveLevel()
  {
    auto alive = aliveTriangles();
    m_Sequence.levels.push_back({ m_Sequence.vertices.size(), std::move(alive.first), std::move(alive.second) });
    m_AliveAtLastLevel = m_Alive;
  }

  /** Vertices in use of degree at most `largest`, small degrees first, then by number. */
  std::vector<VertexIndex>
  candidates(int largest) const
  {
    constexpr int                                 classes = 8;
    std::array<std::vector<VertexIndex>, classes> byDegree;
    for (std::size_t v = 0; v < m_TrianglesOf.size(); ++v)
    {
      const int d = degree(static_cast<VertexIndex>(v));
      if (d > 0 && d <= largest)
      {
        byDegree[std::min(d, classes - 1)].push_back(static_cast<VertexIndex>(v));
      }
    }
    std::vector<VertexIndex> result;
    for (const std::vector<VertexIndex> & vertices : byDegree)
    {
      result.insert(result.end(), vertices.begin(), vertices.end());
    }
    return result;
  }

  void
  collapseIndependent(int pass, int largestDegree)
  {
    constexpr std::size_t smallestLevel = 12;
    for (const VertexIndex v : candidates(largestDegree))
    {
      if (m_Alive <= 4 || m_LockedInPass[v] == pass)
      {
        continue;
      }
      std::vector<VertexIndex> ring = orderedRing(v);
      const int                target = collapseTarget(ring);
      if (target < 0)
      {
        continue;
      }
      std::rotate(ring.begin(), ring.begin() + target, ring.end());
      for (const VertexIndex w : ring)
      {
        m_LockedInPass[w] = pass;
      }
      collapse(v, std::move(ring));
      if (2 * m_Alive <= m_AliveAtLastLevel && m_Alive > smallestLevel)
      {
        saveLevel();
      }
    }
  }

  /** Neighbours of v, counter-clockwise from outside. */
  std::vector<VertexIndex>
  orderedRing(VertexIndex v) const
  {
    const std::vector<int> & star = m_TrianglesOf[v];
    const auto               side = [&](int f) { // the side of triangle f opposite v
      const Triangle & t = m_Triangles[f];
      const int        k = t[0] == v ? 0 : t[1] == v ? 1 : 2;
      return std::make_pair(t[(k + 1) % 3], t[(k + 2) % 3]);
    };
    std::vector<VertexIndex> ring{ side(star[0]).first };
    while (ring.size() < star.size())
    {
      const auto next = std::find_if(star.begin(), star.end(), [&](int f) { return side(f).first == ring.back(); });
      ring.push_back(side(*next).second);
    }
    return ring;
  }

  /** Place in the ring of the vertex of smallest degree to which the centre may be collapsed; -1 when there is none. */
  int
  collapseTarget(const std::vector<VertexIndex> & ring) const
  {
    const int d = static_cast<int>(ring.size());
    if (d == 3 && std::any_of(ring.begin(), ring.end(), [&](VertexIndex w) { return degree(w) <= 3; }))
    {
      return -1; // two triangles would share all three vertices
    }
    int best = -1;
    int bestDegree = std::numeric_limits<int>::max();
    for (int i = 0; i < d; ++i)
    {
      if (degree(ring[i]) < bestDegree && meetsLinkCondition(ring, i))
      {
        best = i;
        bestDegree = degree(ring[i]);
      }
    }
    return best;
  }

  /** No ring vertex but the two next to ring[i] may be a neighbour of ring[i]. */
  bool
  meetsLinkCondition(const std::vector<VertexIndex> & ring, int i) const
  {
    const int d = static_cast<int>(ring.size());
    for (const int f : m_TrianglesOf[ring[i]])
    {
      for (const VertexIndex w : m_Triangles[f])
      {
        for (int k = 2; k <= d - 2; ++k)
        {
          if (w == ring[(i + k) % d])
          {
            return false;
          }
        }
      }
    }
    return true;
  }

  /** Replaces the star of v by the fan of ring[0] over the rest of the ring. */
  void
  collapse(VertexIndex v, std::vector<VertexIndex> ring)
  {
    const std::vector<int>    star = m_TrianglesOf[v];
    const std::vector<double> areas = fanAreas(star, ring);
    for (const int f : star)
    {
      for (const VertexIndex w : m_Triangles[f])
      {
        std::vector<int> & list = m_TrianglesOf[w];
        list.erase(std::find(list.begin(), list.end(), f));
      }
      m_TriangleAlive[f] = 0;
    }
    for (std::size_t q = 0; q + 2 < ring.size(); ++q)
    {
      const int f = star[q];
      m_Triangles[f] = { ring[0], ring[q + 1], ring[q + 2] };
      m_Areas[f] = areas[q];
      m_TriangleAlive[f] = 1;
      for (const VertexIndex w : m_Triangles[f])
      {
        m_TrianglesOf[w].push_back(f);
      }
    }
    --m_Alive;
    m_Sequence.vertices.push_back({ v, std::move(ring) });
  }

  std::vector<double>
  fanAreas(const std::vector<int> & star, const std::vector<VertexIndex> & ring) const
  {
    constexpr double    byOwnArea = 0.9; // the rest in equal parts: no triangle is left with nothing
    double              total = 0.0;
    double              fan = 0.0;
    std::vector<double> areas;
    for (const int f : star)
    {
      total += m_Areas[f];
    }
    for (std::size_t q = 0; q + 2 < ring.size(); ++q)
    {
      areas.push_back(triangleArea(m_Positions[ring[0]], m_Positions[ring[q + 1]], m_Positions[ring[q + 2]]));
      fan += areas.back();
    }
    const double equal = 1.0 / static_cast<double>(areas.size());
    for (double & area : areas)
    {
      area = total * (fan > 0.0 ? byOwnArea * area / fan + (1.0 - byOwnArea) * equal : equal);
    }
    return areas;
  }

  const Positions &             m_Positions;
  std::vector<Triangle>         m_Triangles;
  std::vector<double>           m_Areas;
  std::vector<char>             m_TriangleAlive;
  std::vector<std::vector<int>> m_TrianglesOf; ///< empty: not in use
  std::vector<int>              m_LockedInPass;
  std::size_t                   m_Alive{ 0 };
  std::size_t                   m_AliveAtLastLevel{ 0 };
  CollapseSequence              m_Sequence;
};

} // namespace

CollapseSequence
collapseToTetrahedron(const TriangleMesh & surface, const std::vector<double> & areas)
{
  return Collapser(surface, areas).run();
}

} // namespace moserhex
