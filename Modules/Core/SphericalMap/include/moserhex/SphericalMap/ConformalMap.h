#pragma once

#include "moserhex/Common/StepReport.h"
#include "moserhex/Geometry/TriangleMesh.h"

#include <optional>

namespace moserhex
{

/** Edge weights of the discrete Laplacian D. */
enum class LaplacianWeights
{
  Cotangent,       ///< the paper's: conformal in the limit, may flip triangles of bad meshes
  ClampedCotangent ///< forced into [smallestWeight, largestWeight]: an embedding of the plane for any mesh
};

/** Options of conformalSphereMap. */
struct ConformalMapOptions
{
  Vector3 removedDirection{
    Vector3::UnitZ()
  };                                       ///< the triangle removed lies this way from the surface's centroid [LPS]
  std::optional<Vector3> removedNearPoint; ///< when set: the triangle nearest to this point instead [mm]
  LaplacianWeights       weights{ LaplacianWeights::Cotangent }; ///< of the Laplacian
  double                 smallestWeight{ 1e-2 };                 ///< of clamped weights [1]
  double                 largestWeight{ 1e2 };                   ///< of clamped weights [1]
};

/** What conformalSphereMap made. */
struct ConformalMapResult
{
  Positions  positions;             ///< nV, unit vectors; the removed triangle lies around the north pole
  int        removedTriangle{ -1 }; ///< triangle ABC
  int        flippedTriangles{ 0 }; ///< of the map on the sphere
  StepReport report;                ///< residual: relative residual of the linear systems [1]
};

/** The most regular triangle among those within about 15 degrees of `direction` seen from the surface's centroid (the
 * one nearest in direction when the surface lies elsewhere). A sliver here makes a poor map. */
[[nodiscard]] int
triangleTowards(const TriangleMesh & surface, const Vector3 & direction);

/** The triangle whose centroid is closest to `point`: chains the shells as in the paper, shell k after shell k+1. */
[[nodiscard]] int
triangleNear(const TriangleMesh & surface, const Vector3 & point);

/** Conformal map of a closed genus-0 surface to the unit sphere (Angenent and Haker; the paper's equations).
 *
 * Triangle ABC is removed and two systems with one Cholesky factor are solved for the plane coordinates,
 *
 *   D x = a,  D y = b,      D_PQ = -(cot R + cot S) / 2,   D 1 = 0,
 *   a_A = -1/|B-A|,  a_B = 1/|B-A|,  b_A = (1-theta)/|C-E|,  b_B = theta/|C-E|,  b_C = -1/|C-E|,
 *   theta = <B-A, C-A> / |B-A|^2,   E = A + theta (B-A),
 *
 * then medians are subtracted, the median radius becomes 1, and the plane goes to the sphere by inverse stereographic
 * projection. The paper prints b_C = +1/|C-E|; a solution exists only when the entries of b sum to zero, so it is -1.
 * D is singular (constants): 1 is added to one diagonal entry, which pins the constant and changes nothing else.
 * Orientation: most solid angles positive.
 *
 * \throws InvalidInput  not a closed sphere, a position that is not finite, or triangle ABC degenerate
 * \throws NotConverged  the factorisation failed, or the map is not finite
 * \note Order 1 to 2 in mesh size (angles); O(nV^1.5) time. Deterministic. Triangles may be flipped: see the result. */
[[nodiscard]] ConformalMapResult
conformalSphereMap(const TriangleMesh & surface, const ConformalMapOptions & options = {});

} // namespace moserhex
