#include "OrthonormalDesign.h"

#include "moserhex/Common/Errors.h"

#include <Eigen/QR>

#include <cmath>

namespace moserhex
{
namespace
{
using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

constexpr double smallestLeftOver = 1e-10; ///< of an effect's squares, after the nuisance

/** Orthonormal basis of constant and nuisance, the constant first. */
Matrix
nuisanceBasis(const Matrix & nuisance, Eigen::Index subjects)
{
  Matrix result = Matrix::Constant(subjects, 1, 1.0 / std::sqrt(static_cast<double>(subjects)));
  if (nuisance.cols() > 0)
  {
    // Columns of equal length, so that a covariate's unit does not decide its rank.
    Matrix centred = nuisance.rowwise() - nuisance.colwise().mean();
    centred.colwise().normalize();
    const Eigen::ColPivHouseholderQR<Matrix> qr(centred);
    const Eigen::Index                       rank = qr.rank();
    const Matrix                             basis = qr.householderQ() * Matrix::Identity(subjects, rank);
    result.conservativeResize(Eigen::NoChange, 1 + rank);
    result.rightCols(rank) = basis;
  }
  return result;
}

} // namespace

Matrix
OrthonormalDesign::coefficients(const Eigen::Ref<const Matrix> & residuals) const
{
  const Matrix products = effect.transpose() * residuals;
  return mixing.triangularView<Eigen::Upper>().solve(products).transpose();
}

OrthonormalDesign
orthonormalised(const LinearDesign & design)
{
  const Eigen::Index subjects = design.effect.rows();
  const Eigen::Index effects = design.effect.cols();
  OrthonormalDesign  result;
  result.nuisance = nuisanceBasis(design.nuisance, subjects);
  result.effect.resize(subjects, effects);
  result.mixing = Matrix::Zero(effects, effects);
  for (Eigen::Index column = 0; column < effects; ++column)
  {
    const Vector centred = design.effect.col(column).array() - design.effect.col(column).mean();
    Vector       left = centred;
    for (int time = 0; time < 2; ++time) // the second takes the rounding of the first
    {
      left -= result.nuisance * (result.nuisance.transpose() * left);
      const Vector shares = result.effect.leftCols(column).transpose() * left;
      left -= result.effect.leftCols(column) * shares;
      result.mixing.col(column).head(column) += shares;
    }
    if (!(left.squaredNorm() > smallestLeftOver * centred.squaredNorm()))
    {
      throw InvalidInput("permutation test: the effect is constant, or the nuisance explains it");
    }
    result.mixing(column, column) = left.norm();
    result.effect.col(column) = left / result.mixing(column, column);
  }
  return result;
}

} // namespace moserhex
