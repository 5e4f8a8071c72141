// Derivatives: Taylor remainders fall with slope 2 (gradient) and 3 (second derivatives), within 0.1. Minimiser:
// iteration class, the last Newton step is below 1e-6 rad and converges quadratically, so 1e-7 between two starts.
#include "../src/AreaBarrierSystem.h"

#include "TestPositions.h"
#include "moserhex/Analytic/ObservedOrder.h"
#include "moserhex/Analytic/SurfaceShapes.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Random.h"
#include "moserhex/DiscreteCalculus/TriangleOperators.h"
#include "moserhex/SphericalMap/AreaBarrier.h"
#include "moserhex/SphericalMap/FrameAlignment.h"
#include "moserhex/SphericalMap/SphereMapQuality.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <limits>

using namespace moserhex;
using namespace moserhex::testing;

namespace
{

/** An uneven surface and, as a map without flips, the directions from its centre. */
struct Problem
{
  TriangleMesh        surface;
  Positions           sphere;
  TriangleTopology    topology;
  std::vector<double> targets;
  std::vector<double> weights;

  explicit Problem(int level)
    : surface(
        analytic::starShapedSurface(level,
                                    [](const Vector3 & n) { return 20.0 * (1.0 + 0.4 * n[0] * n[1] + 0.3 * n[2]); }))
    , sphere(analytic::icosphere(level).vertices)
    , topology(triangleTopology(surface))
    , targets(targetSolidAngles(surface))
    , weights(clampedCotanWeights(surface, topology, 0.02, 10.0))
  {}

  [[nodiscard]] AreaBarrierSystem
  system() const
  {
    return { surface.triangles, topology, targets, weights };
  }

  [[nodiscard]] AreaBarrier
  barrier() const
  {
    return { surface.triangles, topology, targets, weights };
  }
};

Eigen::VectorXd
randomStep(std::size_t vertexCount, std::uint64_t seed)
{
  Random          random(seed);
  Eigen::VectorXd step(static_cast<Eigen::Index>(2 * vertexCount));
  for (Eigen::Index i = 0; i < step.size(); ++i)
  {
    step[i] = random.uniform(-1.0, 1.0);
  }
  return step;
}

} // namespace

TEST(AreaBarrier, GradientAndHessianPassTheTaylorTest)
{
  const Problem         problem(1);
  AreaBarrierSystem     system = problem.system();
  const double          shapeWeight = 0.3;
  const Eigen::VectorXd step = randomStep(problem.sphere.size(), 5);
  system.assemble(problem.sphere, shapeWeight, AreaBarrierSystem::Hessian::Exact, 0.0);
  const double energy = system.energy(problem.sphere, shapeWeight).value;
  const double slope = system.gradient().dot(step);
  const double curvature = step.dot(system.hessianTimes(step));

  std::vector<double> lengths;
  std::vector<double> firstRemainders;
  std::vector<double> secondRemainders;
  for (double length = 4e-3; length > 2e-4; length *= 0.5)
  {
    const double moved = system.energy(system.moved(problem.sphere, step, length), shapeWeight).value;
    lengths.push_back(length);
    firstRemainders.push_back(std::abs(moved - energy - length * slope));
    secondRemainders.push_back(std::abs(moved - energy - length * slope - 0.5 * length * length * curvature));
  }
  EXPECT_NEAR(analytic::observedOrder(lengths, firstRemainders), 2.0, 0.1);
  EXPECT_NEAR(analytic::observedOrder(lengths, secondRemainders), 3.0, 0.1);
}

TEST(AreaBarrier, RotationsChangeNothing)
{
  // So the gradient has no part along them: the step of a small rotation is orthogonal to it.
  const Problem     problem(2);
  AreaBarrierSystem system = problem.system();
  system.assemble(problem.sphere, 0.1, AreaBarrierSystem::Hessian::Exact, 0.0);
  for (const Vector3 & axis : { Vector3(1, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1) })
  {
    Eigen::VectorXd step(system.gradient().size());
    for (std::size_t v = 0; v < problem.sphere.size(); ++v)
    {
      step.segment<2>(static_cast<Eigen::Index>(2 * v)) = system.bases()[v].transpose() * axis.cross(problem.sphere[v]);
    }
    EXPECT_LT(std::abs(system.gradient().dot(step)), 1e-11 * system.gradient().norm() * step.norm());
  }
}

TEST(AreaBarrier, DampingAddsTheDirichletEnergyOfTheWeights)
{
  const Problem         problem(1);
  AreaBarrierSystem     system = problem.system();
  const Eigen::VectorXd step = randomStep(problem.sphere.size(), 9);
  const auto            curvature = [&](double damping) {
    system.assemble(problem.sphere, 0.1, AreaBarrierSystem::Hessian::Exact, damping);
    return step.dot(system.hessianTimes(step));
  };
  const double undamped = curvature(0.0); // also sets the tangent bases
  double       dirichlet = 0.0;
  for (std::size_t e = 0; e < problem.topology.edges.size(); ++e)
  {
    const Eigen::Index i = problem.topology.edges[e][0];
    const Eigen::Index j = problem.topology.edges[e][1];
    dirichlet +=
      problem.weights[e] *
      (system.bases()[i] * step.segment<2>(2 * i) - system.bases()[j] * step.segment<2>(2 * j)).squaredNorm();
  }
  EXPECT_NEAR(curvature(3.0) - undamped, 3.0 * dirichlet, 1e-6 * dirichlet);
}

TEST(AreaBarrier, EnergyIsInfiniteAtAFlip)
{
  const Problem problem(2);
  Positions     flipped = problem.sphere;
  flipped[0] = -flipped[0];
  EXPECT_EQ(problem.barrier().energy(flipped, 0.1), std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isfinite(problem.barrier().energy(problem.sphere, 0.1)));
}

TEST(AreaBarrier, MinimumIsBijectiveEqualInAreaAndStationary)
{
  const Problem          problem(3);
  AreaBarrier            barrier = problem.barrier();
  const auto             result = barrier.minimise(problem.sphere);
  const SphereMapQuality quality = sphereMapQuality(problem.surface, result.positions);
  EXPECT_TRUE(result.report.converged);
  EXPECT_LT(result.report.steps, 15);
  EXPECT_TRUE(isBijective(quality));
  EXPECT_LT(quality.areaRatioRms, 0.01);
  EXPECT_NEAR(quality.areaRatioRms, result.areaRatioRms, 1e-12);

  AreaBarrierSystem system = problem.system();
  system.assemble(problem.sphere, 1e-3, AreaBarrierSystem::Hessian::Exact, 0.0);
  const double before = system.gradient().norm();
  system.assemble(result.positions, 1e-3, AreaBarrierSystem::Hessian::Exact, 0.0);
  EXPECT_LT(system.gradient().norm(), 1e-8 * before);
}

TEST(AreaBarrier, MinimumDoesNotDependOnTheStart)
{
  const Problem problem(3);
  AreaBarrier   barrier = problem.barrier();
  Positions     other = problem.sphere;
  for (Vector3 & s : other)
  {
    s = (analytic::rotation(Vector3(1, 2, 3), 0.7) * (s + Vector3(0.3, -0.2, 0.1))).normalized();
  }
  ASSERT_EQ(countFlippedTriangles(problem.surface.triangles, other), 0);
  const auto aligned = [&](const Positions & start) {
    const Positions sphere = barrier.minimise(start).positions;
    return rotated(sphere, bodyFrameRotation(problem.surface, sphere));
  };
  EXPECT_LT(largestDistance(aligned(problem.sphere), aligned(other)), 1e-7);
}

TEST(AreaBarrier, SmallerShapeWeightGivesMoreEqualAreas)
{
  const Problem problem(3);
  AreaBarrier   barrier = problem.barrier();
  double        previous = std::numeric_limits<double>::infinity();
  for (const double shapeWeight : { 1e-1, 1e-2, 1e-3 })
  {
    AreaBarrierOptions options;
    options.shapeWeight = shapeWeight;
    const auto result = barrier.minimise(problem.sphere, options);
    EXPECT_TRUE(result.report.converged);
    EXPECT_LT(result.areaRatioRms, 0.7 * previous) << "eps " << shapeWeight;
    previous = result.areaRatioRms;
  }
}

TEST(AreaBarrier, StopsEarlyWhenAsked)
{
  const Problem      problem(3);
  AreaBarrier        barrier = problem.barrier();
  AreaBarrierOptions options;
  options.maximumSteps = 2;
  const auto result = barrier.minimise(problem.sphere, options);
  EXPECT_FALSE(result.report.converged);
  EXPECT_EQ(result.report.steps, 2);
  EXPECT_EQ(countFlippedTriangles(problem.surface.triangles, result.positions), 0);
}

TEST(AreaBarrier, FlippedStartIsRefused)
{
  const Problem problem(2);
  AreaBarrier   barrier = problem.barrier();
  Positions     flipped = problem.sphere;
  flipped[0] = -flipped[0];
  EXPECT_THROW((void)barrier.minimise(flipped), InvalidInput);
}

TEST(AreaBarrier, BadProblemsAreRefused)
{
  const Problem       problem(1);
  std::vector<double> targets = problem.targets;
  targets.pop_back();
  EXPECT_THROW(AreaBarrier(problem.surface.triangles, problem.topology, targets, problem.weights), InvalidInput);
  targets = problem.targets;
  targets[3] = 0.0;
  EXPECT_THROW(AreaBarrier(problem.surface.triangles, problem.topology, targets, problem.weights), InvalidInput);
  std::vector<double> weights = problem.weights;
  weights[0] = -1.0;
  EXPECT_THROW(AreaBarrier(problem.surface.triangles, problem.topology, problem.targets, weights), InvalidInput);
  EXPECT_THROW((void)problem.barrier().energy(Positions(2, Vector3::UnitX()), 0.1), InvalidInput);
  EXPECT_THROW((void)problem.barrier().minimise(Positions(2, Vector3::UnitX())), InvalidInput);
}

TEST(AreaBarrier, CancellationIsObeyed)
{
  const Problem problem(2);
  AreaBarrier   barrier = problem.barrier();
  EXPECT_THROW((void)barrier.minimise(problem.sphere, {}, [](double) { return false; }), Cancelled);
}
