// Against a dense SVD and planted modes: 1e-10 of the largest deviation. Determinism: bit for bit.
#include "moserhex/ShapeStatistics/ShapeModel.h"

#include "TestShapes.h"
#include "moserhex/Analytic/Refusals.h"
#include "moserhex/ShapeStatistics/Procrustes.h"

#include <Eigen/QR>
#include <Eigen/SVD>

#include <gtest/gtest.h>

using namespace moserhex;
using namespace moserhex::testing;
using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

namespace
{

constexpr Eigen::Index coordinates = 90;

/** Subjects 50 + sum_k b_k mode_k with deviations 8, 4, 2 of three orthonormal modes, b uncorrelated. */
struct Planted
{
  Matrix modes;  ///< coordinates x 3
  Matrix scores; ///< N x 3
  Matrix values; ///< N x coordinates

  explicit Planted(Eigen::Index subjects)
  {
    Random random(3);
    modes = orthonormal(normalMatrix(coordinates, 3, random));
    Matrix b = normalMatrix(subjects, 3, random);
    b.rowwise() -= b.colwise().mean();
    scores = std::sqrt(static_cast<double>(subjects - 1)) * orthonormal(b) * Vector3(8.0, 4.0, 2.0).asDiagonal();
    values = (scores * modes.transpose()).array() + 50.0;
  }

  static Matrix
  orthonormal(const Matrix & columns)
  {
    const Eigen::HouseholderQR<Matrix> qr(columns);
    return qr.householderQ() * Matrix::Identity(columns.rows(), columns.cols());
  }
};

} // namespace

TEST(ShapeModel, PlantedModesAreFound)
{
  const Planted          planted(12);
  const MatrixTable      table(planted.values);
  const ShapeModelResult result = fitShapeModel(table);
  ASSERT_EQ(result.model.modes.cols(), 3);
  EXPECT_LT((result.model.variances - Vector3(64.0, 16.0, 4.0)).norm(), 1e-10 * 64.0);
  EXPECT_NEAR(result.model.totalVariance, 84.0, 1e-10 * 84.0);
  for (Eigen::Index mode = 0; mode < 3; ++mode)
  {
    const double sign = result.model.modes.col(mode).dot(planted.modes.col(mode));
    EXPECT_NEAR(std::abs(sign), 1.0, 1e-10);
    EXPECT_LT((result.scores.col(mode) - sign * planted.scores.col(mode)).norm(), 1e-8);
  }
}

TEST(ShapeModel, EqualsTheDenseSvd)
{
  Random                         random(4);
  const Matrix                   values = normalMatrix(20, coordinates, random);
  const MatrixTable              table(values);
  const ShapeModelResult         result = fitShapeModel(table);
  const Matrix                   centred = values.rowwise() - values.colwise().mean();
  const Eigen::JacobiSVD<Matrix> svd(centred, Eigen::ComputeThinU | Eigen::ComputeThinV);
  ASSERT_EQ(result.variances.size(), 19);
  for (Eigen::Index k = 0; k < 19; ++k)
  {
    EXPECT_NEAR(result.variances[k], std::pow(svd.singularValues()[k], 2) / 19.0, 1e-12);
    EXPECT_NEAR(std::abs(result.model.modes.col(k).dot(svd.matrixV().col(k))), 1.0, 1e-10);
  }
  EXPECT_LT((result.model.modes.transpose() * result.model.modes - Matrix::Identity(19, 19)).norm(), 1e-10);
}

TEST(ShapeModel, ASubjectComesBackFromItsScores)
{
  Random                 random(5);
  const Matrix           values = normalMatrix(10, coordinates, random);
  const MatrixTable      table(values);
  const ShapeModelResult result = fitShapeModel(table);
  const Vector           shape = values.row(4).transpose();
  EXPECT_LT((reconstruct(result.model, result.scores.row(4).transpose()) - shape).norm(), 1e-11);
  EXPECT_LT((scoresOf(result.model, shape) - result.scores.row(4).transpose()).norm(), 1e-11);
}

TEST(ShapeModel, SlabsAndThreadsChangeNothingThatCounts)
{
  Random            random(6);
  const MatrixTable table(normalMatrix(15, coordinates, random));
  ShapeModelOptions options;
  options.slabBytes = 15 * 8 * 9; // nine columns
  options.threads = 1;
  const ShapeModelResult one = fitShapeModel(table, options);
  options.threads = 3;
  const ShapeModelResult three = fitShapeModel(table, options);
  EXPECT_EQ(one.model.modes, three.model.modes);
  EXPECT_EQ(one.scores, three.scores);
  EXPECT_LT((one.scores - fitShapeModel(table).scores).norm(), 1e-10);
}

TEST(ShapeModel, ModesAreKeptByNumberAndByVariance)
{
  const MatrixTable table(Planted(12).values);
  ShapeModelOptions options;
  options.maximumModes = 2;
  EXPECT_EQ(fitShapeModel(table, options).model.modes.cols(), 2);
  EXPECT_EQ(fitShapeModel(table, options).scores.cols(), 3);
  options.maximumModes = 0;
  options.varianceFraction = 0.95; // 80 of 84
  EXPECT_EQ(fitShapeModel(table, options).model.modes.cols(), 2);
  options.varianceFraction = 0.96;
  EXPECT_EQ(fitShapeModel(table, options).model.modes.cols(), 3);
}

TEST(ShapeModel, AShapeAlongAModeHasThatScoreOnly)
{
  const MatrixTable table(Planted(12).values);
  const ShapeModel  model = fitShapeModel(table).model;
  EXPECT_LT((scoresOf(model, shapeAlongMode(model, 1, -3.0)) - Vector3(0.0, -12.0, 0.0)).norm(), 1e-10);
}

TEST(ShapeModel, TheCovarianceOfAPointIsThatOfItsCoordinates)
{
  Random       random(8);
  const Matrix values = normalMatrix(25, coordinates, random);
  const auto   covariances = pointCovariances(MatrixTable(values));
  ASSERT_EQ(covariances.size(), 30u);
  const Matrix centred = values.rowwise() - values.colwise().mean();
  EXPECT_NEAR(covariances[7](0, 2), centred.col(21).dot(centred.col(23)) / 24.0, 1e-13);
  EXPECT_NEAR(covariances[7](1, 1), centred.col(22).squaredNorm() / 24.0, 1e-13);
}

TEST(ShapeModel, CopiesOfOneShapeThatLieElsewhereAreAllTheSame)
{
  const Positions        shape = softCube(6).nodes;
  std::vector<Positions> copies;
  for (int i = 0; i < 6; ++i)
  {
    Positions copy = shape;
    for (Vector3 & p : copy)
    {
      p = turnOf(0.3 * i, Vector3(1, i, 2)) * p + Vector3(200.0 * i, -1000.0, 31.4 * i);
    }
    copies.push_back(copy);
  }
  const auto alignment = generalisedProcrustes(copies.size(), [&](std::size_t subject) { return copies[subject]; }, {});
  Matrix     aligned(6, static_cast<Eigen::Index>(3 * shape.size()));
  for (std::size_t i = 0; i < copies.size(); ++i)
  {
    aligned.row(static_cast<Eigen::Index>(i)) =
      coordinatesOf(transformed(copies[i], alignment.transforms[i])).transpose();
  }
  EXPECT_EQ(analytic::messageOf([&] { (void)fitShapeModel(MatrixTable(aligned)); }),
            "shape model: the subjects are all the same");
  aligned(2, 7) += 1e-4; // a tenth of a micrometre is a difference
  EXPECT_EQ(fitShapeModel(MatrixTable(aligned)).model.modes.cols(), 1);
}

TEST(ShapeModel, Refusals)
{
  Random       random(9);
  const Matrix values = normalMatrix(5, 12, random);
  const auto   refusal = [](const Matrix & m, double fraction) {
    return analytic::messageOf([&] {
      ShapeModelOptions options;
      options.varianceFraction = fraction;
      (void)fitShapeModel(MatrixTable(m), options);
    });
  };
  EXPECT_EQ(refusal(values.topRows(1), 1.0), "shape model: 1 subjects with 12 coordinates, need at least 2 and 1");
  EXPECT_EQ(refusal(values, 1.5), "shape model: the part of the variance must be in (0,1], and a slab have some bytes");
  EXPECT_EQ(refusal(Matrix::Ones(5, 12), 1.0), "shape model: the subjects are all the same");
  Matrix bad = values;
  bad(3, 7) = std::nan("");
  EXPECT_EQ(refusal(bad, 1.0), "statistics: subject 3, number 7 is not finite");
  const ShapeModel model = fitShapeModel(MatrixTable(values)).model;
  EXPECT_EQ(analytic::messageOf([&] { (void)scoresOf(model, Vector::Zero(3)); }),
            "shape model: a shape of 3 coordinates, need 12");
  EXPECT_EQ(analytic::messageOf([&] { (void)reconstruct(model, Vector::Zero(9)); }),
            "shape model: 9 scores, the model has 4 modes");
  EXPECT_EQ(analytic::messageOf([&] { (void)shapeAlongMode(model, 4, 1.0); }), "shape model: no mode 4, there are 4");
  EXPECT_EQ(analytic::messageOf([&] { (void)pointCovariances(MatrixTable(Matrix::Ones(5, 10))); }),
            "covariances: 5 subjects with 10 coordinates, need at least 2, and 3 for each point");
}
