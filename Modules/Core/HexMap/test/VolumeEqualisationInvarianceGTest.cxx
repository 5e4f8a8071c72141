// Threads: bit for bit. Rotation with translation: 1e-9 relative after few steps; a tenth of a cell's edge after all of
// them (0.01 is measured: rounding grows along the minimisation).
#include "TestEqualisation.h"
#include "moserhex/Analytic/SurfaceShapes.h"
#include "moserhex/Common/Errors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace moserhex;
using namespace moserhex::testing;

namespace
{
EqualisationResult
equalised(const BentEllipsoid & solid, const EqualisationOptions & options)
{
  return equaliseVolumes(solid.lattice(3), solid.distance(), solid.volume(), options);
}

/** A solid and the same one turned and 100 mm away. */
struct MovedSolid
{
  explicit MovedSolid(const BentEllipsoid & solid) : one(solid), other(solid)
  {
    other.turn = analytic::rotation(Vector3(1.0, -2.0, 0.5), 0.7);
    other.shift = Vector3(100.0, -50.0, 30.0);
  }

  /** Between the results, moved back [mm]. */
  [[nodiscard]] double
  largestDifference(const EqualisationOptions & options) const
  {
    const HexMesh first = equalised(one, options).mesh;
    const HexMesh second = equalised(other, options).mesh;
    double        largest = 0.0;
    for (std::size_t node = 0; node < first.nodes.size(); ++node)
    {
      const Vector3 expected = other.shift + other.turn * first.nodes[node];
      largest = std::max(largest, (second.nodes[node] - expected).norm());
    }
    return largest;
  }

  BentEllipsoid one;
  BentEllipsoid other;
};
} // namespace

TEST(VolumeEqualisation, IsTheSameForAnyNumberOfThreads)
{
  EqualisationOptions options = nodes(14); // slabs run side by side from here on
  options.threads = 1;
  const auto one = equaliseVolumes(banana.lattice(3), banana.distance(), banana.volume(), options);
  for (const unsigned int threads : { 2u, 3u })
  {
    options.threads = threads;
    const auto several = equaliseVolumes(banana.lattice(3), banana.distance(), banana.volume(), options);
    EXPECT_EQ(several.mesh.nodes, one.mesh.nodes) << threads;
    EXPECT_EQ(several.level, one.level) << threads;
    EXPECT_EQ(several.largestDistance, one.largestDistance) << threads;
    EXPECT_EQ(several.steps.size(), one.steps.size()) << threads;
  }
}

TEST(VolumeEqualisation, FirstStepsForAMovedSolidAreThoseOfTheSolid)
{
  EqualisationOptions options = stages({ 0.1, 50.0, 80.0, 5, 1 });
  options.projection.maximumSteps = 1; // what comes after the first steps is not looked at
  options.repairRounds = 0;
  const MovedSolid       pair(banana);
  const EqualisationStep first = equalised(pair.one, options).steps.front();
  const EqualisationStep moved = equalised(pair.other, options).steps.front();
  EXPECT_EQ(first.iterations, 5);
  EXPECT_NEAR(moved.variance, first.variance, 1e-9 * first.variance);
  EXPECT_NEAR(moved.distance, first.distance, 1e-9 * 30.0);
}

TEST(VolumeEqualisation, MovedSolidGivesTheMovedResult)
{
  // Rounding grows along a few hundred steps of minimisation, mostly in where nodes slide along the surface.
  const MovedSolid pair(banana);
  EXPECT_LT(pair.largestDifference(nodes(10)), 0.1 * std::cbrt(banana.volume() / 729.0));
}

TEST(VolumeEqualisation, ScaledSolidGivesTheScaledResult)
{
  BentEllipsoid scaled = banana;
  scaled.semiAxes *= 2.0;
  scaled.curvature *= 0.5;
  EqualisationOptions options = nodes(10);
  const auto          one = equaliseVolumes(banana.lattice(3), banana.distance(), banana.volume(), options);
  options.surfaceTolerance *= 2.0;
  const auto other = equaliseVolumes(scaled.lattice(3), scaled.distance(), scaled.volume(), options);
  double     largest = 0.0;
  for (std::size_t node = 0; node < one.mesh.nodes.size(); ++node)
  {
    largest = std::max(largest, (other.mesh.nodes[node] - 2.0 * one.mesh.nodes[node]).norm());
  }
  EXPECT_LT(largest, 1e-9 * 60.0); // a power of two: hardly any rounding differs
}

TEST(VolumeEqualisation, ProgressGrowsFromZeroToOne)
{
  double previous = 0.0;
  (void)equaliseVolumes(ball.lattice(2), ball.distance(), ball.volume(), nodes(8), [&](double fraction) {
    EXPECT_GE(fraction, previous);
    EXPECT_LE(fraction, 1.0);
    previous = fraction;
    return true;
  });
  EXPECT_EQ(previous, 1.0);
}

TEST(VolumeEqualisation, CallbackCancels)
{
  int calls = 0;
  EXPECT_THROW((void)equaliseVolumes(
                 ball.lattice(2), ball.distance(), ball.volume(), nodes(8), [&](double) { return ++calls < 20; }),
               Cancelled);
  EXPECT_EQ(calls, 20);
}
