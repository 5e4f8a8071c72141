#include "moserhex/CubeTransfer/CubeAxes.h"

#include "moserhex/Analytic/SolidShapes.h"

#include <gtest/gtest.h>

// Closed forms to round-off: 1e-12.

using namespace moserhex;

TEST(CubeAxes, RotationOfARotatedStretchIsTheRotation)
{
  const Matrix3 rotation = analytic::obliqueDirection();
  Matrix3       stretch;
  stretch << 30.0, 4.0, 1.0, 4.0, 20.0, -3.0, 1.0, -3.0, 50.0;
  EXPECT_TRUE(rotationPart(rotation * stretch).isApprox(rotation, 1e-12));
  EXPECT_TRUE(rotationPart(stretch).isApprox(Matrix3::Identity(), 1e-12));
}

TEST(CubeAxes, VectorsTurnAndComeBack)
{
  const Matrix3 rotation = analytic::obliqueDirection();
  const Vector3 before(1.0, -2.0, 3.0);
  Vector3       vector = before;
  turn(rotation, 3, vector.data());
  EXPECT_TRUE(vector.isApprox(rotation * before, 1e-12));
  turn(rotation.transpose(), 3, vector.data());
  EXPECT_TRUE(vector.isApprox(before, 1e-12));
}

TEST(CubeAxes, ADyadTurnsAsItsVectorDoes)
{
  const Matrix3 rotation = analytic::obliqueDirection();
  const Vector3 v(1.0, -2.0, 3.0);
  const Vector3 w = rotation * v;
  double        tensor[6] = { v[0] * v[0], v[0] * v[1], v[0] * v[2], v[1] * v[1], v[1] * v[2], v[2] * v[2] };
  turn(rotation, 6, tensor);
  const double expected[6] = { w[0] * w[0], w[0] * w[1], w[0] * w[2], w[1] * w[1], w[1] * w[2], w[2] * w[2] };
  for (int n = 0; n < 6; ++n)
  {
    EXPECT_NEAR(tensor[n], expected[n], 1e-12);
  }
}
