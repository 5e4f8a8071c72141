// Reductions and closed forms: to round-off. Rates on null data: within four standard errors, fixed seeds.
#include "moserhex/ShapeStatistics/GroupDesign.h"

#include "NullData.h"
#include "TestShapes.h"
#include "moserhex/Analytic/Refusals.h"

#include <Eigen/LU>

#include <gtest/gtest.h>

using namespace moserhex;
using namespace moserhex::testing;
using Matrix = Eigen::MatrixXd;

namespace
{

/** So many subjects of each of three groups, one after the other. */
std::vector<std::size_t>
threeGroups(std::size_t first, std::size_t second, std::size_t third)
{
  std::vector<std::size_t> groups(first, 0);
  groups.insert(groups.end(), second, 1);
  groups.insert(groups.end(), third, 2);
  return groups;
}

PermutationOptions
permutations(std::size_t count, std::uint64_t seed = 1)
{
  PermutationOptions options;
  options.permutations = count;
  options.seed = seed;
  options.threads = 1;
  return options;
}

} // namespace

TEST(GroupDesign, OfTwoGroupsTheTestIsHotellings)
{
  Random                   random(61);
  const MatrixTable        table(normalMatrix(14, 3 * 20, random));
  const Matrix             age = normalMatrix(14, 1, random);
  std::vector<std::size_t> groups(14, 0);
  std::fill(groups.begin() + 6, groups.end(), 1);
  Eigen::VectorXd zeroOne = Eigen::VectorXd::Zero(14);
  zeroOne.tail(8).setOnes();
  const auto manova = permutationTest(table, { groupColumns(groups, 2), age }, permutations(300));
  const auto hotelling = permutationTest(table, { zeroOne, age }, permutations(300));
  EXPECT_EQ(manova.statistic, hotelling.statistic);
  EXPECT_EQ(manova.p, hotelling.p);
  EXPECT_EQ(manova.pFamilyWise, hotelling.pFamilyWise);
  EXPECT_EQ(manova.standardisedDifference, hotelling.standardisedDifference);
  EXPECT_EQ(manova.slope, hotelling.slope);
}

TEST(GroupDesign, OfThreeGroupsTheStatisticIsPillaisTrace)
{
  Random       random(62);
  const Matrix y = normalMatrix(17, 3, random);
  const auto   groups = threeGroups(4, 6, 7);
  const auto   result = permutationTest(MatrixTable(y), { groupColumns(groups, 3), Matrix(17, 0) }, permutations(20));
  // Sums of squares between and within groups.
  const Eigen::RowVectorXd mean = y.colwise().mean();
  Matrix                   between = Matrix::Zero(3, 3);
  Matrix                   within = Matrix::Zero(3, 3);
  for (const auto & [first, size] : { std::pair(0, 4), std::pair(4, 6), std::pair(10, 7) })
  {
    const Matrix             rows = y.middleRows(first, size);
    const Eigen::RowVectorXd own = rows.colwise().mean();
    const Matrix             left = rows.rowwise() - own;
    between += size * (own - mean).transpose() * (own - mean);
    within += left.transpose() * left;
  }
  const double pillai = (between * (between + within).inverse()).trace();
  EXPECT_EQ(result.degreesOfFreedom, 14u);
  EXPECT_NEAR(result.pillaiTrace[0], pillai, 1e-10);
  EXPECT_NEAR(result.partialCorrelation[0], std::sqrt(pillai / 2.0), 1e-10); // s = 2
  EXPECT_NEAR(result.statistic[0], 14.0 * pillai / (2.0 - pillai), 1e-9);
  EXPECT_EQ(result.standardisedDifference.size(), 0);
}

TEST(GroupDesign, TheOrderOfTheGroupsDoesNotMatter)
{
  Random            random(63);
  const MatrixTable table(normalMatrix(18, 3 * 5, random));
  const Matrix      age = normalMatrix(18, 1, random);
  auto              groups = threeGroups(5, 6, 7);
  const auto        first = permutationTest(table, { groupColumns(groups, 3), age }, permutations(200));
  std::transform(groups.begin(), groups.end(), groups.begin(), [](std::size_t group) { return (group + 1) % 3; });
  const auto second = permutationTest(table, { groupColumns(groups, 3), age }, permutations(200));
  EXPECT_LT((first.statistic - second.statistic).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_EQ(first.p, second.p);
}

TEST(GroupDesign, DisplacementsAreTheGroupsMeansLessTheMeanOfAll)
{
  Random       random(64);
  const Matrix y = normalMatrix(15, 6, random);
  const auto   groups = threeGroups(3, 5, 7);
  const auto   result = permutationTest(MatrixTable(y), { groupColumns(groups, 3), Matrix(15, 0) }, permutations(5));
  const auto   displacements = groupDisplacements(result.slope, { 3, 5, 7 });
  ASSERT_EQ(displacements.size(), 3u);
  const Eigen::RowVectorXd mean = y.colwise().mean();
  const Eigen::RowVectorXd second = y.middleRows(3, 5).colwise().mean() - mean;
  EXPECT_LT((Eigen::Map<const Eigen::VectorXd>(displacements[1].data(), 6) - second.transpose()).norm(), 1e-12);
  EXPECT_LT((3.0 * displacements[0] + 5.0 * displacements[1] + 7.0 * displacements[2]).norm(), 1e-12);
}

TEST(GroupDesign, ACovariateIsTakenOutOfTheDisplacements)
{
  // y = age, and the groups differ in age only.
  const auto      groups = threeGroups(6, 6, 6);
  Random          random(65);
  Eigen::VectorXd age = normalMatrix(18, 1, random);
  age.tail(6).array() += 3.0;
  Matrix y(18, 3);
  y << age, 2.0 * age, -age;
  y += 1e-9 * normalMatrix(18, 3, random);
  const auto result = permutationTest(MatrixTable(y), { groupColumns(groups, 3), age }, permutations(5));
  for (const Matrix & displacement : groupDisplacements(result.slope, { 6, 6, 6 }))
  {
    EXPECT_LT(displacement.norm(), 1e-8);
  }
}

TEST(GroupDesign, PValuesOfNullDataAreUniform)
{
  std::vector<double> p;
  for (std::uint64_t trial = 0; trial < 400; ++trial)
  {
    Random       random(20000 + trial);
    const Matrix y = normalMatrix(21, 3, random);
    const Matrix z = normalMatrix(21, 1, random);
    p.push_back(
      permutationTest(MatrixTable(y), { groupColumns(threeGroups(6, 7, 8), 3), z }, permutations(999, trial)).p[0]);
  }
  EXPECT_LT(kolmogorovSmirnov(p), 1.36); // 5 %
}

TEST(GroupDesign, ABulgeInOneOfThreeGroupsIsFoundAndIsOfThatGroup)
{
  const HexMesh shape = softCube(8);
  const auto    centre = shape.nodeNumber(7, 4, 4);
  const auto    groups = threeGroups(13, 13, 14);
  int           trialsWithFalseAlarms = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed)
  {
    const MatrixTable table(phantomsWithBulge(shape, shape.nodes[centre], 26, seed));
    const auto result = permutationTest(table, { groupColumns(groups, 3), Matrix(40, 0) }, permutations(999, seed));
    const auto displacements = groupDisplacements(result.slope, { 13, 13, 14 });
    EXPECT_LE(result.pFamilyWise[static_cast<Eigen::Index>(centre)], 0.01);
    const Vector3 third = displacements[2].col(static_cast<Eigen::Index>(centre));
    EXPECT_NEAR(third[0], 2.0 * 26.0 / 40.0, 0.7);
    EXPECT_LT(displacements[0](0, static_cast<Eigen::Index>(centre)), third[0]);
    EXPECT_LT(displacements[1](0, static_cast<Eigen::Index>(centre)), third[0]);
    bool isFalseAlarm = false;
    for (std::size_t node = 0; node < shape.nodes.size(); ++node)
    {
      const bool isFar = (shape.nodes[node] - shape.nodes[centre]).norm() > 20.0; // bulge below 0.001 mm
      isFalseAlarm = isFalseAlarm || (isFar && result.pFamilyWise[static_cast<Eigen::Index>(node)] <= 0.05);
    }
    trialsWithFalseAlarms += isFalseAlarm ? 1 : 0;
  }
  EXPECT_LE(trialsWithFalseAlarms, 3); // 10 x 0.05, four standard errors
}

TEST(GroupDesign, Refusals)
{
  EXPECT_EQ(analytic::messageOf([] {
              (void)groupColumns({ 0, 0 }, 1);
            }),
            "groups: 1 groups, need at least 2, and no subject of another");
  EXPECT_EQ(analytic::messageOf([] {
              (void)groupColumns({ 0, 1, 2 }, 2);
            }),
            "groups: 2 groups, need at least 2, and no subject of another");
  EXPECT_EQ(analytic::messageOf([] {
              (void)groupDisplacements(Matrix(3, 4), { 2, 2, 2 });
            }),
            "groups: 3 slopes at a place for 3 groups of 6 subjects");
  Random            random(66);
  const MatrixTable table(normalMatrix(9, 3, random));
  // Nobody in the third group.
  EXPECT_EQ(analytic::messageOf([&] {
              (void)permutationTest(table, { groupColumns(threeGroups(5, 4, 0), 3), Matrix(9, 0) }, permutations(5));
            }),
            "permutation test: the effect is constant, or the nuisance explains it");
}
