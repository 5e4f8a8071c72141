#pragma once

#include "moserhex/Geometry/Pseudonormals.h"

namespace moserhex
{

/** Distance to a closed surface, negative inside. The sign is that of the nearest point's pseudonormal, which is right
 * for every point (Pseudonormals). May be called by several threads at once. */
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
  ClosestPointSearch m_Search;
  Pseudonormals      m_Normals;
};

} // namespace moserhex
