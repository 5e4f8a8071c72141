// Closed forms: round-off. Smoothed values lie between those they are made of.
#include "moserhex/Analytic/Refusals.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/LevelSet/AgreementDensity.h"
#include "moserhex/LevelSet/LabelDensity.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <functional>

using namespace moserhex;
using moserhex::analytic::messageOf;

namespace
{

using IsInside = std::function<bool(const Vector3 & p)>;

LabelVolume
labelOn(VoxelGrid grid, const IsInside & isInside)
{
  LabelVolume label;
  static_cast<VoxelGrid &>(label) = std::move(grid);
  for (int k = 0; k < label.size[2]; ++k)
  {
    for (int j = 0; j < label.size[1]; ++j)
    {
      for (int i = 0; i < label.size[0]; ++i)
      {
        label.inside.push_back(isInside(label.point(i, j, k)) ? 1 : 0);
      }
    }
  }
  return label;
}

VoxelGrid
obliqueGrid(const std::array<int, 3> & size, const Vector3 & spacing)
{
  VoxelGrid grid;
  grid.size = size;
  grid.spacing = spacing;
  grid.direction = Eigen::AngleAxisd(0.3, Vector3(1, 2, 3).normalized()).toRotationMatrix();
  const Vector3 middle(0.5 * (size[0] - 1), 0.5 * (size[1] - 1), 0.5 * (size[2] - 1));
  grid.origin = Vector3(5, -7, 3) - grid.direction * spacing.cwiseProduct(middle);
  return grid;
}

bool
inBall(const Vector3 & p)
{
  return (p - Vector3(5, -7, 3)).norm() < 8.0;
}

/** The ball, and a slab of 4 mm on its Left side. */
bool
inBallAndSlab(const Vector3 & p)
{
  return inBall(p) || inBall(p - Vector3(4, 0, 0));
}

const VoxelGrid grid = obliqueGrid({ { 30, 30, 12 } }, Vector3(1.0, 1.0, 3.0));

/** Calls body(value, p) for every voxel. */
void
forEachValue(const ScalarVolume & image, const std::function<void(double, const Vector3 &)> & body)
{
  std::size_t voxel = 0;
  for (int k = 0; k < image.size[2]; ++k)
  {
    for (int j = 0; j < image.size[1]; ++j)
    {
      for (int i = 0; i < image.size[0]; ++i)
      {
        body(image.values.at(voxel++), image.point(i, j, k));
      }
    }
  }
}

} // namespace

TEST(AgreementDensity, IsOneWhereAllAgreeAndLessWhereOnlySomeHoldTheVoxel)
{
  const AgreementDensity agreement =
    agreementDensity({ labelOn(grid, inBall), labelOn(grid, inBallAndSlab) }, { 0.25, 0.0 });
  std::size_t disputed = 0;
  forEachValue(agreement.density, [&](double value, const Vector3 & p) {
    const bool isDisputed = inBallAndSlab(p) && !inBall(p);
    EXPECT_EQ(value, isDisputed ? 0.25 : 1.0) << p.transpose();
    disputed += isDisputed ? 1 : 0;
  });
  EXPECT_GT(disputed, 100u);
  EXPECT_NEAR(agreement.disputedVolume, 3.0 * static_cast<double>(disputed), 1e-9);
  EXPECT_NEAR(agreement.agreedVolume, 3.0 * static_cast<double>(voxelCount(labelOn(grid, inBall))), 1e-9);
}

TEST(AgreementDensity, SmoothingBlursTheBorderBetweenThemAndNothingElse)
{
  const ScalarVolume density =
    agreementDensity({ labelOn(grid, inBall), labelOn(grid, inBallAndSlab) }, { 0.1, 1.5 }).density;
  forEachValue(density, [&](double value, const Vector3 & p) {
    EXPECT_GE(value, 0.1 - 1e-12);
    EXPECT_LE(value, 1.0 + 1e-12);
    if (inBall(p) && p.x() < 0.0) // more than three standard deviations from the slab
    {
      EXPECT_NEAR(value, 1.0, 1e-12) << p.transpose();
    }
  });
}

TEST(AgreementDensity, LabelsMayLieOnOtherGridsAndBeyondTheFirstOne)
{
  VoxelGrid narrow = grid;
  narrow.size = { { 20, 20, 8 } };
  narrow.origin = grid.point(5, 5, 2); // ends where the ball does
  const LabelVolume  first = labelOn(narrow, inBall);
  const LabelVolume  fine = labelOn(obliqueGrid({ { 70, 50, 50 } }, Vector3::Constant(0.6)), inBallAndSlab);
  const ScalarVolume density = agreementDensity({ first, fine }, { 0.2, 0.0 }).density;
  EXPECT_EQ(density.spacing, narrow.spacing);
  EXPECT_LT(narrow.continuousIndex(density.origin).maxCoeff(), 0.0);
  EXPECT_NO_THROW((void)densityOnLabel(density, first));
  EXPECT_NO_THROW((void)densityOnLabel(density, fine));
  forEachValue(density, [&](double value, const Vector3 & p) {
    const double fromBorder =
      std::min(std::abs((p - Vector3(5, -7, 3)).norm() - 8.0), std::abs((p - Vector3(9, -7, 3)).norm() - 8.0));
    if (fromBorder > 0.6)
    {
      EXPECT_EQ(value, inBallAndSlab(p) && !inBall(p) ? 0.2 : 1.0) << p.transpose();
    }
  });
}

TEST(AgreementDensity, AgreesWithItself)
{
  const LabelVolume  label = labelOn(grid, inBall);
  const ScalarVolume density = agreementDensity({ label, label, label }).density;
  forEachValue(density, [](double value, const Vector3 &) { EXPECT_NEAR(value, 1.0, 1e-12); });
}

TEST(AgreementDensity, WhatCannotAgreeIsRefused)
{
  const LabelVolume label = labelOn(grid, inBall);
  const LabelVolume far = labelOn(grid, [](const Vector3 & p) { return inBall(p + Vector3(0, 20, 0)); });
  const auto        refusalOf = [&](const std::vector<LabelVolume> & labels, const AgreementOptions & options) {
    return messageOf([&] { (void)agreementDensity(labels, options); });
  };
  EXPECT_EQ(refusalOf({ label }, {}), "agreement: at least two labels are needed");
  EXPECT_EQ(refusalOf({ label, far }, {}), "agreement: the labels have no voxel in common");
  LabelVolume elsewhere = label;
  elsewhere.origin += Vector3(1e12, 0, 0); // an image around both would not fit anywhere
  EXPECT_EQ(refusalOf({ label, elsewhere }, {}), "agreement: the labels have no voxel in common");
  EXPECT_EQ(refusalOf({ label, label }, { 0.0, 1.0 }), "agreement: the density of disputed voxels must be in (0, 1]");
  EXPECT_EQ(refusalOf({ label, label }, { 0.1, -1.0 }), "agreement: the smoothing must be finite, not negative");
}
