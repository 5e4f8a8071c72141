#pragma once

#include "moserhex/Geometry/TriangleMesh.h"

#include <cstddef>
#include <vector>

namespace moserhex
{

/** A surface with one vertex per place, and what went on the way. */
struct WeldedSurface
{
  TriangleMesh mesh;                    ///< one vertex per place [mm]
  std::size_t  collapsedTriangles{ 0 }; ///< had two corners in one place
  std::size_t  duplicateTriangles{ 0 }; ///< the same three vertices, in the same sense, as one before
};

/** Vertices with equal coordinates become one, in order of first use; unused ones, collapsed triangles and repetitions
 * go. Triangles without area between three places stay: the surface would be open without them.
 *
 * \param mesh  finite coordinates, indices in range
 * \note O(nV log nV + nF log nF) */
[[nodiscard]] WeldedSurface
weldSurface(const TriangleMesh & mesh);

/** The edges that keep a surface from being closed. */
struct SurfaceEdgeCounts
{
  std::size_t boundaryEdges{ 0 }; ///< of one triangle
  std::size_t boundaryLoops{ 0 }; ///< connected sets of these
  std::size_t overusedEdges{ 0 }; ///< of more than two triangles
};
/** Counts edges by the number of their triangles, whatever the triangles' sense. */
[[nodiscard]] SurfaceEdgeCounts
countSurfaceEdges(const TriangleMesh & mesh);

/** A surface whose triangles agree, part by part. */
struct OrientedSurface
{
  TriangleMesh     mesh;                 ///< the same vertices and triangles, some of them turned [mm]
  std::vector<int> part;                 ///< nF: number of the connected part, in order of the first triangle
  int              parts{ 0 };           ///< connected across edges
  std::size_t      turnedTriangles{ 0 }; ///< the smaller number in every part
  bool             orientable{ true };   ///< false: some edge cannot be satisfied, and `mesh` is of no use
};

/** Turns triangles until neighbours agree. Which of its two orientations a part gets is decided by the majority of its
 * triangles, and by the sign of its volume (positive) where both are as many.
 *
 * \param mesh  every edge has exactly two triangles
 * \throws InvalidInput  an edge has not
 * \note O(nF log nF) */
[[nodiscard]] OrientedSurface
orientSurface(const TriangleMesh & mesh);

/** The triangles of every part as a mesh of its own; vertices are renumbered in order of use. */
[[nodiscard]] std::vector<TriangleMesh>
partsOf(const OrientedSurface & surface);

} // namespace moserhex
