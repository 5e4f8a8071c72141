#include "moserhex/ShapeStatistics/ModelQuality.h"

#include "RankOneDowndate.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Parallel.h"
#include "moserhex/Common/Random.h"
#include "moserhex/Common/Types.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace moserhex
{
namespace
{
using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

void
requireArguments(const Matrix & scores, std::size_t points, const ModelQualityOptions & options)
{
  if (scores.rows() < 3 || scores.cols() < 1 || points == 0 || options.samples == 0)
  {
    throw InvalidInput("model quality: " + std::to_string(scores.rows()) + " subjects, " +
                       std::to_string(scores.cols()) + " modes, " + std::to_string(points) + " points, " +
                       std::to_string(options.samples) + " samples, need at least 3, 1, 1 and 1");
  }
}

/** Entry (i, m-1): distance of subject i to the first m modes of the others. */
Matrix
leaveOneOutDistances(const Matrix & scores, std::size_t points, Eigen::Index modes, unsigned int threads)
{
  const Vector scatter = scores.colwise().squaredNorm().transpose();
  const double rho = static_cast<double>(scores.rows()) / static_cast<double>(scores.rows() - 1);
  Matrix       distances(scores.rows(), modes);
  parallelFor(static_cast<std::size_t>(scores.rows()), threads, [&](std::size_t subject) {
    const auto   row = static_cast<Eigen::Index>(subject);
    const Vector y = scores.row(row).transpose();
    const auto   others = downdatedModes(scatter, y, rho, static_cast<std::size_t>(modes));
    double       unexplained = rho * rho * y.squaredNorm();
    for (Eigen::Index m = 0; m < modes; ++m)
    {
      unexplained -= others[static_cast<std::size_t>(m)].explained;
      distances(row, m) = std::sqrt(std::max(0.0, unexplained) / static_cast<double>(points));
    }
  });
  return distances;
}

/** Entry (s, m-1): distance of sample s of the first m modes to the nearest subject. */
Matrix
sampleDistances(const Matrix & scores, std::size_t points, Eigen::Index modes, const ModelQualityOptions & options)
{
  const Vector variances =
    scores.leftCols(modes).colwise().squaredNorm().transpose() / static_cast<double>(scores.rows() - 1);
  const Vector squaredLengths = scores.rowwise().squaredNorm();
  Matrix       distances(static_cast<Eigen::Index>(options.samples), modes);
  parallelFor(options.samples, options.threads, [&](std::size_t sample) {
    const Vector b = randomScores(variances, sample, options.seed);
    Vector       squared = squaredLengths;
    for (Eigen::Index m = 0; m < modes; ++m)
    {
      // |x_i - sample|^2 gains a sample's component: (y - b)^2 - y^2
      squared.array() += b[m] * (b[m] - 2.0 * scores.col(m).array());
      distances(static_cast<Eigen::Index>(sample), m) =
        std::sqrt(std::max(0.0, squared.minCoeff()) / static_cast<double>(points));
    }
  });
  return distances;
}

} // namespace

ColumnMeans
columnMeans(const Matrix & values)
{
  const double count = static_cast<double>(values.rows());
  ColumnMeans  means;
  for (Eigen::Index column = 0; column < values.cols(); ++column)
  {
    const double average = values.col(column).mean();
    const double squares = (values.col(column).array() - average).square().sum();
    means.mean.push_back(average);
    means.error.push_back(values.rows() > 1 ? std::sqrt(squares / (count - 1.0) / count) : 0.0);
  }
  return means;
}

Vector
randomScores(const Vector & variances, std::size_t sample, std::uint64_t seed)
{
  constexpr std::uint64_t apart = 0xD1B54A32D192ED03ULL; // odd: no other seed near has one of these samples
  Random                  random(Random(1 + (seed - 1) * apart + sample).next());
  Vector                  scores(variances.size());
  for (Eigen::Index k = 0; k < variances.size(); ++k)
  {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - random.uniform())); // Box and Muller
    scores[k] = std::sqrt(variances[k]) * (radius * std::cos(2.0 * pi * random.uniform()));
  }
  return scores;
}

ModelQuality
modelQuality(const Matrix & scores, std::size_t points, const ModelQualityOptions & options)
{
  requireArguments(scores, points, options);
  const auto wanted = static_cast<Eigen::Index>(options.maximumModes);
  // Without one subject there may be one mode less.
  const Eigen::Index available = std::max<Eigen::Index>(1, std::min(scores.cols(), scores.rows() - 2));
  const Eigen::Index modes = wanted == 0 ? available : std::min(wanted, available);

  ModelQuality quality;
  const Vector scatter = scores.colwise().squaredNorm().transpose();
  for (Eigen::Index m = 1; m <= modes; ++m)
  {
    quality.compactness.push_back(scatter.head(m).sum() / scatter.sum());
  }
  ColumnMeans leftOut = columnMeans(leaveOneOutDistances(scores, points, modes, options.threads));
  quality.generalisation = std::move(leftOut.mean);
  quality.generalisationError = std::move(leftOut.error);
  ColumnMeans samples = columnMeans(sampleDistances(scores, points, modes, options));
  quality.specificity = std::move(samples.mean);
  quality.specificityError = std::move(samples.error);
  return quality;
}

} // namespace moserhex
