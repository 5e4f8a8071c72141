#pragma once

#include "moserhex/Geometry/TriangleMesh.h"

#include <array>

namespace moserhex
{

/** Finds the spherical triangle that holds a direction, in a triangulation of the unit sphere without flips.
 *
 * A table on the faces of a cube gives a first triangle; from there the search walks across the sides that separate the
 * triangle from the direction. The order in which sides are tried comes from a fixed sequence, so the walk leaves
 * cycles and still is deterministic. About three triangles a query; a scan over all triangles stands behind the walk.
 * Keeps copies of what it needs; locate may be called from many threads. */
class SphereLocator
{
public:
  /** A place in the triangulation. */
  struct Hit
  {
    int     triangle{ -1 };                 ///< its number, in the order given
    Vector3 barycentric{ Vector3::Zero() }; ///< >= 0, sum 1: central projection onto the flat triangle
  };

  /** \throws InvalidInput when the triangulation is empty or not a closed manifold, or a position is not finite */
  SphereLocator(const std::vector<Triangle> & triangles, const Positions & sphere);

  /** The triangle that holds `direction` (any length but zero); on a shared side or vertex, one of the triangles there.
   * \throws InvalidInput when the direction is zero or not finite */
  [[nodiscard]] Hit
  locate(const Vector3 & direction) const;

  /** The same, starting the walk at `startTriangle`: fast when successive directions are close.
   * \throws InvalidInput when there is no such triangle, or the direction is zero or not finite */
  [[nodiscard]] Hit
  locateFrom(const Vector3 & direction, int startTriangle) const;

private:
  [[nodiscard]] int
  cell(const Vector3 & direction) const;
  [[nodiscard]] int
  walk(const Vector3 & direction, int triangle) const;
  [[nodiscard]] int
  scan(const Vector3 & direction) const;
  [[nodiscard]] Vector3
  barycentricIn(const Vector3 & direction, int triangle) const;

  std::vector<Triangle>           m_Triangles;
  Positions                       m_Sphere;
  std::vector<std::array<int, 3>> m_Neighbours;
  int                             m_CellsPerSide{ 0 };
  std::vector<int>                m_FirstTriangle;
};

} // namespace moserhex
