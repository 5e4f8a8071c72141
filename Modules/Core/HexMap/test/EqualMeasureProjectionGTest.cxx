// Newton's order: fitted over several starts and steps, within 0.2 of 2. Equal measures: the tolerance asked for, 1e-12
// relative a cell. Threads: bit for bit.
#include "moserhex/HexMap/EqualMeasureProjection.h"

#include "TestMeasures.h"
#include "TestSolids.h"
#include "moserhex/Analytic/SurfaceShapes.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/HexMap/MassMeasure.h"
#include "moserhex/HexMap/VolumeEqualisation.h"
#include "moserhex/Quality/HexQuality.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

using namespace moserhex;
using namespace moserhex::testing;

namespace
{

double
totalOf(const CellMeasure & measure, const HexMesh & mesh)
{
  return measureEquality(mesh, measure).total;
}

double
targetOf(const CellMeasure & measure, const HexMesh & mesh)
{
  return totalOf(measure, mesh) / static_cast<double>(mesh.cellCount());
}

double
deviationOf(const CellMeasure & measure, const HexMesh & mesh, double target)
{
  double sum = 0.0;
  for (const double value : measuresOf(measure, mesh))
  {
    sum += std::pow(value / target - 1.0, 2);
  }
  return sum / static_cast<double>(mesh.cellCount());
}

const Vector3 boxSides(1.0, 0.8, 1.2);

/** A box whose nodes slide in its faces: smooth, volumes uneven by a few times the amplitude. */
HexMesh
distortedBox(int n, double amplitude)
{
  return mappedLattice(n, [amplitude](const Vector3 & x) {
    const auto    wave = [&](int axis) { return std::sin(pi * x[axis]); };
    const Vector3 shift(wave(0) * std::cos(pi * x[1]), wave(1) * std::cos(2 * pi * x[2]), wave(2) * x[0]);
    return Vector3((x + amplitude * shift).cwiseProduct(boxSides));
  });
}

/** The unit box with all cells sound, the smaller the nearer they are to the origin. */
HexMesh
gradedBox(double grading)
{
  return mappedLattice(6, [grading](const Vector3 & x) { return Vector3(x.array().pow(grading)); });
}

std::size_t
nonPositiveCornersOf(const HexMesh & mesh)
{
  std::size_t count = 0;
  for (std::size_t cell = 0; cell < mesh.cellCount(); ++cell)
  {
    const auto jacobians = cornerJacobians(cellCorners(mesh, cell));
    count += static_cast<std::size_t>(
      std::count_if(jacobians.begin(), jacobians.end(), [](double jacobian) { return jacobian <= 0.0; }));
  }
  return count;
}

/** A ball's lattice of 8 nodes a side that has equal cells, then distorted smoothly along the surface and inside. */
HexMesh
distortedBall(double amplitude)
{
  const HexMesh       ball = ballOfRadius(1.0).lattice(4);
  const double        target = targetOf(VolumeMeasure(), ball);
  EqualMeasureOptions options;
  options.maximumSteps = 40;
  HexMesh mesh = projectOntoEqualMeasure(ball, VolumeMeasure(), target, ballOfRadius(1.0).distance(), options).mesh;
  for (Vector3 & node : mesh.nodes)
  {
    const double radius = node.norm();
    const double swirl = amplitude * std::sin(2.0 * node.x() + node.z());
    node += swirl * Vector3(node.z(), 0.3, node.y() - node.x());
    node *= radius / node.norm();
  }
  return mesh;
}

struct Residuals
{
  std::vector<double> before;
  std::vector<double> after;
};

/** Root mean squares before and after every Newton step that starts below 0.1 and ends above round-off. */
void
addResiduals(Residuals & residuals, const EqualMeasureResult & result)
{
  std::vector<double> all;
  for (const EqualMeasureStep & step : result.steps)
  {
    all.push_back(std::sqrt(step.deviation));
  }
  all.push_back(std::sqrt(result.report.residual));
  for (std::size_t step = 1; step < all.size(); ++step)
  {
    if (all[step - 1] < 0.1 && all[step] > 1e-12)
    {
      residuals.before.push_back(all[step - 1]);
      residuals.after.push_back(all[step]);
    }
  }
}

template <typename TLattice>
void
expectQuadraticConvergence(const CellMeasure & measure, TLattice lattice, const SignedDistance & phi)
{
  Residuals residuals;
  for (const double amplitude : { 0.001, 0.003, 0.01, 0.03 })
  {
    const HexMesh            mesh = lattice(amplitude);
    const double             target = targetOf(measure, mesh);
    const EqualMeasureResult result = projectOntoEqualMeasure(mesh, measure, target, phi);
    EXPECT_TRUE(result.report.converged) << amplitude << ": " << result.report.note;
    EXPECT_LT(deviationOf(measure, result.mesh, target), 1e-24) << amplitude;
    addResiduals(residuals, result);
  }
  ASSERT_GE(residuals.before.size(), 6u);
  EXPECT_NEAR(analytic::observedOrder(residuals.before, residuals.after), 2.0, 0.2);
}

void
projectBox(const ProgressCallback & progress)
{
  const HexMesh mesh = distortedBox(6, 0.03);
  (void)projectOntoEqualMeasure(
    mesh, VolumeMeasure(), targetOf(VolumeMeasure(), mesh), boxDistance(boxSides), {}, progress);
}

} // namespace

TEST(EqualMeasureProjection, ConvergesQuadraticallyInABox)
{
  expectQuadraticConvergence(
    VolumeMeasure(), [](double amplitude) { return distortedBox(8, amplitude); }, boxDistance(boxSides));
}

TEST(EqualMeasureProjection, ConvergesQuadraticallyInABall)
{
  expectQuadraticConvergence(VolumeMeasure(), distortedBall, ballOfRadius(1.0).distance());
}

TEST(EqualMeasureProjection, ConvergesQuadraticallyForMasses)
{
  // From cells of equal mass under a linear density, as in a box with cells of equal volume they are far from it.
  const LinearDensity density(1.0, Vector3(0.8, -0.3, 0.4));
  const MassMeasure   measure(density, { 2 });
  const HexMesh       equal = [&] {
    const HexMesh       mesh = distortedBox(8, 0.0);
    EqualMeasureOptions options;
    options.maximumSteps = 40;
    return projectOntoEqualMeasure(mesh, measure, targetOf(measure, mesh), boxDistance(boxSides), options).mesh;
  }();
  const auto distorted = [&](double amplitude) {
    const HexMesh shift = distortedBox(8, amplitude);
    const HexMesh none = distortedBox(8, 0.0);
    HexMesh       mesh = equal;
    for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
    {
      mesh.nodes[node] += shift.nodes[node] - none.nodes[node];
    }
    return mesh;
  };
  expectQuadraticConvergence(measure, distorted, boxDistance(boxSides));
}

TEST(EqualMeasureProjection, ExactLatticeIsLeftAlone)
{
  const HexMesh            mesh = farAndOblique(regularLattice(7));
  const double             target = targetOf(VolumeMeasure(), mesh);
  const EqualMeasureResult result =
    projectOntoEqualMeasure(mesh, VolumeMeasure(), target, boxDistance(Vector3::Ones()));
  EXPECT_TRUE(result.report.converged);
  EXPECT_EQ(result.report.steps, 0);
  EXPECT_EQ(result.mesh.nodes, mesh.nodes);
  EXPECT_LT(result.report.residual, 1e-24);
}

TEST(EqualMeasureProjection, ClosedFormLatticeOfALinearDensityInABoxIsLeftAlone)
{
  // mu = 1 + a x on the unit cube: planes x_i with x + a x^2 / 2 = (1 + a / 2) i / (n - 1) cut it into equal masses.
  constexpr double    a = 3.0;
  const LinearDensity density(1.0, Vector3(a, 0.0, 0.0));
  const MassMeasure   measure(density, { 2 });
  const HexMesh       mesh = mappedLattice(
    8, [](const Vector3 & x) { return Vector3((std::sqrt(1.0 + a * (2.0 + a) * x[0]) - 1.0) / a, x[1], x[2]); });
  const double target = (1.0 + a / 2.0) / 343.0;
  for (const double mass : measuresOf(measure, mesh))
  {
    EXPECT_NEAR(mass, target, 1e-14);
  }
  const EqualMeasureResult result = projectOntoEqualMeasure(mesh, measure, target, boxDistance(Vector3::Ones()));
  EXPECT_TRUE(result.report.converged);
  EXPECT_EQ(result.report.steps, 0);
  EXPECT_EQ(result.mesh.nodes, mesh.nodes);
}

TEST(EqualMeasureProjection, EveryCellHasTheTargetAndTheTotalIsKept)
{
  const HexMesh mesh = distortedBox(8, 0.05);
  const double  target = targetOf(VolumeMeasure(), mesh);
  const HexMesh equal = projectOntoEqualMeasure(mesh, VolumeMeasure(), target, boxDistance(boxSides)).mesh;
  for (const double volume : cellVolumes(equal))
  {
    EXPECT_NEAR(volume, target, 1e-11 * target);
  }
  EXPECT_NEAR(totalOf(VolumeMeasure(), equal), totalOf(VolumeMeasure(), mesh), 1e-12);
}

TEST(EqualMeasureProjection, AnotherTotalIsReachedToo)
{
  const HexMesh            mesh = distortedBox(7, 0.03);
  const double             target = 1.1 * targetOf(VolumeMeasure(), mesh);
  const EqualMeasureResult result = projectOntoEqualMeasure(mesh, VolumeMeasure(), target, boxDistance(boxSides));
  EXPECT_TRUE(result.report.converged) << result.report.note;
  EXPECT_NEAR(totalOf(VolumeMeasure(), result.mesh), 1.1 * totalOf(VolumeMeasure(), mesh), 1e-12);
}

TEST(EqualMeasureProjection, OneCellGetsItsVolume)
{
  const HexMesh            mesh = shaken(regularLattice(2), 0.0, 1);
  const EqualMeasureResult result = projectOntoEqualMeasure(mesh, VolumeMeasure(), 1.3, boxDistance(Vector3::Ones()));
  EXPECT_TRUE(result.report.converged) << result.report.note;
  EXPECT_NEAR(cellVolumes(result.mesh).front(), 1.3, 1e-11);
}

TEST(EqualMeasureProjection, LessNormalMotionKeepsTheBoundaryCloserToTheSurface)
{
  const HexMesh mesh = distortedBall(0.03);
  const double  target = targetOf(VolumeMeasure(), mesh);
  double        previous = 0.0;
  for (const double normalMotion : { 0.05, 0.3, 1.0 })
  {
    EqualMeasureOptions options;
    options.normalMotion = normalMotion;
    const EqualMeasureResult result =
      projectOntoEqualMeasure(mesh, VolumeMeasure(), target, ballOfRadius(1.0).distance(), options);
    EXPECT_TRUE(result.report.converged) << normalMotion;
    double moved = 0.0;
    for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
    {
      if (onBoundary(mesh.nodesPerSide, node))
      {
        moved = std::max(moved, std::abs(result.mesh.nodes[node].norm() - mesh.nodes[node].norm()));
      }
    }
    EXPECT_GT(moved, previous) << normalMotion;
    previous = moved;
  }
}

TEST(EqualMeasureProjection, StepThatWouldInvertAPositiveMeshIsHalved)
{
  bool isAnyHalved = false;
  for (const double grading : { 1.6, 1.65, 1.7, 1.75, 1.8, 1.85, 1.9 })
  {
    const HexMesh       mesh = gradedBox(grading);
    EqualMeasureOptions options;
    options.maximumSteps = 1;
    const EqualMeasureResult result =
      projectOntoEqualMeasure(mesh, VolumeMeasure(), 1.0 / 125.0, boxDistance(Vector3::Ones()), options);
    ASSERT_EQ(result.steps.size(), 1u);
    const double fraction = result.steps.front().fraction;
    EXPECT_TRUE(fraction == 1.0 || fraction == 0.5 || fraction == 0.25) << fraction;
    EXPECT_TRUE(fraction == 0.25 || volumeQuality(result.mesh).concaveCells == 0) << grading;
    isAnyHalved = isAnyHalved || (fraction == 0.5 && result.mesh.nodes != mesh.nodes);
  }
  EXPECT_TRUE(isAnyHalved); // else nothing was tested
}

TEST(EqualMeasureProjection, CornersThatTurnOverAreCountedAndSaid)
{
  bool isAnyTurnedOver = false;
  for (const double grading : { 1.0, 1.5, 2.0, 2.5, 3.0, 3.5 })
  {
    const HexMesh            mesh = gradedBox(grading);
    const EqualMeasureResult result =
      projectOntoEqualMeasure(mesh, VolumeMeasure(), 1.0 / 125.0, boxDistance(Vector3::Ones()));
    const std::size_t count = nonPositiveCornersOf(result.mesh);
    EXPECT_EQ(nonPositiveCornersOf(mesh), 0u) << grading;
    EXPECT_EQ(result.nonPositiveCorners, count) << grading;
    const std::string said = "non-positive corners of cells: 0 before, " + std::to_string(count) + " after";
    EXPECT_EQ(result.report.note.find(said) != std::string::npos, count > 0) << grading << ": " << result.report.note;
    isAnyTurnedOver = isAnyTurnedOver || (count > 0 && result.report.converged);
  }
  EXPECT_TRUE(isAnyTurnedOver); // else nothing was tested
}

TEST(EqualMeasureProjection, WhereTheProjectionAloneTurnsCornersOverTheWholeStageDoesNot)
{
  const HexMesh            mesh = gradedBox(2.5);
  const EqualMeasureResult alone =
    projectOntoEqualMeasure(mesh, VolumeMeasure(), 1.0 / 125.0, boxDistance(Vector3::Ones()));
  EXPECT_GT(alone.nonPositiveCorners, 0u); // else nothing was tested
  const EqualisationResult stage = equaliseVolumes(mesh, boxDistance(Vector3::Ones()), 1.0);
  EXPECT_TRUE(stage.exact);
  EXPECT_EQ(nonPositiveCornersOf(stage.mesh), 0u);
}

TEST(EqualMeasureProjection, RunningOutOfStepsIsSaidAndTheBestMeshReturned)
{
  for (const int steps : { 0, 1, 2 })
  {
    EqualMeasureOptions options;
    options.maximumSteps = steps;
    options.tolerance = 1e-30;
    const HexMesh            mesh = distortedBox(6, 0.08);
    const double             target = targetOf(VolumeMeasure(), mesh);
    const EqualMeasureResult result =
      projectOntoEqualMeasure(mesh, VolumeMeasure(), target, boxDistance(boxSides), options);
    EXPECT_FALSE(result.report.converged) << steps;
    EXPECT_FALSE(result.report.note.empty()) << steps;
    EXPECT_EQ(result.report.steps, steps);
    EXPECT_NEAR(result.report.residual, deviationOf(VolumeMeasure(), result.mesh, target), 1e-12);
    EXPECT_LE(result.report.residual, deviationOf(VolumeMeasure(), mesh, target) + 1e-12);
    EXPECT_EQ(result.mesh.nodes == mesh.nodes, steps == 0);
  }
}

TEST(EqualMeasureProjection, TangledMeshIsNotMadeWorse)
{
  const HexMesh            mesh = shaken(regularLattice(6), 0.5, 3);
  const EqualMeasureResult result =
    projectOntoEqualMeasure(mesh, VolumeMeasure(), 1.0 / 125.0, boxDistance(Vector3::Ones()));
  EXPECT_LE(deviationOf(VolumeMeasure(), result.mesh, 1.0 / 125.0), deviationOf(VolumeMeasure(), mesh, 1.0 / 125.0));
  EXPECT_NEAR(result.report.residual, deviationOf(VolumeMeasure(), result.mesh, 1.0 / 125.0), 1e-12);
}

TEST(EqualMeasureProjection, MovedAndScaledMeshGivesTheMovedResult)
{
  const BentEllipsoid organ{ Vector3(3.0, 2.0, 2.5), 0.05 };
  BentEllipsoid       moved = organ;
  moved.turn = analytic::rotation(Vector3(1.0, -2.0, 0.5), 0.7);
  moved.shift = Vector3(100.0, -50.0, 30.0);
  const HexMesh       mesh = organ.lattice(3);
  const HexMesh       movedMesh = moved.lattice(3);
  const double        target = targetOf(VolumeMeasure(), mesh);
  EqualMeasureOptions options;
  options.maximumSteps = 30;
  const auto one = projectOntoEqualMeasure(mesh, VolumeMeasure(), target, organ.distance(), options);
  const auto other = projectOntoEqualMeasure(movedMesh, VolumeMeasure(), target, moved.distance(), options);
  EXPECT_TRUE(one.report.converged) << one.report.note;
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
  {
    EXPECT_LT((other.mesh.nodes[node] - moved.shift - moved.turn * one.mesh.nodes[node]).norm(), 1e-9);
  }
}

TEST(EqualMeasureProjection, IsTheSameForAnyNumberOfThreads)
{
  const HexMesh       mesh = distortedBox(16, 0.05);
  const double        target = targetOf(VolumeMeasure(), mesh);
  EqualMeasureOptions options;
  options.threads = 1;
  const auto one = projectOntoEqualMeasure(mesh, VolumeMeasure(), target, boxDistance(boxSides), options);
  for (const unsigned int threads : { 2u, 3u, 0u })
  {
    options.threads = threads;
    const auto several = projectOntoEqualMeasure(mesh, VolumeMeasure(), target, boxDistance(boxSides), options);
    EXPECT_EQ(several.mesh.nodes, one.mesh.nodes) << threads;
    EXPECT_EQ(several.report.residual, one.report.residual) << threads;
  }
}

TEST(EqualMeasureProjection, ProgressGrowsFromZeroToOne)
{
  double previous = 0.0;
  int    calls = 0;
  projectBox([&](double fraction) {
    EXPECT_GE(fraction, previous);
    EXPECT_LE(fraction, 1.0);
    previous = fraction;
    ++calls;
    return true;
  });
  EXPECT_GT(calls, 0);
}

TEST(EqualMeasureProjection, CallbackCancels)
{
  EXPECT_THROW(projectBox([](double) { return false; }), Cancelled);
}
