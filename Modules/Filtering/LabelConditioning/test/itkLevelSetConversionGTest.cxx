// Identities: conversions copy, so results are compared exactly (positions within round-off, 1e-12 mm).
#include "itkLabelVolumeConversion.h"
#include "itkLevelSetConversion.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

using namespace moserhex;
using LevelSetImage = itk::Image<double, 3>;
using LabelImage = itk::Image<unsigned char, 3>;

namespace
{

LevelSet
obliqueLevelSet()
{
  LevelSet levelSet;
  levelSet.grid.size = { { 4, 5, 6 } };
  levelSet.grid.spacing = 0.7;
  levelSet.grid.origin = Vector3(-10.0, 20.0, 3.0);
  levelSet.grid.direction =
    Eigen::AngleAxisd(0.6, Vector3(1.0, 2.0, -1.0).normalized()).toRotationMatrix() * Vector3(1, 1, -1).asDiagonal();
  for (std::size_t node = 0; node < levelSet.grid.nodeCount(); ++node)
  {
    levelSet.values.push_back(0.25 * static_cast<double>(node) - 7.0);
  }
  return levelSet;
}

LabelImage::Pointer
smallLabelImage()
{
  const auto           image = LabelImage::New();
  LabelImage::SizeType size{ { 4, 3, 2 } };
  image->SetRegions(size);
  image->Allocate();
  image->FillBuffer(0);
  image->SetPixel({ { 1, 1, 1 } }, 5);
  image->SetPixel({ { 2, 1, 1 } }, 9);
  return image;
}

} // namespace

TEST(LevelSetConversion, ThereAndBackIsTheSameLevelSet)
{
  const LevelSet expected = obliqueLevelSet();
  const LevelSet actual = itk::LevelSetFromImage(itk::ImageFromLevelSet<LevelSetImage>(expected).GetPointer());
  EXPECT_EQ(actual.grid.size, expected.grid.size);
  EXPECT_EQ(actual.grid.spacing, expected.grid.spacing);
  EXPECT_EQ(actual.grid.origin, expected.grid.origin);
  EXPECT_EQ(actual.grid.direction, expected.grid.direction);
  EXPECT_EQ(actual.values, expected.values);
}

TEST(LevelSetConversion, NodesAndPixelsHaveTheSamePlaceInSpace)
{
  const LevelSet           levelSet = obliqueLevelSet();
  const auto               image = itk::ImageFromLevelSet<LevelSetImage>(levelSet);
  LevelSetImage::PointType point;
  image->TransformIndexToPhysicalPoint({ { 3, 1, 4 } }, point);
  EXPECT_LT((Vector3(point[0], point[1], point[2]) - levelSet.grid.point(3, 1, 4)).norm(), 1e-12);
}

TEST(LevelSetConversion, AnisotropicImageIsRefused)
{
  const auto   image = itk::ImageFromLevelSet<LevelSetImage>(obliqueLevelSet());
  const double spacing[3] = { 0.7, 0.7, 0.8 };
  image->SetSpacing(spacing);
  EXPECT_THROW(itk::LevelSetFromImage(image.GetPointer()), InvalidInput);
}

TEST(LabelVolumeConversion, FirstIndexNeedNotBeZero)
{
  const auto             image = smallLabelImage();
  LabelImage::RegionType region({ { 10, -3, 2 } }, { { 4, 3, 2 } });
  image->SetRegions(region);
  LabelImage::PointType point;
  image->TransformIndexToPhysicalPoint({ { 11, -2, 3 } }, point);
  const LabelVolume volume = itk::LabelVolumeFromImage(image.GetPointer(), 5);
  EXPECT_LT((Vector3(point[0], point[1], point[2]) - volume.point(1, 1, 1)).norm(), 1e-12);
  EXPECT_EQ(volume.inside[volume.voxelNumber(1, 1, 1)], 1);
  EXPECT_EQ(voxelCount(volume), 1u);
}

TEST(LabelVolumeConversion, AbsentLabelIsRefusedWithTheLabelsPresent)
{
  try
  {
    (void)itk::LabelVolumeFromImage(smallLabelImage().GetPointer(), 3);
    FAIL() << "accepted";
  }
  catch (const InvalidInput & error)
  {
    EXPECT_STREQ(error.what(), "label 3 is not in the image; labels present: 5, 9");
  }
}

TEST(LabelVolumeConversion, RoundedDirectionIsMadeOrthonormal)
{
  const auto                image = smallLabelImage();
  LabelImage::DirectionType direction;
  direction.SetIdentity();
  direction[0][0] = direction[1][1] = 0.866;
  direction[0][1] = -0.5;
  direction[1][0] = 0.5;
  image->SetDirection(direction);
  const LabelVolume volume = itk::LabelVolumeFromImage(image.GetPointer(), 5);
  EXPECT_LT((volume.direction.transpose() * volume.direction - Matrix3::Identity()).norm(), 1e-12);
  EXPECT_NEAR(volume.direction(1, 0), 0.5, 1e-4);
}

TEST(LabelVolumeConversion, ShearedAxesAreRefused)
{
  const auto                image = smallLabelImage();
  LabelImage::DirectionType direction;
  direction.SetIdentity();
  direction[0][1] = 0.1;
  image->SetDirection(direction);
  EXPECT_THROW(itk::LabelVolumeFromImage(image.GetPointer(), 5), InvalidInput);
}
