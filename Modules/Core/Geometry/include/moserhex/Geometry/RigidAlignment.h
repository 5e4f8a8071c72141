#pragma once

#include "moserhex/Common/Types.h"

namespace moserhex
{

/** What of the difference between two sets of corresponding points is taken away before they are compared. */
enum class AlignmentKind
{
  None,      ///< nothing: they have the same frame already
  Rigid,     ///< place and turn; size stays
  Similarity ///< place, turn and size
};

/** x -> s R x + t. Rigid where s = 1. */
struct SimilarityTransform
{
  double  scale{ 1.0 };                    ///< s > 0 [1]
  Matrix3 rotation{ Matrix3::Identity() }; ///< R, det R = +1 [1]
  Vector3 translation{ Vector3::Zero() };  ///< t [mm]

  /** s R x + t [mm]. */
  [[nodiscard]] Vector3
  operator()(const Vector3 & x) const
  {
    return scale * (rotation * x) + translation;
  }

  /** Of the rotation, 0 to 180 [degree]. */
  [[nodiscard]] double
  angle() const;

  /** What takes s R x + t back to x. */
  [[nodiscard]] SimilarityTransform
  inverse() const;
};

/** The rotation and translation that bring points nearest to others, pair by pair, in the sense of least squares:
 *
 *   minimise  sum_a |R x_a + t - y_a|^2  over R, t with det R = +1
 *   sum_a (y_a - mean y)(x_a - mean x)^T = U S V^T,   R = U diag(1, 1, det U V^T) V^T,   t = mean y - R mean x
 *
 * Kabsch, Acta Cryst. A32 (1976) 922; the sign of Umeyama, IEEE PAMI 13 (1991) 376, so a reflection never comes out.
 * \param moving  x, n x 3 [mm] \param fixed  y, n x 3 [mm]
 * \throws InvalidInput  sizes differ, a coordinate is not finite, or the rotation is not determined: the points lie on
 * a line (fewer than three do), or a mirror image of them is as near as they are
 * \note O(n). Deterministic. */
[[nodiscard]] SimilarityTransform
rigidAlignment(const Positions & moving, const Positions & fixed);

/** The same with a scale, s = tr(S diag(1, 1, det U V^T)) / sum_a |x_a - mean x|^2 (Umeyama's eq. 42),
 * t = mean y - s R mean x. \throws InvalidInput  as rigidAlignment */
[[nodiscard]] SimilarityTransform
similarityAlignment(const Positions & moving, const Positions & fixed);

/** Every point moved. \return n x 3 [mm] */
[[nodiscard]] Positions
transformed(const Positions & points, const SimilarityTransform & transform);

} // namespace moserhex
