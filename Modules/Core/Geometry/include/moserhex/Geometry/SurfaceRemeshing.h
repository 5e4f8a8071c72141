#pragma once

#include "moserhex/Common/StepReport.h"
#include "moserhex/Geometry/TriangleMesh.h"

#include <cstddef>
#include <functional>

namespace moserhex
{

/** Maps a point near a surface to a point on it. Must be safe to call from several threads. */
using PointProjection = std::function<Vector3(const Vector3 &)>;

/** Options of remeshSurface. */
struct SurfaceRemeshingOptions
{
  double targetEdgeLength{ 0.0 }; ///< L; needed when sizingRounds > 0 [mm]
  int    sizingRounds{ 6 };       ///< rounds of split, collapse, flip, relax [1]
  int    smoothingRounds{ 4 };    ///< rounds of flip, relax that follow [1]
  double splitRatio{ 1.4 };       ///< sides longer than this times L are halved [1]
  double collapseRatio{ 0.75 };   ///< sides shorter than this times L are collapsed [1]
  double relaxation{ 0.5 };       ///< step of the smoothing rounds towards the centroid of the neighbours, in (0,1] [1]
};

/** What remeshSurface made. */
struct SurfaceRemeshingResult
{
  TriangleMesh mesh;           ///< closed, outward, of the genus of the input [mm]
  std::size_t  splits{ 0 };    ///< sides halved, over all rounds
  std::size_t  collapses{ 0 }; ///< sides collapsed, over all rounds
  std::size_t  flips{ 0 };     ///< sides flipped, over all rounds
  StepReport   report; ///< converged: no side is left that wants a flip; residual: number of sides that want one
};

/** Even, Delaunay triangulation of a closed surface with the topology of the input.
 *
 * Per round: sides longer than splitRatio L are halved; sides shorter than collapseRatio L are collapsed, shortest
 * first, if the link condition holds (the common neighbours of the ends are exactly the two opposite corners), no
 * triangle turns by more than 73 degrees and no side becomes longer than 1.5 L; sides with
 * cot(alpha) + cot(beta) < 0 at the opposite corners are flipped (Delaunay); vertices move in their tangent plane
 * towards the area-weighted centroid of their triangles and are then projected.
 * Every operation keeps the surface closed, manifold and its genus.
 *
 * \param surface  closed, manifold, outward                                nV x 3 [mm], nF x 3
 * \param project  onto the smooth surface that is meshed; empty: stay where relaxation ends
 * \throws InvalidInput  options out of range; surface not closed and manifold (see triangleTopology)
 * \note Deterministic. Positions move by the projection and by O(L^2 curvature); with no projection a coarse mesh
 *       shrinks slightly. */
[[nodiscard]] SurfaceRemeshingResult
remeshSurface(const TriangleMesh &            surface,
              const SurfaceRemeshingOptions & options,
              const PointProjection &         project = {});

/** Numbers that decide whether a triangulation is fit for cotangent weights. */
struct SurfaceQualitySummary
{
  double      minimumAngle{ 0.0 };     ///< smallest corner [degree]
  double      smallestArea{ 0.0 };     ///< of a triangle, over the mean [1]
  double      largestArea{ 0.0 };      ///< of a triangle, over the mean [1]
  double      largestCrease{ 0.0 };    ///< angle between the normals of two neighbours [degree]
  std::size_t negativeCotangents{ 0 }; ///< sides with cot(alpha) + cot(beta) < -1e-9
};

/** \throws InvalidInput  surface not closed and manifold (see triangleTopology) */
[[nodiscard]] SurfaceQualitySummary
summarizeSurfaceQuality(const TriangleMesh & surface);

} // namespace moserhex
