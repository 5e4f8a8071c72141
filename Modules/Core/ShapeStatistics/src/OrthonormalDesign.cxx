#include "OrthonormalDesign.h"

#include "moserhex/Common/Errors.h"

#include <cmath>
#include <optional>

namespace moserhex
{
namespace
{
using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

constexpr double smallestVariation = 1e-20; ///< of a column's squares, about its mean: below it is constant
constexpr double smallestLeftOver = 1e-10;  ///< of a column's squares about its mean, after those before it

/** Adds what the basis does not hold of a column to it, by Gram and Schmidt, done twice.
 * \param basis  orthonormal, the constant first \return the column's parts along the basis, the new one the last;
 * nothing where next to nothing is left: the basis stays as it is */
std::optional<Vector>
addColumn(Matrix & basis, const Vector & column)
{
  const Vector centred = column.array() - column.mean();
  if (!(centred.squaredNorm() > smallestVariation * column.squaredNorm()))
  {
    return std::nullopt;
  }
  const Eigen::Index size = basis.cols();
  Vector             parts = Vector::Zero(size + 1);
  Vector             left = centred;
  for (int time = 0; time < 2; ++time) // the second takes the rounding of the first
  {
    const Vector shares = basis.transpose() * left;
    left -= basis * shares;
    parts.head(size) += shares;
  }
  if (!(left.squaredNorm() > smallestLeftOver * centred.squaredNorm()))
  {
    return std::nullopt;
  }
  parts[size] = left.norm();
  basis.conservativeResize(Eigen::NoChange, size + 1);
  basis.col(size) = left / parts[size];
  return parts;
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
  Matrix             basis = Matrix::Constant(subjects, 1, 1.0 / std::sqrt(static_cast<double>(subjects)));
  for (Eigen::Index column = 0; column < design.nuisance.cols(); ++column)
  {
    if (!addColumn(basis, design.nuisance.col(column)))
    {
      result.nuisanceLeftOut.push_back(static_cast<std::size_t>(column));
    }
  }
  result.nuisance = basis;
  result.mixing = Matrix::Zero(effects, effects);
  for (Eigen::Index column = 0; column < effects; ++column)
  {
    const std::optional<Vector> parts = addColumn(basis, design.effect.col(column));
    if (!parts)
    {
      throw InvalidInput("permutation test: the effect is constant, or the nuisance explains it");
    }
    result.mixing.col(column).head(column + 1) = parts->tail(column + 1);
  }
  result.effect = basis.rightCols(effects);
  return result;
}

} // namespace moserhex
