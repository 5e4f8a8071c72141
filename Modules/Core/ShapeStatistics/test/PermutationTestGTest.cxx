// Exact p: to round-off. Rates on null data: within four standard errors of binomial counts, fixed seeds.
#include "moserhex/ShapeStatistics/PermutationTest.h"

#include "Arrangements.h"
#include "NullData.h"
#include "TestShapes.h"
#include "moserhex/Analytic/Refusals.h"
#include "moserhex/ShapeStatistics/GroupDesign.h"

#include <Eigen/QR>

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

using namespace moserhex;
using namespace moserhex::testing;
using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

namespace
{

Vector
groups(Eigen::Index subjects)
{
  Vector result = Vector::Zero(subjects);
  result.tail(subjects / 2).setOnes();
  return result;
}

PermutationOptions
scalars(std::size_t permutations, std::uint64_t seed = 1)
{
  PermutationOptions options;
  options.componentsPerPlace = 1;
  options.permutations = permutations;
  options.seed = seed;
  options.threads = 1;
  return options;
}

} // namespace

TEST(PermutationTest, TheStatisticIsStudentsTSquared)
{
  Random       random(21);
  const Matrix y = normalMatrix(15, 1, random);
  const Vector x = normalMatrix(15, 1, random);
  const Matrix z = normalMatrix(15, 2, random);
  const auto   result = permutationTest(MatrixTable(y), { x, z }, scalars(10));

  Matrix X(15, 4);
  X << x, Vector::Ones(15), z;
  const Vector beta = X.colPivHouseholderQr().solve(Vector(y));
  const double sigma2 = (y - X * beta).squaredNorm() / 11.0;
  const double variance = sigma2 * (X.transpose() * X).inverse()(0, 0);
  EXPECT_EQ(result.degreesOfFreedom, 11u);
  EXPECT_NEAR(result.slope(0, 0), beta[0], 1e-12);
  EXPECT_NEAR(result.statistic[0], beta[0] * beta[0] / variance, 1e-9);
  const double correlation = std::sqrt(result.statistic[0] / (result.statistic[0] + 11.0));
  EXPECT_NEAR(result.partialCorrelation[0], beta[0] < 0.0 ? -correlation : correlation, 1e-12);
  EXPECT_EQ(result.standardisedDifference.size(), 0);
  const auto turned = permutationTest(MatrixTable(Matrix(-y)), { x, z }, scalars(10));
  EXPECT_NEAR(turned.partialCorrelation[0], -result.partialCorrelation[0], 1e-12);
}

TEST(PermutationTest, CohensDHasASign)
{
  Random random(23);
  Matrix y = normalMatrix(20, 2, random);
  y.col(0).tail(10).array() -= 3.0;
  y.col(1).tail(10).array() += 3.0;
  const auto result = permutationTest(MatrixTable(y), { groups(20), Matrix(20, 0) }, scalars(10));
  for (Eigen::Index place = 0; place < 2; ++place)
  {
    const Vector first = y.col(place).head(10);
    const Vector second = y.col(place).tail(10);
    const double squares =
      (first.array() - first.mean()).square().sum() + (second.array() - second.mean()).square().sum();
    EXPECT_NEAR(
      result.standardisedDifference[place], (second.mean() - first.mean()) / std::sqrt(squares / 18.0), 1e-10);
  }
  EXPECT_LT(result.standardisedDifference[0], 0.0);
}

TEST(PermutationTest, OfVectorsItIsHotellingsTSquared)
{
  Random       random(22);
  const Matrix y = normalMatrix(16, 3, random);
  const auto   result = permutationTest(MatrixTable(y), { groups(16), Matrix(16, 0) });

  const Vector3 difference = (y.bottomRows(8).colwise().mean() - y.topRows(8).colwise().mean()).transpose();
  Matrix        within = y;
  within.topRows(8).rowwise() -= y.topRows(8).colwise().mean();
  within.bottomRows(8).rowwise() -= y.bottomRows(8).colwise().mean();
  const Matrix3 pooled = within.transpose() * within / 14.0;
  const double  squaredDistance = difference.dot(pooled.inverse() * difference);
  EXPECT_LT((result.slope.col(0) - difference).norm(), 1e-13);
  EXPECT_NEAR(result.statistic[0], 4.0 * squaredDistance, 1e-9); // n1 n2 / (n1 + n2)
  EXPECT_NEAR(result.standardisedDifference[0], std::sqrt(squaredDistance), 1e-10);
}

TEST(PermutationTest, FewSubjectsAreEnumerated)
{
  Matrix y(7, 1);
  y << 1, 2, 3, 4, 10, 11, 12;
  Vector x(7);
  x << 0, 0, 0, 0, 1, 1, 1;
  const auto result = permutationTest(MatrixTable(y), { x, Matrix(7, 0) }, scalars(1000));
  EXPECT_TRUE(result.isExact);
  EXPECT_EQ(result.permutations, 35u); // 7 over 3
  EXPECT_NEAR(result.p[0], 1.0 / 35.0, 1e-15);
}

TEST(PermutationTest, TheNumberOfOrdersCountsEqualSubjectsOnce)
{
  Matrix rows(5, 2);
  rows << 0, 1, 0, 1, 1, 1, 0, 2, 0, 1;
  const Arrangements all = arrangementsOf(rows, 100, 1);
  EXPECT_TRUE(all.areAll);
  EXPECT_EQ(all.orders.size(), 20u); // 5! / 3!
  EXPECT_EQ(all.orders.front(), (std::vector<std::uint16_t>{ 0, 0, 2, 3, 0 }));
  const Arrangements some = arrangementsOf(rows, 18, 1);
  EXPECT_FALSE(some.areAll);
  EXPECT_EQ(some.orders.size(), 19u);
}

TEST(PermutationTest, GroupsOfOneSizeThatChangePlacesAreAsGood)
{
  // The best that two groups of four can do is 2 of 70 orders, of five 2 of 252; of three pairs 3! of 90.
  const auto apart = [](Eigen::Index subjects, const Matrix & effect) {
    return permutationTest(MatrixTable(Vector::LinSpaced(subjects, 1.0, 2.0).array().pow(8).matrix()),
                           { effect, Matrix(subjects, 0) },
                           scalars(10000));
  };
  EXPECT_NEAR(apart(8, groups(8)).smallestPossibleP, 2.0 / 70.0, 1e-15);
  EXPECT_NEAR(apart(8, groups(8)).p[0], 2.0 / 70.0, 1e-15);
  EXPECT_NEAR(apart(8, groups(8)).pFamilyWise[0], 2.0 / 70.0, 1e-15);
  EXPECT_NEAR(apart(10, groups(10)).smallestPossibleP, 2.0 / 252.0, 1e-15);
  EXPECT_NEAR(apart(10, groups(10)).p[0], 2.0 / 252.0, 1e-15);
  EXPECT_NEAR(apart(6, groupColumns({ 0, 0, 1, 1, 2, 2 }, 3)).smallestPossibleP, 6.0 / 90.0, 1e-15);
  EXPECT_NEAR(apart(7, groups(7)).smallestPossibleP, 1.0 / 35.0, 1e-15);
  const Vector unevenlySpaced = Vector::LinSpaced(6, 1.0, 2.0).array().square();
  EXPECT_NEAR(apart(6, unevenlySpaced).smallestPossibleP, 1.0 / 720.0, 1e-15);
  EXPECT_NEAR(apart(6, Vector::LinSpaced(6, 1.0, 2.0)).smallestPossibleP, 2.0 / 720.0, 1e-15); // and backwards
}

TEST(PermutationTest, AllOrdersAreNotExactWithANuisance)
{
  Vector sex(8);
  sex << 0, 0, 1, 1, 0, 0, 1, 1;
  Random       random(23);
  const Matrix y = groups(8) * Matrix::Constant(1, 40, 9.0) + normalMatrix(8, 40, random);
  const auto   result = permutationTest(MatrixTable(y), { groups(8), sex }, scalars(10000));
  EXPECT_EQ(result.permutations, 2520u); // 8! / 2!^4
  EXPECT_TRUE(result.areAllOrders);
  EXPECT_FALSE(result.isExact);
  EXPECT_NEAR(result.smallestPossibleP, 2.0 / 70.0, 1e-15); // sexes may go anywhere
  EXPECT_NEAR(result.p.minCoeff(), result.smallestPossibleP, 1e-15);
  EXPECT_TRUE(permutationTest(MatrixTable(y), { groups(8), Vector::Constant(8, 3.6) }, scalars(10000)).isExact);
}

TEST(PermutationTest, ACovariateThatFollowsFromOthersIsLeftOut)
{
  Random       random(24);
  const Vector age = 61.3 + 9.7 * normalMatrix(40, 1, random).col(0).array();
  const Vector volume = 41.7 + 6.1 * normalMatrix(40, 1, random).col(0).array();
  Matrix       sites = Matrix::Zero(40, 3);
  for (Eigen::Index i = 0; i < 40; ++i)
  {
    sites(i, i % 3) = 1.0;
  }
  Matrix all(40, 8);
  all << age, Vector(2024.1 - age.array()), volume, 1e-3 * volume, Vector::Constant(40, 3.6), sites;
  Matrix few(40, 4);
  few << age, volume, sites.leftCols(2);
  const MatrixTable  table(Matrix(normalMatrix(40, 3 * 30, random)));
  PermutationOptions options = scalars(200);
  options.componentsPerPlace = 3;
  const auto expected = permutationTest(table, { groups(40), few }, options);
  const auto result = permutationTest(table, { groups(40), all }, options);
  EXPECT_EQ(result.nuisanceLeftOut, (std::vector<std::size_t>{ 1, 3, 4, 7 }));
  EXPECT_TRUE(expected.nuisanceLeftOut.empty());
  EXPECT_EQ(result.degreesOfFreedom, 34u); // 40 less constant, age, volume, two sites and the effect
  EXPECT_LT((result.statistic - expected.statistic).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LE(result.pillaiTrace.maxCoeff(), 1.0);
  EXPECT_EQ(result.p, expected.p);
}

TEST(PermutationTest, AllOrdersWithACovariateAreThoseOfRefittedModels)
{
  constexpr Eigen::Index subjects = 6;
  constexpr Eigen::Index places = 3;
  Random                 random(77);
  const Vector           x = groups(subjects);
  const Matrix           y = normalMatrix(subjects, places, random);
  const Vector           z = x + Vector(normalMatrix(subjects, 1, random));
  const auto             result = permutationTest(MatrixTable(y), { x, Matrix(z) }, scalars(1000000));

  // Freedman and Lane: residuals of the reduced model in every order, its fit, and the whole model fitted anew.
  Matrix reduced(subjects, 2);
  reduced << Vector::Ones(subjects), z;
  Matrix whole(subjects, 3);
  whole << x, reduced;
  const Matrix fit = reduced * reduced.colPivHouseholderQr().solve(y);
  const Matrix residuals = y - fit;
  const auto   statistics = [&whole](const Matrix & data) {
    const Matrix beta = whole.colPivHouseholderQr().solve(data);
    const double design = (whole.transpose() * whole).inverse()(0, 0);
    Vector       t2(data.cols());
    for (Eigen::Index place = 0; place < data.cols(); ++place)
    {
      const double sigma2 = (data.col(place) - whole * beta.col(place)).squaredNorm() / (subjects - 3.0);
      t2[place] = beta(0, place) * beta(0, place) / (sigma2 * design);
    }
    return t2;
  };
  const Vector              own = statistics(y);
  std::vector<Eigen::Index> order(subjects);
  std::iota(order.begin(), order.end(), Eigen::Index{ 0 });
  Vector p = Vector::Zero(places);
  Vector pFamilyWise = Vector::Zero(places);
  double orders = 0.0;
  do
  {
    Matrix data = fit;
    for (Eigen::Index subject = 0; subject < subjects; ++subject)
    {
      data.row(subject) += residuals.row(order[static_cast<std::size_t>(subject)]);
    }
    const Vector t2 = statistics(data);
    for (Eigen::Index place = 0; place < places; ++place)
    {
      p[place] += t2[place] >= own[place] * (1.0 - 1e-9) ? 1.0 : 0.0;
      pFamilyWise[place] += t2.maxCoeff() >= own[place] * (1.0 - 1e-9) ? 1.0 : 0.0;
    }
    orders += 1.0;
  } while (std::next_permutation(order.begin(), order.end()));
  EXPECT_EQ(static_cast<double>(result.permutations), orders);
  EXPECT_LT((result.p - p / orders).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT((result.pFamilyWise - pFamilyWise / orders).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(PermutationTest, PValuesOfNullDataAreUniform)
{
  std::vector<double> p;
  for (std::uint64_t trial = 0; trial < 400; ++trial)
  {
    Random       random(1000 + trial);
    const Matrix y = normalMatrix(20, 3, random);
    const Matrix z = normalMatrix(20, 1, random);
    auto         options = scalars(999, trial);
    options.componentsPerPlace = 3;
    p.push_back(permutationTest(MatrixTable(y), { groups(20), z }, options).p[0]);
  }
  EXPECT_LT(kolmogorovSmirnov(p), 1.36); // 5 %
}

TEST(PermutationTest, TheFamilyWiseErrorIsControlled)
{
  int found = 0;
  for (std::uint64_t trial = 0; trial < 200; ++trial)
  {
    Random random(5000 + trial);
    auto   options = scalars(199, trial);
    options.componentsPerPlace = 3;
    const Matrix y = normalMatrix(16, 3 * 30, random);
    found += permutationTest(MatrixTable(y), { groups(16), Matrix(16, 0) }, options).pFamilyWise.minCoeff() <= 0.05;
  }
  EXPECT_LE(found, 10 + 4 * 3.1); // 200 x 0.05, four standard errors
  EXPECT_GE(found, 1);
}

TEST(PermutationTest, TheFamilyWiseErrorIsControlledBesideACovariateThatGoesWithTheGroups)
{
  int found = 0;
  for (std::uint64_t trial = 0; trial < 400; ++trial)
  {
    Random       random(9000 + trial);
    auto         options = scalars(199, trial);
    const Vector age = 1.5 * groups(24) + Vector(normalMatrix(24, 1, random));
    const Matrix y = normalMatrix(24, 30, random) + age * Matrix::Constant(1, 30, 2.0); // by age alone
    found += permutationTest(MatrixTable(y), { groups(24), Matrix(age) }, options).pFamilyWise.minCoeff() <= 0.05;
  }
  EXPECT_LE(found, 20 + 4 * 4.4); // 400 x 0.05, four standard errors
  EXPECT_GE(found, 20 - 4 * 4.4);
}

TEST(PermutationTest, ABulgeOfTwoMillimetresInHalfOfFortyPhantomsIsFound)
{
  const HexMesh shape = softCube(8);
  const auto    centre = shape.nodeNumber(7, 4, 4);
  int           trialsWithFalseAlarms = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
  {
    PermutationOptions options;
    options.permutations = 999;
    options.seed = seed;
    const MatrixTable table(phantomsWithBulge(shape, shape.nodes[centre], 20, seed));
    const auto        result = permutationTest(table, { groups(40), Matrix(40, 0) }, options);
    EXPECT_EQ(result.pFamilyWise[static_cast<Eigen::Index>(centre)], 0.001);
    EXPECT_NEAR(result.slope(0, static_cast<Eigen::Index>(centre)), 2.0, 1.0);
    bool isFalseAlarm = false;
    for (std::size_t node = 0; node < shape.nodes.size(); ++node)
    {
      const bool isFar = (shape.nodes[node] - shape.nodes[centre]).norm() > 20.0; // bulge below 0.001 mm
      isFalseAlarm = isFalseAlarm || (isFar && result.pFamilyWise[static_cast<Eigen::Index>(node)] <= 0.05);
    }
    trialsWithFalseAlarms += isFalseAlarm ? 1 : 0;
  }
  EXPECT_LE(trialsWithFalseAlarms, 1 + 4); // 20 x 0.05, four standard errors
}

TEST(PermutationTest, AConfoundingCovariateIsNotTakenForTheGroup)
{
  // Age raises y, and the second group is older: without age in the model the groups differ.
  int withAge = 0;
  int without = 0;
  for (std::uint64_t trial = 0; trial < 100; ++trial)
  {
    Random       random(9000 + trial);
    const Vector group = groups(24);
    const Vector age = 60.0 + 5.0 * group.array() + 5.0 * normalMatrix(24, 1, random).col(0).array();
    const Matrix y = 0.3 * age + normalMatrix(24, 1, random);
    withAge += permutationTest(MatrixTable(y), { group, age }, scalars(199, trial)).p[0] <= 0.05;
    without += permutationTest(MatrixTable(y), { group, Matrix(24, 0) }, scalars(199, trial)).p[0] <= 0.05;
  }
  EXPECT_LE(withAge, 5 + 4 * 2.2);
  EXPECT_GE(without, 30);
}

TEST(PermutationTest, PlacesWithoutVariationHaveNoEffect)
{
  Random random(41);
  Matrix y(10, 6);
  y << Matrix::Constant(10, 3, 17.3), normalMatrix(10, 3, random);
  y.col(4).setConstant(2.0); // flat in one direction
  const auto result = permutationTest(MatrixTable(y), { groups(10), Matrix(10, 0) });
  EXPECT_EQ(result.statistic[0], 0.0);
  EXPECT_EQ(result.p[0], 1.0);
  EXPECT_TRUE(std::isfinite(result.statistic[1]));
  EXPECT_GT(result.p[1], 0.0);
}

TEST(PermutationTest, TheSameForAnyNumberOfThreads)
{
  Random             random(42);
  const MatrixTable  table(normalMatrix(30, 3 * 600, random));
  const Matrix       z = normalMatrix(30, 1, random);
  PermutationOptions options;
  options.permutations = 200;
  options.threads = 1;
  const auto one = permutationTest(table, { groups(30), z }, options);
  options.threads = 3;
  const auto three = permutationTest(table, { groups(30), z }, options);
  EXPECT_EQ(one.p, three.p);
  EXPECT_EQ(one.pFamilyWise, three.pFamilyWise);
  EXPECT_EQ(one.statistic, three.statistic);
}

TEST(FalseDiscoveryRates, AreThoseOfTheDefinition)
{
  const Vector p = (Vector(4) << 0.04, 0.01, 0.03, 0.5).finished();
  const Vector q = falseDiscoveryRates(p);
  EXPECT_NEAR(q[1], 0.04, 1e-15);
  EXPECT_NEAR(q[2], 4.0 * 0.04 / 3.0, 1e-15);
  EXPECT_NEAR(q[0], 4.0 * 0.04 / 3.0, 1e-15);
  EXPECT_NEAR(q[3], 0.5, 1e-15);
}

TEST(PermutationTest, Refusals)
{
  Random            random(43);
  const MatrixTable table(normalMatrix(6, 3, random));
  const auto        refusal = [&](const Vector & effect, const Matrix & nuisance, std::size_t components) {
    PermutationOptions options;
    options.componentsPerPlace = components;
    return analytic::messageOf([&] { (void)permutationTest(table, { effect, nuisance }, options); });
  };
  const Vector group = groups(6);
  EXPECT_EQ(refusal(groups(5), Matrix(6, 0), 3), "permutation test: 5 values of the effect for 6 subjects");
  EXPECT_EQ(refusal(group, Matrix::Ones(5, 1), 3), "permutation test: 5 values of the nuisance for 6 subjects");
  EXPECT_EQ(refusal(Vector::Ones(6), Matrix(6, 0), 3),
            "permutation test: the effect is constant, or the nuisance explains it");
  EXPECT_EQ(refusal(group, 2.0 * group, 1), "permutation test: the effect is constant, or the nuisance explains it");
  EXPECT_EQ(refusal(group, Matrix(6, 0), 2), "permutation test: 3 columns, need some for each place");
  EXPECT_EQ(refusal(group, Matrix(6, 0), 4), "permutation test: 1 to 3 components a place");
  EXPECT_EQ(refusal(group, normalMatrix(6, 3, random), 3),
            "permutation test: 6 subjects for 5 effects and 3 components");
  EXPECT_EQ(analytic::messageOf([&] {
              requireTestable({ group, normalMatrix(6, 3, random) });
            }),
            "permutation test: 6 subjects for 5 effects and 3 components");
  EXPECT_EQ(analytic::messageOf([&] {
              requireTestable({ Vector::Constant(6, 3.6), Matrix(6, 0) });
            }),
            "permutation test: the effect is constant, or the nuisance explains it");
  Vector bad = group;
  bad[0] = std::nan("");
  EXPECT_EQ(refusal(bad, Matrix(6, 0), 3), "permutation test: a value of the design is not finite");
}
