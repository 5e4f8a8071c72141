#pragma once

#include "moserhex/Common/Types.h"

namespace moserhex
{

/** What is taken out of the differences between corresponding points. */
enum class AlignmentKind
{
  None,      ///< nothing: places are compared as they are
  Rigid,     ///< place and turn; size stays
  Similarity ///< place, turn and size
};

/** p -> scale R p + t */
struct SimilarityTransform
{
  double  scale{ 1.0 };                    ///< > 0 [1]
  Matrix3 rotation{ Matrix3::Identity() }; ///< a rotation, never a reflection
  Vector3 translation{ Vector3::Zero() };  ///< [mm]

  [[nodiscard]] Vector3
  operator()(const Vector3 & p) const
  {
    return scale * (rotation * p) + translation;
  }
};

/** Every point carried over. */
[[nodiscard]] Positions
transformed(const SimilarityTransform & transform, const Positions & points);

/** Mean of the points [mm]. \throws InvalidInput  no point */
[[nodiscard]] Vector3
centroidOf(const Positions & points);

/** Centroid size: sqrt(sum |p - centroid|^2), the usual size of a set of landmarks [mm].
 * \throws InvalidInput  no point */
[[nodiscard]] double
centroidSize(const Positions & points);

/** The transform that brings corresponding points together best:
 *
 *   min over (s, R, t) of sum_a |f_a - (s R m_a + t)|^2,      R a rotation, s = 1 unless kind is Similarity
 *   sum_a (f_a - f)(m_a - m)^T = U S V^T,   R = U diag(1, 1, d) V^T,   d = det(U V^T)
 *   s = (S_1 + S_2 + d S_3) / sum_a |m_a - m|^2,              t = f - s R m          f, m the centroids
 *
 * [kabsch1976], with the scale by [umeyama1991, eq. 40-43]. None gives the identity.
 * \param moving  m, at least 3 points [mm] \param fixed  f, as many [mm]
 * \throws InvalidInput  other numbers of points, a coordinate that is not finite, or points on a line or symmetric, for
 * which more than one rotation is best (S_2 + d S_3 <= 1e-9 S_1) */
[[nodiscard]] SimilarityTransform
alignPoints(const Positions & moving, const Positions & fixed, AlignmentKind kind);

} // namespace moserhex
