// Identity class (1e-12): inverses, invariance. Search class: the compass stops at the documented part of the bounds,
// so what it finds lies within that of the true frame, plus what the triangulation of a ridge blurs (half a degree).
#include "moserhex/Analytic/SurfaceShapes.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/HexMap/CubeShellMaps.h"
#include "moserhex/HexMap/FramePlacement.h"
#include "moserhex/SphericalMap/FrameAlignment.h"
#include "moserhex/SphericalMap/SphereMapQuality.h"
#include "moserhex/StructuredGrid/CubeToSphere.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <limits>

using namespace moserhex;

namespace
{

constexpr double degree = 0.017453292519943295;

/** A cube with rounded edges, its frame turned by `turn` away from the axes; the map is the direction. */
TriangleMesh
roundedCube(const Matrix3 & turn)
{
  return analytic::starShapedSurface(4, [&](const Vector3 & direction) {
    return 20.0 / std::pow((turn.transpose() * direction).array().abs().pow(6).sum(), 1.0 / 6.0);
  });
}

TriangleMesh
lobedSurface()
{
  return analytic::starShapedSurface(
    3, [](const Vector3 & d) { return 20.0 * (1.0 + 0.25 * d[0] * d[1] + 0.2 * d[2] * d[2] * d[0] - 0.15 * d[1]); });
}

Positions
directions(int levels)
{
  return analytic::icosphere(levels).vertices;
}

double
angleInDegrees(const Matrix3 & rotation)
{
  return Eigen::AngleAxisd(rotation).angle() / degree;
}

FramePlacementOptions
freeSearch()
{
  FramePlacementOptions options;
  options.anchor = 0.0;
  return options;
}

} // namespace

TEST(FramePlacement, UnplacedUndoesPlaced)
{
  const FramePlacement placement{ analytic::rotation(Vector3(1, -2, 0.5), 0.9), Vector3(0.1, -0.2, 0.05) };
  for (const Vector3 & s : directions(2))
  {
    EXPECT_LT((unplaced(placed(s, placement), placement) - s).norm(), 1e-12);
    EXPECT_NEAR(placed(s, placement).norm(), 1.0, 1e-15);
  }
}

TEST(FramePlacement, MapsArePlacedVertexByVertex)
{
  const FramePlacement         placement{ analytic::rotation(Vector3::UnitY(), 0.3), Vector3(0, 0.1, 0) };
  const std::vector<Positions> maps{ directions(0), directions(1) };
  const std::vector<Positions> result = placed(maps, placement);
  ASSERT_EQ(result.size(), 2u);
  ASSERT_EQ(result[1].size(), maps[1].size());
  EXPECT_EQ(result[1][7], placed(maps[1][7], placement));
}

TEST(FramePlacement, BoostChangesAreaRatiosWithinTheDocumentedFactor)
{
  const double         b = 0.2;
  const FramePlacement placement{ Matrix3::Identity(), b * Vector3(1, 2, -2).normalized() };
  const double         factor = std::pow((1.0 + b) / (1.0 - b), 2);
  const TriangleMesh   sphere = analytic::icosphere(4);
  const Positions      moved = placed({ sphere.vertices }, placement).front();
  double               largest = 0.0;
  double               smallest = std::numeric_limits<double>::infinity();
  for (const Triangle & t : sphere.triangles)
  {
    const auto   angle = [&](const Positions & p) { return signedSolidAngle(p[t[0]], p[t[1]], p[t[2]]); };
    const double ratio = angle(moved) / angle(sphere.vertices);
    largest = std::max(largest, ratio);
    smallest = std::min(smallest, ratio);
  }
  // Reached at the poles of the boost; triangles of 0.08 rad about them come within 2 %.
  EXPECT_LE(largest, factor);
  EXPECT_GT(largest, 0.98 * factor);
  EXPECT_GE(smallest, 1.0 / factor);
  EXPECT_LT(smallest, 1.02 / factor);
}

TEST(FramePlacement, EdgesOfACubeHaveScaledJacobianOne)
{
  FramePlacementOptions options;
  options.nodesPerSide = 8;
  const TriangleMesh cube = cubeSurfaceMesh(7); // its vertices are the nodes
  Positions          map;
  for (const Vector3 & vertex : cube.vertices)
  {
    map.push_back(cubeToSphere(vertex / vertex.cwiseAbs().maxCoeff()));
  }
  const EdgeScore score = edgeScore(cube, map, {}, options);
  EXPECT_NEAR(score.smallestScaledJacobian, 1.0, 1e-9);
  EXPECT_NEAR(score.score, std::exp(-options.sharpness), 1e-9);
}

TEST(FramePlacement, ScoresOfManyPlacementsAreThoseOfEach)
{
  const TriangleMesh          surface = lobedSurface();
  std::vector<FramePlacement> placements(3);
  placements[1].rotation = analytic::rotation(Vector3(1, 2, 3).normalized(), 0.5);
  placements[2].boost = Vector3(0.1, 0.0, 0.05);
  const std::vector<EdgeScore> scores = edgeScores(surface, directions(3), placements);
  ASSERT_EQ(scores.size(), 3u);
  for (std::size_t p = 0; p < 3; ++p)
  {
    EXPECT_EQ(scores[p].score, edgeScore(surface, directions(3), placements[p]).score);
  }
}

TEST(FramePlacement, FrameOfATurnedCubeIsFoundAgain)
{
  for (const Vector3 & axis : { Vector3(1, 0, 0), Vector3(1, -2, 1.5) })
  {
    const Matrix3              turn = analytic::rotation(axis.normalized(), 7.0 * degree);
    const FramePlacementResult result = placeFrame(roundedCube(turn), directions(4), freeSearch());
    EXPECT_LT(angleInDegrees(result.placement.rotation * turn), 1.0);
    EXPECT_NEAR(result.angle, 7.0, 1.0);
    EXPECT_LT(result.after.score, result.before.score);
    EXPECT_GT(result.after.smallestScaledJacobian, result.before.smallestScaledJacobian);
    EXPECT_TRUE(result.report.converged);
    EXPECT_EQ(result.report.note, "");
  }
}

TEST(FramePlacement, BoostThatPulledTheMapOffTheEdgesIsUndone)
{
  const FramePlacement  pulled{ Matrix3::Identity(), Vector3(0.03, -0.05, 0.04) };
  FramePlacementOptions options = freeSearch();
  options.maximumBoost = 0.1;
  const Positions            map = placed({ directions(4) }, pulled).front();
  const FramePlacementResult result = placeFrame(roundedCube(Matrix3::Identity()), map, options);
  EXPECT_LT((result.placement.boost + pulled.boost).norm(), 0.01);
  EXPECT_LT(result.angle, 1.0);
}

TEST(FramePlacement, BoundsHold)
{
  FramePlacementOptions options = freeSearch();
  options.maximumAngle = 3.0;
  options.maximumBoost = 0.02;
  const FramePlacement       pulled{ analytic::rotation(Vector3(2, 1, 0).normalized(), 8.0 * degree),
                               Vector3(0.0, 0.06, 0.06) };
  const Positions            map = placed({ directions(4) }, pulled).front();
  const FramePlacementResult result = placeFrame(roundedCube(Matrix3::Identity()), map, options);
  EXPECT_LE(result.angle, 3.0 + 1e-12);
  EXPECT_GT(result.angle, 2.9) << "the true frame lies farther out in this direction";
  EXPECT_NEAR(angleInDegrees(result.placement.rotation), result.angle, 1e-9);
  EXPECT_LE(result.placement.boost.norm(), 0.02 + 1e-15);
}

TEST(FramePlacement, SphereLeavesTheFrameAlone)
{
  FramePlacementOptions options;
  options.maximumBoost = 0.05;
  const FramePlacementResult result = placeFrame(analytic::icosphere(4, 20.0), directions(4), options);
  EXPECT_LT(result.angle, 1.0);
  EXPECT_LT(result.placement.boost.norm(), 0.001);
}

TEST(FramePlacement, AnchorKeepsTheFrameNearer)
{
  const TriangleMesh    surface = lobedSurface();
  FramePlacementOptions options = freeSearch();
  const double          unbound = placeFrame(surface, directions(3), options).angle;
  options.anchor = 2.0;
  const double anchored = placeFrame(surface, directions(3), options).angle;
  options.anchor = 1e6;
  EXPECT_GT(unbound, 1.0);
  EXPECT_LT(anchored, unbound);
  EXPECT_LT(placeFrame(surface, directions(3), options).angle, 1e-3 * options.maximumAngle + 1e-12);
}

TEST(FramePlacement, PlaceSizeAndAttitudeOfTheBodyDoNotMatter)
{
  const TriangleMesh surface = lobedSurface();
  TriangleMesh       moved = surface;
  const Matrix3      turn = analytic::rotation(Vector3(1, 1, -1).normalized(), 1.1);
  for (Vector3 & vertex : moved.vertices)
  {
    vertex = 1e4 * (turn * vertex) + Vector3(5, -3, 800);
  }
  const EdgeScore expected = edgeScore(surface, directions(3), {});
  const EdgeScore score = edgeScore(moved, directions(3), {});
  EXPECT_NEAR(score.score, expected.score, 1e-9 * expected.score);
  EXPECT_NEAR(score.smallestScaledJacobian, expected.smallestScaledJacobian, 1e-9);
}

TEST(FramePlacement, TurnedMapHasTheScoreOfThePlacedFrame)
{
  const TriangleMesh   surface = lobedSurface();
  const FramePlacement placement{ analytic::rotation(Vector3(0, 1, 2).normalized(), 0.2), Vector3::Zero() };
  const Positions      turned = placed({ directions(3) }, placement).front();
  EXPECT_NEAR(edgeScore(surface, turned, {}).score, edgeScore(surface, directions(3), placement).score, 1e-9);
}

TEST(FramePlacement, ResultTellsTheScoresOfBothFrames)
{
  FramePlacementOptions options;
  options.maximumBoost = 0.05;
  const TriangleMesh         surface = lobedSurface();
  const FramePlacementResult result = placeFrame(surface, directions(3), options);
  EXPECT_EQ(result.before.score, edgeScore(surface, directions(3), {}, options).score);
  EXPECT_EQ(result.after.score, edgeScore(surface, directions(3), result.placement, options).score);
  EXPECT_LE(result.after.score, result.before.score);
  EXPECT_EQ(result.evaluations, 1 + 12 * result.report.steps);
}

TEST(FramePlacement, NoFreedomGivesTheIdentity)
{
  FramePlacementOptions options;
  options.maximumAngle = 0.0;
  const FramePlacementResult result = placeFrame(lobedSurface(), directions(3), options);
  EXPECT_EQ(result.placement.rotation, Matrix3::Identity());
  EXPECT_EQ(result.placement.boost, Vector3::Zero());
  EXPECT_EQ(result.evaluations, 1);
  EXPECT_TRUE(result.report.converged);
}

TEST(FramePlacement, SearchThatRunsOutOfRoundsSaysSo)
{
  FramePlacementOptions options;
  options.maximumRounds = 2;
  const FramePlacementResult result = placeFrame(lobedSurface(), directions(3), options);
  EXPECT_FALSE(result.report.converged);
  EXPECT_EQ(result.report.note, "the rounds ran out");
  EXPECT_EQ(result.report.steps, 2);
}

TEST(FramePlacement, ThreadsDoNotChangeAnyBit)
{
  FramePlacementOptions options;
  options.maximumBoost = 0.05;
  options.threads = 1;
  const FramePlacementResult one = placeFrame(lobedSurface(), directions(3), options);
  options.threads = 3;
  const FramePlacementResult three = placeFrame(lobedSurface(), directions(3), options);
  EXPECT_EQ(one.placement.rotation, three.placement.rotation);
  EXPECT_EQ(one.placement.boost, three.placement.boost);
  EXPECT_EQ(one.after.score, three.after.score);
  EXPECT_EQ(one.evaluations, three.evaluations);
}

TEST(FramePlacement, MapOfAnotherSurfaceIsRefused)
{
  EXPECT_THROW((void)placeFrame(lobedSurface(), directions(2)), InvalidInput);
  EXPECT_THROW((void)edgeScore(lobedSurface(), directions(2), {}), InvalidInput);
}

TEST(FramePlacement, OptionsOutOfRangeAreRefused)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto   refuses = [](auto change) {
    FramePlacementOptions options;
    change(options);
    EXPECT_THROW((void)placeFrame(lobedSurface(), directions(3), options), InvalidInput);
  };
  refuses([](FramePlacementOptions & o) { o.nodesPerSide = 2; });
  refuses([](FramePlacementOptions & o) { o.nodesPerSide = 9; });
  refuses([](FramePlacementOptions & o) { o.maximumAngle = -1.0; });
  refuses([](FramePlacementOptions & o) { o.maximumAngle = 181.0; });
  refuses([](FramePlacementOptions & o) { o.maximumBoost = 0.5; });
  refuses([&](FramePlacementOptions & o) { o.maximumBoost = nan; });
  refuses([](FramePlacementOptions & o) { o.sharpness = 0.0; });
  refuses([&](FramePlacementOptions & o) { o.anchor = nan; });
  refuses([](FramePlacementOptions & o) { o.firstStep = 0.0; });
  refuses([](FramePlacementOptions & o) { o.smallestStep = 0.6; });
  refuses([](FramePlacementOptions & o) { o.maximumRounds = 0; });
}

TEST(FramePlacement, CallbackStopsTheSearch)
{
  EXPECT_THROW((void)placeFrame(lobedSurface(), directions(3), {}, [](double) { return false; }), Cancelled);
}
