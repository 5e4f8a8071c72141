// Identities: conversions copy, so values are compared exactly (positions within round-off, 1e-12 mm).
#include "itkDensityConversion.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <itkImage.h>

using namespace moserhex;

namespace
{

/** Oblique and anisotropic, its region beginning at (10, -3, 2), value 100 i + 10 j + k at the index from there. */
template <typename TPixel>
typename itk::Image<TPixel, 3>::Pointer
obliqueImage()
{
  using ImageType = itk::Image<TPixel, 3>;
  const auto                            image = ImageType::New();
  const typename ImageType::RegionType  region({ { 10, -3, 2 } }, { { 4, 3, 2 } });
  typename ImageType::DirectionType     direction;
  const Matrix3                         axes = Eigen::AngleAxisd(0.6, Vector3(1, 2, -1).normalized()).matrix();
  const typename ImageType::SpacingType spacing(std::array<double, 3>{ { 0.5, 0.7, 3.0 } }.data());
  for (unsigned int a = 0; a < 3; ++a)
  {
    for (unsigned int b = 0; b < 3; ++b)
    {
      direction[a][b] = axes(static_cast<int>(a), static_cast<int>(b));
    }
  }
  image->SetRegions(region);
  image->SetSpacing(spacing);
  image->SetDirection(direction);
  image->Allocate();
  for (int k = 0; k < 2; ++k)
  {
    for (int j = 0; j < 3; ++j)
    {
      for (int i = 0; i < 4; ++i)
      {
        image->SetPixel({ { 10 + i, -3 + j, 2 + k } }, static_cast<TPixel>(100 * i + 10 * j + k));
      }
    }
  }
  return image;
}

} // namespace

TEST(DensityConversion, VoxelsKeepTheirValueAndTheirPlaceInSpace)
{
  const auto         image = obliqueImage<double>();
  const ScalarVolume volume = itk::ScalarVolumeFromImage(image.GetPointer());
  EXPECT_EQ(volume.size, (std::array<int, 3>{ { 4, 3, 2 } }));
  EXPECT_EQ(volume.values[volume.voxelNumber(3, 2, 1)], 321.0);
  itk::Image<double, 3>::PointType point;
  image->TransformIndexToPhysicalPoint({ { 13, -1, 3 } }, point);
  EXPECT_LT((Vector3(point[0], point[1], point[2]) - volume.point(3, 2, 1)).norm(), 1e-12);
}

TEST(DensityConversion, IntegerVoxelsAreTaken)
{
  const ScalarVolume volume = itk::ScalarVolumeFromImage(obliqueImage<short>().GetPointer());
  EXPECT_EQ(volume.values[volume.voxelNumber(1, 2, 0)], 120.0);
}

TEST(DensityConversion, ShearedAxesAreRefused)
{
  const auto                          image = obliqueImage<float>();
  itk::Image<float, 3>::DirectionType direction;
  direction.SetIdentity();
  direction[0][1] = 0.1;
  image->SetDirection(direction);
  EXPECT_THROW((void)itk::ScalarVolumeFromImage(image.GetPointer()), InvalidInput);
}
