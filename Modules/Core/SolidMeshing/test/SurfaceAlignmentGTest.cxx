// Exact: motions that are undone; then what is refused.
#include "moserhex/SolidMeshing/SurfaceAlignment.h"

#include "moserhex/Common/Errors.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>

using namespace moserhex;

namespace
{

const Vector3 halfAxes(12.0, 8.0, 5.0);

/** Of an ellipsoid, near its surface a distance. */
LevelSet
ellipsoid()
{
  LevelSet phi;
  phi.grid.size = { { 41, 33, 27 } };
  phi.grid.spacing = 1.0;
  phi.grid.origin = Vector3(-20, -16, -13);
  for (std::size_t node = 0; node < phi.grid.nodeCount(); ++node)
  {
    const Vector3 p = phi.grid.point(node);
    const double  level = p.cwiseQuotient(halfAxes).norm();
    const Vector3 slope = p.cwiseQuotient(halfAxes.cwiseProduct(halfAxes)) / std::max(level, 0.1);
    phi.values.push_back((level - 1.0) / std::max(slope.norm(), 0.05));
  }
  return phi;
}

Positions
pointsOfEllipsoid()
{
  Positions points;
  for (int k = 0; k < 500; ++k)
  {
    const double z = -1.0 + (2.0 * k + 1.0) / 500.0;
    const double angle = 2.399963 * k;
    const double r = std::sqrt(1.0 - z * z);
    points.push_back(Vector3(r * std::cos(angle), r * std::sin(angle), z).cwiseProduct(halfAxes));
  }
  return points;
}

} // namespace

TEST(SurfaceAlignment, UndoesAMotion)
{
  const Matrix3 turn = Eigen::AngleAxis<double>(0.3, Vector3(1, 2, -1).normalized()).toRotationMatrix();
  const Vector3 shift(3.0, -2.0, 1.5);
  Positions     points = pointsOfEllipsoid();
  for (Vector3 & point : points)
  {
    point = turn * point + shift;
  }
  const SurfaceAlignmentResult result = alignToSurface(points, ellipsoid());
  EXPECT_TRUE(result.report.converged);
  EXPECT_GT(result.rmsBefore, 1.5);
  EXPECT_LT(result.rmsAfter, 0.05);
  EXPECT_LT((result.motion.matrix * turn - Matrix3::Identity()).norm(), 0.01);
  EXPECT_LT((result.motion.matrix * shift + result.motion.translation).norm(), 0.05);
  EXPECT_NEAR(result.motion.angle(), 0.3 * 180.0 / pi, 0.5);
  EXPECT_NEAR(result.shift, shift.norm(), 0.1);
}

TEST(SurfaceAlignment, UndoesAStretch)
{
  const Vector3 stretch(1.2, 0.9, 1.0 / 1.08);
  Positions     points = pointsOfEllipsoid();
  for (Vector3 & point : points)
  {
    point = stretch.cwiseProduct(point) + Vector3(1.0, 2.0, -1.0);
  }
  SurfaceAlignmentOptions options;
  options.kind = SurfaceAlignmentKind::Affine;
  const SurfaceAlignmentResult result = alignToSurface(points, ellipsoid(), options);
  EXPECT_TRUE(result.report.converged);
  EXPECT_LT(result.rmsAfter, 0.05);
  EXPECT_LT((result.motion.matrix * stretch.asDiagonal() - Matrix3::Identity()).norm(), 0.02);
  EXPECT_NEAR(result.motion.matrix.determinant(), 1.0, 1e-9);
}

TEST(SurfaceAlignment, APartThatTheOtherSolidLacksHasLittleInfluence)
{
  Positions points = pointsOfEllipsoid();
  for (Vector3 & point : points)
  {
    point[0] += point[0] > 9.0 ? 4.0 : 0.0; // a tenth of them
  }
  for (const SurfaceAlignmentKind kind : { SurfaceAlignmentKind::Rigid, SurfaceAlignmentKind::Affine })
  {
    SurfaceAlignmentOptions options;
    options.kind = kind;
    const SurfaceAlignmentResult result = alignToSurface(points, ellipsoid(), options);
    EXPECT_LT((result.motion.matrix - Matrix3::Identity()).norm(), 0.01);
    EXPECT_LT(result.shift, 0.05);
  }
}

TEST(SurfaceAlignment, ComesFromFarBeyondTheGrid)
{
  Positions points = pointsOfEllipsoid();
  for (Vector3 & point : points)
  {
    point += Vector3(400.0, 100.0, -300.0);
  }
  const SurfaceAlignmentResult result = alignToSurface(points, ellipsoid());
  EXPECT_LT(result.rmsAfter, 0.05);
  EXPECT_NEAR(result.shift, Vector3(400.0, 100.0, -300.0).norm(), 0.1);
}

TEST(SurfaceAlignment, LeavesWhatFits)
{
  const SurfaceAlignmentResult result = alignToSurface(pointsOfEllipsoid(), ellipsoid());
  EXPECT_LT(result.motion.angle(), 0.1);
  EXPECT_LT(result.shift, 0.01);
}

TEST(SurfaceAlignment, RefusesWhatIsNoSurface)
{
  EXPECT_THROW((void)alignToSurface(Positions(2, Vector3::Zero()), ellipsoid()), InvalidInput);
  Positions points = pointsOfEllipsoid();
  points[7].x() = std::nan("");
  EXPECT_THROW((void)alignToSurface(points, ellipsoid()), InvalidInput);
  LevelSet empty = ellipsoid();
  for (double & value : empty.values)
  {
    value = 1.0;
  }
  EXPECT_THROW((void)alignToSurface(pointsOfEllipsoid(), empty), InvalidInput);
}
