// Closed form in one dimension: order 2 in the spacing, slope within 0.2 (nodes interpolate linearly). Equal-volume
// maps: round-off. Whole runs on smooth organs: bounds with a factor of two or more to spare.
#include "moserhex/HexMap/VolumetricMoserFlow.h"

#include "MoserVelocity.h"
#include "TestLattices.h"
#include "moserhex/Analytic/ObservedOrder.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/HexMap/CellMeasure.h"
#include "moserhex/Quality/HexQuality.h"
#include "moserhex/StructuredGrid/CubeLattice.h"
#include "moserhex/StructuredGrid/CubeToSphere.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace moserhex;
using namespace moserhex::testing;

namespace
{

VolumetricMoserFlowOptions
onePass()
{
  VolumetricMoserFlowOptions options;
  options.maximumPasses = 1;
  options.smoothedPasses = 0;
  return options;
}

/** x -> x + a sin(2 pi x) / (2 pi): density 1 + a cos(2 pi x). */
double
stretched(double x, double a)
{
  return x + a * std::sin(2 * pi * x) / (2 * pi);
}

MoserVelocity
velocityOf(const HexMesh & mesh)
{
  return { mesh.nodesPerSide, cellVolumes(mesh), MoserFlowOperators(mesh.nodesPerSide) };
}
} // namespace

TEST(MoserVelocity, OneDimensionalDensityIsCarriedByItsOwnDistribution)
{
  // For |Df| = F'(x): v = x - F(x), g_1 = F, so the origin of y is F^-1(y).
  std::vector<double> spacings;
  std::vector<double> errors;
  for (const int n : { 9, 17, 33, 65 })
  {
    const HexMesh mesh = mappedLattice(n, [](const Vector3 & x) { return Vector3(stretched(x[0], 0.4), x[1], x[2]); });
    const MoserVelocity velocity = velocityOf(mesh);
    double              largest = 0.0;
    for (int i = 0; i < n; ++i)
    {
      const Vector3 point(i, 0.37 * (n - 1), 0.81 * (n - 1));
      const Vector3 origin = velocity.originOf(point, 16);
      largest = std::max(largest, std::abs(stretched(origin[0] / (n - 1), 0.4) - i / (n - 1.0)));
      EXPECT_NEAR(origin[1], point[1], 1e-10);
      EXPECT_NEAR(origin[2], point[2], 1e-10);
    }
    spacings.push_back(1.0 / (n - 1));
    errors.push_back(largest);
  }
  EXPECT_NEAR(analytic::observedOrder(spacings, errors), 2.0, 0.2);
  EXPECT_LT(errors.back(), 1e-4);
}

TEST(MoserVelocity, TimeStepErrorFallsFast)
{
  const HexMesh mesh =
    mappedLattice(33, [](const Vector3 & x) { return Vector3(stretched(x[0], 0.6), stretched(x[1], -0.4), x[2]); });
  const MoserVelocity velocity = velocityOf(mesh);
  const Vector3       point(9.3, 21.4, 16.0);
  const Vector3       reference = velocity.originOf(point, 512);
  const double        coarse = (velocity.originOf(point, 4) - reference).norm();
  const double        fine = (velocity.originOf(point, 32) - reference).norm();
  // The field is piecewise smooth, so Runge-Kutta of order 4 is held up by the kinks between cells: order 5/3 or more.
  EXPECT_LT(fine, coarse / 32.0);
  EXPECT_LT(coarse, 1e-2);
}

TEST(MoserVelocity, BoundaryPointsStayInTheirFaceAndCornersStay)
{
  const HexMesh       mesh = starShapedMesh(5, bumpyRadius);
  const MoserVelocity velocity = velocityOf(mesh);
  for (double a = 0.0; a <= 9.0; a += 0.5)
  {
    EXPECT_EQ(velocity.originOf(Vector3(a, 3.3, 9), 4)[2], 9.0);
    EXPECT_EQ(velocity.originOf(Vector3(a, 0, 9), 4)[1], 0.0);
    EXPECT_EQ(velocity.originOf(Vector3(a, 0, 9), 4)[2], 9.0);
  }
  EXPECT_EQ(velocity.originOf(Vector3(0, 9, 0), 4), Vector3(0, 9, 0));
}

TEST(VolumetricMoserFlow, OneDimensionalMapBecomesEqualSpacing)
{
  // f o g_1^-1 = F o F^-1 = identity.
  std::vector<double> spacings;
  std::vector<double> errors;
  for (const int n : { 9, 17, 33 })
  {
    const HexMesh mesh = mappedLattice(n, [](const Vector3 & x) { return Vector3(stretched(x[0], 0.5), x[1], x[2]); });
    const auto    result = volumetricMoserFlow(mesh, {}, onePass());
    ASSERT_EQ(result.bestPass, 1);
    double largest = 0.0;
    for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
    {
      const double expected = static_cast<double>(node % static_cast<std::size_t>(n)) / (n - 1.0);
      largest = std::max(largest, std::abs(result.mesh.nodes[node][0] - expected));
    }
    spacings.push_back(1.0 / (n - 1));
    errors.push_back(largest);
  }
  EXPECT_NEAR(analytic::observedOrder(spacings, errors), 2.0, 0.3);
}

TEST(VolumetricMoserFlow, OnePassRemovesASmoothThreeDimensionalVariation)
{
  const HexMesh mesh = mappedLattice(20, [](const Vector3 & x) {
    const double bulge = 0.15 * std::sin(pi * x[0]) * std::sin(pi * x[1]) * std::sin(pi * x[2]);
    return Vector3(x + bulge * Vector3(x[1] - 0.3, 0.4 - x[0], x[2] - 0.5));
  });
  const double  before = volumeQuality(mesh).volumeVariance;
  const auto    result = volumetricMoserFlow(mesh, {}, onePass());
  EXPECT_LT(result.passes.back().volumeVariance, 0.02 * before);
}

TEST(VolumetricMoserFlow, AVolumePreservingMapStays)
{
  // A shear flow: x += 0.1 sin(2 pi y): determinant 1, and the trilinear cells are parallelepipeds of equal volume.
  const HexMesh mesh =
    mappedLattice(10, [](const Vector3 & x) { return Vector3(x[0] + 0.1 * std::sin(2 * pi * x[1]), x[1], x[2]); });
  VolumetricMoserFlowOptions options = onePass();
  options.targetVariance = 0.0;
  const auto result = volumetricMoserFlow(mesh, {}, options);
  EXPECT_LT(result.passes.back().largestStep, 1e-12);
  EXPECT_LT(result.passes.back().volumeVariance, 1e-24);
}

TEST(VolumetricMoserFlow, AMeshThatIsGoodEnoughIsReturnedAtOnce)
{
  const HexMesh mesh = regularLattice(6);
  const auto    result = volumetricMoserFlow(mesh, {});
  EXPECT_EQ(result.report.steps, 0);
  EXPECT_EQ(result.bestPass, 0);
  EXPECT_TRUE(result.report.converged);
  EXPECT_EQ(result.mesh.nodes, mesh.nodes);
}

TEST(VolumetricMoserFlow, HeldBoundaryKeepsBoundaryNodesAndTotalVolume)
{
  const HexMesh              mesh = starShapedMesh(6, ellipsoidRadius);
  VolumetricMoserFlowOptions options = onePass();
  options.maximumPasses = 4;
  options.boundary = BoundaryMotion::held;
  const auto result = volumetricMoserFlow(mesh, alongRays(ellipsoidRadius), options);
  EXPECT_GT(result.bestPass, 0);
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
  {
    if (onBoundary(mesh.nodesPerSide, node))
    {
      EXPECT_EQ(result.mesh.nodes[node], mesh.nodes[node]);
    }
  }
  const double volume = measureEquality(mesh, VolumeMeasure()).total;
  EXPECT_NEAR(measureEquality(result.mesh, VolumeMeasure()).total, volume, 1e-12 * volume);
}

TEST(VolumetricMoserFlow, SlidingReachesWhatHoldingCannot)
{
  const HexMesh              mesh = starShapedMesh(8, ellipsoidRadius);
  VolumetricMoserFlowOptions options = onePass();
  options.maximumPasses = 8;
  options.minimumGain = 0.0;
  const double sliding = volumetricMoserFlow(mesh, alongRays(ellipsoidRadius), options).report.residual;
  options.boundary = BoundaryMotion::held;
  const double held = volumetricMoserFlow(mesh, alongRays(ellipsoidRadius), options).report.residual;
  EXPECT_LT(sliding, 0.1 * held);
}

TEST(VolumetricMoserFlow, SlidingNodesStayOnTheSurface)
{
  const auto result = volumetricMoserFlow(starShapedMesh(6, bumpyRadius), alongRays(bumpyRadius));
  for (std::size_t node = 0; node < result.mesh.nodes.size(); ++node)
  {
    if (onBoundary(result.mesh.nodesPerSide, node))
    {
      const Vector3 & p = result.mesh.nodes[node];
      EXPECT_NEAR(p.norm(), bumpyRadius(p.normalized()), 1e-12);
    }
  }
}

TEST(VolumetricMoserFlow, SmoothOrgansGetEqualVolumesAndNoConcaveCell)
{
  for (const auto radius : { ellipsoidRadius, bumpyRadius })
  {
    const HexMesh mesh = starShapedMesh(10, radius);
    const auto    result = volumetricMoserFlow(mesh, alongRays(radius));
    const auto    quality = summarizeQuality(result.mesh);
    EXPECT_GT(summarizeQuality(mesh).volumeVariance, 0.02);
    EXPECT_LT(quality.volumeVariance, 1e-3);
    EXPECT_EQ(quality.concaveCells, 0U);
  }
}

TEST(VolumetricMoserFlow, NeverReturnsAWorseMeshAndReportsEveryPass)
{
  const HexMesh              mesh = shaken(starShapedMesh(5, bumpyRadius), 3.0, 9);
  VolumetricMoserFlowOptions options;
  options.maximumPasses = 6;
  const auto result = volumetricMoserFlow(mesh, alongRays(bumpyRadius), options);
  ASSERT_EQ(result.passes.size(), static_cast<std::size_t>(result.report.steps) + 1U);
  const MoserPass & best = result.passes[static_cast<std::size_t>(result.bestPass)];
  for (const MoserPass & pass : result.passes)
  {
    EXPECT_GE(pass.score, best.score);
  }
  const VolumeQuality quality = volumeQuality(result.mesh);
  EXPECT_EQ(quality.volumeVariance, best.volumeVariance);
  EXPECT_EQ(quality.concavePercent, best.concavePercent);
}

TEST(VolumetricMoserFlow, TwoRunsGiveTheSameBits)
{
  const HexMesh mesh = starShapedMesh(6, bumpyRadius);
  EXPECT_EQ(volumetricMoserFlow(mesh, alongRays(bumpyRadius)).mesh.nodes,
            volumetricMoserFlow(mesh, alongRays(bumpyRadius)).mesh.nodes);
}

TEST(VolumetricMoserFlow, ScaleDoesNotMatter)
{
  const HexMesh mesh = starShapedMesh(4, bumpyRadius);
  const auto    expected = volumetricMoserFlow(mesh, alongRays(bumpyRadius));
  for (const double scale : { 1e-6, 1e6 })
  {
    HexMesh scaled = mesh;
    for (Vector3 & node : scaled.nodes)
    {
      node *= scale;
    }
    const auto radius = [scale](const Vector3 & d) { return scale * bumpyRadius(d); };
    const auto result = volumetricMoserFlow(scaled, alongRays(radius));
    EXPECT_NEAR(result.report.residual, expected.report.residual, 1e-6 * expected.report.residual);
  }
}

TEST(VolumetricMoserFlow, OptionsOutOfRangeAreRefused)
{
  const HexMesh mesh = regularLattice(4);
  const auto    refuses = [&](auto change) {
    VolumetricMoserFlowOptions options;
    change(options);
    EXPECT_THROW(static_cast<void>(volumetricMoserFlow(mesh, {}, options)), InvalidInput);
  };
  refuses([](auto & o) { o.maximumPasses = 0; });
  refuses([](auto & o) { o.smoothedPasses = -1; });
  refuses([](auto & o) { o.targetVariance = -1.0; });
  refuses([](auto & o) { o.minimumGain = 1.0; });
  refuses([](auto & o) { o.concaveWeight = -1.0; });
}

TEST(VolumetricMoserFlow, WrongNumberOfNodesIsRefused)
{
  HexMesh mesh = regularLattice(4);
  mesh.nodes.pop_back();
  EXPECT_THROW(static_cast<void>(volumetricMoserFlow(mesh, {})), InvalidInput);
}

TEST(VolumetricMoserFlow, AMeshTurnedInsideOutIsRefused)
{
  const HexMesh mesh = mappedLattice(4, [](const Vector3 & x) { return Vector3(-x[0], x[1], x[2]); });
  EXPECT_THROW(static_cast<void>(volumetricMoserFlow(mesh, {})), InvalidInput);
}

TEST(VolumetricMoserFlow, ARadialDensityInTheBallBecomesUniform)
{
  // Shell k of size rho_k lies on the sphere of radius r(rho), r^3 = rho^3 (1 + a (1 - rho^3)): the radial density
  // d(r^3)/d(rho^3) = 1 + a (1 - 2 rho^3). In closed form the flow must bring shell k back to the fraction rho_k^3 of
  // the volume, r'^3 = 3 int density s^2 ds; the sampling of the ball by few cells leaves an error that falls with the
  // mesh.
  constexpr double    a = 0.4;
  std::vector<double> worst;
  for (const int shells : { 4, 8, 12 })
  {
    const CubeLattice lattice(shells);
    HexMesh           mesh{ lattice.nodesPerSide(), Positions(lattice.nodeCount()) };
    for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
    {
      const double rho = lattice.relativeSize(lattice.shellOfNode(node));
      const double cube = rho * rho * rho;
      mesh.nodes[node] = std::cbrt(cube * (1.0 + a * (1.0 - cube))) * cubeToSphere(lattice.positionOnShell(node));
    }
    const auto worstShellError = [&](const HexMesh & ball) {
      const std::vector<double> volumes = cellVolumes(ball);
      std::vector<double>       enclosed(static_cast<std::size_t>(shells) + 1, 0.0);
      double                    total = 0.0;
      for (std::size_t cell = 0; cell < volumes.size(); ++cell)
      {
        enclosed[static_cast<std::size_t>(lattice.shellOfCell(cell))] += volumes[cell];
        total += volumes[cell];
      }
      double error = 0.0;
      double sum = 0.0;
      for (int k = 1; k <= shells; ++k)
      {
        sum += enclosed[static_cast<std::size_t>(k)];
        error = std::max(error, std::abs(sum / total - std::pow(lattice.relativeSize(k), 3)));
      }
      return error;
    };
    VolumetricMoserFlowOptions options;
    options.smoothedPasses = 0;
    options.boundary = BoundaryMotion::held;
    const VolumetricMoserFlowResult flow = volumetricMoserFlow(mesh, {}, options);
    EXPECT_GT(worstShellError(mesh), 0.05) << shells << " shells";
    EXPECT_LT(worstShellError(flow.mesh), 0.1 * worstShellError(mesh)) << shells << " shells";
    worst.push_back(worstShellError(flow.mesh));
  }
  EXPECT_LT(worst[2], worst[0]);
}

TEST(VolumetricMoserFlow, TheCallerCanStopIt)
{
  const HexMesh mesh = starShapedMesh(3, bumpyRadius);
  EXPECT_THROW(static_cast<void>(volumetricMoserFlow(mesh, {}, {}, [](double) { return false; })), Cancelled);
}
