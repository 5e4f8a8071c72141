#pragma once

#include "moserhex/Common/Types.h"
#include "moserhex/ShapeStatistics/SubjectTable.h"

#include <vector>

namespace moserhex
{

/** Shapes as a mean and a few directions of change: x = mean + modes b, D = 3 x (number of points) coordinates. */
struct ShapeModel
{
  Eigen::VectorXd mean;                 ///< D [mm]
  Eigen::MatrixXd modes;                ///< D x K, orthonormal columns [1]
  Eigen::VectorXd variances;            ///< K, of the subjects' scores b, descending, > 0 [mm^2]
  double          totalVariance{ 0.0 }; ///< of all modes there are, also those not kept [mm^2]
};

/** Options of fitShapeModel. */
struct ShapeModelOptions
{
  std::size_t  maximumModes{ 0 };       ///< kept; 0: no such limit
  double       varianceFraction{ 1.0 }; ///< in (0,1]: so many modes as hold this part of the total variance [1]
  std::size_t  slabBytes{ std::size_t{ 16 } << 20 }; ///< of one slab of the table; four are in memory
  unsigned int threads{ 0 };                         ///< 0: all; the result does not depend on it
};

/** What fitShapeModel found. */
struct ShapeModelResult
{
  ShapeModel model; ///< with the modes kept
  /** N x r, scores of the subjects in all r <= N - 1 modes there are, of which the first K were kept [mm]. */
  Eigen::MatrixXd scores;
  Eigen::VectorXd variances; ///< r, of all modes, descending [mm^2]
};

/** Principal components of shapes, for far fewer subjects than coordinates [cootes1995].
 *
 *   G = X X^T,   G v_k = (N-1) lambda_k v_k,   mode_k = X^T v_k / sqrt((N-1) lambda_k),   b_ik = sqrt((N-1) lambda_k)
 * v_ik
 *
 * X the N x D matrix of the subjects less their mean. Two passes over the table: mean and G, then the modes. The sign
 * of a mode is that which makes its component of largest magnitude (the first among equals) positive. Modes below 1e-10
 * of the largest variance are rounding, as G squares the numbers, and are left out.
 *
 * \throws InvalidInput  fewer than two subjects, a value that is not finite, subjects that are all the same (their root
 * mean square distance to the mean is below 1e-12 of the mean's length, which is rounding), or options out of range
 * \throws NotConverged  the eigenvalues were not found
 * \note O(N^2 D + N^3) time; memory of slabs, G and the modes kept. Deterministic for any number of threads. */
[[nodiscard]] ShapeModelResult
fitShapeModel(const SubjectTable & table, const ShapeModelOptions & options = {});

/** b = modes^T (x - mean): K scores of a shape, aligned as the model's subjects were [mm].
 * \throws InvalidInput  another number of coordinates */
[[nodiscard]] Eigen::VectorXd
scoresOf(const ShapeModel & model, const Eigen::VectorXd & shape);

/** mean + modes b; missing scores at the end are 0 [mm].
 * \throws InvalidInput  more scores than modes */
[[nodiscard]] Eigen::VectorXd
reconstruct(const ShapeModel & model, const Eigen::VectorXd & scores);

/** The mean changed by so many standard deviations of one mode [mm].
 * \throws InvalidInput  no such mode */
[[nodiscard]] Eigen::VectorXd
shapeAlongMode(const ShapeModel & model, std::size_t mode, double standardDeviations);

/** Covariance of the place of every point over the subjects, divisor N - 1, one pass over the table [mm^2].
 * \throws InvalidInput  fewer than two subjects, or a number of columns that is no multiple of 3 */
[[nodiscard]] std::vector<Matrix3>
pointCovariances(const SubjectTable & table, unsigned int threads = 0);

/** Points one after the other, 3 x (number of points) coordinates, and back. */
[[nodiscard]] Eigen::VectorXd
coordinatesOf(const Positions & points);
/** The inverse of coordinatesOf: entries 3 a, 3 a + 1, 3 a + 2 are point a. */
[[nodiscard]] Positions
pointsOf(const Eigen::VectorXd & coordinates);

} // namespace moserhex
