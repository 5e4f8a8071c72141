#include "moserhex/ShapeStatistics/ShapeModel.h"

#include "Slabs.h"

#include <Eigen/Eigenvalues>

#include <array>
#include <cmath>

namespace moserhex
{
namespace
{
using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

/** Of the largest variance; below it is rounding. */
constexpr double smallestVariance = 1e-10;

/** Of the mean's length. Copies of one shape that lie elsewhere and are turned differ after alignment by the rounding
 * of their coordinates and turns, some 1e-16 to 1e-14 of that; no measurement is so precise. */
constexpr double smallestDeviation = 1e-12;

constexpr std::size_t covarianceSlabBytes = std::size_t{ 4 } << 20;

Eigen::Index
signedIndex(std::size_t index)
{
  return static_cast<Eigen::Index>(index);
}

void
requireArguments(const SubjectTable & table, const ShapeModelOptions & options)
{
  if (table.subjects() < 2 || table.columns() == 0)
  {
    throw InvalidInput("shape model: " + std::to_string(table.subjects()) + " subjects with " +
                       std::to_string(table.columns()) + " coordinates, need at least 2 and 1");
  }
  if (!(options.varianceFraction > 0.0 && options.varianceFraction <= 1.0) || options.slabBytes == 0)
  {
    throw InvalidInput("shape model: the part of the variance must be in (0,1], and a slab have some bytes");
  }
}

/** G, and the mean: the first pass. */
Matrix
gramMatrix(const SubjectTable & table, const ShapeModelOptions & options, Vector & mean)
{
  const auto                      subjects = signedIndex(table.subjects());
  std::array<Matrix, slabsAtOnce> parts;
  Matrix                          gram = Matrix::Zero(subjects, subjects);
  mean.resize(signedIndex(table.columns()));
  forEachSlab(
    table,
    slabColumns(table, options.slabBytes),
    options.threads,
    [&](std::size_t slot, std::size_t first, std::size_t count) {
      Eigen::RowVectorXd slabMean;
      const Matrix       slab = centredSlab(table, first, count, slabMean);
      mean.segment(signedIndex(first), signedIndex(count)) = slabMean.transpose();
      parts[slot] = Matrix::Zero(subjects, subjects);
      parts[slot].selfadjointView<Eigen::Lower>().rankUpdate(slab);
    },
    [&](std::size_t slot) { gram += parts[slot]; });
  return gram;
}

/** How many modes hold the part of the variance that is wanted. */
std::size_t
modesToKeep(const Vector & variances, const ShapeModelOptions & options)
{
  const double wanted = options.varianceFraction * variances.sum();
  double       held = 0.0;
  std::size_t  count = 0;
  while (count < static_cast<std::size_t>(variances.size()) && held < wanted)
  {
    held += variances[signedIndex(count++)];
  }
  return options.maximumModes == 0 ? count : std::min(count, options.maximumModes);
}

/** X^T weights: the second pass. */
Matrix
combineSubjects(const SubjectTable & table, const Matrix & weights, const ShapeModelOptions & options)
{
  Matrix result(signedIndex(table.columns()), weights.cols());
  forEachSlab(
    table,
    slabColumns(table, options.slabBytes),
    options.threads,
    [&](std::size_t, std::size_t first, std::size_t count) {
      Eigen::RowVectorXd mean;
      const Matrix       slab = centredSlab(table, first, count, mean);
      result.middleRows(signedIndex(first), signedIndex(count)).noalias() = slab.transpose() * weights;
    },
    [](std::size_t) {});
  return result;
}

/** Turns modes, and the scores with them, so that the component of largest magnitude is positive. */
void
fixSigns(Matrix & modes, Matrix & scores)
{
  for (Eigen::Index mode = 0; mode < modes.cols(); ++mode)
  {
    Eigen::Index largest = 0;
    modes.col(mode).cwiseAbs().maxCoeff(&largest);
    if (modes(largest, mode) < 0.0)
    {
      modes.col(mode) = -modes.col(mode);
      scores.col(mode) = -scores.col(mode);
    }
  }
}

} // namespace

ShapeModelResult
fitShapeModel(const SubjectTable & table, const ShapeModelOptions & options)
{
  requireArguments(table, options);
  ShapeModelResult result;
  const Matrix     gram = gramMatrix(table, options, result.model.mean);

  const Eigen::SelfAdjointEigenSolver<Matrix> solver(gram); // reads the lower half
  if (solver.info() != Eigen::Success)
  {
    throw NotConverged("shape model: eigenvalues of the subjects' products were not found", StepReport{});
  }
  const Vector ascending = solver.eigenvalues();
  const double largest = ascending[ascending.size() - 1];
  const double rounding = smallestDeviation * smallestDeviation * result.model.mean.squaredNorm();
  if (!(largest > static_cast<double>(gram.rows()) * rounding))
  {
    throw InvalidInput("shape model: the subjects are all the same");
  }
  const auto   rank = std::min<Eigen::Index>((ascending.array() > smallestVariance * largest).count(), gram.rows() - 1);
  const Vector roots = ascending.tail(rank).reverse().cwiseSqrt();
  const Matrix vectors = solver.eigenvectors().rightCols(rank).rowwise().reverse();
  result.variances = roots.cwiseAbs2() / static_cast<double>(gram.rows() - 1);
  result.scores = vectors * roots.asDiagonal();

  const auto kept = signedIndex(modesToKeep(result.variances, options));
  result.model.variances = result.variances.head(kept);
  result.model.totalVariance = result.variances.sum();
  const Matrix weights = vectors.leftCols(kept) * roots.head(kept).cwiseInverse().asDiagonal();
  result.model.modes = combineSubjects(table, weights, options);
  fixSigns(result.model.modes, result.scores);
  return result;
}

Vector
scoresOf(const ShapeModel & model, const Vector & shape)
{
  if (shape.size() != model.mean.size())
  {
    throw InvalidInput("shape model: a shape of " + std::to_string(shape.size()) + " coordinates, need " +
                       std::to_string(model.mean.size()));
  }
  return model.modes.transpose() * (shape - model.mean);
}

Vector
reconstruct(const ShapeModel & model, const Vector & scores)
{
  if (scores.size() > model.modes.cols())
  {
    throw InvalidInput("shape model: " + std::to_string(scores.size()) + " scores, the model has " +
                       std::to_string(model.modes.cols()) + " modes");
  }
  return model.mean + model.modes.leftCols(scores.size()) * scores;
}

Vector
shapeAlongMode(const ShapeModel & model, std::size_t mode, double standardDeviations)
{
  if (mode >= static_cast<std::size_t>(model.modes.cols()))
  {
    throw InvalidInput("shape model: no mode " + std::to_string(mode) + ", there are " +
                       std::to_string(model.modes.cols()));
  }
  const auto k = signedIndex(mode);
  return model.mean + standardDeviations * std::sqrt(model.variances[k]) * model.modes.col(k);
}

std::vector<Matrix3>
pointCovariances(const SubjectTable & table, unsigned int threads)
{
  if (table.subjects() < 2 || table.columns() % 3 != 0)
  {
    throw InvalidInput("covariances: " + std::to_string(table.subjects()) + " subjects with " +
                       std::to_string(table.columns()) + " coordinates, need at least 2, and 3 for each point");
  }
  std::vector<Matrix3> result(table.columns() / 3);
  const double         divisor = static_cast<double>(table.subjects() - 1);
  forEachSlab(
    table,
    slabColumns(table, covarianceSlabBytes),
    threads,
    [&](std::size_t, std::size_t first, std::size_t count) {
      Eigen::RowVectorXd mean;
      const Matrix       slab = centredSlab(table, first, count, mean);
      for (std::size_t column = 0; column < count; column += 3)
      {
        const auto point = slab.middleCols<3>(signedIndex(column));
        result[(first + column) / 3] = point.transpose() * point / divisor;
      }
    },
    [](std::size_t) {});
  return result;
}

Vector
coordinatesOf(const Positions & points)
{
  Vector result(3 * signedIndex(points.size()));
  for (std::size_t a = 0; a < points.size(); ++a)
  {
    result.segment<3>(3 * signedIndex(a)) = points[a];
  }
  return result;
}

Positions
pointsOf(const Vector & coordinates)
{
  Positions result(static_cast<std::size_t>(coordinates.size() / 3));
  for (std::size_t a = 0; a < result.size(); ++a)
  {
    result[a] = coordinates.segment<3>(3 * signedIndex(a));
  }
  return result;
}

} // namespace moserhex
