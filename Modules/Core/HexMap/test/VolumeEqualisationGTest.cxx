// Exactness: variance 1e-18 as the header promises, volume 1e-9 relative, certificates by the Quality module. Exact
// starts: bit for bit.
#include "moserhex/HexMap/VolumeEqualisation.h"

#include "TestEqualisation.h"
#include "TestMeasures.h"
#include "moserhex/Analytic/SurfaceShapes.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Geometry/ClosestPoint.h"
#include "moserhex/HexMap/MassMeasure.h"
#include "moserhex/Quality/HexQuality.h"
#include "moserhex/Quality/JacobianBounds.h"
#include "moserhex/StructuredGrid/CubeLattice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <set>
#include <utility>

using namespace moserhex;
using namespace moserhex::testing;

namespace
{
/** Of boundary nodes and the centres of boundary quadrilaterals, each to where Newton steps along the gradient lead. */
double
largestDistance(const HexMesh & mesh, const SignedDistance & phi)
{
  const int  n = mesh.nodesPerSide;
  double     largest = 0.0;
  Vector3    gradient;
  const auto look = [&](const Vector3 & point) {
    Vector3 onSurface = point;
    double  value = phi(onSurface, gradient);
    for (int step = 0; step < 4; ++step)
    {
      onSurface -= value / std::max(gradient.squaredNorm(), 0.09) * gradient;
      value = phi(onSurface, gradient);
    }
    largest = std::max(largest, (onSurface - point).norm() + std::abs(value) / std::max(gradient.norm(), 0.3));
  };
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
  {
    if (onBoundary(n, node))
    {
      look(mesh.nodes[node]);
    }
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const int side : { 0, n - 1 })
    {
      const auto at = [&](int a, int b) {
        int index[3];
        index[axis] = side;
        index[(axis + 1) % 3] = a;
        index[(axis + 2) % 3] = b;
        return mesh.nodes[mesh.nodeNumber(index[0], index[1], index[2])];
      };
      for (int b = 0; b + 1 < n; ++b)
      {
        for (int a = 0; a + 1 < n; ++a)
        {
          look(0.25 * (at(a, b) + at(a + 1, b) + at(a, b + 1) + at(a + 1, b + 1)));
        }
      }
    }
  }
  return largest;
}

/** Of the points from the boundary's quadrilaterals, taken as two triangles each. */
double
largestDistanceFromBoundary(const Positions & points, const HexMesh & mesh)
{
  const CubeLattice lattice(mesh.nodesPerSide / 2);
  TriangleMesh      boundary;
  boundary.vertices = mesh.nodes;
  for (const Quad & quad : lattice.quadsOfShell(lattice.shells()))
  {
    const auto at = [&quad](int corner) { return static_cast<VertexIndex>(quad[corner]); };
    boundary.triangles.push_back({ at(0), at(1), at(2) });
    boundary.triangles.push_back({ at(0), at(2), at(3) });
  }
  const ClosestPointSearch search(boundary);
  double                   largest = 0.0;
  for (const Vector3 & point : points)
  {
    largest = std::max(largest, search.closest(point).squaredDistance);
  }
  return std::sqrt(largest);
}

/** What the result says is what the mesh is. */
void
expectHonest(const EqualisationResult & result, const SignedDistance & phi, double volume)
{
  const double target = volume / static_cast<double>(result.mesh.cellCount());
  double       variance = 0.0;
  for (const double cell : cellVolumes(result.mesh))
  {
    variance += std::pow(cell / target - 1.0, 2) / static_cast<double>(result.mesh.cellCount());
  }
  EXPECT_NEAR(result.variance, variance, 1e-9 * variance + 1e-26);
  EXPECT_EQ(result.concaveCells, volumeQuality(result.mesh).concaveCells);
  EXPECT_EQ(result.uncertifiedCells, result.mesh.cellCount() - certifyCells(result.mesh).positive);
  EXPECT_NEAR(result.largestDistance, largestDistance(result.mesh, phi), 1e-9 * result.largestDistance + 1e-12);
  EXPECT_EQ(result.smallestScaledJacobian, summarizeQuality(result.mesh).scaledJacobian.minimum);
  EXPECT_EQ(result.exact, result.shortcomings.empty());
  EXPECT_EQ(result.report.converged, result.exact);
  EXPECT_EQ(result.report.residual, result.variance);
}

void
expectExact(const EqualisationResult & result, const SignedDistance & phi, double volume, int nodesPerSide)
{
  expectHonest(result, phi, volume);
  ASSERT_EQ(result.mesh.nodesPerSide, nodesPerSide);
  EXPECT_TRUE(result.exact);
  for (const std::string & shortcoming : result.shortcomings)
  {
    ADD_FAILURE() << shortcoming;
  }
  EXPECT_LE(result.variance, 1e-18);
  EXPECT_EQ(result.concaveCells, 0u);
  EXPECT_EQ(certifyCells(result.mesh).positive, result.mesh.cellCount());
  EXPECT_NEAR(measureEquality(result.mesh, VolumeMeasure()).total, volume, 1e-9 * volume);
  EXPECT_LE(result.largestDistance, EqualisationOptions().surfaceTolerance);
}

void
expectExact(const BentEllipsoid & organ, int shells, int nodesPerSide)
{
  const EqualisationResult result =
    equaliseVolumes(organ.lattice(shells), organ.distance(), organ.volume(), nodes(nodesPerSide));
  expectExact(result, organ.distance(), organ.volume(), nodesPerSide);
  if (nodesPerSide % 2 == 0)
  {
    const double edge = std::cbrt(organ.volume() / static_cast<double>(result.mesh.cellCount()));
    EXPECT_LE(result.uncoveredDistance, edge);
    EXPECT_NEAR(
      largestDistanceFromBoundary(organ.boundaryPoints(12), result.mesh), result.uncoveredDistance, 0.1 * edge);
  }
}

/** A ball and a round horn of the radius along x, up to x = reach, around it: volume in closed form. */
struct HornedBall
{
  double ballRadius;
  double hornRadius;
  double reach;

  [[nodiscard]] double
  volume() const
  {
    const double root = std::sqrt(ballRadius * ballRadius - hornRadius * hornRadius);
    const double ball = 4.0 / 3.0 * pi * std::pow(ballRadius, 3);
    const double cylinder = pi * hornRadius * hornRadius * (reach - hornRadius);
    const double cylinderInBall = 2.0 / 3.0 * pi * (std::pow(ballRadius, 3) - std::pow(root, 3));
    return ball + cylinder - cylinderInBall + 2.0 / 3.0 * pi * std::pow(hornRadius, 3);
  }

  [[nodiscard]] SignedDistance
  distance() const
  {
    return [*this](const Vector3 & p, Vector3 & gradient) {
      const Vector3 axis(std::min(std::max(p[0], 0.0), reach - hornRadius), 0.0, 0.0);
      const double  toBall = p.norm() - ballRadius;
      const double  toHorn = (p - axis).norm() - hornRadius;
      gradient = toBall < toHorn ? Vector3(p / std::max(p.norm(), 1e-9))
                                 : Vector3((p - axis) / std::max((p - axis).norm(), 1e-9));
      return std::min(toBall, toHorn);
    };
  }
};

const Vector3 boxSides = Vector3::Constant(30.0);
const double  boxVolume = boxSides.prod();

/** Every node anywhere in the middle nine tenths of the box. */
HexMesh
tangledBox(int n, std::uint64_t seed)
{
  Random random(seed);
  return mappedLattice(n, [&](const Vector3 &) {
    const double x = random.uniform(0.05, 0.95);
    const double y = random.uniform(0.05, 0.95);
    const double z = random.uniform(0.05, 0.95);
    return Vector3(Vector3(x, y, z).cwiseProduct(boxSides));
  });
}

HexMesh
regularBox(int n)
{
  return mappedLattice(n, [](const Vector3 & x) { return Vector3(x.cwiseProduct(boxSides)); });
}
} // namespace

TEST(VolumeEqualisation, BallFromACoarseStartIsExact)
{
  expectExact(ball, 3, 14);
}

TEST(VolumeEqualisation, BallFromAStartOfTheSameSizeIsExact)
{
  expectExact(ball, 5, 10);
}

TEST(VolumeEqualisation, SlenderEllipsoidFromACoarseStartIsExact)
{
  expectExact(slender, 3, 12);
}

TEST(VolumeEqualisation, SlenderEllipsoidFromAStartOfTheSameSizeIsExact)
{
  expectExact(slender, 5, 10);
}

TEST(VolumeEqualisation, BananaFromACoarseStartIsExact)
{
  expectExact(banana, 3, 12);
}

TEST(VolumeEqualisation, BananaFromAStartOfTheSameSizeIsExact)
{
  expectExact(banana, 5, 10);
}

TEST(VolumeEqualisation, OddNumberOfNodesIsExactToo)
{
  expectExact(ball, 3, 11);
}

TEST(VolumeEqualisation, ShakenInteriorOfACubeUntangles)
{
  for (const std::uint64_t seed : { 1u, 2u, 3u })
  {
    HexMesh start = shaken(regularLattice(8), 0.3, seed); // two cells' edges
    for (Vector3 & node : start.nodes)
    {
      node = node.cwiseProduct(boxSides);
    }
    EXPECT_GT(volumeQuality(start).concaveCells, start.cellCount() / 2) << seed; // else nothing is tested
    const EqualisationResult result = equaliseVolumes(start, boxDistance(boxSides), boxVolume);
    expectExact(result, boxDistance(boxSides), boxVolume, 8);
  }
}

TEST(VolumeEqualisation, ShakenBallUntangles)
{
  HexMesh start = shaken(ball.lattice(4), 10.0, 4);
  EXPECT_GT(volumeQuality(start).concaveCells, start.cellCount() / 2); // else nothing is tested
  expectExact(equaliseVolumes(start, ball.distance(), ball.volume()), ball.distance(), ball.volume(), 8);
}

TEST(VolumeEqualisation, CoarseLatticeThatStaysTangledIsUntangledBeforeItIsRefined)
{
  EqualisationOptions options = nodes(8);
  options.surfaceTolerance = 2.0; // cells are 4 mm wide
  options.repairRounds = 0;
  for (const std::uint64_t seed : { 1u, 3u, 12u })
  {
    HexMesh start = banana.lattice(3);
    Random  random(seed);
    for (Vector3 & node : start.nodes) // those of the boundary, too
    {
      const double x = random.uniform(-1, 1);
      const double y = random.uniform(-1, 1);
      const double z = random.uniform(-1, 1);
      node += 15.0 * Vector3(x, y, z);
    }
    const EqualisationResult result = equaliseVolumes(start, banana.distance(), banana.volume(), options);
    EXPECT_TRUE(result.exact) << seed;
    const std::size_t stages = options.coarseStages.size();
    ASSERT_GT(result.steps.size(), stages) << seed;
    EXPECT_GT(result.steps[stages - 1].uncertified, 0u) << seed; // else nothing is tested
    EXPECT_EQ(result.steps[stages].nodesPerSide, 6) << seed;
  }
}

namespace
{
/** A slender, bent organ and the cube turned about its diagonal: long cells, few of them. */
EqualisationResult
equalisedSlender(double length, double curvature, double turn)
{
  const BentEllipsoid organ{ Vector3(length, 12.0, 12.0), curvature };
  const Matrix3       rotation = analytic::rotation(Vector3(1.0, 1.0, 1.0).normalized(), turn);
  HexMesh             start = ballOfRadius(1.0).lattice(3);
  for (Vector3 & node : start.nodes)
  {
    node = organ.ofUnitBall(rotation * node);
  }
  EqualisationOptions options;
  options.surfaceTolerance = 3.0; // cells are 6 mm wide, and there are five along the whole length
  options.repairRounds = 0;
  options.polishRounds = 0;
  return equaliseVolumes(start, organ.distance(), organ.volume(), options);
}

std::vector<EqualisationStep>
stepsOf(const EqualisationResult & result, const std::string & name)
{
  std::vector<EqualisationStep> steps;
  std::copy_if(result.steps.begin(),
               result.steps.end(),
               std::back_inserter(steps),
               [&name](const EqualisationStep & step) { return step.name == name; });
  return steps;
}
} // namespace

TEST(VolumeEqualisation, MeshThatTheProjectionSpoilsIsMadeMoreEqualBeforeItIsProjectedAgain)
{
  const EqualisationResult result = equalisedSlender(55.0, 0.018, 0.6);
  const auto               projections = stepsOf(result, "project");
  EXPECT_TRUE(result.exact);
  ASSERT_EQ(projections.size(), 2u);
  EXPECT_GT(projections[0].uncertified, 0u); // else nothing is tested
  EXPECT_EQ(projections[1].uncertified, 0u);
  EXPECT_EQ(result.steps[result.steps.size() - 2].name, "minimise");
}

TEST(VolumeEqualisation, FirstProjectedMeshIsKeptWhenItIsTheBetterOne)
{
  const EqualisationResult result = equalisedSlender(60.0, 0.018, 0.9);
  const auto               projections = stepsOf(result, "project");
  ASSERT_EQ(projections.size(), 2u);
  EXPECT_EQ(projections[0].uncertified, 0u);
  EXPECT_GT(projections[1].uncertified, 0u); // else nothing is tested
  EXPECT_TRUE(result.exact);
  EXPECT_EQ(result.uncertifiedCells, 0u);
}

TEST(VolumeEqualisation, ResultForAnyTangleIsHonest)
{
  // Without an order to start from there need be no way out: then the result says so.
  const HexMesh       start = tangledBox(6, 1);
  EqualisationOptions options;
  options.repairRounds = 4;
  const EqualisationResult result = equaliseVolumes(start, boxDistance(boxSides), boxVolume, options);
  expectHonest(result, boxDistance(boxSides), boxVolume);
  EXPECT_LE(result.concaveCells, volumeQuality(start).concaveCells);
}

TEST(VolumeEqualisation, ExactLatticeIsLeftAlone)
{
  const HexMesh            start = regularBox(7);
  const EqualisationResult result = equaliseVolumes(start, boxDistance(boxSides), boxVolume);
  expectExact(result, boxDistance(boxSides), boxVolume, 7);
  EXPECT_EQ(result.mesh.nodes, start.nodes);
}

TEST(VolumeEqualisation, ItsOwnResultIsLeftAlone)
{
  const EqualisationResult first = equaliseVolumes(ball.lattice(3), ball.distance(), ball.volume(), nodes(10));
  ASSERT_TRUE(first.exact);
  const EqualisationResult second = equaliseVolumes(first.mesh, ball.distance(), ball.volume());
  EXPECT_TRUE(second.exact);
  EXPECT_EQ(second.mesh.nodes, first.mesh.nodes);
}

TEST(VolumeEqualisation, MassesUnderALinearDensityBecomeEqual)
{
  const LinearDensity density(1.0, Vector3(0.02, -0.01, 0.015)); // 1 at the centre: the ball's mass is its volume
  const MassMeasure   measure(density, { 2 });
  const auto          result =
    equaliseMeasures(ball.lattice(3), ball.distance(), ball.volume(), measure, ball.volume(), nodes(10));
  EXPECT_TRUE(result.exact);
  EXPECT_EQ(certifyCells(result.mesh).positive, result.mesh.cellCount());
  EXPECT_LE(result.variance, 1e-18);
  const double target = ball.volume() / 729.0;
  for (const double mass : measuresOf(measure, result.mesh))
  {
    EXPECT_NEAR(mass, target, 1e-8 * target);
  }
  EXPECT_GT(measureEquality(result.mesh, VolumeMeasure()).variance, 1e-3); // else the density did nothing
}

TEST(VolumeEqualisation, CellsGetTheSharesThatAreWanted)
{
  std::vector<double> shares(729, 1.0);
  for (std::size_t cell = 0; cell < shares.size(); ++cell)
  {
    shares[cell] = cell % 9 < 4 ? 0.5 : 1.5; // halves along i
  }
  const SharedVolumeMeasure measure(shares);
  const HexMesh             start = equaliseVolumes(ball.lattice(3), ball.distance(), ball.volume(), nodes(10)).mesh;
  const auto                result = equaliseMeasures(start, ball.distance(), ball.volume(), measure, ball.volume());
  EXPECT_TRUE(result.exact);
  const std::vector<double> volumes = cellVolumes(result.mesh);
  EXPECT_NEAR(volumes[8] / volumes[0], 3.0, 1e-6);
  EXPECT_NEAR(std::accumulate(volumes.begin(), volumes.end(), 0.0), ball.volume(), 1e-6 * ball.volume());
}

TEST(VolumeEqualisation, LatticeAtRestStaysWhereItIs)
{
  const HexMesh       tied = equaliseVolumes(ball.lattice(3), ball.distance(), ball.volume(), nodes(10)).mesh;
  EqualisationOptions options;
  options.ties.reference = tied.nodes;
  options.ties.referenceWeight = 0.1;
  for (EqualisationStage & stage : options.directStages)
  {
    stage.volumeWeight = 0.1; // cells are hardly held to their volumes
  }
  const auto farthestMove = [&] {
    const HexMesh mesh = minimisedLattice(tied, ball.distance(), ball.volume(), VolumeMeasure(), options);
    double        farthest = 0.0;
    for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
    {
      farthest = std::max(farthest, (mesh.nodes[node] - tied.nodes[node]).norm());
    }
    return farthest;
  };
  const double forBetterShapes = farthestMove();
  EXPECT_GT(forBetterShapes, 0.5);
  options.ties.rest = tied.nodes;
  EXPECT_LT(farthestMove(), 0.2 * forBetterShapes);
}

TEST(VolumeEqualisation, UniformDensityGivesEqualVolumes)
{
  const LinearDensity density(2.5, Vector3::Zero());
  const MassMeasure   measure(density, { 2 });
  const auto          result =
    equaliseMeasures(ball.lattice(3), ball.distance(), ball.volume(), measure, 2.5 * ball.volume(), nodes(8));
  expectExact(result, ball.distance(), ball.volume(), 8);
}

TEST(VolumeEqualisation, VolumeThatTheSurfaceDoesNotHoldIsReported)
{
  for (const double factor : { 0.5, 2.0 })
  {
    const double volume = factor * ball.volume();
    const auto   result = equaliseVolumes(ball.lattice(2), ball.distance(), volume);
    expectHonest(result, ball.distance(), volume);
    EXPECT_FALSE(result.exact) << factor;
    EXPECT_FALSE(result.shortcomings.empty()) << factor;
  }
}

TEST(VolumeEqualisation, SurfaceAsideOfTheStartIsReachedOrReported)
{
  BentEllipsoid away = ball;
  away.shift = Vector3(30.0, 0.0, 0.0);
  const auto result = equaliseVolumes(ball.lattice(2), away.distance(), ball.volume());
  expectHonest(result, away.distance(), ball.volume());
}

TEST(VolumeEqualisation, PartOfTheOrganThatTheStartDoesNotReachIsReachedOrReported)
{
  for (const auto & [hornRadius, nodesPerSide] : { std::make_pair(1.5, 10), std::make_pair(2.5, 12) })
  {
    const HornedBall organ{ 10.0, hornRadius, 26.5 };
    const auto       result =
      equaliseVolumes(ballOfRadius(10.0).lattice(3), organ.distance(), organ.volume(), nodes(nodesPerSide));
    expectHonest(result, organ.distance(), organ.volume());
    double end = 0.0;
    for (const Vector3 & node : result.mesh.nodes)
    {
      end = std::max(end, node[0]);
    }
    const double edge = std::cbrt(organ.volume() / static_cast<double>(result.mesh.cellCount()));
    const double missing = organ.reach - end;
    EXPECT_TRUE(!result.exact || missing < edge) << hornRadius << " mm: " << missing << " mm are missing";
    EXPECT_GT(result.uncoveredDistance, missing - 0.5) << hornRadius;
  }
}

TEST(VolumeEqualisation, StageIsLeftOutWhereTheScaledJacobianIsEnough)
{
  const auto minimisations = [](double enough) {
    EqualisationOptions options;
    options.directStages.push_back(options.directStages.back());
    options.directStages.back().enoughScaledJacobian = enough;
    const EqualisationResult result = equaliseVolumes(ball.lattice(4), ball.distance(), ball.volume(), options);
    EXPECT_TRUE(result.exact);
    EXPECT_NEAR(result.meanScaledJacobian, summarizeQuality(result.mesh).scaledJacobian.mean, 1e-14);
    return std::count_if(
      result.steps.begin(), result.steps.end(), [](const EqualisationStep & step) { return step.name == "minimise"; });
  };
  EXPECT_EQ(minimisations(0.1), minimisations(0.999) - 1);
}

TEST(VolumeEqualisation, NoStepsAtAllAreReported)
{
  EqualisationOptions options = stages({ 0.1, 50.0, 80.0, 0, 1 });
  options.repairRounds = 0;
  options.projection.maximumSteps = 0;
  const auto result = equaliseVolumes(ball.lattice(3), ball.distance(), ball.volume(), options);
  expectHonest(result, ball.distance(), ball.volume());
  EXPECT_FALSE(result.exact);
}

TEST(VolumeEqualisation, EveryStepIsLogged)
{
  const auto result = equaliseVolumes(ball.lattice(3), ball.distance(), ball.volume(), nodes(12));
  ASSERT_FALSE(result.steps.empty());
  EXPECT_EQ(result.report.steps, static_cast<int>(result.steps.size()));
  std::set<std::string> names;
  for (const EqualisationStep & step : result.steps)
  {
    names.insert(step.name);
    EXPECT_TRUE(step.nodesPerSide >= 6 && step.nodesPerSide <= 12) << step.nodesPerSide;
    EXPECT_GE(step.seconds, 0.0);
    EXPECT_TRUE(std::isfinite(step.variance) && std::isfinite(step.distance));
  }
  EXPECT_TRUE(names.count("minimise") == 1 && names.count("project") == 1);
  names.erase("minimise");
  names.erase("project");
  names.erase("repair");
  names.erase("polish");
  EXPECT_TRUE(names.empty()) << *names.begin();
}
