// Closed forms, 1e-9. Iterated closest points end near a motion that the shape determines: 0.05 mm for steps of 0.001
// mm.
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

/** Four points on each face of the cube about the origin with this half side, so placed that nothing moves them as a
 * whole. */
Positions
onACube(double halfSide)
{
  Positions points;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double side : { -1.0, 1.0 })
    {
      for (const double u : { -1.0, 1.0 })
      {
        for (const double v : { -2.0, 2.0 })
        {
          Vector3 p;
          p[axis] = side * halfSide;
          p[(axis + 1) % 3] = u;
          p[(axis + 2) % 3] = v;
          points.push_back(p);
        }
      }
    }
  }
  return points;
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
  EXPECT_LT(largest, 0.05);
}

TEST(NearestPointCorrespondence, PointsOfACubeGoStraightToALargerOne)
{
  const NearestPointResult result = nearestPointCorrespondence(onACube(4.0), cubeSurface(1, 10.0));
  ASSERT_TRUE(result.report.converged);
  const Positions expected = onACube(5.0);
  ASSERT_EQ(result.points.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    EXPECT_LT((result.points[i] - expected[i]).norm(), 1e-9);
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
