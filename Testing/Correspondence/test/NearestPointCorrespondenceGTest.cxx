// Closed forms. Iterated closest points end within their tolerance of a motion that the shape determines: 0.02 mm; a
// sphere's nearest points are radial: within the height of a triangle, 0.5 % of the radius.
#include "moserhex/Correspondence/NearestPointCorrespondence.h"

#include "moserhex/Analytic/SurfaceShapes.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Geometry/RigidAlignment.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace moserhex;
using namespace moserhex::analytic;

namespace
{

const Positions aPyramid{ Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1) };

Positions
shifted(const Positions & points, double by)
{
  Positions result = points;
  for (Vector3 & p : result)
  {
    p.x() += by;
  }
  return result;
}

} // namespace

TEST(Medoid, IsTheSubjectInTheMiddle)
{
  const std::vector<Positions> subjects{
    shifted(aPyramid, 0.0), shifted(aPyramid, 5.0), shifted(aPyramid, 1.0), shifted(aPyramid, 1.5)
  };
  EXPECT_EQ(medoidOf(subjects), 2u); // sums 7.5, 12.5, 5.5, 5.5: the first among equals
  EXPECT_EQ(medoidOf({ aPyramid }), 0u);
}

TEST(Medoid, RefusesNoSubjectAndOtherNumbersOfPoints)
{
  EXPECT_THROW((void)medoidOf({}), InvalidInput);
  EXPECT_THROW((void)medoidOf({ aPyramid, { Vector3::Zero() } }), InvalidInput);
}

TEST(NearestPointCorrespondence, AMovedSurfaceHasTheMovedPoints)
{
  const TriangleMesh  surface = ellipsoidSurface(4, Vector3(26.0, 18.0, 12.0));
  SimilarityTransform motion;
  motion.rotation = rotation(Vector3(1, 2, 1), 0.2);
  motion.translation = Vector3(3.0, -2.0, 1.0);
  const Positions    expected = transformed(surface.vertices, motion);
  const TriangleMesh moved{ expected, surface.triangles };

  const NearestPointResult result = nearestPointCorrespondence(surface.vertices, moved);
  ASSERT_TRUE(result.report.converged);
  double largest = 0.0;
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    largest = std::max(largest, (result.points[i] - expected[i]).norm());
  }
  EXPECT_LT(largest, 0.02);
}

TEST(NearestPointCorrespondence, ASphereGoesRadiallyToAnother)
{
  const Positions          points = icosphere(2, 8.0).vertices;
  const NearestPointResult result = nearestPointCorrespondence(points, icosphere(4, 10.0));
  ASSERT_TRUE(result.report.converged);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    EXPECT_LT((result.points[i] - 1.25 * points[i]).norm(), 0.05);
  }
}

TEST(NearestPointCorrespondence, SaysWhenItsAlignmentStoppedEarly)
{
  const TriangleMesh surface = ellipsoidSurface(3, Vector3(26.0, 18.0, 12.0));
  const Matrix3      turn = rotation(Vector3(0, 0, 1), 0.3);
  Positions          turned = surface.vertices;
  for (Vector3 & p : turned)
  {
    p = turn * p;
  }
  NearestPointOptions options;
  options.maximumSteps = 1;
  const NearestPointResult result = nearestPointCorrespondence(turned, surface, options);
  EXPECT_FALSE(result.report.converged);
  EXPECT_EQ(result.report.steps, 1);
  EXPECT_GT(result.report.residual, options.tolerance);
}

TEST(NearestPointCorrespondence, RefusesASurfaceWithoutTriangles)
{
  EXPECT_THROW((void)nearestPointCorrespondence(aPyramid, {}), InvalidInput);
}
