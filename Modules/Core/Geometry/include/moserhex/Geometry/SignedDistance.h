#pragma once

#include "moserhex/Geometry/ClosestPoint.h"

#include <array>
#include <vector>

namespace moserhex
{

/** Distance to a closed surface, negative inside.
 *
 * The sign is that of (p - q) . n, q the nearest point and n the pseudonormal there: of the triangle, the sum of two
 * triangles' normals on an edge, their sum weighted by the angles at a vertex. That sign is right for every point
 * (Baerentzen and Aanaes, IEEE TVCG 11 (2005) 243); at an edge or vertex that of a single triangle is not.
 * May be called by several threads at once. */
class SignedDistance
{
public:
  /** \param surface  closed, oriented outwards, without degenerate triangles and self-intersection
   * \throws InvalidInput  there is no triangle, or an edge has not two \note O(nF log nF) */
  explicit SignedDistance(const TriangleMesh & surface);

  /** \param p  [mm] \return [mm], positive outside, 0 on the surface */
  [[nodiscard]] double
  operator()(const Vector3 & p) const;

private:
  [[nodiscard]] Vector3
  pseudonormal(const ClosestPointOnSurface & nearest) const;

  ClosestPointSearch                  m_Search;
  std::vector<Triangle>               m_Triangles;
  Positions                           m_FaceNormals;
  std::vector<std::array<Vector3, 3>> m_EdgeNormals; ///< per triangle, of the edge opposite to each corner
  Positions                           m_VertexNormals;
};

} // namespace moserhex
