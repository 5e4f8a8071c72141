// Against the formula written out in scalars, and identities: round-off (1e-13 of the value, 1e-11 of the largest entry
// of a gradient). Taylor remainders: slope fitted, within 0.1 of 2. Threads and instruction sets: bit for bit.
#include "ShapeEnergy.h"

#include "CellKernels.h"
#include "ShapeEnergyInstructionSets.h"
#include "TestEnergies.h"
#include "moserhex/Analytic/SurfaceShapes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

using namespace moserhex;
using namespace moserhex::testing;

namespace
{
using Eigen::VectorXd;

LatticeEnergy
shapeEnergy(int n, const ShapeEnergyWeights & weights, VectorXd targets = {}, unsigned int threads = 1)
{
  const LatticeLayout layout(n);
  if (targets.size() == 0)
  {
    targets = unitTargetVolumes(layout);
  }
  return [=](const VectorXd & x, VectorXd & gradient) {
    return addShapeEnergy(layout, x, targets, weights, threads, gradient);
  };
}

/** f of one corner with the edges as columns. */
double
meanRatio(const Matrix3 & J, double epsilon)
{
  const double d = J.determinant();
  const double r = std::sqrt(epsilon * epsilon + d * d);
  const double chi = d > 0.0 ? 0.5 * (d + r) : 0.5 * epsilon * epsilon / (r - d);
  return J.squaredNorm() / (3.0 * std::cbrt(chi * chi));
}

/** The energy of one cell as the header states it. */
double
referenceEnergy(const HexCorners & corners, double target, const ShapeEnergyWeights & weights)
{
  // The neighbours of each VTK corner along i, j, k, with the sign that makes the edges point upwards.
  constexpr std::size_t next[8][3] = { { 1, 3, 4 }, { 0, 2, 5 }, { 3, 1, 6 }, { 2, 0, 7 },
                                       { 5, 7, 0 }, { 4, 6, 1 }, { 7, 5, 2 }, { 6, 4, 3 } };
  constexpr double      sign[8][3] = { { 1, 1, 1 },  { -1, 1, 1 },  { -1, -1, 1 },  { 1, -1, 1 },
                                       { 1, 1, -1 }, { -1, 1, -1 }, { -1, -1, -1 }, { 1, -1, -1 } };
  double                energy = 0.0;
  for (std::size_t a = 0; a < 8; ++a)
  {
    Matrix3 J;
    for (std::size_t d = 0; d < 3; ++d)
    {
      J.col(static_cast<Eigen::Index>(d)) = sign[a][d] * (corners[next[a][d]] - corners[a]);
    }
    energy += std::pow(meanRatio(J, weights.regularisation), weights.power) / 8.0;
    const double scaledJacobian = J.determinant() / (J.col(0).norm() * J.col(1).norm() * J.col(2).norm());
    energy += weights.angle * std::pow(1.0 - scaledJacobian, 2) / 8.0;
  }
  return energy + 0.5 * weights.volume * std::pow(hexVolume(corners) / target - 1.0, 2);
}

double
referenceEnergy(const HexMesh & mesh, const VectorXd & targets, const ShapeEnergyWeights & weights)
{
  const LatticeLayout layout(mesh.nodesPerSide, mesh.paddingLayers);
  double              sum = 0.0;
  for (std::size_t cell = 0; cell < mesh.cellCount(); ++cell)
  {
    const double target = targets[static_cast<Eigen::Index>(layout.slot(cell))];
    sum += target > 0.0 ? referenceEnergy(cellCorners(mesh, cell), target, weights) : 0.0;
  }
  return sum;
}

/** Uneven targets in [0.5, 2) and, of every third cell or so, none. */
VectorXd
patchyTargets(int n, std::uint64_t seed, int layers = 0)
{
  Random   random(seed);
  VectorXd targets = unitTargetVolumes(LatticeLayout(n, layers));
  for (Eigen::Index node = 0; node < targets.size(); ++node)
  {
    targets[node] *= random.uniform() < 0.3 ? 0.0 : random.uniform(0.5, 2.0);
  }
  return targets;
}

} // namespace

TEST(ShapeEnergy, PerfectCubesHaveTheirLeastValue)
{
  for (const int power : { 1, 2, 3 })
  {
    for (const double epsilon : { 1e-9, 0.1 })
    {
      // |J|^2 = 3 and det J = 1 at every corner, and no deviation of the volume.
      const double   chi = 0.5 * (1.0 + std::sqrt(1.0 + epsilon * epsilon));
      const double   expected = 125.0 * std::pow(chi, -2.0 / 3.0 * power);
      const VectorXd x = vectorOf(unitCells(6, 0.0, 1));
      const auto     energy = shapeEnergy(6, { epsilon, 50.0, power });
      EXPECT_NEAR(valueAt(energy, x), expected, 1e-13 * expected) << power << " " << epsilon;
    }
  }
}

TEST(ShapeEnergy, PerfectCubesAreStationary)
{
  const VectorXd gradient = gradientAt(shapeEnergy(6, { 1e-9, 50.0, 2 }), vectorOf(unitCells(6, 0.0, 1)));
  EXPECT_LT(gradient.cwiseAbs().maxCoeff(), 1e-13);
}

TEST(ShapeEnergy, IsItsFormulaInScalars)
{
  for (const int n : { 2, 3, 6, 9 })
  {
    for (const double amplitude : { 0.1, 0.5, 2.0 })
    {
      for (const int power : { 1, 2, 3 })
      {
        const HexMesh            mesh = unitCells(n, amplitude, 3);
        const ShapeEnergyWeights weights{ 0.05, 7.0, power };
        const VectorXd           targets = patchyTargets(n, 4);
        const double             expected = referenceEnergy(mesh, targets, weights);
        EXPECT_NEAR(valueAt(shapeEnergy(n, weights, targets), vectorOf(mesh)), expected, 1e-13 * expected)
          << n << " " << amplitude << " " << power;
      }
    }
  }
}

namespace
{

LatticeEnergy
paddedShapeEnergy(int n, int layers, const ShapeEnergyWeights & weights, const VectorXd & targets)
{
  return [=](const VectorXd & x, VectorXd & gradient) {
    return addShapeEnergy(LatticeLayout(n, layers), x, targets, weights, 1, gradient);
  };
}

} // namespace

TEST(ShapeEnergy, WithPaddingAndAnglesIsItsFormulaInScalars)
{
  for (const auto & [n, layers] : { std::pair(2, 1), std::pair(3, 2), std::pair(6, 1), std::pair(5, 0) })
  {
    for (const double amplitude : { 0.1, 0.5, 2.0 })
    {
      const HexMesh            mesh = paddedUnitCells(n, layers, amplitude, 3);
      const ShapeEnergyWeights weights{ 0.05, 7.0, 2, 20.0 };
      const VectorXd           targets = patchyTargets(n, 4, layers);
      const double             expected = referenceEnergy(mesh, targets, weights);
      EXPECT_NEAR(valueAt(paddedShapeEnergy(n, layers, weights, targets), vectorOf(mesh)), expected, 1e-13 * expected)
        << n << " " << layers << " " << amplitude;
    }
  }
}

TEST(ShapeEnergy, GradientWithPaddingAndAnglesHasTaylorRemainderOfSecondOrder)
{
  for (const auto & [amplitude, step] : { std::pair(0.2, 1e-3), std::pair(1.5, 1e-4) })
  {
    const auto energy = paddedShapeEnergy(4, 2, { 0.1, 50.0, 1, 20.0 }, patchyTargets(4, 5, 2));
    EXPECT_NEAR(taylorOrder(energy, paddedUnitCells(4, 2, amplitude, 6), step), 2.0, 0.1) << amplitude;
  }
}

TEST(ShapeEnergy, GradientOfDistortedLatticesHasTaylorRemainderOfSecondOrder)
{
  for (const int power : { 1, 2, 3 })
  {
    const auto energy = shapeEnergy(5, { 0.1, 50.0, power }, patchyTargets(5, 5));
    EXPECT_NEAR(taylorOrder(energy, unitCells(5, 0.2, 6), 1e-3), 2.0, 0.1) << power;
  }
}

TEST(ShapeEnergy, GradientOfInvertedLatticesHasTaylorRemainderOfSecondOrder)
{
  for (const int power : { 1, 2, 3 })
  {
    for (const double epsilon : { 0.02, 0.1 })
    {
      const auto energy = shapeEnergy(5, { epsilon, 50.0, power });
      EXPECT_NEAR(taylorOrder(energy, unitCells(5, 1.5, 7), 1e-3 * epsilon), 2.0, 0.1) << power << " " << epsilon;
      HexMesh mirrored = unitCells(5, 0.2, 8);
      for (Vector3 & node : mirrored.nodes)
      {
        node.x() *= -1.0;
      }
      EXPECT_NEAR(taylorOrder(energy, mirrored, 1e-3), 2.0, 0.1) << power << " " << epsilon;
    }
  }
}

TEST(ShapeEnergy, IsFiniteForInvertedCellsAndFallsOnTheWayOut)
{
  double previous = std::numeric_limits<double>::infinity();
  for (const double height : { -2.0, -1.0, -0.5, -0.1, -0.01, 0.0, 0.01, 0.1, 0.5, 0.9 })
  {
    const HexMesh mesh = mappedLattice(2, [&](const Vector3 & x) { return Vector3(x[0], x[1], height * x[2]); });
    const double  energy = valueAt(shapeEnergy(2, { 0.1, 0.0, 1 }), vectorOf(mesh));
    EXPECT_TRUE(std::isfinite(energy));
    EXPECT_LT(energy, previous) << height;
    previous = energy;
  }
}

TEST(ShapeEnergy, DoesNotDependOnRotationAndTranslation)
{
  const HexMesh mesh = unitCells(5, 0.6, 9);
  const Matrix3 turn = analytic::rotation(Vector3(1.0, -2.0, 0.5), 0.7);
  HexMesh       moved = mesh;
  for (Vector3 & node : moved.nodes)
  {
    node = turn * node + Vector3(3.0, -2.0, 1.0);
  }
  const auto          energy = shapeEnergy(5, { 0.1, 5.0, 2 }, patchyTargets(5, 10));
  const double        value = valueAt(energy, vectorOf(mesh));
  const VectorXd      gradient = gradientAt(energy, vectorOf(mesh));
  const VectorXd      movedGradient = gradientAt(energy, vectorOf(moved));
  const LatticeLayout layout(5);
  EXPECT_NEAR(valueAt(energy, vectorOf(moved)), value, 1e-12 * value);
  for (std::size_t node = 0; node < layout.nodes; ++node)
  {
    EXPECT_LT((layout.at(movedGradient, node) - turn * layout.at(gradient, node)).norm(),
              1e-11 * gradient.cwiseAbs().maxCoeff());
  }
}

TEST(ShapeEnergy, ExertsNeitherForceNorTorqueOnTheWhole)
{
  const VectorXd      x = vectorOf(unitCells(6, 0.8, 11));
  const VectorXd      gradient = gradientAt(shapeEnergy(6, { 0.05, 50.0, 3 }), x);
  const LatticeLayout layout(6);
  Vector3             force = Vector3::Zero();
  Vector3             torque = Vector3::Zero();
  for (std::size_t node = 0; node < layout.nodes; ++node)
  {
    force += layout.at(gradient, node);
    torque += layout.at(x, node).cross(layout.at(gradient, node));
  }
  EXPECT_LT(force.norm(), 1e-11 * gradient.cwiseAbs().maxCoeff());
  EXPECT_LT(torque.norm(), 1e-11 * gradient.cwiseAbs().maxCoeff());
}

TEST(ShapeEnergy, DoesNotDependOnScaleWhenRegularisationAndTargetsScaleToo)
{
  const HexMesh  mesh = unitCells(5, 0.6, 12);
  const VectorXd targets = patchyTargets(5, 13);
  const double   value = valueAt(shapeEnergy(5, { 0.1, 5.0, 2 }, targets), vectorOf(mesh));
  for (const double scale : { 1e-3, 0.3, 20.0 })
  {
    const double volume = scale * scale * scale;
    const auto   scaled = shapeEnergy(5, { 0.1 * volume, 5.0, 2 }, volume * targets);
    EXPECT_NEAR(valueAt(scaled, scale * vectorOf(mesh)), value, 1e-12 * value) << scale;
  }
}

TEST(ShapeEnergy, CellsWithoutATargetDoNotContribute)
{
  const int           n = 7;
  const LatticeLayout layout(n);
  VectorXd            targets = VectorXd::Zero(static_cast<Eigen::Index>(layout.stride));
  const std::size_t   only = layout.node(5, 2, 3); // the last cell of its row: its lane is followed by masked ones
  targets[static_cast<Eigen::Index>(only)] = 1.0;
  const HexMesh  mesh = unitCells(n, 0.7, 14);
  const VectorXd gradient = gradientAt(shapeEnergy(n, { 0.1, 50.0, 1 }, targets), vectorOf(mesh));
  for (std::size_t node = 0; node < layout.nodes; ++node)
  {
    bool isCorner = false;
    for (const std::size_t corner : layout.corner)
    {
      isCorner = isCorner || node == only + corner;
    }
    EXPECT_EQ(layout.at(gradient, node) == Vector3::Zero(), !isCorner) << node;
  }
}

TEST(ShapeEnergy, GradientIsAdded)
{
  const VectorXd      x = vectorOf(unitCells(4, 0.3, 15));
  const auto          energy = shapeEnergy(4, { 0.1, 5.0, 1 });
  const LatticeLayout layout(4);
  VectorXd            sum = VectorXd::Constant(layout.size(), 2.0);
  layout.clearPadding(sum);
  const VectorXd before = sum;
  (void)energy(x, sum);
  EXPECT_LT((sum - before - gradientAt(energy, x)).cwiseAbs().maxCoeff(), 1e-13);
}

TEST(ShapeEnergy, IsTheSameForAnyNumberOfThreads)
{
  for (const int n : { 14, 17, 20 })
  {
    const VectorXd           x = vectorOf(unitCells(n, 0.6, 16));
    const VectorXd           targets = patchyTargets(n, 17);
    const ShapeEnergyWeights weights{ 0.05, 50.0, 2 };
    const auto               one = shapeEnergy(n, weights, targets, 1);
    for (const unsigned int threads : { 2u, 3u, 0u })
    {
      const auto several = shapeEnergy(n, weights, targets, threads);
      EXPECT_EQ(valueAt(one, x), valueAt(several, x)) << n;
      EXPECT_TRUE(gradientAt(one, x) == gradientAt(several, x)) << n;
      EXPECT_TRUE(latticeVolumes(LatticeLayout(n), x, 1) == latticeVolumes(LatticeLayout(n), x, threads)) << n;
    }
  }
}

class ShapeEnergyOf : public ::testing::TestWithParam<const char *>
{};

INSTANTIATE_TEST_SUITE_P(InstructionSet,
                         ShapeEnergyOf,
                         ::testing::ValuesIn(shapeEnergyVariantNames),
                         [](const auto & set) { return std::string(set.param); });

TEST_P(ShapeEnergyOf, AnInstructionSetIsTheSame)
{
  const std::vector<ShapeEnergyVariant> variants = shapeEnergyVariants();
  const auto                            variant =
    std::find_if(variants.begin(), variants.end(), [](const ShapeEnergyVariant & v) { return v.name == GetParam(); });
  if (variant == variants.end())
  {
    GTEST_SKIP() << "not run: this machine has no " << GetParam();
  }
  for (const int n : { 2, 5, 10 })
  {
    const LatticeLayout layout(n);
    for (const double amplitude : { 0.0, 0.3, 2.0 })
    {
      const VectorXd x = vectorOf(unitCells(n, amplitude, 18));
      const VectorXd targets = patchyTargets(n, 19);
      for (const int power : { 1, 3 })
      {
        const ShapeEnergyWeights weights{ 0.05, 50.0, power };
        const auto               energy = shapeEnergy(n, weights, targets);
        VectorXd                 gradient = VectorXd::Zero(layout.size());
        EXPECT_EQ(variant->addEnergy(layout, x, targets, weights, 1, gradient), valueAt(energy, x));
        EXPECT_TRUE(gradient == gradientAt(energy, x));
        EXPECT_TRUE(variant->volumes(layout, x, 1) == latticeVolumes(layout, x, 1));
      }
    }
  }
}

TEST(LatticeVolumes, AreThoseOfTheCells)
{
  for (const auto & [n, layers] : { std::pair(2, 0), std::pair(3, 0), std::pair(8, 0), std::pair(4, 2) })
  {
    const HexMesh             mesh = paddedUnitCells(n, layers, 0.8, 20); // some inverted
    const LatticeLayout       layout(n, layers);
    const std::vector<double> expected = cellVolumes(mesh);
    VectorXd                  volumes = latticeVolumes(layout, vectorOf(mesh), 1);
    ASSERT_EQ(volumes.size(), layout.slotCount());
    for (std::size_t cell = 0; cell < expected.size(); ++cell)
    {
      double & volume = volumes[static_cast<Eigen::Index>(layout.slot(cell))];
      EXPECT_NEAR(volume, expected[cell], 1e-13 * 27.0) << n << " " << cell;
      volume = 0.0;
    }
    EXPECT_EQ(volumes, VectorXd::Zero(volumes.size())) << n; // nothing where no cell begins
  }
}

TEST(LatticeVolumes, UnitTargetsStandAtTheCells)
{
  const LatticeLayout layout(5);
  const VectorXd      targets = unitTargetVolumes(layout);
  EXPECT_EQ(targets.sum(), 64.0);
  for (std::size_t cell = 0; cell < 64; ++cell)
  {
    EXPECT_EQ(targets[static_cast<Eigen::Index>(layout.firstNode(cell))], 1.0);
  }
}

TEST(Lanes, InverseCubeRootIsExactToRoundOff)
{
  for (double x = 1e-60; x < 1e60; x *= 1.37)
  {
    const double root = inverseCubeRoot(allLanes(x))[3];
    EXPECT_NEAR(root * std::cbrt(x), 1.0, 1e-15) << x;
  }
}

TEST(Lanes, SelectTakesNothingOfWhatItLeavesOut)
{
  Lanes a = allLanes(1.0);
  Lanes b = allLanes(2.0);
  a[2] = std::numeric_limits<double>::quiet_NaN();
  b[5] = std::numeric_limits<double>::infinity();
  LaneMask    yes = a > Lanes{}; // NaN is not
  const Lanes chosen = select(yes, a, b);
  for (std::size_t lane = 0; lane < laneCount; ++lane)
  {
    EXPECT_EQ(chosen[lane], lane == 2 ? 2.0 : 1.0);
  }
}
