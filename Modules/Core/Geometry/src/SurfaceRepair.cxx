#include "moserhex/Geometry/SurfaceRepair.h"

#include "TriangleSides.h"
#include "moserhex/Common/Errors.h"

#include <algorithm>
#include <numeric>

namespace moserhex
{
namespace
{

/** For each vertex the first one with its coordinates. */
std::vector<std::size_t>
firstOfPlace(const Positions & vertices)
{
  const auto less = [&vertices](std::size_t a, std::size_t b) {
    const Vector3 & p = vertices[a];
    const Vector3 & q = vertices[b];
    return std::lexicographical_compare(p.data(), p.data() + 3, q.data(), q.data() + 3);
  };
  std::vector<std::size_t> order(vertices.size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  std::stable_sort(order.begin(), order.end(), less);
  std::vector<std::size_t> first(vertices.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const bool same = i > 0 && !less(order[i - 1], order[i]);
    first[order[i]] = same ? first[order[i - 1]] : order[i];
  }
  return first;
}

/** The triangle with its smallest vertex first, in the same sense. */
Triangle
smallestFirst(Triangle triangle)
{
  std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
  return triangle;
}

/** Removes all but the first of equal triangles; returns how many went. */
std::size_t
removeDuplicates(std::vector<Triangle> & triangles)
{
  std::vector<std::size_t> order(triangles.size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  std::vector<Triangle> keys(triangles.size());
  std::transform(triangles.begin(), triangles.end(), keys.begin(), smallestFirst);
  std::stable_sort(order.begin(), order.end(), [&keys](std::size_t a, std::size_t b) { return keys[a] < keys[b]; });
  std::vector<bool> repeated(triangles.size(), false);
  for (std::size_t i = 1; i < order.size(); ++i)
  {
    repeated[order[i]] = keys[order[i - 1]] == keys[order[i]];
  }
  std::vector<Triangle> kept;
  kept.reserve(triangles.size());
  for (std::size_t f = 0; f < triangles.size(); ++f)
  {
    if (!repeated[f])
    {
      kept.push_back(triangles[f]);
    }
  }
  const std::size_t removed = triangles.size() - kept.size();
  triangles = std::move(kept);
  return removed;
}

/** What lies across a side. */
struct Neighbour
{
  int  triangle;
  bool agrees; ///< the two triangles run along the edge in opposite directions
};
using Neighbours = std::vector<std::array<Neighbour, 3>>;

Neighbours
neighboursOf(const TriangleMesh & mesh)
{
  const std::vector<TriangleSide> sides = sortedSides(mesh);
  Neighbours                      neighbours(mesh.triangles.size());
  forEachEdge(sides, [&](std::size_t first, std::size_t count) {
    if (count != 2)
    {
      throw InvalidInput("orientSurface: an edge has " + std::to_string(count) + " triangles, need 2");
    }
    const TriangleSide & p = sides[first];
    const TriangleSide & q = sides[first + 1];
    const bool           agrees = p.ascending != q.ascending;
    neighbours[p.triangle][p.side] = { q.triangle, agrees };
    neighbours[q.triangle][q.side] = { p.triangle, agrees };
  });
  return neighbours;
}

/** Marks the part of `seed` and which of its triangles are to be turned for all to agree with the seed.
 * \return its triangles, or nothing when it is not orientable */
std::vector<int>
spreadFrom(int seed, int number, const Neighbours & neighbours, std::vector<int> & part, std::vector<bool> & turned)
{
  std::vector<int> members{ seed };
  part[seed] = number;
  for (std::size_t next = 0; next < members.size(); ++next)
  {
    const int f = members[next];
    for (const Neighbour & neighbour : neighbours[f])
    {
      const bool wanted = neighbour.agrees == turned[f];
      if (part[neighbour.triangle] < 0)
      {
        part[neighbour.triangle] = number;
        turned[neighbour.triangle] = wanted;
        members.push_back(neighbour.triangle);
      }
      else if (turned[neighbour.triangle] != wanted)
      {
        return {};
      }
    }
  }
  return members;
}

double
signedVolume(const TriangleMesh & mesh, const std::vector<int> & members, const std::vector<bool> & turned)
{
  TriangleMesh part{ mesh.vertices, {} };
  for (const int f : members)
  {
    part.triangles.push_back(mesh.triangles[f]);
    if (turned[f])
    {
      std::swap(part.triangles.back()[1], part.triangles.back()[2]);
    }
  }
  return enclosedVolume(part);
}

} // namespace

WeldedSurface
weldSurface(const TriangleMesh & mesh)
{
  const std::vector<std::size_t> first = firstOfPlace(mesh.vertices);
  WeldedSurface                  welded;
  std::vector<VertexIndex>       newNumber(mesh.vertices.size(), -1);
  for (const Triangle & triangle : mesh.triangles)
  {
    std::array<std::size_t, 3> corner{};
    for (std::size_t i = 0; i < 3; ++i)
    {
      corner[i] = first[static_cast<std::size_t>(triangle[i])];
    }
    if (corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0])
    {
      ++welded.collapsedTriangles;
      continue;
    }
    Triangle renumbered{};
    for (std::size_t i = 0; i < 3; ++i)
    {
      if (newNumber[corner[i]] < 0)
      {
        newNumber[corner[i]] = static_cast<VertexIndex>(welded.mesh.vertices.size());
        welded.mesh.vertices.push_back(mesh.vertices[corner[i]]);
      }
      renumbered[i] = newNumber[corner[i]];
    }
    welded.mesh.triangles.push_back(renumbered);
  }
  welded.duplicateTriangles = removeDuplicates(welded.mesh.triangles);
  return welded;
}

SurfaceEdgeCounts
countSurfaceEdges(const TriangleMesh & mesh)
{
  SurfaceEdgeCounts               counts;
  const std::vector<TriangleSide> sides = sortedSides(mesh);
  std::vector<std::size_t>        loop(mesh.vertices.size());
  std::iota(loop.begin(), loop.end(), std::size_t{ 0 });
  std::vector<bool> onBoundary(mesh.vertices.size(), false);
  forEachEdge(sides, [&](std::size_t first, std::size_t count) {
    const TriangleSide & side = sides[first];
    counts.overusedEdges += count > 2 ? 1 : 0;
    if (count == 1)
    {
      ++counts.boundaryEdges;
      onBoundary[side.low] = true;
      onBoundary[side.high] = true;
      loop[rootOf(loop, side.low)] = rootOf(loop, side.high);
    }
  });
  for (std::size_t v = 0; v < loop.size(); ++v)
  {
    counts.boundaryLoops += onBoundary[v] && rootOf(loop, v) == v ? 1 : 0;
  }
  return counts;
}

OrientedSurface
orientSurface(const TriangleMesh & mesh)
{
  const Neighbours  neighbours = neighboursOf(mesh);
  std::vector<bool> turned(mesh.triangles.size(), false);
  OrientedSurface   oriented;
  oriented.mesh = mesh;
  oriented.part.assign(mesh.triangles.size(), -1);
  for (int seed = 0; seed < static_cast<int>(mesh.triangles.size()); ++seed)
  {
    if (oriented.part[seed] >= 0)
    {
      continue;
    }
    const std::vector<int> members = spreadFrom(seed, oriented.parts, neighbours, oriented.part, turned);
    if (members.empty())
    {
      oriented.orientable = false;
      return oriented;
    }
    ++oriented.parts;
    const auto count = static_cast<std::size_t>(
      std::count_if(members.begin(), members.end(), [&turned](int f) { return static_cast<bool>(turned[f]); }));
    const bool other =
      2 * count > members.size() || (2 * count == members.size() && signedVolume(mesh, members, turned) < 0.0);
    oriented.turnedTriangles += other ? members.size() - count : count;
    for (const int f : members)
    {
      if (turned[f] != other)
      {
        std::swap(oriented.mesh.triangles[f][1], oriented.mesh.triangles[f][2]);
      }
    }
  }
  return oriented;
}

std::vector<TriangleMesh>
partsOf(const OrientedSurface & surface)
{
  std::vector<TriangleMesh> parts(static_cast<std::size_t>(surface.parts));
  // A vertex may belong to two parts that touch there: it is numbered anew when the part changes.
  std::vector<std::vector<std::size_t>> members(parts.size());
  for (std::size_t f = 0; f < surface.part.size(); ++f)
  {
    members[static_cast<std::size_t>(surface.part[f])].push_back(f);
  }
  std::vector<VertexIndex> number(surface.mesh.vertices.size(), -1);
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    std::vector<VertexIndex> used;
    for (const std::size_t f : members[p])
    {
      Triangle triangle = surface.mesh.triangles[f];
      for (VertexIndex & vertex : triangle)
      {
        const VertexIndex old = vertex;
        if (number[old] < 0)
        {
          number[old] = static_cast<VertexIndex>(parts[p].vertices.size());
          parts[p].vertices.push_back(surface.mesh.vertices[old]);
          used.push_back(old);
        }
        vertex = number[old];
      }
      parts[p].triangles.push_back(triangle);
    }
    for (const VertexIndex old : used)
    {
      number[old] = -1;
    }
  }
  return parts;
}

} // namespace moserhex
