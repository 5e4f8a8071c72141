#pragma once

#include "moserhex/ShapeStatistics/SubjectTable.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace moserhex
{

/** What is asked of the subjects' numbers: y = constant + nuisance g + effect b + error. */
struct LinearDesign
{
  Eigen::MatrixXd effect;   ///< N x h, tested together: 0 and 1 for two groups, a covariate, or groupColumns
  Eigen::MatrixXd nuisance; ///< N x z, what else explains the numbers, without the constant; may have no columns
};

/** Options of permutationTest. */
struct PermutationOptions
{
  std::size_t   permutations{ 10000 };   ///< >= 1; all there are, when these are not more
  std::uint64_t seed{ 1 };               ///< of the permutations
  std::size_t   componentsPerPlace{ 3 }; ///< q: columns of the table that belong to one place, 1 to 3
  unsigned int  threads{ 0 };            ///< 0: all; the result does not depend on it
};

/** One entry for each of the L places. */
struct PermutationResult
{
  Eigen::MatrixXd slope;           ///< q h x L: b, q for each column of the effect: group 1 less group 0, or change per
                                   ///< unit of the covariate [unit of y]
  Eigen::VectorXd pillaiTrace;     ///< V, in [0,s] [1]
  Eigen::VectorXd statistic;       ///< df V / (s - V), of one column Hotelling's T^2, of one component, too, t^2 [1]
  Eigen::VectorXd p;               ///< of the place alone
  Eigen::VectorXd pFamilyWise;     ///< corrected for the search over all places, by the largest statistic
  Eigen::VectorXd qFalseDiscovery; ///< smallest false discovery rate at which the place counts
  Eigen::VectorXd partialCorrelation; ///< sqrt(V / s), of one number and one effect with the slope's sign; its square
                                      ///< is the partial eta squared [1]
  Eigen::VectorXd standardisedDifference; ///< effect of two values: Cohen's d with its sign, of vectors Mahalanobis' D;
                                          ///< else empty [1]
  std::size_t permutations{ 0 };          ///< made, the subjects' own order among them
  bool        areAllOrders{ false };      ///< all that there are were made
  bool        isExact{ false };       ///< the p are exact: all orders were made, and there is no nuisance but constants
  double      smallestPossibleP{ 1 }; ///< below it no p and no pFamilyWise can be with these orders, whatever the data
  std::size_t degreesOfFreedom{ 0 };  ///< N less the rank of constant, nuisance and effect
  std::vector<std::size_t> nuisanceLeftOut; ///< its columns that are constant, or explained by those before them
};

/** Tests at every place whether an effect explains the subjects' numbers, beyond a constant and nuisance covariates.
 *
 *   V = tr(H (H + W)^-1),    H, W the q x q sums of squares that the effect explains, and that are left
 *   h = 1:  T^2 = df V / (1 - V) = b^T Sigma^-1 b / c,    Sigma = W / df,    c = variance of b over Sigma
 *
 * V is Pillai's trace [pillai1955], in [0,s], s = min(q,h); with the k - 1 columns of k groups (groupColumns) the test
 * is a one-way MANOVA at every place, with two groups Hotelling's.
 *
 * Permutations by Freedman and Lane [freedman1983; winkler2014]: what is left of y after the nuisance is permuted over
 * the subjects, and the full model is fitted again. Everything is projected before, so that a permutation costs one
 * product with the orthonormal design, and the residuals are whitened by their own scatter, to which 1e-12 of its trace
 * is added (places where the subjects do not vary in some direction). V is the part of the whitened residuals that the
 * effect explains.
 *
 * p = part of the permutations, the subjects' own order among them, with a V at least as large [phipson2010]; family-
 * wise: with a largest V over all places at least as large [nichols2002]; q: Benjamini and Hochberg. Subjects of
 * equal effect and nuisance are interchangeable: when there are no more different orders than `permutations`, all are
 * made, and without nuisance the p are exact (with it they are asymptotically, as residuals of a fit are permuted).
 * Null hypotheses of all places but those with an effect may hold: control is strong.
 *
 * Orders whose effect, without what the nuisance explains, spans the subjects' own have a V at least as large, whatever
 * the data: two groups of one size that change places. So p is at least the part of such orders (smallestPossibleP):
 * 2 / 70 of 4 against 4 subjects, 1 / 35 of 4 against 3.
 *
 * Columns of the nuisance that are constant (they vary by less than 1e-10 of their length), or of which those before
 * leave less than 1e-5 of the length about the mean, are left out: they take nothing away, and no degree of freedom.
 *
 * \throws InvalidInput  other numbers of subjects, more than 65535, fewer degrees of freedom than q, a number of the
 * design or the table that is not finite, no effect, or a column of it that is constant or explained by the nuisance
 * and the columns before it, or options out of range \note O(permutations N L q (h + z)) time, memory of some blocks of
 * places and 2 N + 8 L / 256 bytes a permutation. Permutation k depends on seed and k only. Deterministic for any
 * number of threads. */
[[nodiscard]] PermutationResult
permutationTest(const SubjectTable & table, const LinearDesign & design, const PermutationOptions & options = {});

/** Finds what permutationTest would refuse of a design before there are any data for it.
 * \param componentsPerPlace  q, 1 to 3 \throws InvalidInput  as permutationTest, of what the design alone decides */
void
requireTestable(const LinearDesign & design, std::size_t componentsPerPlace = 3);

/** q-values of Benjamini and Hochberg [benjamini1995]: q_(i) = min over j >= i of min(1, m p_(j) / j), p ascending. */
[[nodiscard]] Eigen::VectorXd
falseDiscoveryRates(const Eigen::VectorXd & p);

} // namespace moserhex
