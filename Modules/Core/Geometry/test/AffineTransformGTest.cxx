// Closed forms, to round-off.
#include "moserhex/Geometry/AffineTransform.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <cmath>

using namespace moserhex;

TEST(AffineTransform, MapsPoints)
{
  AffineTransform transform;
  transform.matrix << 1.0, 0.5, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 1.0;
  transform.translation = Vector3(1.0, -1.0, 3.0);
  EXPECT_EQ(transform(Vector3(2.0, 4.0, 1.0)), Vector3(5.0, 7.0, 4.0));
}

TEST(AffineTransform, ItsTurnIsThatOfThePolarDecomposition)
{
  const double    degree = pi / 180.0;
  const Matrix3   turn = Eigen::AngleAxis<double>(25.0 * degree, Vector3(1, -2, 2).normalized()).toRotationMatrix();
  AffineTransform transform;
  transform.matrix = turn * Vector3(0.5, 1.0, 1.7).asDiagonal();
  EXPECT_LT((transform.rotation() - turn).norm(), 1e-14);
  EXPECT_NEAR(transform.angle(), 25.0, 1e-12);
  EXPECT_EQ(AffineTransform{}.angle(), 0.0);
}
