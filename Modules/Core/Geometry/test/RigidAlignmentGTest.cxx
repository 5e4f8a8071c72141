#include "moserhex/Geometry/RigidAlignment.h"

#include "moserhex/Analytic/Lattices.h"
#include "moserhex/Analytic/Refusals.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <limits>

// Known motions come back to 1e-12 of the coordinates; minima by comparison with motions nearby.

using namespace moserhex;

namespace
{

/** Points in no special position. */
Positions
somePoints()
{
  return analytic::lattice(3,
                           [](const Vector3 & c) {
                             return Vector3(10.0 * c[0] + std::sin(5.0 * c[1]),
                                            7.0 * c[1] + 0.3 * c[0] * c[2],
                                            4.0 * c[2] + 2.0 * std::cos(3.0 * c[0]));
                           })
    .nodes;
}

SimilarityTransform
someMotion(double scale)
{
  SimilarityTransform motion;
  motion.scale = scale;
  motion.rotation = Eigen::AngleAxisd(2.5, Vector3(1.0, -2.0, 0.5).normalized()).toRotationMatrix();
  motion.translation = { 120.0, -35.0, 8.0 };
  return motion;
}

double
squaredDistance(const Positions & points, const SimilarityTransform & motion, const Positions & others)
{
  double sum = 0.0;
  for (std::size_t a = 0; a < points.size(); ++a)
  {
    sum += (motion(points[a]) - others[a]).squaredNorm();
  }
  return sum;
}

/** The points moved, and a disturbance that no motion explains. */
Positions
disturbed(const SimilarityTransform & motion)
{
  Positions points = transformed(somePoints(), motion);
  for (std::size_t a = 0; a < points.size(); ++a)
  {
    points[a] += Vector3(std::sin(7.0 * a), std::cos(3.0 * a), std::sin(2.0 * a + 1.0));
  }
  return points;
}

} // namespace

TEST(RigidAlignment, AKnownMotionComesBack)
{
  const SimilarityTransform motion = someMotion(1.0);
  const SimilarityTransform found = rigidAlignment(somePoints(), transformed(somePoints(), motion));
  EXPECT_EQ(found.scale, 1.0);
  EXPECT_LE((found.rotation - motion.rotation).norm(), 1e-12);
  EXPECT_LE((found.translation - motion.translation).norm(), 1e-10);
}

TEST(RigidAlignment, AKnownSimilarityComesBack)
{
  const SimilarityTransform motion = someMotion(0.8);
  const SimilarityTransform found = similarityAlignment(somePoints(), transformed(somePoints(), motion));
  EXPECT_NEAR(found.scale, 0.8, 1e-13);
  EXPECT_LE((found.rotation - motion.rotation).norm(), 1e-12);
  EXPECT_LE((found.translation - motion.translation).norm(), 1e-10);
}

TEST(RigidAlignment, AngleIsThatOfTheRotation)
{
  EXPECT_NEAR(someMotion(2.0).angle(), 2.5 * 180.0 / pi, 1e-12);
  EXPECT_EQ(SimilarityTransform{}.angle(), 0.0);
}

TEST(RigidAlignment, NoMotionNearbyIsBetter)
{
  const Positions fixed = disturbed(someMotion(1.2));
  for (const bool withScale : { false, true })
  {
    const SimilarityTransform best =
      withScale ? similarityAlignment(somePoints(), fixed) : rigidAlignment(somePoints(), fixed);
    const double smallest = squaredDistance(somePoints(), best, fixed);
    for (int axis = 0; axis < 3; ++axis)
    {
      for (const double step : { -1e-3, 1e-3 })
      {
        SimilarityTransform other = best;
        other.translation[axis] += step;
        EXPECT_GT(squaredDistance(somePoints(), other, fixed), smallest);
        other = best;
        other.rotation = Eigen::AngleAxisd(step, Vector3::Unit(axis)).toRotationMatrix() * best.rotation;
        EXPECT_GT(squaredDistance(somePoints(), other, fixed), smallest);
        other = best;
        other.scale += step;
        EXPECT_TRUE(!withScale || squaredDistance(somePoints(), other, fixed) > smallest);
      }
    }
  }
}

TEST(RigidAlignment, AMirrorImageIsTurnedAndNotReflected)
{
  Positions mirrored = somePoints();
  for (Vector3 & point : mirrored)
  {
    point[0] = -point[0];
  }
  const SimilarityTransform found = rigidAlignment(somePoints(), mirrored);
  EXPECT_NEAR(found.rotation.determinant(), 1.0, 1e-12);
}

TEST(RigidAlignment, PointsInAPlaneAreEnough)
{
  const Positions           plane{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 2, 0 } };
  const SimilarityTransform found = rigidAlignment(plane, transformed(plane, someMotion(1.0)));
  EXPECT_LE((found.rotation - someMotion(1.0).rotation).norm(), 1e-12);
}

TEST(RigidAlignment, RefusesWhatHasNoSingleAnswer)
{
  const auto refusal = [](const Positions & moving, const Positions & fixed) {
    return analytic::messageOf([&] { (void)rigidAlignment(moving, fixed); });
  };
  const Positions line{ { 0, 0, 0 }, { 1, 1, 1 }, { 3, 3, 3 } };
  EXPECT_NE(refusal(line, line).find("rotation of 3 points is not determined"), std::string::npos);
  EXPECT_NE(refusal({ { 1, 2, 3 } }, { { 1, 2, 3 } }).find("is not determined"), std::string::npos);
  EXPECT_NE(refusal({}, {}).find("0 points to 0"), std::string::npos);
  EXPECT_NE(refusal(line, { { 0, 0, 0 } }).find("3 points to 1"), std::string::npos);
  Positions broken = somePoints();
  broken[5][1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(refusal(broken, somePoints()).find("pair 5"), std::string::npos);
  // The octahedron's mirror image is as near turned by one rotation as by another.
  const Positions octahedron{ { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } };
  Positions       inverted = octahedron;
  for (Vector3 & point : inverted)
  {
    point = -point;
  }
  EXPECT_NE(refusal(octahedron, inverted).find("is not determined"), std::string::npos);
}

TEST(SimilarityTransform, ItsInverseTakesPointsBack)
{
  SimilarityTransform transform;
  transform.scale = 1.3;
  transform.rotation = Eigen::AngleAxis<double>(0.7, Vector3(1, 2, -1).normalized()).toRotationMatrix();
  transform.translation = Vector3(10, -20, 5);
  const Vector3 p(3, 4, 5);
  EXPECT_LT((transform.inverse()(transform(p)) - p).norm(), 1e-13);
}
