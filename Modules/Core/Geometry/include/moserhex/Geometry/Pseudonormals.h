#pragma once

#include "moserhex/Geometry/ClosestPoint.h"

#include <array>
#include <vector>

namespace moserhex
{

/** Normals n of a closed surface at its nearest points q to others, p, such that (p - q) . n < 0 exactly where p is
 * inside: of the triangle, the sum of two triangles' normals on an edge, their sum weighted by the angles at a vertex
 * (Baerentzen and Aanaes, IEEE TVCG 11 (2005) 243). At an edge or vertex the normal of a single triangle, or an
 * interpolated one anywhere, may point to the wrong side. May be asked by several threads at once. */
class Pseudonormals
{
public:
  /** \param surface  closed, oriented outwards, without degenerate triangles and self-intersection
   * \throws InvalidInput  an edge has not two triangles \note O(nF log nF) */
  explicit Pseudonormals(const TriangleMesh & surface);

  /** Not of unit length. \param nearest  a point of the surface, as ClosestPointSearch gives it */
  [[nodiscard]] Vector3
  at(const ClosestPointOnSurface & nearest) const;

private:
  std::vector<Triangle>               m_Triangles;
  Positions                           m_FaceNormals;
  std::vector<std::array<Vector3, 3>> m_EdgeNormals; ///< per triangle, of the edge opposite to each corner
  Positions                           m_VertexNormals;
};

} // namespace moserhex
