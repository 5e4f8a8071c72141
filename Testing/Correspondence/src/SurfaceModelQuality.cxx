#include "moserhex/Correspondence/SurfaceModelQuality.h"

#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Parallel.h"
#include "moserhex/Correspondence/SurfaceDistance.h"
#include "moserhex/ShapeStatistics/ModelQuality.h"
#include "moserhex/ShapeStatistics/ShapeModel.h"

#include <algorithm>
#include <string>

namespace moserhex
{
namespace
{
using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

/** A row a subject. */
Matrix
rowsOf(const std::vector<SubjectSurface> & subjects)
{
  Matrix rows(static_cast<Eigen::Index>(subjects.size()),
              3 * static_cast<Eigen::Index>(subjects.front().points.size()));
  for (std::size_t s = 0; s < subjects.size(); ++s)
  {
    if (subjects[s].points.size() != subjects.front().points.size())
    {
      throw InvalidInput("surface model quality: subject " + std::to_string(s) + " has another number of points");
    }
    rows.row(static_cast<Eigen::Index>(s)) = coordinatesOf(subjects[s].points).transpose();
  }
  return rows;
}

Matrix
withoutRow(const Matrix & rows, Eigen::Index left)
{
  Matrix others(rows.rows() - 1, rows.cols());
  others.topRows(left) = rows.topRows(left);
  others.bottomRows(rows.rows() - 1 - left) = rows.bottomRows(rows.rows() - 1 - left);
  return others;
}

/** With the first so many scores. */
Positions
shapeOf(const ShapeModel & model, const Vector & scores, std::size_t modes)
{
  const auto count = std::min(static_cast<Eigen::Index>(modes), static_cast<Eigen::Index>(scores.size()));
  return pointsOf(reconstruct(model, scores.head(count)));
}

ShapeModel
modelOf(const Matrix & rows)
{
  ShapeModelOptions options;
  options.threads = 1;
  return fitShapeModel(MatrixTable(rows), options).model;
}

} // namespace

SurfaceModelQuality
surfaceModelQuality(const std::vector<SubjectSurface> & subjects,
                    const SpannedSurface &              span,
                    const std::vector<std::size_t> &    modes,
                    const SurfaceModelQualityOptions &  options)
{
  if (subjects.size() < 3 || options.pairs == 0)
  {
    throw InvalidInput("surface model quality: " + std::to_string(subjects.size()) + " subjects, " +
                       std::to_string(options.pairs) + " pairs, need at least 3 and 1");
  }
  const Matrix                rows = rowsOf(subjects);
  const auto                  columns = static_cast<Eigen::Index>(modes.size());
  std::vector<SampledSurface> surfaces;
  surfaces.reserve(subjects.size());
  for (const SubjectSurface & subject : subjects)
  {
    surfaces.emplace_back(subject.surface, options.spacing);
  }
  const auto distanceTo = [&](std::size_t subject, const Positions & points) {
    return symmetricSurfaceDistance(SampledSurface(span(points), options.spacing), surfaces[subject], 1).mean;
  };

  Matrix leftOut(rows.rows(), columns);
  parallelFor(subjects.size(), options.threads, [&](std::size_t subject) {
    const auto       row = static_cast<Eigen::Index>(subject);
    const ShapeModel others = modelOf(withoutRow(rows, row));
    const Vector     scores = scoresOf(others, rows.row(row).transpose());
    for (Eigen::Index m = 0; m < columns; ++m)
    {
      leftOut(row, m) = distanceTo(subject, shapeOf(others, scores, modes[static_cast<std::size_t>(m)]));
    }
  });

  const ShapeModel all = modelOf(rows);
  const auto       distanceToNearest = [&](const Vector & scores, std::size_t kept) {
    const Positions points = shapeOf(all, scores, kept);
    Eigen::Index    nearest = 0;
    (void)(rows.rowwise() - coordinatesOf(points).transpose()).rowwise().squaredNorm().minCoeff(&nearest);
    return distanceTo(static_cast<std::size_t>(nearest), points);
  };
  Matrix random(static_cast<Eigen::Index>(options.pairs), columns);
  parallelFor(options.pairs, options.threads, [&](std::size_t pair) {
    const Vector scores = randomScores(all.variances, pair, options.seed);
    for (Eigen::Index m = 0; m < columns; ++m)
    {
      const std::size_t kept = modes[static_cast<std::size_t>(m)];
      random(static_cast<Eigen::Index>(pair), m) =
        0.5 * (distanceToNearest(scores, kept) + distanceToNearest(-scores, kept));
    }
  });

  const ColumnMeans generalisation = columnMeans(leftOut);
  const ColumnMeans specificity = columnMeans(random);
  return { generalisation.mean, generalisation.error, specificity.mean, specificity.error };
}

} // namespace moserhex
