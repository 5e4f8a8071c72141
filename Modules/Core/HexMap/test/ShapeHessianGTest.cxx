// Taylor remainders of the gradient: slope fitted, within 0.1 of 2. Identities: round-off (1e-11 of the largest entry
// or of the quadratic form's terms). Threads: bit for bit.
#include "ShapeHessian.h"

#include "TestEnergies.h"
#include "moserhex/Common/Errors.h"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <vector>

using namespace moserhex;
using namespace moserhex::testing;

namespace
{
using Eigen::VectorXd;

const HessianForm bothForms[] = { HessianForm::Full, HessianForm::GaussNewton };

/** The energy on one lattice, with uneven targets. */
struct Problem
{
  LatticeLayout      layout;
  VectorXd           x;
  VectorXd           targets;
  ShapeEnergyWeights weights;

  Problem(const HexMesh & mesh, const ShapeEnergyWeights & weights_)
    : layout(mesh.nodesPerSide), x(vectorOf(mesh)), targets(unitTargetVolumes(layout)), weights(weights_)
  {
    Random random(31);
    for (Eigen::Index node = 0; node < targets.size(); ++node)
    {
      targets[node] *= random.uniform(0.5, 2.0);
    }
  }

  [[nodiscard]] VectorXd
  gradient(const VectorXd & at) const
  {
    VectorXd result = VectorXd::Zero(layout.size());
    (void)addShapeEnergy(layout, at, targets, weights, 1, result);
    return result;
  }

  [[nodiscard]] VectorXd
  product(const VectorXd & direction, HessianForm form, unsigned int threads = 1) const
  {
    VectorXd result = VectorXd::Zero(layout.size());
    addShapeHessianProduct(layout, x, direction, targets, weights, form, threads, result);
    return result;
  }

  [[nodiscard]] VectorXd
  randomDirection(std::uint64_t seed) const
  {
    return vectorOf(unitCells(layout.nodesPerSide, 1.0, seed)) - vectorOf(unitCells(layout.nodesPerSide, 0.0, seed));
  }
};

HexMesh
mirrored(HexMesh mesh)
{
  for (Vector3 & node : mesh.nodes)
  {
    node.x() *= -1.0;
  }
  return mesh;
}

/** Regular, distorted, tangled and inverted lattices. */
std::vector<HexMesh>
lattices()
{
  return { unitCells(5, 0.0, 1), unitCells(5, 0.2, 2), unitCells(5, 1.5, 3), mirrored(unitCells(5, 0.2, 4)) };
}

/** One cell of edges 1, 1 and a height of any sign. */
HexMesh
box(double height)
{
  return mappedLattice(2, [height](const Vector3 & x) { return Vector3(x[0], x[1], height * x[2]); });
}

/** Of the Gauss-Newton form, over the largest; of the matrix itself. */
double
smallestEigenvalue(const Problem & problem)
{
  const auto      size = problem.layout.size();
  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(size, size);
  for (std::size_t component = 0; component < 3; ++component)
  {
    for (std::size_t node = 0; node < problem.layout.nodes; ++node)
    {
      const auto column = static_cast<Eigen::Index>(component * problem.layout.stride + node);
      H.col(column) = problem.product(VectorXd::Unit(size, column), HessianForm::GaussNewton);
    }
  }
  const VectorXd eigenvalues = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(H).eigenvalues();
  return eigenvalues.minCoeff() / eigenvalues.maxCoeff();
}

/** Fitted order of |grad E(x + t d) - grad E(x) - t H d| in t; t down from `largestStep` by halves. */
double
taylorOrderOfGradient(const Problem & problem, double largestStep)
{
  const VectorXd      direction = problem.randomDirection(17);
  const VectorXd      gradient = problem.gradient(problem.x);
  const VectorXd      product = problem.product(direction, HessianForm::Full);
  std::vector<double> steps;
  std::vector<double> remainders;
  for (double step = largestStep; step > 0.1 * largestStep; step *= 0.5)
  {
    steps.push_back(step);
    remainders.push_back((problem.gradient(problem.x + step * direction) - gradient - step * product).norm());
  }
  return analytic::observedOrder(steps, remainders);
}

} // namespace

TEST(ShapeHessian, OfDistortedLatticesHasTaylorRemainderOfSecondOrder)
{
  for (const double volumeWeight : { 0.0, 50.0 })
  {
    const Problem problem(unitCells(5, 0.2, 6), { 0.1, volumeWeight, 1 });
    EXPECT_NEAR(taylorOrderOfGradient(problem, 1e-3), 2.0, 0.1) << volumeWeight;
  }
}

TEST(ShapeHessian, OfInvertedLatticesHasTaylorRemainderOfSecondOrder)
{
  for (const double epsilon : { 0.02, 0.1 })
  {
    const Problem tangled(unitCells(5, 1.5, 7), { epsilon, 50.0, 1 });
    EXPECT_NEAR(taylorOrderOfGradient(tangled, 1e-3 * epsilon), 2.0, 0.1) << epsilon;
    const Problem inverted(mirrored(unitCells(5, 0.2, 8)), { epsilon, 50.0, 1 });
    EXPECT_NEAR(taylorOrderOfGradient(inverted, 1e-3), 2.0, 0.1) << epsilon;
  }
}

TEST(ShapeHessian, IsSymmetric)
{
  for (const HexMesh & mesh : lattices())
  {
    const Problem  problem(mesh, { 0.05, 50.0, 1 });
    const VectorXd u = problem.randomDirection(9);
    const VectorXd v = problem.randomDirection(10);
    for (const HessianForm form : bothForms)
    {
      const VectorXd Hu = problem.product(u, form);
      const VectorXd Hv = problem.product(v, form);
      EXPECT_NEAR(u.dot(Hv), v.dot(Hu), 1e-11 * u.norm() * Hv.norm());
    }
  }
}

TEST(ShapeHessian, IsLinearInTheVectorAndAdded)
{
  for (const HessianForm form : bothForms)
  {
    const Problem  problem(unitCells(5, 0.8, 11), { 0.05, 50.0, 1 });
    const VectorXd u = problem.randomDirection(12);
    const VectorXd v = problem.randomDirection(13);
    VectorXd       sum = problem.product(1e-9 * u, form) * 1e9;
    addShapeHessianProduct(problem.layout, problem.x, v, problem.targets, problem.weights, form, 1, sum);
    const VectorXd expected = problem.product(u + v, form);
    EXPECT_LT((sum - expected).cwiseAbs().maxCoeff(), 1e-11 * expected.cwiseAbs().maxCoeff());
  }
}

TEST(ShapeHessian, GaussNewtonIsPositiveSemidefinite)
{
  for (const double amplitude : { 0.0, 0.2, 0.7, 1.5 })
  {
    EXPECT_GT(smallestEigenvalue(Problem(unitCells(3, amplitude, 14), { 0.05, 50.0, 1 })), -1e-11) << amplitude;
    EXPECT_GT(smallestEigenvalue(Problem(mirrored(unitCells(3, amplitude, 15)), { 0.05, 50.0, 1 })), -1e-11)
      << amplitude;
  }
}

TEST(ShapeHessian, GaussNewtonIsPositiveSemidefiniteForFlatCells)
{
  // Where the bound in the header is nearly attained: edges orthogonal to their cofactors.
  for (const double height : { -0.01, 0.0, 0.01 })
  {
    EXPECT_GT(smallestEigenvalue(Problem(box(height), { 0.02, 0.0, 1 })), -1e-11) << height;
  }
}

TEST(ShapeHessian, FullFormAloneIsNegativeAlongTheWayOutOfAnInvertedCell)
{
  // A cell of height -h costs about (2 + h^2) h^(2/3) times a constant, concave in h below 0.3.
  const Problem  problem(box(-0.2), { 0.02, 0.0, 1 });
  const VectorXd way = vectorOf(box(0.8)) - problem.x;
  EXPECT_LT(way.dot(problem.product(way, HessianForm::Full)), 0.0);
  EXPECT_GT(way.dot(problem.product(way, HessianForm::GaussNewton)), 0.0);
}

TEST(ShapeHessian, SendsTranslationsToZero)
{
  const Problem problem(unitCells(5, 0.8, 18), { 0.05, 50.0, 1 });
  VectorXd      shift = VectorXd::Zero(problem.layout.size());
  for (std::size_t node = 0; node < problem.layout.nodes; ++node)
  {
    problem.layout.add(shift, node, Vector3(1.0, -2.0, 0.5));
  }
  for (const HessianForm form : bothForms)
  {
    EXPECT_EQ(problem.product(shift, form).cwiseAbs().maxCoeff(), 0.0);
  }
}

TEST(ShapeHessian, CellsWithoutATargetDoNotContribute)
{
  Problem           problem(unitCells(7, 0.7, 14), { 0.1, 50.0, 1 });
  const std::size_t only = problem.layout.node(5, 2, 3); // the last cell of its row
  const double      target = problem.targets[static_cast<Eigen::Index>(only)];
  problem.targets.setZero();
  problem.targets[static_cast<Eigen::Index>(only)] = target;
  for (const HessianForm form : bothForms)
  {
    const VectorXd product = problem.product(problem.randomDirection(19), form);
    for (std::size_t node = 0; node < problem.layout.nodes; ++node)
    {
      bool isCorner = false;
      for (const std::size_t corner : problem.layout.corner)
      {
        isCorner = isCorner || node == only + corner;
      }
      EXPECT_EQ(problem.layout.at(product, node) == Vector3::Zero(), !isCorner) << node;
    }
  }
}

TEST(ShapeHessian, IsTheSameForAnyNumberOfThreads)
{
  for (const int n : { 14, 17, 20 })
  {
    const Problem  problem(unitCells(n, 0.6, 16), { 0.05, 50.0, 1 });
    const VectorXd direction = problem.randomDirection(17);
    for (const HessianForm form : bothForms)
    {
      const VectorXd one = problem.product(direction, form, 1);
      for (const unsigned int threads : { 2u, 3u, 0u })
      {
        EXPECT_TRUE(one == problem.product(direction, form, threads)) << n << " " << threads;
      }
    }
  }
}

TEST(ShapeHessian, OtherPowersThanOneAreRefused)
{
  const Problem problem(unitCells(3, 0.1, 1), { 0.05, 50.0, 2 });
  EXPECT_THROW((void)problem.product(problem.x, HessianForm::Full), InvalidInput);
}
