#pragma once

#include "moserhex/Common/Types.h"

#include <array>
#include <vector>

namespace moserhex
{

/** Vertex numbers, counter-clockwise seen from outside. */
using Triangle = std::array<VertexIndex, 3>;

/** A triangulated surface. Closed surfaces are oriented outwards: counter-clockwise seen from outside. */
struct TriangleMesh
{
  Positions             vertices;  ///< nV x 3 [mm]
  std::vector<Triangle> triangles; ///< nF x 3
};

/** Half the norm of the cross product of two edges [mm^2]. */
[[nodiscard]] double
triangleArea(const Vector3 & a, const Vector3 & b, const Vector3 & c);

/** Area of every triangle, nF [mm^2]. */
[[nodiscard]] std::vector<double>
triangleAreas(const TriangleMesh & mesh);

/** Sum of the areas of the triangles [mm^2]. */
[[nodiscard]] double
surfaceArea(const TriangleMesh & mesh);

/** Signed volume enclosed by a closed mesh (divergence theorem); positive when oriented outwards [mm^3]. */
[[nodiscard]] double
enclosedVolume(const TriangleMesh & mesh);

/** Area-weighted centroid of the surface [mm]. */
[[nodiscard]] Vector3
surfaceCentroid(const TriangleMesh & mesh);

/** Unit normals, area-weighted over the incident triangles, nV. Zero where all incident triangles are degenerate. */
[[nodiscard]] Positions
vertexNormals(const TriangleMesh & mesh);

/** Axis-aligned bounding box; both corners zero for an empty set. */
struct BoundingBox
{
  Vector3 lower{ Vector3::Zero() }; ///< smallest coordinate along each axis [mm]
  Vector3 upper{ Vector3::Zero() }; ///< largest coordinate along each axis [mm]
};
/** The smallest box that holds all points [mm]. */
[[nodiscard]] BoundingBox
boundingBox(const Positions & points);

} // namespace moserhex
