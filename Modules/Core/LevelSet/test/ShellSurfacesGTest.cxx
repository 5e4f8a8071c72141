// Exact class: topology, nesting, determinism for any thread count, refusals. Closed-form class: shells of a ball are
// concentric spheres of known radius, within 1 % of the ball's radius (the ordering is known to one layer of nodes).
// Contract class: volume within 1e-5, smallest angle 25 degrees, no negative cotangent weight.
#include "moserhex/Common/Errors.h"
#include "moserhex/Geometry/SelfIntersection.h"
#include "moserhex/LevelSet/CubicInterpolation.h"
#include "moserhex/LevelSet/EikonalArrival.h"
#include "moserhex/LevelSet/MarchingTetrahedra.h"
#include "moserhex/LevelSet/ShellOrdering.h"
#include "moserhex/LevelSet/ShellSurfaces.h"
#include "moserhex/LevelSet/SignedDistance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace moserhex;

namespace
{

struct Organ
{
  LevelSet phi;
  LevelSet ordering;
  double   volume{ 0.0 };
};

template <typename TFunction>
Organ
organ(const Vector3 & extent, double spacing, const TFunction & f)
{
  Organ organ;
  for (std::size_t a = 0; a < 3; ++a)
  {
    const double e = extent[static_cast<int>(a)];
    organ.phi.grid.size[a] = 2 * static_cast<int>(std::ceil(e / spacing) + 5) + 1;
    organ.phi.grid.origin[static_cast<int>(a)] = -spacing * (organ.phi.grid.size[a] / 2) + 0.1 * spacing;
  }
  organ.phi.grid.spacing = spacing;
  organ.phi.values.resize(organ.phi.grid.nodeCount());
  for (std::size_t node = 0; node < organ.phi.values.size(); ++node)
  {
    organ.phi.values[node] = f(organ.phi.grid.point(node));
  }
  organ.phi = redistance(organ.phi);
  organ.volume = VolumeBelowLevel(organ.phi).volume(0.0);
  const FrontWeight front = frontWeight(organ.phi);
  organ.ordering =
    shellOrdering(organ.phi, eikonalArrival(organ.phi, front.weight, front.seed).levelSet, front.seed).levelSet;
  return organ;
}

/** Half a cell edge of a lattice of `shells` shells. */
double
spacingFor(double volume, int shells)
{
  return 0.5 * std::cbrt(volume) / (2 * shells - 1);
}

const Organ &
ball()
{
  static const Organ o = organ({ 10, 10, 10 }, spacingFor(4188.8, 5), [](const Vector3 & p) { return p.norm() - 10; });
  return o;
}

const Organ &
ellipsoid()
{
  static const Organ o = organ({ 24, 8, 8 }, spacingFor(6434, 6), [](const Vector3 & p) {
    return 8 * (Vector3(p.x() / 24, p.y() / 8, p.z() / 8).norm() - 1);
  });
  return o;
}

const Organ &
dumbbell()
{
  static const Organ o = organ({ 14, 6, 6 }, spacingFor(1300, 6), [](const Vector3 & p) {
    const double left = (p + Vector3(8, 0, 0)).norm() - 5.5;
    const double right = (p - Vector3(8, 0, 0)).norm() - 5;
    const double bar = std::max(std::abs(p.x()) - 8, std::hypot(p.y(), p.z()) - 2);
    return std::min(std::min(left, right), bar);
  });
  return o;
}

void
expectContract(const Organ & o, int count)
{
  const std::vector<ShellSurface> shells = extractShellSurfaces(o.ordering, o.phi, o.volume, count);
  const std::vector<double>       fractions = cubeVolumeFractions(count);
  ASSERT_EQ(shells.size(), fractions.size());
  for (std::size_t k = 0; k < shells.size(); ++k)
  {
    EXPECT_TRUE(summarizeTopology(shells[k].mesh).isSphere()) << "shell " << k + 1;
    EXPECT_NEAR(enclosedVolume(shells[k].mesh) / (fractions[k] * o.volume), 1, 1e-5) << "shell " << k + 1;
    EXPECT_EQ(shells[k].volume, enclosedVolume(shells[k].mesh));
    EXPECT_GE(shells[k].quality.minimumAngle, 25) << "shell " << k + 1;
    EXPECT_EQ(shells[k].quality.negativeCotangents, 0u) << "shell " << k + 1;
    EXPECT_EQ(countSelfIntersections(shells[k].mesh), 0u) << "shell " << k + 1;
    if (k > 0)
    {
      EXPECT_TRUE(isNestedInside(shells[k - 1].mesh, shells[k].mesh)) << "shell " << k + 1;
      EXPECT_GT(shells[k].gap.smallest, 0) << "shell " << k + 1;
    }
  }
}

} // namespace

TEST(ShellSurfaces, OfABallAreConcentricSpheres)
{
  const int                       count = 5;
  const std::vector<ShellSurface> shells = extractShellSurfaces(ball().ordering, ball().phi, ball().volume, count);
  for (std::size_t k = 0; k < shells.size(); ++k)
  {
    const double expected = 10 * (2.0 * static_cast<double>(k) + 1) / (2 * count - 1);
    for (const Vector3 & p : shells[k].mesh.vertices)
    {
      EXPECT_NEAR(p.norm(), expected, k + 1 == shells.size() ? 0.02 : 0.35) << "shell " << k + 1;
    }
  }
}

TEST(ShellSurfaces, KeepTheContractOnABall)
{
  expectContract(ball(), 5);
}

TEST(ShellSurfaces, KeepTheContractOnALongEllipsoid)
{
  expectContract(ellipsoid(), 6);
}

TEST(ShellSurfaces, KeepTheContractOnADumbbell)
{
  expectContract(dumbbell(), 6);
}

TEST(ShellSurfaces, VerticesOfTheOutermostShellLieOnTheLevelSet)
{
  const Organ &           o = ellipsoid();
  const ShellSurface      outer = extractShellSurfaces(o.ordering, o.phi, o.volume, 6).back();
  const CubicInterpolator phi(o.phi);
  for (const Vector3 & p : outer.mesh.vertices)
  {
    EXPECT_NEAR(phi.value(p), outer.level, 1e-4 * o.phi.grid.spacing);
  }
}

TEST(ShellSurfaces, TriangleCountFollowsTheCubeShell)
{
  const std::vector<ShellSurface> shells = extractShellSurfaces(ball().ordering, ball().phi, ball().volume, 5);
  for (std::size_t k = 0; k < shells.size(); ++k)
  {
    const double side = 2.0 * static_cast<double>(k) + 1;
    const double wanted = std::max(1200.0, 24 * side * side);
    EXPECT_NEAR(static_cast<double>(shells[k].mesh.triangles.size()) / wanted, 1, 0.1) << "shell " << k + 1;
  }
}

TEST(ShellSurfaces, VolumeFractionsMayBeAnyIncreasingNumbers)
{
  const std::vector<double>       fractions{ 0.2, 0.25, 0.9, 1.0 };
  const std::vector<ShellSurface> shells = extractShellSurfaces(ball().ordering, ball().phi, ball().volume, fractions);
  for (std::size_t k = 0; k < fractions.size(); ++k)
  {
    EXPECT_NEAR(shells[k].volume / ball().volume, fractions[k], 1e-5);
  }
}

TEST(ShellSurfaces, AreTheSameForOneAndTwoThreads)
{
  ShellSurfaceOptions options;
  options.threads = 1;
  const auto one = extractShellSurfaces(ball().ordering, ball().phi, ball().volume, 5, options);
  options.threads = 2;
  const auto two = extractShellSurfaces(ball().ordering, ball().phi, ball().volume, 5, options);
  for (std::size_t k = 0; k < one.size(); ++k)
  {
    EXPECT_EQ(one[k].mesh.vertices, two[k].mesh.vertices);
    EXPECT_EQ(one[k].mesh.triangles, two[k].mesh.triangles);
    EXPECT_EQ(one[k].gap.smallest, two[k].gap.smallest);
  }
}

TEST(ShellSurfaces, FollowAGridThatIsTurnedAndMoved)
{
  Organ         turned = ball();
  Matrix3       direction;
  const Vector3 offset(100, -50, 7);
  direction << 0.6, -0.8, 0, 0.8, 0.6, 0, 0, 0, 1;
  const auto move = [&](RegularGrid & grid) {
    grid.origin = direction * grid.origin + offset;
    grid.direction = direction * grid.direction;
  };
  move(turned.phi.grid);
  move(turned.ordering.grid);
  const auto before = extractShellSurfaces(ball().ordering, ball().phi, ball().volume, 3);
  const auto after = extractShellSurfaces(turned.ordering, turned.phi, ball().volume, 3);
  for (std::size_t k = 0; k < before.size(); ++k)
  {
    // Round-off may decide a flip or a collapse differently, so the surfaces are compared, within their chords.
    Positions moved;
    for (const Vector3 & p : before[k].mesh.vertices)
    {
      moved.push_back(direction * p + offset);
    }
    EXPECT_LT(summarizeDistances(moved, ClosestPointSearch(after[k].mesh)).largest, 0.08);
  }
}

TEST(ShellSurfaces, SummaryHoldsTheWorstNumbersAndWarns)
{
  std::vector<ShellSurface> shells(3);
  for (ShellSurface & shell : shells)
  {
    shell.targetVolume = 1;
    shell.volume = 1;
    shell.quality.minimumAngle = 40;
  }
  shells[1].volume = 1.0002;
  shells[2].quality.minimumAngle = 33;
  shells[1].gap = { 0.5, 1.0, 1.5 };
  shells[2].gap = { 0.1, 3.0, 4.0 };
  const ShellSurfacesSummary summary = summarizeShells(shells);
  EXPECT_NEAR(summary.worstVolumeError, 2e-4, 1e-12);
  EXPECT_EQ(summary.minimumAngle, 33);
  EXPECT_EQ(summary.smallestGap, 0.1);
  EXPECT_EQ(summary.largestGap, 4.0);
  EXPECT_NEAR(summary.meanGap, 2.0, 1e-12);
  EXPECT_NEAR(summary.smallestRelativeGap(), 0.05, 1e-12);
  EXPECT_EQ(summary.warnings.size(), 1u); // the thin gap
  shells[2].nested = false;
  shells[2].selfIntersections = 2;
  shells[0].quality.negativeCotangents = 1;
  EXPECT_EQ(summarizeShells(shells).warnings.size(), 4u);
}

TEST(ShellSurfaces, WrongInputIsRefused)
{
  const Organ & o = ball();
  LevelSet      other = o.phi;
  other.grid.size[2] -= 1;
  other.values.resize(other.grid.nodeCount());
  EXPECT_THROW((void)extractShellSurfaces(other, o.phi, o.volume, 3), InvalidInput);
  EXPECT_THROW((void)extractShellSurfaces(o.ordering, o.phi, 0.0, 3), InvalidInput);
  EXPECT_THROW((void)extractShellSurfaces(o.ordering, o.phi, o.volume, 0), InvalidInput);
  using Fractions = std::vector<double>;
  for (const Fractions & wrong : { Fractions{}, Fractions{ 0.5 }, Fractions{ 0.5, 0.5, 1 }, Fractions{ 0, 1 } })
  {
    EXPECT_THROW((void)extractShellSurfaces(o.ordering, o.phi, o.volume, wrong), InvalidInput);
  }
  EXPECT_THROW((void)extractShellSurfaces(o.ordering, o.phi, 1e9, 3), InvalidInput); // more than the box holds
  const auto refused = [&](auto change) {
    ShellSurfaceOptions options;
    change(options);
    EXPECT_THROW((void)extractShellSurfaces(o.ordering, o.phi, o.volume, 3, options), InvalidInput);
  };
  refused([](auto & x) { x.trianglesPerQuad = 0; });
  refused([](auto & x) { x.fewestTriangles = 3; });
  refused([](auto & x) { x.volumeTolerance = 0; });
  refused([](auto & x) { x.acceptedVolumeError = 0; });
  refused([](auto & x) { x.maximumVolumeShifts = -1; });
}

TEST(ShellSurfaces, MissedVolumeIsNotSilent)
{
  ShellSurfaceOptions options;
  options.maximumVolumeShifts = 0;
  options.acceptedVolumeError = 1e-9;
  EXPECT_THROW((void)extractShellSurfaces(ball().ordering, ball().phi, ball().volume, 3, options), NotConverged);
}

TEST(ShellSurfaces, CallerCanStop)
{
  EXPECT_THROW((void)extractShellSurfaces(
                 ball().ordering, ball().phi, ball().volume, 3, {}, [](double fraction) { return fraction < 0.5; }),
               Cancelled);
}
