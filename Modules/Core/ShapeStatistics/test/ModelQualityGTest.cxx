// Two roads, one number: 1e-9 of the distances, which are square roots of differences. Determinism: bit for bit.
#include "moserhex/ShapeStatistics/ModelQuality.h"

#include "RankOneDowndate.h"
#include "TestShapes.h"
#include "moserhex/Analytic/Refusals.h"
#include "moserhex/ShapeStatistics/ShapeModel.h"

#include <Eigen/Eigenvalues>

#include <gtest/gtest.h>

using namespace moserhex;
using namespace moserhex::testing;
using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

namespace
{

constexpr Eigen::Index coordinates = 60;

Matrix
someShapes(Eigen::Index subjects)
{
  Random random(11);
  Matrix scales = Matrix::Zero(coordinates, coordinates);
  for (Eigen::Index k = 0; k < coordinates; ++k)
  {
    scales(k, k) = 5.0 / (1.0 + k);
  }
  return normalMatrix(subjects, coordinates, random) * scales;
}

/** The mean distance by a model of the others for every subject. */
double
generalisationByHand(const Matrix & values, std::size_t modes)
{
  double sum = 0.0;
  for (Eigen::Index left = 0; left < values.rows(); ++left)
  {
    Matrix others(values.rows() - 1, values.cols());
    others << values.topRows(left), values.bottomRows(values.rows() - 1 - left);
    ShapeModelOptions options;
    options.maximumModes = modes;
    const ShapeModel model = fitShapeModel(MatrixTable(others), options).model;
    const Vector     shape = values.row(left).transpose();
    sum += (reconstruct(model, scoresOf(model, shape)) - shape).norm() / std::sqrt(coordinates / 3.0);
  }
  return sum / static_cast<double>(values.rows());
}

} // namespace

TEST(RankOneDowndate, EigenvaluesAndPartsAreThoseOfTheDenseMatrix)
{
  Random       random(12);
  const Vector d = (Vector(7) << 9.0, 7.0, 7.0, 4.0, 2.0, 1.0, 0.5).finished();
  Vector       y = normalMatrix(7, 1, random);
  y[4] = 0.0;
  y *= 0.3;
  const double                                rho = 1.2;
  const Eigen::SelfAdjointEigenSolver<Matrix> solver(Matrix(Matrix(d.asDiagonal()) - rho * y * y.transpose()));
  const auto                                  modes = downdatedModes(d, y, rho, 7);
  ASSERT_EQ(modes.size(), 7u);
  for (Eigen::Index k = 0; k < 7; ++k)
  {
    const auto & mode = modes[static_cast<std::size_t>(k)];
    EXPECT_NEAR(mode.eigenvalue, solver.eigenvalues()[6 - k], 1e-13);
    EXPECT_NEAR(mode.explained, std::pow(rho * y.dot(solver.eigenvectors().col(6 - k)), 2), 1e-12) << k;
  }
}

TEST(ModelQuality, CompactnessIsThatOfTheKnownSpectrum)
{
  // Scores of deviations 3, 2, 1 that are uncorrelated: parts 9, 4, 1 of 14.
  Matrix scores(4, 3);
  scores << 3, 2, 1, -3, 2, -1, 3, -2, -1, -3, -2, 1;
  const ModelQuality quality = modelQuality(scores, 10);
  ASSERT_EQ(quality.compactness.size(), 2u);
  EXPECT_NEAR(quality.compactness[0], 9.0 / 14.0, 1e-15);
  EXPECT_NEAR(quality.compactness[1], 13.0 / 14.0, 1e-15);
}

TEST(ModelQuality, GeneralisationEqualsModelsWithoutOneSubject)
{
  const Matrix       values = someShapes(9);
  const auto         fit = fitShapeModel(MatrixTable(values));
  const ModelQuality quality = modelQuality(fit.scores, coordinates / 3);
  ASSERT_EQ(quality.generalisation.size(), 7u);
  for (std::size_t modes = 1; modes <= 7; ++modes)
  {
    EXPECT_NEAR(quality.generalisation[modes - 1], generalisationByHand(values, modes), 1e-9) << modes << " modes";
  }
}

TEST(ModelQuality, ADirectionThatOneSubjectSpansIsNotInTheModelOfTheOthers)
{
  // A, A, B, C in a plane: without B, or C, the others lie on a line. D, twice, is out of it.
  Matrix four(4, coordinates);
  four << someShapes(3).row(0), someShapes(3);
  Matrix six(6, coordinates);
  six << four, someShapes(4).row(3), someShapes(4).row(3);
  for (const Matrix & values : { four, six })
  {
    const auto         fit = fitShapeModel(MatrixTable(values));
    const ModelQuality quality = modelQuality(fit.scores, coordinates / 3);
    for (std::size_t modes = 1; modes <= quality.generalisation.size(); ++modes)
    {
      EXPECT_NEAR(quality.generalisation[modes - 1], generalisationByHand(values, modes), 1e-7) << modes << " modes";
    }
    EXPECT_GT(quality.generalisation.back(), 0.1);
  }
}

TEST(ModelQuality, SpecificityOfManySamplesOfOneModeIsTheIntegral)
{
  // Subjects at -1, 0 and 1 mm, of one point: the mean distance of N(0,1) to the nearest is 0.350 mm.
  Matrix scores(3, 1);
  scores << -1, 0, 1;
  ModelQualityOptions options;
  options.samples = 20000;
  const auto density = [](double x) { return std::exp(-0.5 * x * x) / std::sqrt(2.0 * pi); };
  double     integral = 0.0;
  for (double x = -8.0; x < 8.0; x += 1e-3)
  {
    integral += 1e-3 * density(x) * std::min(std::abs(x), std::min(std::abs(x - 1.0), std::abs(x + 1.0)));
  }
  const ModelQuality quality = modelQuality(scores, 1, options);
  EXPECT_NEAR(quality.specificity.front(), integral, 4.0 * quality.specificityError.front());
  EXPECT_LT(quality.specificityError.front(), 0.01);
}

TEST(ModelQuality, TheSameForAnyNumberOfThreads)
{
  const auto          fit = fitShapeModel(MatrixTable(someShapes(12)));
  ModelQualityOptions options;
  options.threads = 1;
  const ModelQuality one = modelQuality(fit.scores, 20, options);
  options.threads = 3;
  const ModelQuality three = modelQuality(fit.scores, 20, options);
  EXPECT_EQ(one.generalisation, three.generalisation);
  EXPECT_EQ(one.specificity, three.specificity);
  options.seed = 2;
  EXPECT_NE(modelQuality(fit.scores, 20, options).specificity, one.specificity);
}

TEST(ModelQuality, TooLittleIsRefused)
{
  EXPECT_EQ(analytic::messageOf([] { (void)modelQuality(Matrix::Ones(2, 1), 5); }),
            "model quality: 2 subjects, 1 modes, 5 points, 1000 samples, need at least 3, 1, 1 and 1");
}

TEST(RandomScores, HaveTheVariancesAndDoNotDependOnHowManyModesAreAskedFor)
{
  const Vector  variances = (Vector(3) << 4.0, 1.0, 0.0).finished();
  Vector        sum = Vector::Zero(3);
  Vector        squares = Vector::Zero(3);
  constexpr int samples = 20000;
  for (std::size_t sample = 0; sample < samples; ++sample)
  {
    const Vector b = randomScores(variances, sample, 1);
    EXPECT_EQ(randomScores(variances.head(2), sample, 1), b.head(2));
    sum += b;
    squares += b.cwiseAbs2();
  }
  EXPECT_LT((sum / samples).cwiseAbs().maxCoeff(), 4.0 * 2.0 / std::sqrt(samples)); // four standard errors
  EXPECT_LT((squares / samples - variances).cwiseAbs().maxCoeff(), 4.0 * 4.0 * std::sqrt(2.0 / samples));
  EXPECT_NE(randomScores(variances, 0, 1), randomScores(variances, 0, 2));
}
