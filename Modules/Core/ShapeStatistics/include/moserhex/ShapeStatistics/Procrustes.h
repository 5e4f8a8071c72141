#pragma once

#include "moserhex/Common/StepReport.h"
#include "moserhex/Geometry/RigidAlignment.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace moserhex
{

/** sqrt(sum |p - centroid|^2), the usual size of a set of landmarks [mm]. \throws InvalidInput  no point */
[[nodiscard]] double
centroidSize(const Positions & points);

/** The points of a subject, the same number and order for all [mm]. Called by several threads at once, once for every
 * subject and step: subjects need not be in memory together. */
using SubjectLoader = std::function<Positions(std::size_t subject)>;

/** Options of generalisedProcrustes. */
struct ProcrustesOptions
{
  AlignmentKind kind{ AlignmentKind::Rigid }; ///< what is taken away of the subjects' differences
  double        tolerance{ 1e-10 };           ///< done when the mean moves by less, over its centroid size [1]
  int           maximumSteps{ 100 };          ///< >= 1: alignments of all subjects, each with a new mean
  unsigned int  threads{ 0 };                 ///< 0: all; the result does not depend on it
};

/** What generalisedProcrustes found. */
struct ProcrustesResult
{
  Positions                        mean;             ///< of the aligned subjects [mm]
  double                           size{ 0.0 };      ///< mean centroid size of the subjects as they are [mm]
  std::vector<SimilarityTransform> transforms;       ///< of every subject onto the mean
  double                           deviation{ 0.0 }; ///< rms distance of aligned points to the mean's [mm]
  StepReport                       report;           ///< residual: last move of the mean over its centroid size [1]
};

/** Brings a subject onto a mean by rigidAlignment; with Similarity the scale is size / (its centroid size), so that
 * every subject gets the same size and none shrinks because it fits badly. None gives the identity.
 * \throws InvalidInput  as rigidAlignment */
[[nodiscard]] SimilarityTransform
alignToMean(const Positions & subject, const Positions & mean, AlignmentKind kind, double size);

/** Generalised Procrustes analysis [gower1975]: rotations and translations (and sizes made equal) that minimise
 *
 *   sum over subjects i, points a of |T_i x_ia - m_a|^2,     m the mean of T_i x_i
 *
 * by turns: every subject onto the mean, then the mean anew. Starts from the plain mean, so the result keeps the
 * patients' axes and does not depend on which subject comes first; from the first subject where the subjects' turns
 * differ so much that their plain mean is degenerate. With None: one step, the plain mean.
 *
 * \param count  of subjects, >= 1
 * \throws InvalidInput  no subject, other numbers of points, tolerance or steps out of range, or as rigidAlignment
 * (names the subject) \note `converged` is false when the tolerance is not met. O(points) memory. Deterministic for any
 * number of threads.
 */
[[nodiscard]] ProcrustesResult
generalisedProcrustes(std::size_t count, const SubjectLoader & load, const ProcrustesOptions & options = {});

} // namespace moserhex
