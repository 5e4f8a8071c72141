#pragma once

#include "moserhex/ShapeStatistics/PermutationTest.h"

namespace moserhex
{

/** Orthonormal columns: constant and nuisance, then what is left of the effect. */
struct OrthonormalDesign
{
  Eigen::MatrixXd          nuisance;        ///< N x (rank of constant and nuisance); the first is the constant
  Eigen::MatrixXd          effect;          ///< N x h
  Eigen::MatrixXd          mixing;          ///< h x h, upper triangular: what is left of the effect is effect x mixing
  std::vector<std::size_t> nuisanceLeftOut; ///< as PermutationResult has it

  /** Least squares for numbers of which the nuisance is taken out. \return q x h, a column for each effect
   * \param residuals  N x q */
  [[nodiscard]] Eigen::MatrixXd
  coefficients(const Eigen::Ref<const Eigen::MatrixXd> & residuals) const;
};

/** By Gram and Schmidt, done twice. A column that varies by less than 1e-10 of its length is constant; one of which
 * the columns before it leave less than 1e-5 of its length about the mean is explained by them: a nuisance so is left
 * out. \pre sizes as permutationTest demands
 * \throws InvalidInput  a column of the effect is constant, or explained by the nuisance and the columns before it */
[[nodiscard]] OrthonormalDesign
orthonormalised(const LinearDesign & design);

} // namespace moserhex
