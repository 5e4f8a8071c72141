// Points found against points known to lie on the surface: within the spacing of the grid, which follows from the
// number wanted. Threads: bit for bit.
#include "SurfacePoints.h"

#include "TestSolids.h"
#include "moserhex/Common/Errors.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

using namespace moserhex;
using namespace moserhex::testing;

namespace
{
const BentEllipsoid organ{ Vector3(8.0, 4.0, 5.0),
                           0.03,
                           Eigen::AngleAxisd(0.7, Vector3(1, 2, 3).normalized()).matrix(),
                           Vector3(100.0, -50.0, 7.0) };

/** Spacing at which a ball of this volume has so many crossings [mm]. */
double
spacingFor(double volume, std::size_t count)
{
  return std::sqrt(1.5 * std::cbrt(36.0 * pi * volume * volume) / static_cast<double>(count));
}

/** Of the farthest point of one set from the other. */
double
farthest(const Positions & points, const Positions & others)
{
  double largest = 0.0;
  for (const Vector3 & p : points)
  {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vector3 & q : others)
    {
      nearest = std::min(nearest, (p - q).squaredNorm());
    }
    largest = std::max(largest, nearest);
  }
  return std::sqrt(largest);
}

Positions
pointsFrom(const Positions & around, std::size_t count = 2000, unsigned int threads = 1)
{
  return surfacePoints(around, organ.distance(), organ.volume(), count, threads);
}
} // namespace

TEST(SurfacePoints, LieOnTheSurface)
{
  const double tolerance = spacingFor(organ.volume(), 2000) / 4000.0;
  Vector3      gradient;
  for (const Vector3 & point : pointsFrom(organ.lattice(2).nodes))
  {
    EXPECT_LT(std::abs(organ.distance()(point, gradient)), 1.1 * tolerance);
  }
}

TEST(SurfacePoints, AreAsManyAsWantedOnABall)
{
  const BentEllipsoid ball = ballOfRadius(3.0);
  for (const std::size_t count : { 500u, 2000u, 20000u })
  {
    const auto found = surfacePoints(ball.lattice(2).nodes, ball.distance(), ball.volume(), count, 1).size();
    EXPECT_NEAR(static_cast<double>(found) / static_cast<double>(count), 1.0, 0.05);
  }
}

TEST(SurfacePoints, CoverTheWholeSurface)
{
  for (const std::size_t count : { 500u, 4000u })
  {
    EXPECT_LT(farthest(organ.boundaryPoints(7), pointsFrom(organ.lattice(2).nodes, count)),
              spacingFor(organ.volume(), count));
  }
}

TEST(SurfacePoints, CoverWhatLiesFarOutsideTheLattice)
{
  const Vector3   tip = organ.ofUnitBall({ 1.0, 0.0, 0.0 });
  const Positions crumb{ organ.shift, organ.shift + Vector3(0.1, 0.2, 0.1) };
  const Positions offCentre{ tip, 0.9 * tip + 0.1 * organ.shift };
  for (const Positions & around : { crumb, offCentre })
  {
    EXPECT_LT(farthest(organ.boundaryPoints(7), pointsFrom(around)), spacingFor(organ.volume(), 2000));
  }
}

TEST(SurfacePoints, SolidWithoutEndIsRefused)
{
  const SignedDistance halfSpace = [](const Vector3 & p, Vector3 & gradient) {
    gradient = Vector3(0.0, 0.0, 1.0);
    return p[2];
  };
  EXPECT_THROW((void)surfacePoints(organ.lattice(2).nodes, halfSpace, 10.0, 100, 1), InvalidInput);
}

TEST(SurfacePoints, LatticeElsewhereIsRefused)
{
  const Positions elsewhere{ Vector3::Zero(), Vector3::Ones() };
  EXPECT_THROW((void)pointsFrom(elsewhere), InvalidInput);
}

TEST(SurfacePoints, LatticeOutOfAllProportionIsRefused)
{
  EXPECT_THROW((void)pointsFrom({ organ.shift - Vector3::Constant(1e5), organ.shift + Vector3::Constant(1e5) }),
               InvalidInput);
}

TEST(SurfacePoints, AreTheSameForAnyNumberOfThreads)
{
  EXPECT_EQ(pointsFrom(organ.lattice(2).nodes, 2000, 1), pointsFrom(organ.lattice(2).nodes, 2000, 3));
}
