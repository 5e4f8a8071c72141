// Closed forms to round-off (1e-12 relative); a density of bounded second derivative to the stated order.
#include "TestDensities.h"
#include "TestShapes.h"
#include "moserhex/Analytic/Refusals.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/LevelSet/LabelDensity.h"
#include "moserhex/LevelSet/VoxelTopology.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <sstream>

using namespace moserhex;
using namespace moserhex::test;

namespace
{

using Index3 = std::array<int, 3>;

Index3
indexOf(const VoxelGrid & grid, std::size_t voxel)
{
  const int number = static_cast<int>(voxel);
  return { { number % grid.size[0], number / grid.size[0] % grid.size[1], number / (grid.size[0] * grid.size[1]) } };
}

/** An ellipsoid, not centred, on the voxels of obliqueVoxels(). */
LabelVolume
obliqueLabel()
{
  LabelVolume label;
  static_cast<VoxelGrid &>(label) = obliqueVoxels();
  for (std::size_t voxel = 0; voxel < label.gridVoxels(); ++voxel)
  {
    const auto [i, j, k] = indexOf(label, voxel);
    label.inside.push_back((i - 3.4) * (i - 3.4) + 1.5 * (j - 3) * (j - 3) + 2.0 * (k - 2.6) * (k - 2.6) < 6.5 ? 1 : 0);
  }
  return label;
}

/** A grid of other spacings and axes that covers obliqueLabel() with room to spare. */
VoxelGrid
otherGrid(const Vector3 & spacing)
{
  const VoxelGrid label = obliqueVoxels();
  VoxelGrid       grid;
  grid.direction = Eigen::AngleAxisd(-0.9, Vector3(1, 0.4, 0.3).normalized()).toRotationMatrix();
  grid.spacing = spacing;
  for (int axis = 0; axis < 3; ++axis)
  {
    grid.size[static_cast<std::size_t>(axis)] = static_cast<int>(std::ceil(30.0 / spacing[axis]));
  }
  const Vector3 centre = label.point(3, 3, 2);
  grid.origin = centre - grid.direction * Vector3(15.0, 15.0, 15.0);
  return grid;
}

Vector3
centroidOf(const LabelVolume & label)
{
  Vector3     sum = Vector3::Zero();
  std::size_t voxel = 0;
  for (int k = 0; k < label.size[2]; ++k)
  {
    for (int j = 0; j < label.size[1]; ++j)
    {
      for (int i = 0; i < label.size[0]; ++i)
      {
        sum += label.inside[voxel++] != 0 ? label.point(i, j, k) : Vector3(0.0, 0.0, 0.0);
      }
    }
  }
  return sum / static_cast<double>(voxelCount(label));
}

double
linear(const Vector3 & p)
{
  return 100.0 + Vector3(1.0, -2.0, 0.5).dot(p);
}

double
one(const Vector3 &)
{
  return 1.0;
}

/** The image with its voxels outside the label set to a value. */
ScalarVolume
maskedBy(const LabelVolume & label, ScalarVolume image, double outside)
{
  for (std::size_t voxel = 0; voxel < image.values.size(); ++voxel)
  {
    image.values[voxel] = label.inside[voxel] != 0 ? image.values[voxel] : outside;
  }
  return image;
}

std::string
refusalOf(const ScalarVolume & image, const LabelVolume & label)
{
  return analytic::messageOf([&] { (void)densityOnLabel(image, label); });
}

} // namespace

TEST(MeanDensity, LinearDensityHasItsMeanAtTheCentroidOnEveryGrid)
{
  const LabelVolume label = obliqueLabel();
  for (const Vector3 & spacing : { Vector3(0.3, 0.5, 0.4), Vector3(1.0, 0.9, 1.2), Vector3(4.0, 3.0, 5.0) })
  {
    const VoxelGrid    grid = otherGrid(spacing);
    const DensityImage density(imageOf(grid, linear));
    EXPECT_NEAR(meanDensity(label, density, grid), linear(centroidOf(label)), 1e-10) << spacing.transpose();
  }
}

TEST(MeanDensity, MeanOfAllVoxelsOfTheDensitysOwnGridIsTheMeanOfItsVoxels)
{
  LabelVolume label = obliqueLabel();
  label.inside.assign(label.inside.size(), 1);
  Random             random(1);
  const ScalarVolume image = imageOf(label, [&](const Vector3 &) { return random.uniform(6.0, 9.0); });
  double             sum = 0.0;
  for (const double value : image.values)
  {
    sum += value;
  }
  EXPECT_NEAR(meanDensity(label, DensityImage(image), image), sum / static_cast<double>(image.values.size()), 1e-12);
}

TEST(MeanDensity, IsTheSameForAnyNumberOfThreads)
{
  const LabelVolume  label = obliqueLabel();
  Random             random(2);
  const ScalarVolume image =
    imageOf(otherGrid(Vector3(1, 1, 1)), [&](const Vector3 &) { return random.uniform(1, 9); });
  const DensityImage density(image);
  EXPECT_EQ(meanDensity(label, density, image, 1), meanDensity(label, density, image, 3));
}

TEST(MeanDensity, EmptyLabelIsRefused)
{
  LabelVolume label = obliqueLabel();
  label.inside.assign(label.inside.size(), 0);
  const ScalarVolume image = imageOf(label, one);
  EXPECT_THROW((void)meanDensity(label, DensityImage(image), image), InvalidInput);
}

TEST(LabelDensity, UniformDensityIsOneAndItsMassTheVolume)
{
  const LabelVolume  label = obliqueLabel();
  const LabelDensity result = densityOnLabel(imageOf(label, [](const Vector3 &) { return 0.3; }), label);
  const double       volume = static_cast<double>(voxelCount(label)) * label.voxelVolume();
  EXPECT_NEAR(result.meanDensity, 0.3, 1e-14);
  EXPECT_NEAR(result.mass, 0.3 * volume, 1e-12 * volume);
  EXPECT_NEAR(result.density.value(centroidOf(label)), 1.0, 1e-14);
  EXPECT_NEAR(result.smallest, 1.0, 1e-14);
  EXPECT_NEAR(result.largest, 1.0, 1e-14);
}

TEST(LabelDensity, MeanOverTheLabelBecomesOne)
{
  const LabelVolume  label = obliqueLabel();
  Random             random(3);
  const ScalarVolume image =
    imageOf(otherGrid(Vector3(0.2, 0.3, 0.25)), [&](const Vector3 &) { return random.uniform(1, 9); });
  const LabelDensity result = densityOnLabel(image, label);
  EXPECT_NEAR(meanDensity(label, result.density, image), 1.0, 1e-12);
  // far from the voxels beside the label, which have their values from it
  EXPECT_NEAR(result.density.value(centroidOf(label)) * result.meanDensity,
              DensityImage(image).value(centroidOf(label)),
              1e-12 * result.meanDensity);
  EXPECT_LT(result.smallest, 1.0);
  EXPECT_GT(result.largest, 1.0);
}

TEST(LabelDensity, ImageCutAtTheLabelsVoxelsCoversIt)
{
  const LabelVolume label = cropAndPad(obliqueLabel(), { { 0, 0, 0 } });
  EXPECT_EQ(refusalOf(imageOf(label, one), obliqueLabel()), "accepted");
}

TEST(LabelDensity, UncoveredSideIsNamedInThePatient)
{
  const LabelVolume label =
    labelOf({ { 9, 9, 9 } }, Vector3(1, 1, 1), [](const Vector3 & p) { return p.norm() - 3.2; });
  const char * sides[6] = { "Right", "Left", "Anterior", "Posterior", "Inferior", "Superior" };
  for (int side = 0; side < 6; ++side)
  {
    VoxelGrid grid = label;
    const int axis = side / 2;
    grid.size[static_cast<std::size_t>(axis)] -= 2; // the label has one empty voxel on each side
    grid.origin[axis] += side % 2 == 0 ? 2.0 : 0.0;
    const std::string text =
      std::string(side % 2 == 0 ? "start" : "end") + " of image axis " + std::to_string(axis + 1);
    EXPECT_EQ(refusalOf(imageOf(grid, one), label),
              "density image: does not cover the label, 1 mm are missing on its " + std::string(sides[side]) +
                " side (" + text + ")");
  }
}

TEST(LabelDensity, UncoveredSideOfAFlippedImageIsStillThePatients)
{
  const LabelVolume label =
    labelOf({ { 9, 9, 9 } }, Vector3(1, 1, 1), [](const Vector3 & p) { return p.norm() - 3.2; });
  VoxelGrid grid = label;
  grid.direction = Vector3(-1, 1, 1).asDiagonal();
  grid.origin[0] = 2.0; // its first voxel, and it runs to the Right
  EXPECT_NE(refusalOf(imageOf(grid, one), label).find("Left side (start of image axis 1)"), std::string::npos);
}

TEST(LabelDensity, ImageElsewhereIsRefused)
{
  ScalarVolume image = imageOf(obliqueVoxels(), one);
  image.origin += Vector3(500.0, 0.0, 0.0);
  EXPECT_NE(refusalOf(image, obliqueLabel()).find("does not cover the label"), std::string::npos);
}

TEST(LabelDensity, FirstVoxelInTheLabelThatIsNotPositiveAndFiniteIsNamed)
{
  const LabelVolume  label = obliqueLabel();
  const ScalarVolume good = imageOf(label, linear);
  ASSERT_EQ(label.inside[label.voxelNumber(3, 3, 2)] + label.inside[label.voxelNumber(4, 3, 3)], 2);
  for (const double value : { 0.0, -2.0, std::nan(""), std::numeric_limits<double>::infinity() })
  {
    ScalarVolume image = good;
    image.values[image.voxelNumber(4, 3, 3)] = -7.0;
    image.values[image.voxelNumber(3, 3, 2)] = value;
    std::ostringstream expected;
    expected << "density image: voxel (3, 3, 2) holds " << value << " in the label, need positive and finite";
    EXPECT_EQ(refusalOf(image, label), expected.str());
  }
}

TEST(LabelDensity, VoxelThatIsNotPositiveIsFoundOnEveryGrid)
{
  const LabelVolume label = obliqueLabel();
  for (const Vector3 & spacing : { Vector3(0.3, 0.5, 0.4), Vector3(1.0, 0.9, 1.2), Vector3(4.0, 3.0, 5.0) })
  {
    const VoxelGrid grid = otherGrid(spacing);
    ScalarVolume    image = imageOf(grid, one);
    const Vector3   index = grid.continuousIndex(label.point(3, 3, 2));
    const int       at[3] = { static_cast<int>(std::lround(index[0])),
                              static_cast<int>(std::lround(index[1])),
                              static_cast<int>(std::lround(index[2])) };
    image.values[image.voxelNumber(at[0], at[1], at[2])] = 0.0;
    const std::string voxel =
      "voxel (" + std::to_string(at[0]) + ", " + std::to_string(at[1]) + ", " + std::to_string(at[2]) + ") holds 0 in";
    EXPECT_NE(refusalOf(image, label).find(voxel), std::string::npos) << spacing.transpose();
  }
}

TEST(LabelDensity, DensityMaskedByItsLabelIsContinuedOutside)
{
  const LabelVolume  label = obliqueLabel();
  const auto         uniform = [](const Vector3 &) { return 5.0; };
  const ScalarVolume whole = imageOf(label, uniform);
  for (const double outside : { 0.0, -1024.0, std::nan("") })
  {
    const LabelDensity result = densityOnLabel(maskedBy(label, whole, outside), label);
    EXPECT_NEAR(result.meanDensity, 5.0, 1e-13);
    for (std::size_t voxel = 0; voxel < label.inside.size(); voxel += 7)
    {
      const Index3 at = indexOf(label, voxel);
      EXPECT_NEAR(result.density.value(label.point(at[0], at[1], at[2])), 1.0, 1e-13);
    }
  }
}

TEST(LabelDensity, WhatLiesBesideTheLabelNeverMatters)
{
  const LabelVolume  label = obliqueLabel();
  Random             random(5);
  const ScalarVolume uniform = imageOf(label, one);
  const ScalarVolume varied = imageOf(label, [&](const Vector3 &) { return random.uniform(1, 9); });
  for (const ScalarVolume & image : { uniform, varied })
  {
    const LabelDensity expected = densityOnLabel(maskedBy(label, image, 0.0), label);
    for (const double outside : { 1e-200, 1.0, 100.0, 1e200 })
    {
      const LabelDensity result = densityOnLabel(maskedBy(label, image, outside), label);
      EXPECT_EQ(result.meanDensity, expected.meanDensity) << outside;
      EXPECT_EQ(result.largest, expected.largest) << outside;
      for (std::size_t voxel = 0; voxel < label.inside.size(); ++voxel)
      {
        const Index3  at = indexOf(label, voxel);
        const Vector3 p = label.point(at[0], at[1], at[2]) + Vector3(0.2, -0.3, 0.1);
        EXPECT_EQ(result.density.value(p), expected.density.value(p)) << outside << " " << voxel;
      }
    }
  }
  EXPECT_NEAR(densityOnLabel(maskedBy(label, uniform, 100.0), label).meanDensity, 1.0, 1e-13);
}

TEST(LabelDensity, VoxelsBesideTheLabelHaveTheValueOfTheNearestInIt)
{
  // A slab: the nearest voxel is that of the same row.
  const LabelVolume label =
    labelOf({ { 9, 6, 6 } }, Vector3(1, 1, 1), [](const Vector3 & p) { return std::abs(p.x()) - 2.2; });
  const ScalarVolume image = imageOf(label, [](const Vector3 & p) { return 3.0 + p.y() / 10.0; });
  const LabelDensity result = densityOnLabel(maskedBy(label, image, 50.0), label);
  for (const int i : { 0, 1, 7, 8 })
  {
    const double edge = result.density.value(label.point(4, 2, 3));
    EXPECT_NEAR(result.density.value(label.point(i, 2, 3)), edge, 1e-12) << i;
  }
}

TEST(LabelDensity, AVoxelLostBesideTheMeanIsNamedWithTheUsersIndexAndValue)
{
  const LabelVolume label = obliqueLabel();
  ScalarVolume      image = imageOf(label, [](const Vector3 &) { return 1e200; });
  ASSERT_EQ(label.inside[label.voxelNumber(4, 3, 3)], 1);
  image.values[image.voxelNumber(4, 3, 3)] = 1e-200;
  const std::string refusal = refusalOf(image, label);
  EXPECT_NE(refusal.find("voxel (4, 3, 3) holds 1e-200, too little"), std::string::npos) << refusal;
}

TEST(LabelDensity, OnlyTheLargestComponentCounts)
{
  const LabelVolume label = labelOf({ { 20, 9, 9 } }, Vector3(1, 1, 1), [](const Vector3 & p) {
    return std::min((p - Vector3(-4, 0, 0)).norm() - 3.2, (p - Vector3(8.5, 0, 0)).norm() - 0.9);
  });
  ASSERT_GT(voxelTopology(label).components, 1u);
  ScalarVolume image = imageOf(label, linear);
  image.values[image.voxelNumber(18, 4, 4)] = 0.0; // in the small component
  ASSERT_EQ(label.inside[label.voxelNumber(18, 4, 4)], 1);
  LabelVolume largest = label;
  keepLargestComponentInPlace(largest);
  EXPECT_EQ(densityOnLabel(image, label).meanDensity, densityOnLabel(imageOf(label, linear), largest).meanDensity);
}

TEST(LabelDensity, IsTheSameForAnyNumberOfThreads)
{
  const LabelVolume  label = obliqueLabel();
  Random             random(4);
  const ScalarVolume image =
    imageOf(otherGrid(Vector3(1, 1, 1)), [&](const Vector3 &) { return random.uniform(1, 9); });
  const LabelDensity first = densityOnLabel(image, label, 1);
  const LabelDensity second = densityOnLabel(image, label, 3);
  EXPECT_EQ(first.meanDensity, second.meanDensity);
  EXPECT_EQ(first.density.value(centroidOf(label)), second.density.value(centroidOf(label)));
}

TEST(LabelDensity, InvalidImageIsRefused)
{
  ScalarVolume image = imageOf(obliqueVoxels(), one);
  image.values.pop_back();
  EXPECT_THROW((void)densityOnLabel(image, obliqueLabel()), InvalidInput);
}

TEST(LabelDensity, EmptyLabelIsRefused)
{
  LabelVolume label = obliqueLabel();
  label.inside.assign(label.inside.size(), 0);
  EXPECT_THROW((void)densityOnLabel(imageOf(label, one), label), InvalidInput);
}

TEST(LabelDensity, MeanThatOverflowsIsRefused)
{
  const LabelVolume label = obliqueLabel();
  EXPECT_NE(refusalOf(imageOf(label, [](const Vector3 &) { return 1e308; }), label).find("too large"),
            std::string::npos);
}
