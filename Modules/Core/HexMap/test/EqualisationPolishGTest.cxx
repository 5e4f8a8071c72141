// Volumes equal to 1e-9, the bound of the whole stage. What is left alone, and threads: bit for bit.
#include "Equaliser.h"

#include "SurfacePoints.h"
#include "TestEqualisation.h"
#include "moserhex/Quality/HexQuality.h"
#include "moserhex/Quality/JacobianBounds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

using namespace moserhex;
using namespace moserhex::testing;

namespace
{
const VolumeMeasure  measure;
const SignedDistance inBanana = banana.distance();

EqualisationOptions
unpolished(double surfaceTolerance = 0.5)
{
  EqualisationOptions options;
  options.nodesPerSide = 10;
  options.polishRounds = 0;
  options.surfaceTolerance = surfaceTolerance;
  options.threads = 1;
  return options;
}

/** Exact, but one node in the middle has been pushed towards a corner of its cell. */
HexMesh
withANarrowCorner()
{
  HexMesh    mesh = equaliseVolumes(banana.lattice(3), inBanana, banana.volume(), unpolished()).mesh;
  const auto at = mesh.nodeNumber(4, 4, 4);
  mesh.nodes[at] += 0.6 * (mesh.nodes[mesh.nodeNumber(5, 5, 5)] - mesh.nodes[at]);
  return projectOntoEqualMeasure(mesh, measure, banana.volume() / 729.0, inBanana).mesh;
}

EqualisationResult
polished(const HexMesh & mesh, const EqualisationOptions & options)
{
  const EqualisationProblem problem{ inBanana, banana.volume(),
                                     measure,  banana.volume(),
                                     options,  surfacePoints(mesh.nodes, inBanana, banana.volume(), 2000, 1) };
  Equaliser                 equaliser(mesh, problem);
  equaliser.polish({});
  return equaliser.result();
}

EqualisationOptions
withRounds(int rounds, EqualisationOptions options = unpolished())
{
  options.polishRounds = rounds;
  return options;
}

double
smallestScaledJacobianOf(const HexMesh & mesh)
{
  return summarizeQuality(mesh).scaledJacobian.minimum;
}
} // namespace

TEST(EqualisationPolish, LiftsTheNarrowestCornerOfAnExactMesh)
{
  const HexMesh narrow = withANarrowCorner();
  const double  before = smallestScaledJacobianOf(narrow);
  ASSERT_TRUE(polished(narrow, unpolished()).exact);
  ASSERT_LT(before, 0.1);
  const EqualisationResult result = polished(narrow, withRounds(4));
  EXPECT_GT(smallestScaledJacobianOf(result.mesh), 0.18);
  EXPECT_TRUE(result.exact);
  EXPECT_LE(result.variance, 1e-18);
  EXPECT_EQ(certifyCells(result.mesh).positive, result.mesh.cellCount());
  ASSERT_GE(result.steps.size(), 2u);
  EXPECT_EQ(result.steps[0].name, "polish");
  EXPECT_EQ(result.steps[1].name, "project");
  EXPECT_LE(result.steps[0].iterations, 10);
}

namespace
{
EqualisationResult
equalisedWithRounds(int rounds, const BentEllipsoid & organ)
{
  return equaliseVolumes(organ.lattice(3), organ.distance(), organ.volume(), withRounds(rounds, unpolished(1.0)));
}

/** Their first letters: minimise, project, polish, repair. */
std::string
initialsOfSteps(const EqualisationResult & result)
{
  std::string initials;
  for (const EqualisationStep & step : result.steps)
  {
    initials += step.name == "polish" ? 'P' : step.name.front();
  }
  return initials;
}
} // namespace

TEST(EqualisationPolish, NarrowMeshIsLiftedBeforeItIsProjected)
{
  const BentEllipsoid      organ{ Vector3(40.0, 12.0, 14.0) };
  const EqualisationResult plain = equalisedWithRounds(0, organ);
  const EqualisationResult lifted = equalisedWithRounds(1, organ);
  EXPECT_EQ(initialsOfSteps(plain), "mmmmp");
  EXPECT_EQ(initialsOfSteps(lifted), "mmmmPp");
  EXPECT_TRUE(plain.exact && lifted.exact);
  EXPECT_GT(lifted.smallestScaledJacobian, 1.1 * plain.smallestScaledJacobian);
}

TEST(EqualisationPolish, MeshThatIsNotFlawlessWhenLiftedIsProjectedAsItWas)
{
  const BentEllipsoid organ{ Vector3(50.0, 12.0, 14.0), 0.015 };
  const std::string   steps = initialsOfSteps(equalisedWithRounds(1, organ));
  EXPECT_NE(steps.find("mPpp"), std::string::npos) << steps;
}

TEST(EqualisationPolish, MeshWithoutNarrowCornersIsLeftAlone)
{
  const HexMesh good = polished(withANarrowCorner(), withRounds(4)).mesh;
  ASSERT_GT(smallestScaledJacobianOf(good), 0.18);
  const EqualisationResult result = polished(good, withRounds(4));
  EXPECT_EQ(result.mesh.nodes, good.nodes);
  EXPECT_TRUE(result.steps.empty());
}

TEST(EqualisationPolish, NoRoundsLeaveTheMeshAlone)
{
  const HexMesh narrow = withANarrowCorner();
  EXPECT_EQ(polished(narrow, withRounds(0)).mesh.nodes, narrow.nodes);
}

TEST(EqualisationPolish, MeshThatIsNotExactIsLeftAlone)
{
  HexMesh unequal = withANarrowCorner();
  unequal.nodes[unequal.nodeNumber(2, 2, 2)] *= 1.0 + 1e-6;
  const EqualisationResult result = polished(unequal, withRounds(4));
  EXPECT_EQ(result.mesh.nodes, unequal.nodes);
  EXPECT_TRUE(result.steps.empty());

  const HexMesh narrow = withANarrowCorner();
  const double  tolerance = 0.99 * polished(narrow, unpolished()).largestDistance;
  EXPECT_TRUE(polished(narrow, withRounds(4, unpolished(tolerance))).steps.empty());
}

TEST(EqualisationPolish, NeverReturnsAWorseMesh)
{
  // With ever less room at the boundary: from some tolerance on nothing is gained, and the mesh comes back as it was.
  const HexMesh            narrow = withANarrowCorner();
  const double             before = smallestScaledJacobianOf(narrow);
  const EqualisationResult start = polished(narrow, unpolished());
  for (const double room : { 1.01, 1.1, 1.5 })
  {
    const EqualisationOptions options = unpolished(room * start.largestDistance);
    const EqualisationResult  result = polished(narrow, withRounds(2, options));
    EXPECT_TRUE(result.exact) << room;
    EXPECT_FALSE(result.steps.empty()) << room;
    EXPECT_TRUE(result.mesh.nodes == narrow.nodes || smallestScaledJacobianOf(result.mesh) > before) << room;
    EXPECT_LE(result.largestDistance, std::max(start.largestDistance, 0.95 * options.surfaceTolerance) + 1e-12) << room;
  }
}

TEST(EqualisationPolish, RoundThatLeadsTooFarIsTakenInPart)
{
  const HexMesh            narrow = withANarrowCorner();
  const EqualisationResult start = polished(narrow, unpolished());
  const EqualisationResult result = polished(narrow, withRounds(1, unpolished(1.01 * start.largestDistance)));
  ASSERT_GT(result.steps.size(), 2u); // else nothing is tested
  EXPECT_GT(result.smallestScaledJacobian, start.smallestScaledJacobian);
  EXPECT_TRUE(result.exact);
}

TEST(EqualisationPolish, MeshThatCannotBeLiftedComesBackAsItWas)
{
  EqualisationOptions options = withRounds(2);
  options.projection.maximumSteps = 0; // the cells do not become equal again
  const HexMesh            narrow = withANarrowCorner();
  const EqualisationResult result = polished(narrow, options);
  EXPECT_EQ(result.steps.size(), 5u); // one round, and four projections of ever smaller parts of it
  EXPECT_EQ(result.mesh.nodes, narrow.nodes);
}

TEST(EqualisationPolish, IsTheSameForAnyNumberOfThreads)
{
  const HexMesh            narrow = withANarrowCorner();
  EqualisationOptions      options = withRounds(4);
  const EqualisationResult one = polished(narrow, options);
  for (const unsigned int threads : { 2u, 3u })
  {
    options.threads = threads;
    EXPECT_EQ(polished(narrow, options).mesh.nodes, one.mesh.nodes) << threads;
  }
}
