#pragma once

#include "moserhex/Common/Errors.h"
#include "moserhex/Geometry/TriangleMesh.h"

#include <cstdint>
#include <sstream>
#include <vector>

namespace moserhex
{

/** Closed, oriented, manifold triangulation that can be edited: split, flip, collapse. Private to this module.
 *
 * Half-edge e = 3 t + k runs from corner k of triangle t to corner k+1; twin(e) runs the other way in the neighbour.
 * Triangles and vertices that were removed keep their numbers and are marked dead. */
class EditableTriangulation
{
public:
  Positions vertices;

  /** \throws InvalidInput unless every side has exactly one twin and every vertex one fan. O(nF). */
  explicit EditableTriangulation(const TriangleMesh & mesh)
    : vertices(mesh.vertices)
    , m_Triangles(mesh.triangles)
    , m_TriangleAlive(mesh.triangles.size(), 1)
    , m_VertexAlive(mesh.vertices.size(), 1)
    , m_Outgoing(mesh.vertices.size(), -1)
    , m_Mark(mesh.vertices.size(), 0)
  {
    connect();
  }

  [[nodiscard]] int
  halfEdgeCount() const
  {
    return static_cast<int>(3 * m_Triangles.size());
  }
  [[nodiscard]] bool
  halfEdgeIsAlive(int e) const
  {
    return m_TriangleAlive[e / 3] != 0;
  }
  [[nodiscard]] bool
  vertexIsAlive(VertexIndex v) const
  {
    return m_VertexAlive[v] != 0;
  }
  [[nodiscard]] const std::vector<Triangle> &
  triangles() const
  {
    return m_Triangles;
  }
  [[nodiscard]] bool
  triangleIsAlive(std::size_t t) const
  {
    return m_TriangleAlive[t] != 0;
  }
  [[nodiscard]] static int
  next(int e)
  {
    return e % 3 == 2 ? e - 2 : e + 1;
  }
  [[nodiscard]] static int
  previous(int e)
  {
    return e % 3 == 0 ? e + 2 : e - 1;
  }
  [[nodiscard]] int
  twin(int e) const
  {
    return m_Twin[e];
  }
  [[nodiscard]] VertexIndex
  origin(int e) const
  {
    return m_Triangles[e / 3][e % 3];
  }
  [[nodiscard]] VertexIndex
  target(int e) const
  {
    return origin(next(e));
  }
  /** Corner opposite to the half-edge, in its triangle. */
  [[nodiscard]] VertexIndex
  apex(int e) const
  {
    return origin(previous(e));
  }

  /** Calls visit(e) for the half-edges that leave v. */
  template <typename TVisitor>
  void
  forEachOutgoing(VertexIndex v, TVisitor && visit) const
  {
    const int start = m_Outgoing[v];
    int       e = start;
    do
    {
      visit(e);
      e = m_Twin[previous(e)];
    } while (e != start);
  }

  [[nodiscard]] int
  valence(VertexIndex v) const
  {
    int count = 0;
    forEachOutgoing(v, [&count](int) { ++count; });
    return count;
  }

  [[nodiscard]] bool
  areNeighbours(VertexIndex a, VertexIndex b) const
  {
    bool found = false;
    forEachOutgoing(a, [&](int e) { found = found || target(e) == b; });
    return found;
  }

  /** Link condition for the collapse of e = ab: a and b have exactly the two opposite corners as common neighbours,
   * and no corner is left with fewer than three neighbours. */
  [[nodiscard]] bool
  collapseKeepsTopology(int e)
  {
    const VertexIndex a = origin(e);
    const VertexIndex b = target(e);
    ++m_Stamp;
    int valenceOfA = 0;
    forEachOutgoing(a, [&](int q) {
      m_Mark[target(q)] = m_Stamp;
      ++valenceOfA;
    });
    int common = 0;
    int valenceOfB = 0;
    forEachOutgoing(b, [&](int q) {
      common += m_Mark[target(q)] == m_Stamp ? 1 : 0;
      ++valenceOfB;
    });
    return common == 2 && valenceOfA + valenceOfB >= 8 && apex(e) != apex(m_Twin[e]) && valence(apex(e)) > 3 &&
           valence(apex(m_Twin[e])) > 3;
  }

  /** Moves b of e = ab into a and removes the two triangles of e. Precondition: collapseKeepsTopology(e). */
  void
  collapse(int e)
  {
    const int         f = m_Twin[e];
    const VertexIndex a = origin(e);
    const VertexIndex b = target(e);
    const VertexIndex c = apex(e);
    const VertexIndex d = apex(f);
    forEachOutgoing(b, [&](int q) { m_Scratch.push_back(q); });
    // Outer neighbours of the two dying triangles become neighbours of each other.
    const int outerC[2] = { m_Twin[next(e)], m_Twin[previous(e)] }; // c->b and a->c
    const int outerD[2] = { m_Twin[next(f)], m_Twin[previous(f)] }; // d->a and b->d
    for (const int q : m_Scratch)
    {
      m_Triangles[q / 3][q % 3] = a;
    }
    m_Scratch.clear();
    pair(outerC[0], outerC[1]);
    pair(outerD[0], outerD[1]);
    m_TriangleAlive[e / 3] = 0;
    m_TriangleAlive[f / 3] = 0;
    m_VertexAlive[b] = 0;
    m_Outgoing[c] = outerC[0];
    m_Outgoing[a] = outerC[1];
    m_Outgoing[d] = outerD[0];
  }

  /** Puts a vertex at p on e = ab; the two triangles become four. */
  void
  split(int e, const Vector3 & p)
  {
    const int         f = m_Twin[e];
    const VertexIndex b = target(e);
    const VertexIndex c = apex(e);
    const VertexIndex d = apex(f);
    const auto        m = static_cast<VertexIndex>(vertices.size());
    const int         outerC = m_Twin[next(e)];     // c->b
    const int         outerD = m_Twin[previous(f)]; // b->d
    vertices.push_back(p);
    m_VertexAlive.push_back(1);
    m_Outgoing.push_back(-1);
    m_Mark.push_back(0);
    // Old triangles keep a: (a, m, c) at e and (m, a, d) at f. New ones take b.
    m_Triangles[next(e) / 3][next(e) % 3] = m;
    m_Triangles[f / 3][f % 3] = m;
    const int g = addTriangle(m, b, c); // m->b, b->c, c->m
    const int h = addTriangle(b, m, d); // b->m, m->d, d->b
    pair(g, h);
    pair(g + 1, outerC);
    pair(g + 2, next(e));
    pair(h + 1, previous(f));
    pair(h + 2, outerD);
    m_Outgoing[m] = g;
    m_Outgoing[b] = h;
  }

  /** Replaces side ab of the triangles abc, bad by dc. The half-edge e becomes d->c. */
  void
  flip(int e)
  {
    const int         f = m_Twin[e];
    const VertexIndex a = origin(e);
    const VertexIndex b = target(e);
    const VertexIndex c = apex(e);
    const VertexIndex d = apex(f);
    const int         bc = m_Twin[next(e)];
    const int         ca = m_Twin[previous(e)];
    const int         ad = m_Twin[next(f)];
    const int         db = m_Twin[previous(f)];
    setTriangle(e, d, c, a); // d->c, c->a, a->d
    setTriangle(f, c, d, b); // c->d, d->b, b->c
    pair(next(e), ca);
    pair(previous(e), ad);
    pair(next(f), db);
    pair(previous(f), bc);
    m_Outgoing[a] = previous(e);
    m_Outgoing[b] = previous(f);
    m_Outgoing[c] = f;
    m_Outgoing[d] = e;
  }

  /** What is alive, renumbered in order. */
  [[nodiscard]] TriangleMesh
  mesh() const
  {
    TriangleMesh             result;
    std::vector<VertexIndex> number(vertices.size(), -1);
    for (std::size_t v = 0; v < vertices.size(); ++v)
    {
      if (m_VertexAlive[v])
      {
        number[v] = static_cast<VertexIndex>(result.vertices.size());
        result.vertices.push_back(vertices[v]);
      }
    }
    for (std::size_t t = 0; t < m_Triangles.size(); ++t)
    {
      if (m_TriangleAlive[t])
      {
        const Triangle & corners = m_Triangles[t];
        result.triangles.push_back({ number[corners[0]], number[corners[1]], number[corners[2]] });
      }
    }
    return result;
  }

private:
  void
  pair(int e, int f)
  {
    m_Twin[e] = f;
    m_Twin[f] = e;
  }

  /** Corners of the triangle of e, beginning at the origin of e. */
  void
  setTriangle(int e, VertexIndex a, VertexIndex b, VertexIndex c)
  {
    Triangle & t = m_Triangles[e / 3];
    t[e % 3] = a;
    t[next(e) % 3] = b;
    t[previous(e) % 3] = c;
  }

  int
  addTriangle(VertexIndex a, VertexIndex b, VertexIndex c)
  {
    m_Triangles.push_back({ a, b, c });
    m_TriangleAlive.push_back(1);
    m_Twin.resize(m_Twin.size() + 3, -1);
    return halfEdgeCount() - 3;
  }

  void
  connect()
  {
    const auto       count = static_cast<VertexIndex>(vertices.size());
    std::vector<int> firstOfVertex(vertices.size() + 1, 0);
    for (int e = 0; e < halfEdgeCount(); ++e)
    {
      if (origin(e) < 0 || origin(e) >= count || origin(e) == target(e))
      {
        std::ostringstream message;
        message << "triangle " << e / 3 << " names vertex " << origin(e) << " (twice, or out of 0 to " << count - 1
                << ')';
        throw InvalidInput(message.str());
      }
      ++firstOfVertex[origin(e) + 1];
    }
    for (std::size_t v = 0; v < vertices.size(); ++v)
    {
      firstOfVertex[v + 1] += firstOfVertex[v];
      m_VertexAlive[v] = firstOfVertex[v + 1] > firstOfVertex[v];
    }
    std::vector<int> leaving(halfEdgeCount());
    std::vector<int> fill(firstOfVertex.begin(), firstOfVertex.end() - 1);
    for (int e = 0; e < halfEdgeCount(); ++e)
    {
      leaving[fill[origin(e)]++] = e;
      m_Outgoing[origin(e)] = e;
    }
    const auto countAndFind = [&](VertexIndex a, VertexIndex b, int & found) {
      int matches = 0;
      for (int i = firstOfVertex[a]; i < firstOfVertex[a + 1]; ++i)
      {
        if (target(leaving[i]) == b)
        {
          found = leaving[i];
          ++matches;
        }
      }
      return matches;
    };
    m_Twin.assign(halfEdgeCount(), -1);
    for (int e = 0; e < halfEdgeCount(); ++e)
    {
      int       self = -1;
      const int same = countAndFind(origin(e), target(e), self);
      const int opposite = countAndFind(target(e), origin(e), m_Twin[e]);
      if (same != 1 || opposite != 1)
      {
        std::ostringstream message;
        message << "edge (" << origin(e) << ", " << target(e) << ") has " << same << " and " << opposite
                << " triangles in its two directions, need 1 and 1 (closed, manifold, oriented)";
        throw InvalidInput(message.str());
      }
    }
    for (VertexIndex v = 0; v < count; ++v)
    {
      if (m_VertexAlive[v] && valence(v) != firstOfVertex[v + 1] - firstOfVertex[v])
      {
        std::ostringstream message;
        message << "vertex " << v << " joins more than one fan of triangles, need 1 (manifold)";
        throw InvalidInput(message.str());
      }
    }
  }

  std::vector<Triangle>     m_Triangles;
  std::vector<std::uint8_t> m_TriangleAlive;
  std::vector<std::uint8_t> m_VertexAlive;
  std::vector<int>          m_Outgoing; ///< one half-edge that leaves each vertex
  std::vector<int>          m_Twin;
  std::vector<int>          m_Mark;
  int                       m_Stamp{ 0 };
  std::vector<int>          m_Scratch;
};

} // namespace moserhex
