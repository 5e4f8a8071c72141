// Known transforms to round-off: 1e-12 of the coordinates, which are of some 20 mm.
#include "moserhex/ShapeStatistics/PointAlignment.h"

#include "TestShapes.h"
#include "moserhex/Analytic/Refusals.h"

#include <gtest/gtest.h>

using namespace moserhex;
using namespace moserhex::testing;

namespace
{

const SimilarityTransform known{ 1.3, turnOf(2.5, { 1.0, -2.0, 0.5 }), { 10.0, -40.0, 300.0 } };

double
largestDifference(const Positions & a, const Positions & b)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    largest = std::max(largest, (a[i] - b[i]).norm());
  }
  return largest;
}

} // namespace

TEST(PointAlignment, AKnownSimilarityIsFound)
{
  const Positions           points = softCube(4).nodes;
  const SimilarityTransform found = alignPoints(points, transformed(known, points), AlignmentKind::Similarity);
  EXPECT_NEAR(found.scale, known.scale, 1e-13);
  EXPECT_LT((found.rotation - known.rotation).norm(), 1e-13);
  EXPECT_LT((found.translation - known.translation).norm(), 1e-11);
}

TEST(PointAlignment, ARigidOneLeavesTheSize)
{
  const Positions           points = softCube(4).nodes;
  const SimilarityTransform found = alignPoints(points, transformed(known, points), AlignmentKind::Rigid);
  EXPECT_EQ(found.scale, 1.0);
  EXPECT_LT((found.rotation - known.rotation).norm(), 1e-13);
  EXPECT_NEAR(centroidSize(transformed(found, points)), centroidSize(points), 1e-10);
}

TEST(PointAlignment, NoneIsTheIdentity)
{
  const Positions points = softCube(3).nodes;
  EXPECT_EQ(largestDifference(transformed(alignPoints(points, transformed(known, points), AlignmentKind::None), points),
                              points),
            0.0);
}

TEST(PointAlignment, AMirroredShapeIsTurnedNotReflected)
{
  const Positions points{ { 0, 0, 0 }, { 3, 0, 0 }, { 0, 2, 0 }, { 0, 0, 1 }, { 1, 1, 1 } };
  Positions       mirrored = points;
  for (Vector3 & p : mirrored)
  {
    p[2] = -p[2];
  }
  const Matrix3 R = alignPoints(points, mirrored, AlignmentKind::Rigid).rotation;
  EXPECT_NEAR(R.determinant(), 1.0, 1e-13);
  EXPECT_LT((R * R.transpose() - Matrix3::Identity()).norm(), 1e-13);
}

TEST(PointAlignment, PointsInAPlaneAreEnough)
{
  const Positions           points{ { 0, 0, 0 }, { 3, 0, 0 }, { 0, 2, 0 }, { 1, 5, 0 } };
  const SimilarityTransform found = alignPoints(points, transformed(known, points), AlignmentKind::Similarity);
  EXPECT_LT((found.rotation - known.rotation).norm(), 1e-13);
}

TEST(PointAlignment, NoSmallChangeOfTheTransformIsBetter)
{
  Random    random(1);
  Positions moving = softCube(3).nodes;
  Positions fixed = transformed(known, moving);
  for (Vector3 & p : fixed)
  {
    p += Vector3(normalNumber(random), normalNumber(random), normalNumber(random));
  }
  const auto squares = [&](const SimilarityTransform & transform) {
    double sum = 0.0;
    for (std::size_t a = 0; a < moving.size(); ++a)
    {
      sum += (transform(moving[a]) - fixed[a]).squaredNorm();
    }
    return sum;
  };
  const SimilarityTransform best = alignPoints(moving, fixed, AlignmentKind::Similarity);
  for (int trial = 0; trial < 50; ++trial)
  {
    SimilarityTransform other = best;
    other.rotation =
      turnOf(1e-3, Vector3(normalNumber(random), normalNumber(random), normalNumber(random))) * best.rotation;
    other.scale *= 1.0 + 1e-3 * normalNumber(random);
    other.translation += 1e-2 * Vector3(normalNumber(random), normalNumber(random), normalNumber(random));
    EXPECT_GT(squares(other), squares(best));
  }
}

TEST(PointAlignment, DegenerateAndOtherPointsAreRefused)
{
  const Positions line{ { 0, 0, 0 }, { 1, 1, 1 }, { 2, 2, 2 }, { 5, 5, 5 } };
  const auto      refusal = [](const Positions & moving, const Positions & fixed) {
    return analytic::messageOf([&] { (void)alignPoints(moving, fixed, AlignmentKind::Rigid); });
  };
  EXPECT_EQ(refusal(line, line),
            "alignment: the points lie on a line or are symmetric, so that no rotation is the best one");
  EXPECT_EQ(refusal(Positions(4, Vector3::Ones()), line),
            "alignment: the points lie on a line or are symmetric, so that no rotation is the best one");
  EXPECT_EQ(refusal(Positions(3, Vector3::Ones()), line),
            "alignment: 3 and 4 points, need as many of both and at least 3");
  Positions bad = line;
  bad[2][1] = std::nan("");
  EXPECT_EQ(refusal(line, bad), "alignment: point 2 is not finite");
  EXPECT_EQ(analytic::messageOf([] { (void)centroidOf({}); }), "centroid: no point");
}
