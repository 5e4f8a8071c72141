#pragma once

#include "moserhex/ShapeStatistics/PermutationTest.h"

#include <vector>

namespace moserhex
{

/** The effect of k groups, N x (k - 1): column g is 1 for the subjects of group g + 1 and else 0, so that its slope is
 * that group's mean less the mean of group 0. \param groups  of every subject, 0 to k - 1
 * \throws InvalidInput  k < 2, or a group out of range */
[[nodiscard]] Eigen::MatrixXd
groupColumns(const std::vector<std::size_t> & groups, std::size_t k);

/** Displacement of every group's mean from the mean of all subjects, q x L each, from the slopes of groupColumns:
 *
 *   d_g = b_g - sum_f (N_f / N) b_f,    b_0 = 0
 *
 * The sizes' weighted sum of all is zero. With a nuisance its influence is taken out: that is how the groups' means
 * would lie if all groups had the same. \param slopes  q (k - 1) x L \param sizes  N_g of the k groups
 * \throws InvalidInput  other numbers of groups, or no subject */
[[nodiscard]] std::vector<Eigen::MatrixXd>
groupDisplacements(const Eigen::MatrixXd & slopes, const std::vector<std::size_t> & sizes);

} // namespace moserhex
