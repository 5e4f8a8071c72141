// Exactness as VolumeEqualisation.h promises: variance 1e-18, certificates by the Quality module. Geometry of the
// start: closed forms, round-off.
#include "moserhex/HexMap/Padding.h"

#include "TestEnergies.h"
#include "TestEqualisation.h"
#include "TestMeasures.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Geometry/HexMeshNumbering.h"
#include "moserhex/HexMap/EqualMeasureProjection.h"
#include "moserhex/HexMap/LatticeSmoothing.h"
#include "moserhex/HexMap/MassMeasure.h"
#include "moserhex/Quality/HexQuality.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace moserhex;
using namespace moserhex::testing;

namespace
{

EqualisationResult
equalisedWithPadding(const BentEllipsoid & organ, int shells, int layers, unsigned int threads = 1)
{
  const double        volume = organ.volume();
  EqualisationOptions options;
  options.threads = threads;
  const EqualisationResult lattice = equaliseVolumes(organ.lattice(shells), organ.distance(), volume, options);
  return equaliseVolumes(padded(lattice.mesh, layers), organ.distance(), volume, paddingOptions(options));
}

} // namespace

TEST(Padding, NoLayersLeaveTheLatticeAsItIs)
{
  const HexMesh lattice = ball.lattice(3);
  const HexMesh mesh = padded(lattice, 0);
  EXPECT_EQ(mesh.paddingLayers, 0);
  for (std::size_t node = 0; node < lattice.nodes.size(); ++node)
  {
    EXPECT_LT((mesh.nodes[node] - lattice.nodes[node]).norm(), 1e-13);
  }
}

TEST(Padding, ACubesLayersHaveTheirRightVolumesAndItsBoundaryStays)
{
  const int                 n = 6;
  const HexMesh             mesh = padded(regularLattice(n), 2);
  const std::vector<double> volumes = cellVolumes(mesh);
  const double              mean = 1.0 / static_cast<double>(mesh.cellCount());
  for (std::size_t cell = 0; cell < mesh.latticeCellCount(); ++cell)
  {
    EXPECT_NEAR(volumes[cell], mean, 1e-14);
  }
  const auto quads = static_cast<std::ptrdiff_t>(6 * (n - 1) * (n - 1));
  for (int layer = 0; layer < 2; ++layer)
  {
    const auto first = volumes.begin() + static_cast<std::ptrdiff_t>(mesh.latticeCellCount()) + layer * quads;
    EXPECT_NEAR(std::accumulate(first, first + quads, 0.0), static_cast<double>(quads) * mean, 1e-14);
    EXPECT_GT(*std::min_element(first, first + quads), 0.5 * mean);
  }
  for (const std::size_t node : boundaryNodes(mesh))
  {
    const Vector3 & place = mesh.nodes[node];
    EXPECT_NEAR((place - Vector3::Constant(0.5)).cwiseAbs().maxCoeff(), 0.5, 1e-14);
  }
}

TEST(Padding, BallAndBananaBecomeExactWithWideCorners)
{
  for (const BentEllipsoid & organ : { ball, banana })
  {
    for (const int layers : { 1, 2 })
    {
      const EqualisationResult result = equalisedWithPadding(organ, 4, layers);
      SCOPED_TRACE(layers);
      EXPECT_TRUE(result.exact) << (result.shortcomings.empty() ? "" : result.shortcomings.front());
      EXPECT_EQ(result.mesh.paddingLayers, layers);
      EXPECT_LE(result.variance, 1e-18);
      const HexQualitySummary quality = summarizeQuality(result.mesh);
      EXPECT_EQ(quality.certified.positive, result.mesh.cellCount());
      EXPECT_NEAR(quality.volume, organ.volume(), 1e-9 * organ.volume());
      EXPECT_GE(quality.scaledJacobian.minimum, 0.4); // 0.22 at most without padding
      EXPECT_GE(quality.scaledJacobian.mean, 0.85);
      EXPECT_FALSE(quality.isLattice);
    }
  }
}

TEST(Padding, AnglesCountAsMuchAsTheyAreAskedTo)
{
  const HexMesh lattice = equaliseVolumes(ball.lattice(5), ball.distance(), ball.volume()).mesh;
  const auto    meanScaledJacobian = [&](const EqualisationOptions & options) {
    const HexMesh mesh = equaliseVolumes(padded(lattice, 1), ball.distance(), ball.volume(), options).mesh;
    return summarizeQuality(mesh).scaledJacobian.mean;
  };
  const double        strong = meanScaledJacobian(paddingOptions({}));
  const double        weak = meanScaledJacobian(paddingOptions({}, PaddingAngles::Weak));
  EqualisationOptions without = paddingOptions({}, PaddingAngles::Weak);
  for (EqualisationStage & stage : without.directStages)
  {
    stage.angleWeight = 0.0;
  }
  const double none = meanScaledJacobian(without);
  EXPECT_GT(strong, weak);
  EXPECT_GT(weak, none);
}

TEST(Padding, WhatIsFarFromRightAnglesIsMinimisedForLonger)
{
  const auto paddedWith = [](const BentEllipsoid & organ, const EqualisationOptions & options) {
    const HexMesh lattice = equaliseVolumes(organ.lattice(5), organ.distance(), organ.volume()).mesh;
    return equaliseVolumes(padded(lattice, 2), organ.distance(), organ.volume(), options);
  };
  EqualisationOptions shorter = paddingOptions({});
  shorter.directStages.resize(2);
  const BentEllipsoid      hook{ Vector3(32.0, 10.0, 10.0), 0.02 };
  const EqualisationResult afterFew = paddedWith(hook, shorter);
  const EqualisationResult afterMany = paddedWith(hook, paddingOptions({}));
  EXPECT_TRUE(afterMany.exact);
  EXPECT_GE(afterMany.meanScaledJacobian, afterFew.meanScaledJacobian + 0.1);
  EXPECT_GE(afterMany.smallestScaledJacobian, 0.2);
  EXPECT_EQ(paddedWith(ball, paddingOptions({})).mesh.nodes, paddedWith(ball, shorter).mesh.nodes);
}

TEST(Padding, IsTheSameForAnyNumberOfThreads)
{
  const EqualisationResult one = equalisedWithPadding(ball, 7, 1, 1);
  const EqualisationResult three = equalisedWithPadding(ball, 7, 1, 3);
  EXPECT_EQ(one.mesh.nodes, three.mesh.nodes);
}

TEST(Padding, ProjectionConvergesInAFewStepsOfANewtonsMethod)
{
  const HexMesh            start = padded(equaliseVolumes(ball.lattice(4), ball.distance(), ball.volume()).mesh, 1);
  const double             target = ball.volume() / static_cast<double>(start.cellCount());
  EqualMeasureOptions      options;
  const EqualMeasureResult result = projectOntoEqualMeasure(start, VolumeMeasure(), target, ball.distance(), options);
  EXPECT_TRUE(result.report.converged) << result.report.note;
  EXPECT_LE(result.report.residual, 1e-24);
  EXPECT_LE(result.report.steps, 8);
  for (const EqualMeasureStep & step : result.steps)
  {
    EXPECT_LT(step.solverSteps, 100); // the preconditioner fits the padding, too
  }
}

TEST(Padding, MassesUnderALinearDensityBecomeEqual)
{
  struct Ramp final : Density
  {
    [[nodiscard]] ValueAndGradient
    at(const Vector3 & p) const override
    {
      return { 1.0 + 0.02 * p.x(), Vector3(0.02, 0.0, 0.0) };
    }
  };
  const Ramp               density;
  const MassMeasure        measure(density, { 4 });
  const EqualisationResult volumes = equalisedWithPadding(ball, 4, 1);
  const EqualisationResult masses = equaliseMeasures(
    volumes.mesh, ball.distance(), ball.volume(), measure, ball.volume(), paddingOptions(EqualisationOptions{}));
  EXPECT_TRUE(masses.exact) << (masses.shortcomings.empty() ? "" : masses.shortcomings.front());
  EXPECT_LE(measureEquality(masses.mesh, measure).variance, 1e-18);
  EXPECT_GE(volumeQuality(masses.mesh).volumeVariance, 1e-4);
}

TEST(Padding, WhatIsForLatticesAloneRefusesIt)
{
  const HexMesh mesh = padded(ball.lattice(3), 1);
  EXPECT_THROW((void)padded(mesh, 1), InvalidInput);
  EXPECT_THROW((void)padded(ball.lattice(3), -1), InvalidInput);
  EXPECT_THROW((void)smoothLattice(mesh, {}, {}), InvalidInput);
  EXPECT_THROW((void)equaliseVolumes(mesh, ball.distance(), ball.volume(), nodes(8)), InvalidInput);
}
