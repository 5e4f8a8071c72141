#pragma once

#include "moserhex/Common/StepReport.h"
#include "moserhex/Geometry/TriangleMesh.h"

namespace moserhex
{

/** Options of moebiusCentring. */
struct MoebiusCentringOptions
{
  double tolerance{ 1e-12 };  ///< on the norm of the area centroid [1]
  int    maximumSteps{ 100 }; ///< of Newton's method
};

/** What moebiusCentring made. */
struct MoebiusCentringResult
{
  Positions  positions; ///< nV, |s| = 1
  StepReport report;    ///< residual: norm of the area centroid at the end [1]
};

/** Conformal transformation of the sphere that moves a point s by the boost c, |c| < 1:
 *
 *   s -> ((1 - |c|^2) s + 2 (1 + c.s) c) / (1 + 2 c.s + |c|^2)
 */
[[nodiscard]] Vector3
moebiusBoost(const Vector3 & s, const Vector3 & c);

/** The Moebius transformation after which the area centroid sum_i m_i s_i lies at the centre of the sphere, m_i a third
 * of the area on the surface of the triangles at vertex i. It is unique up to a rotation; Newton with the Jacobian
 * sum m_i (I - s_i s_i^T) of the boost finds it in three or four steps. Beyond the paper: it takes away the dependence
 * of the conformal map on scale, on the triangle removed, and most of the area distortion.
 *
 * \throws InvalidInput  sizes differ, or the surface has no area
 * \throws NotConverged  tolerance not met (half of the area in one point) */
[[nodiscard]] MoebiusCentringResult
moebiusCentring(const TriangleMesh & surface, const Positions & sphere, const MoebiusCentringOptions & options = {});

} // namespace moserhex
