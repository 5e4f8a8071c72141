#pragma once

#include "moserhex/Geometry/TriangleMesh.h"

#include <functional>

namespace moserhex::analytic
{

/** Icosahedron split `levels` times, vertices on the sphere: 10 * 4^levels + 2 vertices, 20 * 4^levels triangles,
 * oriented outwards. */
[[nodiscard]] TriangleMesh
icosphere(int levels, double radius = 1.0);

/** Icosphere stretched along the axes: a triangulated ellipsoid with the given semi-axes. */
[[nodiscard]] TriangleMesh
ellipsoidSurface(int levels, const Vector3 & semiAxes);

/** Surface of the cube about the origin, each face `divisions` x `divisions` squares of two triangles, outwards. */
[[nodiscard]] TriangleMesh
cubeSurface(int divisions, double side = 1.0);

/** Torus about the z axis: genus 1, V-E+F = 0, outwards. ringDivisions x tubeDivisions vertices, each at least 3. */
[[nodiscard]] TriangleMesh
torusSurface(int ringDivisions, int tubeDivisions, double ringRadius = 2.0, double tubeRadius = 0.7);

/** A star-shaped surface: every vertex n of the unit icosphere moves to radius(n) * n. */
[[nodiscard]] TriangleMesh
starShapedSurface(int levels, const std::function<double(const Vector3 &)> & radius);

/** The same mesh with its vertices renumbered and its triangles shuffled, from a seed. */
[[nodiscard]] TriangleMesh
renumbered(const TriangleMesh & mesh, std::uint64_t seed);

/** Rotation by `angle` [rad] about `axis`, for tests of rotation invariance. */
[[nodiscard]] Matrix3
rotation(const Vector3 & axis, double angle);

} // namespace moserhex::analytic
