#pragma once

#include "moserhex/Geometry/TriangleMesh.h"

#include <string>

namespace moserhex
{

using Edge = std::array<VertexIndex, 2>; ///< smaller vertex first

/** Edges and neighbours of a closed, oriented, manifold triangulation. Corner k of triangle f sits opposite the edge
 * (f[k+1], f[k+2]); side k is the edge (f[k], f[k+1]). */
struct TriangleTopology
{
  std::vector<Edge>               edges;          ///< nE, in ascending order
  std::vector<std::array<int, 3>> triangleEdges;  ///< nF x 3: edge number of side k
  std::vector<std::array<int, 3>> neighbours;     ///< nF x 3: triangle across side k
  std::vector<int>                vertexTriangle; ///< nV: one incident triangle
};

/** \throws InvalidInput when an index is out of range, a triangle repeats a vertex, or an edge is not shared by exactly
 * two triangles of opposite direction; the message names the first such edge. O(nF log nF). */
[[nodiscard]] TriangleTopology
triangleTopology(const TriangleMesh & mesh);

/** Numbers that decide whether a surface is a sphere. */
struct SurfaceTopologySummary
{
  std::size_t vertices{ 0 };            ///< those that a triangle uses
  std::size_t edges{ 0 };               ///< different pairs of vertices
  std::size_t triangles{ 0 };           ///< all of the mesh
  std::size_t components{ 0 };          ///< connected parts
  std::size_t boundaryEdges{ 0 };       ///< edges with one triangle
  std::size_t nonManifoldEdges{ 0 };    ///< edges with more than two triangles, or two in the same direction
  std::size_t nonManifoldVertices{ 0 }; ///< vertices whose triangles form more than one fan
  long        eulerCharacteristic{ 0 }; ///< V - E + F over vertices that are used

  /** One closed manifold of Euler characteristic 2. */
  [[nodiscard]] bool
  isSphere() const
  {
    return components == 1 && boundaryEdges == 0 && nonManifoldEdges == 0 && nonManifoldVertices == 0 &&
           eulerCharacteristic == 2;
  }
};

/** Never throws on bad connectivity (indices must be in range): it counts. */
[[nodiscard]] SurfaceTopologySummary
summarizeTopology(const TriangleMesh & mesh);

/** \throws InvalidInput with the numbers ("V-E+F = 0, need 2 (genus 0)") unless the mesh is one closed sphere. */
void
requireSphere(const TriangleMesh & mesh, const std::string & what);

} // namespace moserhex
