#pragma once

#include "moserhex/Geometry/TriangleMesh.h"

#include <vector>

namespace moserhex
{

/** A vertex taken out of a triangulation by a half-edge collapse. */
struct CollapsedVertex
{
  VertexIndex              vertex;
  std::vector<VertexIndex> ring; ///< neighbours counter-clockwise from outside; ring[0] is where it was collapsed to
};

/** A triangulation on the way from the full one to the tetrahedron. */
struct CollapseLevel
{
  std::size_t           collapsed; ///< vertices taken out before
  std::vector<Triangle> triangles;
  std::vector<double>   areas; ///< area of the surface each triangle stands for
};

struct CollapseSequence
{
  std::vector<CollapsedVertex> vertices; ///< in the order of their removal
  std::vector<CollapseLevel>   levels;   ///< the full mesh, then each time the number of vertices has halved
  std::vector<Triangle>        last;     ///< four triangles: a tetrahedron
};

/** Takes a closed genus-0 triangulation apart, one vertex at a time, down to a tetrahedron.
 *
 * In passes over independent vertices, small degrees first; a vertex goes to the ring vertex of smallest degree that
 * meets the link condition, so that every step leaves a closed manifold. The star's area goes to the new triangles,
 * nine tenths by their own area. Positions are used for nothing else. \throws NotConverged when no vertex can be
 * collapsed (cannot happen on a sphere of more than four vertices) */
[[nodiscard]] CollapseSequence
collapseToTetrahedron(const TriangleMesh & surface, const std::vector<double> & areas);

} // namespace moserhex
