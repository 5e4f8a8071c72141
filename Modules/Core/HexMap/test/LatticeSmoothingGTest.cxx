// Harmonic identities: round-off (1e-11). Surface constraint: 1e-12. Guarded smoothing and edge sliding: inequalities
// that the algorithm guarantees (badness never rises) or that its purpose asks for, on shapes where they are far off.
#include "moserhex/HexMap/LatticeSmoothing.h"

#include "TestLattices.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Quality/HexQuality.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace moserhex;
using namespace moserhex::testing;

namespace
{
LatticeSmoothingOptions
nothing()
{
  LatticeSmoothingOptions options;
  options.edges.slides = 0;
  options.guarded.sweeps = 0;
  return options;
}

/** Sum over all corners of max(0, threshold - scaled Jacobian)^2. */
double
totalBadness(const HexMesh & mesh, double threshold)
{
  double sum = 0.0;
  for (std::size_t cell = 0; cell < mesh.cellCount(); ++cell)
  {
    const HexCorners corners = cellCorners(mesh, cell);
    const int        next[8][3] = { { 1, 3, 4 }, { 2, 0, 5 }, { 3, 1, 6 }, { 0, 2, 7 },
                                    { 7, 5, 0 }, { 4, 6, 1 }, { 5, 7, 2 }, { 6, 4, 3 } };
    const auto       jacobians = cornerJacobians(corners);
    for (std::size_t c = 0; c < 8; ++c)
    {
      double lengths = 1.0;
      for (const int neighbour : next[c])
      {
        lengths *= (corners[static_cast<std::size_t>(neighbour)] - corners[c]).norm();
      }
      const double missing = threshold - jacobians[c] / lengths;
      sum += missing > 0.0 ? missing * missing : 0.0;
    }
  }
  return sum;
}

/** Cylinder-like block, flat on one side: two cube edges lie on the flat side. */
double
flatSidedRadius(const Vector3 & d)
{
  const double round = 20.0;
  const double flat = d[1] < -0.1 ? 11.0 / -d[1] : 1e9;
  return std::pow(std::pow(round, -8) + std::pow(flat, -8), -0.125);
}
} // namespace

TEST(LatticeSmoothing, NothingAskedForChangesNothing)
{
  const HexMesh mesh = shaken(regularLattice(6), 0.05, 1);
  const HexMesh result = smoothLattice(mesh, alongRays(ellipsoidRadius), nothing());
  EXPECT_EQ(result.nodes, mesh.nodes);
}

TEST(LatticeSmoothing, HarmonicInteriorNodesAreTheMeanOfTheirNeighbours)
{
  LatticeSmoothingOptions options = nothing();
  options.interiorTime = std::numeric_limits<double>::infinity();
  const HexMesh mesh = smoothLattice(starShapedMesh(4, bumpyRadius), {}, options);
  const int     n = mesh.nodesPerSide;
  for (int k = 1; k + 1 < n; ++k)
  {
    for (int j = 1; j + 1 < n; ++j)
    {
      for (int i = 1; i + 1 < n; ++i)
      {
        const auto    at = [&](int a, int b, int c) { return mesh.nodes[mesh.nodeNumber(a, b, c)]; };
        const Vector3 mean =
          (at(i + 1, j, k) + at(i - 1, j, k) + at(i, j + 1, k) + at(i, j - 1, k) + at(i, j, k + 1) + at(i, j, k - 1)) /
          6.0;
        EXPECT_LT((at(i, j, k) - mean).norm(), 1e-11);
      }
    }
  }
}

TEST(LatticeSmoothing, LinearMapsAreFixedPointsOfTheDiffusion)
{
  Matrix3 matrix;
  matrix << 3, 0.5, 0, -0.2, 2, 0.1, 0.3, 0, 1;
  const HexMesh mesh = mappedLattice(7, [&](const Vector3 & x) { return Vector3(matrix * x); });
  for (const double time : { 0.1, 5.0, 1e6, std::numeric_limits<double>::infinity() })
  {
    LatticeSmoothingOptions options = nothing();
    options.interiorTime = time;
    const HexMesh result = smoothLattice(mesh, {}, options);
    for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
    {
      EXPECT_LT((result.nodes[node] - mesh.nodes[node]).norm(), 1e-12);
    }
  }
}

TEST(LatticeSmoothing, DiffusionRestoresAShakenLatticeFurtherTheLongerItLasts)
{
  const HexMesh regular = regularLattice(8);
  const HexMesh mesh = shaken(regular, 0.05, 2);
  double        previous = std::numeric_limits<double>::infinity();
  for (const double time : { 0.1, 1.0, 10.0, 1e6 })
  {
    LatticeSmoothingOptions options = nothing();
    options.interiorTime = time;
    const HexMesh result = smoothLattice(mesh, {}, options);
    double        squares = 0.0;
    for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
    {
      squares += (result.nodes[node] - regular.nodes[node]).squaredNorm();
    }
    EXPECT_LT(squares, 0.7 * previous);
    previous = squares;
  }
  EXPECT_LT(previous, 1e-9);
}

TEST(LatticeSmoothing, BoundaryNodesStayOnTheSurface)
{
  LatticeSmoothingOptions options;
  options.boundarySweeps = 3;
  options.interiorTime = 0.1;
  const HexMesh mesh = smoothLattice(starShapedMesh(5, bumpyRadius), alongRays(bumpyRadius), options);
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
  {
    if (onBoundary(mesh.nodesPerSide, node))
    {
      const Vector3 direction = mesh.nodes[node].normalized();
      EXPECT_NEAR(mesh.nodes[node].norm(), bumpyRadius(direction), 1e-12);
    }
  }
}

TEST(LatticeSmoothing, WithoutAProjectionTheBoundaryIsHeld)
{
  const HexMesh           mesh = shaken(starShapedMesh(4, bumpyRadius), 0.5, 3);
  LatticeSmoothingOptions options;
  options.boundarySweeps = 2;
  const HexMesh result = smoothLattice(mesh, {}, options);
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
  {
    if (onBoundary(mesh.nodesPerSide, node))
    {
      EXPECT_EQ(result.nodes[node], mesh.nodes[node]);
    }
  }
}

TEST(LatticeSmoothing, TangentialSweepsEvenOutTheBoundary)
{
  // One boundary node of a ball pulled aside along the surface comes back towards the middle of its neighbours.
  const auto    sphere = alongRays([](const Vector3 &) { return 10.0; });
  HexMesh       mesh = starShapedMesh(5, [](const Vector3 &) { return 10.0; });
  const auto    node = mesh.nodeNumber(5, 5, 9);
  const Vector3 original = mesh.nodes[node];
  mesh.nodes[node] = sphere(original + Vector3(0.6, 0.3, 0.0));
  LatticeSmoothingOptions options = nothing();
  options.boundarySweeps = 1;
  options.boundaryStrength = 1.0;
  const HexMesh result = smoothLattice(mesh, sphere, options);
  EXPECT_LT((result.nodes[node] - original).norm(), 0.3 * (mesh.nodes[node] - original).norm());
}

TEST(LatticeSmoothing, GuardedSweepsNeverRaiseTheBadness)
{
  for (std::uint64_t seed = 1; seed <= 5; ++seed)
  {
    HexMesh                 mesh = shaken(starShapedMesh(4, bumpyRadius), 3.0, seed);
    LatticeSmoothingOptions options = nothing();
    options.guarded.sweeps = 1;
    double before = totalBadness(mesh, options.guarded.threshold);
    ASSERT_GT(before, 0.0);
    for (int sweep = 0; sweep < 4; ++sweep)
    {
      mesh = smoothLattice(mesh, alongRays(bumpyRadius), options);
      const double after = totalBadness(mesh, options.guarded.threshold);
      EXPECT_LE(after, before * (1.0 + 1e-12)) << "seed " << seed;
      before = after;
    }
  }
}

TEST(LatticeSmoothing, GuardedSweepsUntangleNineTenthsOfAShakenBlock)
{
  const HexMesh mesh = shaken(regularLattice(8), 0.12, 4);
  const auto    before = summarizeQuality(mesh).concaveCells;
  ASSERT_GT(before, 30U);
  LatticeSmoothingOptions options = nothing();
  options.guarded.sweeps = 10;
  EXPECT_LT(10U * summarizeQuality(smoothLattice(mesh, {}, options)).concaveCells, before);
}

TEST(LatticeSmoothing, EdgesThatLieOnAFlatSideSlideTowardsTheRim)
{
  const HexMesh           mesh = starShapedMesh(10, flatSidedRadius);
  LatticeSmoothingOptions options = nothing();
  options.edges.slides = 8;
  const HexMesh result = smoothLattice(mesh, alongRays(flatSidedRadius), options);
  // The edge j = 0, k = 0 lies on the flat side y = -11, its rim towards -z.
  const auto middle = mesh.nodeNumber(10, 0, 0);
  EXPECT_LT(result.nodes[middle][2], mesh.nodes[middle][2] - 0.2);
  EXPECT_GT(summarizeQuality(result).edges.scaledJacobianMin, summarizeQuality(mesh).edges.scaledJacobianMin);
}

TEST(LatticeSmoothing, EdgesOfABallStay)
{
  const auto              radius = [](const Vector3 &) { return 10.0; };
  const HexMesh           mesh = starShapedMesh(6, radius);
  LatticeSmoothingOptions options = nothing();
  options.edges.slides = 3;
  const HexMesh result = smoothLattice(mesh, alongRays(radius), options);
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
  {
    EXPECT_LT((result.nodes[node] - mesh.nodes[node]).norm(), 1e-9);
  }
}

TEST(LatticeSmoothing, SmallAndOddLatticesAreAccepted)
{
  for (const int n : { 2, 3, 4, 5 })
  {
    const HexMesh mesh = regularLattice(n);
    EXPECT_EQ(smoothLattice(mesh, [](const Vector3 & p) { return p; }).nodes.size(), mesh.nodes.size());
  }
}

TEST(LatticeSmoothing, TwoRunsGiveTheSameBits)
{
  const HexMesh mesh = shaken(starShapedMesh(6, bumpyRadius), 1.0, 6);
  EXPECT_EQ(smoothLattice(mesh, alongRays(bumpyRadius)).nodes, smoothLattice(mesh, alongRays(bumpyRadius)).nodes);
}

TEST(LatticeSmoothing, OptionsOutOfRangeAreRefused)
{
  const HexMesh mesh = regularLattice(4);
  const auto    refuses = [&](auto change) {
    LatticeSmoothingOptions options;
    change(options);
    EXPECT_THROW(static_cast<void>(smoothLattice(mesh, {}, options)), InvalidInput);
  };
  refuses([](auto & o) { o.edges.slides = -1; });
  refuses([](auto & o) { o.edges.sufficientCurvature = 0.0; });
  refuses([](auto & o) { o.edges.step = -0.1; });
  refuses([](auto & o) { o.edges.gain = std::numeric_limits<double>::infinity(); });
  refuses([](auto & o) { o.edges.window = 0; });
  refuses([](auto & o) { o.boundarySweeps = -1; });
  refuses([](auto & o) { o.boundaryStrength = 1.5; });
  refuses([](auto & o) { o.interiorTime = -1.0; });
  refuses([](auto & o) { o.guarded.sweeps = -1; });
  refuses([](auto & o) { o.guarded.strength = 0.0; });
  refuses([](auto & o) { o.guarded.threshold = 1.0; });
}

TEST(LatticeSmoothing, WrongNumberOfNodesIsRefused)
{
  HexMesh mesh = regularLattice(4);
  mesh.nodes.pop_back();
  EXPECT_THROW(static_cast<void>(smoothLattice(mesh, {})), InvalidInput);
}

TEST(LatticeSmoothing, CoordinateThatIsNotFiniteIsRefused)
{
  HexMesh mesh = regularLattice(4);
  mesh.nodes[5][2] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(static_cast<void>(smoothLattice(mesh, {})), InvalidInput);
}
