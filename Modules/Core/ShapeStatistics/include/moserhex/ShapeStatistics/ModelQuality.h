#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace moserhex
{

/** Options of modelQuality. */
struct ModelQualityOptions
{
  std::size_t   maximumModes{ 0 }; ///< M; 0, or more than there are: all
  std::size_t   samples{ 1000 };   ///< of the model, for specificity
  std::uint64_t seed{ 1 };         ///< of the samples' scores
  unsigned int  threads{ 0 };      ///< 0: all; the result does not depend on it
};

/** How good a correspondence is, by the model made with it [davies2002]; entry m - 1 for m modes, M entries. Distances
 * of shapes are root mean squares over their points. */
struct ModelQuality
{
  std::vector<double> compactness;         ///< part of the variance in the first m modes; large is good [1]
  std::vector<double> generalisation;      ///< distance of a subject to the model of the others; small is good [mm]
  std::vector<double> generalisationError; ///< standard error of that mean over the subjects [mm]
  std::vector<double> specificity;         ///< distance of random shapes to the nearest subject; small is good [mm]
  std::vector<double> specificityError;    ///< standard error of that mean over the samples [mm]
};

/** Mean of every column, and its standard error, 0 for a single row. */
struct ColumnMeans
{
  std::vector<double> mean;  ///< of every column
  std::vector<double> error; ///< standard error of the mean, of every column
};

/** \param values  a row for each observation */
[[nodiscard]] ColumnMeans
columnMeans(const Eigen::MatrixXd & values);

/** Scores b_k ~ N(0, variance_k) of a random shape of a model; they depend on k, sample and seed only, so those of
 * fewer modes are the first of those of more [mm]. \param variances  of modes, >= 0 [mm^2] */
[[nodiscard]] Eigen::VectorXd
randomScores(const Eigen::VectorXd & variances, std::size_t sample, std::uint64_t seed);

/** Compactness, generalisation and specificity as functions of the number of modes.
 *
 * Generalisation leaves every subject out once. The scatter of the others is a change of rank one,
 *
 *   S_i = D - rho y_i y_i^T,    D = diag(d) the scatter of all,    rho = N / (N-1),    y_i the scores of subject i
 *
 * so that its variances are the roots mu of the secular equation 1 = rho sum_j y_j^2 / (d_j - mu), one between each two
 * d, and what a mode of theirs explains of the subject (rho y_i from their mean) is 1 / sum_j y_j^2 / (d_j - mu)^2
 * [golub1973]: O(N M r) a subject instead of a decomposition. A mu of at most 1e-10 of the largest d is 0: a direction
 * that only subject i spans, no mode of the others. The subjects stay aligned as they are.
 *
 * Specificity draws randomScores of k <= m modes; a sample has the same b_k for every m.
 *
 * \param scores  N x r, of all modes, uncorrelated with mean 0: ShapeModelResult::scores [mm]
 * \param points  of a shape, > 0
 * \throws InvalidInput  fewer than 3 subjects, no modes, no points, no samples
 * \note O(N^2 M r + samples N M) time. Deterministic for any number of threads. */
[[nodiscard]] ModelQuality
modelQuality(const Eigen::MatrixXd & scores, std::size_t points, const ModelQualityOptions & options = {});

} // namespace moserhex
