#include "moserhex/Geometry/TriangleTopology.h"

#include "TriangleSides.h"
#include "moserhex/Common/Errors.h"

#include <algorithm>
#include <numeric>
#include <sstream>

namespace moserhex
{
namespace
{

void
requireIndicesInRange(const TriangleMesh & mesh)
{
  const auto count = static_cast<VertexIndex>(mesh.vertices.size());
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
  {
    const Triangle & t = mesh.triangles[f];
    for (const VertexIndex v : t)
    {
      if (v < 0 || v >= count)
      {
        std::ostringstream message;
        message << "triangle " << f << " names vertex " << v << ", need 0 to " << count - 1;
        throw InvalidInput(message.str());
      }
    }
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
    {
      std::ostringstream message;
      message << "triangle " << f << " repeats a vertex (" << t[0] << ' ' << t[1] << ' ' << t[2] << ')';
      throw InvalidInput(message.str());
    }
  }
}

} // namespace

TriangleTopology
triangleTopology(const TriangleMesh & mesh)
{
  requireIndicesInRange(mesh);
  const std::vector<TriangleSide> sides = sortedSides(mesh);

  TriangleTopology topology;
  topology.triangleEdges.resize(mesh.triangles.size());
  topology.neighbours.resize(mesh.triangles.size());
  topology.vertexTriangle.assign(mesh.vertices.size(), -1);
  topology.edges.reserve(sides.size() / 2);
  forEachEdge(sides, [&](std::size_t first, std::size_t count) {
    const TriangleSide & p = sides[first];
    if (count != 2 || p.ascending == sides[first + 1].ascending)
    {
      std::ostringstream message;
      message << "edge (" << p.low << ", " << p.high << ") has " << count << " triangle" << (count == 1 ? "" : "s")
              << (count == 2 ? " of the same direction" : "") << ", need 2 of opposite direction";
      throw InvalidInput(message.str());
    }
    const TriangleSide & q = sides[first + 1];
    const int            edge = static_cast<int>(topology.edges.size());
    topology.edges.push_back({ p.low, p.high });
    topology.triangleEdges[p.triangle][p.side] = edge;
    topology.triangleEdges[q.triangle][q.side] = edge;
    topology.neighbours[p.triangle][p.side] = q.triangle;
    topology.neighbours[q.triangle][q.side] = p.triangle;
  });
  for (std::size_t f = mesh.triangles.size(); f-- > 0;)
  {
    for (const VertexIndex v : mesh.triangles[f])
    {
      topology.vertexTriangle[v] = static_cast<int>(f);
    }
  }
  return topology;
}

SurfaceTopologySummary
summarizeTopology(const TriangleMesh & mesh)
{
  SurfaceTopologySummary          summary;
  const std::vector<TriangleSide> sides = sortedSides(mesh);
  std::vector<std::size_t>        component(mesh.vertices.size());
  std::iota(component.begin(), component.end(), std::size_t{ 0 });
  // Corners (triangle, vertex) joined across shared edges: a manifold vertex has one class of corners.
  std::vector<std::size_t> fan(3 * mesh.triangles.size());
  std::iota(fan.begin(), fan.end(), std::size_t{ 0 });

  forEachEdge(sides, [&](std::size_t first, std::size_t count) {
    ++summary.edges;
    const TriangleSide & p = sides[first];
    component[rootOf(component, p.low)] = rootOf(component, p.high);
    if (count == 1)
    {
      ++summary.boundaryEdges;
    }
    else if (count > 2 || p.ascending == sides[first + 1].ascending)
    {
      ++summary.nonManifoldEdges;
    }
    for (std::size_t s = first + 1; s < first + count; ++s)
    {
      const TriangleSide & q = sides[s];
      for (const VertexIndex v : { p.low, p.high })
      {
        const auto cornerOf = [&](const TriangleSide & side) {
          const Triangle & t = mesh.triangles[side.triangle];
          const int        k = t[0] == v ? 0 : t[1] == v ? 1 : 2;
          return 3 * static_cast<std::size_t>(side.triangle) + k;
        };
        fan[rootOf(fan, cornerOf(p))] = rootOf(fan, cornerOf(q));
      }
    }
  });

  std::vector<std::size_t> fansOfVertex(mesh.vertices.size(), 0);
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const std::size_t corner = 3 * f + k;
      const bool        isRoot = rootOf(fan, corner) == corner;
      fansOfVertex[mesh.triangles[f][k]] += isRoot ? 1 : 0;
    }
  }
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
  {
    if (fansOfVertex[v] > 0)
    {
      ++summary.vertices;
      summary.nonManifoldVertices += fansOfVertex[v] > 1 ? 1 : 0;
      summary.components += rootOf(component, v) == v ? 1 : 0;
    }
  }
  summary.triangles = mesh.triangles.size();
  summary.eulerCharacteristic =
    static_cast<long>(summary.vertices) - static_cast<long>(summary.edges) + static_cast<long>(summary.triangles);
  return summary;
}

void
requireSphere(const TriangleMesh & mesh, const std::string & what)
{
  requireIndicesInRange(mesh);
  const SurfaceTopologySummary s = summarizeTopology(mesh);
  if (s.isSphere())
  {
    return;
  }
  std::ostringstream message;
  message << what << ": V-E+F = " << s.eulerCharacteristic << ", need 2 (genus 0)";
  if (s.components != 1)
  {
    message << "; " << s.components << " components, need 1";
  }
  if (s.boundaryEdges > 0)
  {
    message << "; " << s.boundaryEdges << " boundary edges, need 0 (closed)";
  }
  if (s.nonManifoldEdges + s.nonManifoldVertices > 0)
  {
    message << "; " << s.nonManifoldEdges << " non-manifold or badly oriented edges and " << s.nonManifoldVertices
            << " non-manifold vertices, need 0";
  }
  throw InvalidInput(message.str());
}

} // namespace moserhex
