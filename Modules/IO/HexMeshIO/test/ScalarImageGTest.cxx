// Exact: values of a file that stores doubles. Places to 1e-6 mm where a header holds single precision.
#include "moserhex/HexMeshIO/ScalarImageReader.h"

#include "../src/ImageGrid.h"
#include "TestFolder.h"
#include "moserhex/Analytic/SolidShapes.h"

#include <gtest/gtest.h>

#include <itkImageFileWriter.h>
#include <itkMetaImageIO.h>
#include <itkNiftiImageIO.h>
#include <itkNrrdImageIO.h>
#include <itkVectorImage.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

using namespace moserhex;

namespace
{

/** Oblique and anisotropic, value 1.25 n + 2 at voxel n. */
template <typename TVoxel>
typename itk::Image<TVoxel, 3>::Pointer
testImage()
{
  using ImageType = itk::Image<TVoxel, 3>;
  const auto                        image = ImageType::New();
  typename ImageType::SizeType      size{ { 5, 4, 3 } };
  typename ImageType::DirectionType direction;
  const Matrix3                     axes = analytic::obliqueDirection();
  typename ImageType::SpacingType   spacing;
  typename ImageType::PointType     origin;
  const Vector3                     sides(0.5, 0.75, 3.0);
  for (unsigned int a = 0; a < 3; ++a)
  {
    spacing[a] = sides[static_cast<int>(a)];
    origin[a] = 10.0 * a - 7.0;
    for (unsigned int b = 0; b < 3; ++b)
    {
      direction[a][b] = axes(static_cast<int>(a), static_cast<int>(b));
    }
  }
  image->SetRegions(size);
  image->SetSpacing(spacing);
  image->SetOrigin(origin);
  image->SetDirection(direction);
  image->Allocate();
  for (int voxel = 0; voxel < 60; ++voxel)
  {
    image->GetBufferPointer()[voxel] = static_cast<TVoxel>(1.25 * voxel + 2.0);
  }
  return image;
}

template <typename TImage>
void
write(const std::string & fileName, const TImage * image)
{
  itk::ImageIOBase::Pointer io = itk::NrrdImageIO::New().GetPointer();
  if (fileName.find(".nii") != std::string::npos)
  {
    io = itk::NiftiImageIO::New().GetPointer();
  }
  else if (fileName.find(".mh") != std::string::npos)
  {
    io = itk::MetaImageIO::New().GetPointer();
  }
  const auto writer = itk::ImageFileWriter<TImage>::New();
  writer->SetImageIO(io);
  writer->SetFileName(fileName);
  writer->SetInput(image);
  writer->Update();
}

} // namespace

class EveryScalarFormat : public testing::TestWithParam<const char *>
{};
INSTANTIATE_TEST_SUITE_P(ScalarImage,
                         EveryScalarFormat,
                         testing::Values("a.nrrd", "a.nii", "a.nii.gz", "a.mha", "a.mhd"),
                         [](const auto & instance) {
                           std::string name = instance.param;
                           std::replace(name.begin(), name.end(), '.', '_');
                           return name;
                         });

TEST_P(EveryScalarFormat, GivesValuesAndPlace)
{
  const TestFolder folder;
  const auto       image = testImage<double>();
  write(folder / GetParam(), image.GetPointer());
  const ScalarImage read = readScalarImage(folder / GetParam());
  const VoxelGrid   grid = voxelGridOf(*read.image);
  EXPECT_EQ(grid.size, (std::array<int, 3>{ { 5, 4, 3 } }));
  EXPECT_TRUE(grid.spacing.isApprox(Vector3(0.5, 0.75, 3.0), 1e-6));
  EXPECT_LT((grid.origin - Vector3(-7.0, 3.0, 13.0)).norm(), 1e-5);
  EXPECT_TRUE(grid.direction.isApprox(analytic::obliqueDirection(), 1e-5));
  EXPECT_TRUE((grid.direction.transpose() * grid.direction).isApprox(Matrix3::Identity(), 1e-14));
  const double * values = read.image->GetBufferPointer();
  EXPECT_TRUE(std::equal(values, values + 60, image->GetBufferPointer()));
}

TEST_P(EveryScalarFormat, CutFileIsRefused)
{
  const TestFolder folder;
  write(folder / GetParam(), testImage<double>().GetPointer());
  const std::string name = folder / (std::string(GetParam()) == "a.mhd" ? "a.raw" : GetParam());
  const std::string bytes = readBytes(name);
  writeBytes(name, bytes.substr(0, bytes.size() - 1));
  EXPECT_THROW((void)readScalarImage(folder / GetParam()), BadInput);
}

TEST(ScalarImageReader, EveryNumberTypeIsTaken)
{
  const TestFolder folder;
  write(folder / "uchar.nrrd", testImage<unsigned char>().GetPointer());
  write(folder / "short.nrrd", testImage<short>().GetPointer());
  write(folder / "float.nrrd", testImage<float>().GetPointer());
  EXPECT_EQ(readScalarImage(folder / "uchar.nrrd").image->GetBufferPointer()[3], 5.0);
  EXPECT_EQ(readScalarImage(folder / "short.nrrd").image->GetBufferPointer()[3], 5.0);
  EXPECT_EQ(readScalarImage(folder / "float.nrrd").image->GetBufferPointer()[3], 5.75);
}

TEST(ScalarImageReader, SlopeAndInterceptOfNiftiAreApplied)
{
  const TestFolder folder;
  write(folder / "a.nii", testImage<short>().GetPointer());
  std::string bytes = readBytes(folder / "a.nii");
  const float slopeAndIntercept[2] = { 0.5F, 3.0F };
  std::memcpy(bytes.data() + 112, slopeAndIntercept, sizeof slopeAndIntercept);
  writeBytes(folder / "a.nii", bytes);
  EXPECT_EQ(readScalarImage(folder / "a.nii").image->GetBufferPointer()[3], 5.5);
}

TEST(ScalarImageReader, ValuesOfNiftiThatAreNotFiniteAreReadAsZeroWithAWarning)
{
  const TestFolder folder;
  const auto       image = testImage<float>();
  image->GetBufferPointer()[7] = std::numeric_limits<float>::quiet_NaN();
  image->GetBufferPointer()[9] = -std::numeric_limits<float>::infinity();
  write(folder / "density.nii.gz", image.GetPointer());
  const ScalarImage read = readScalarImage(folder / "density.nii.gz");
  EXPECT_EQ(read.image->GetBufferPointer()[7], 0.0);
  EXPECT_EQ(read.image->GetBufferPointer()[9], 0.0);
  EXPECT_EQ(read.image->GetBufferPointer()[8], image->GetBufferPointer()[8]);
  ASSERT_EQ(read.warnings.size(), 1u);
  EXPECT_NE(read.warnings.front().find("2 values that are not finite were read as 0"), std::string::npos)
    << read.warnings.front();
}

TEST(ScalarImageReader, ValuesThatAreNotFiniteAreLeftToTheLabel)
{
  const TestFolder folder;
  const auto       image = testImage<float>();
  image->GetBufferPointer()[7] = std::numeric_limits<float>::quiet_NaN();
  image->GetBufferPointer()[8] = std::numeric_limits<float>::infinity();
  write(folder / "a.nrrd", image.GetPointer());
  const ScalarImage read = readScalarImage(folder / "a.nrrd");
  EXPECT_TRUE(std::isnan(read.image->GetBufferPointer()[7]));
  EXPECT_TRUE(std::isinf(read.image->GetBufferPointer()[8]));
}

TEST(ScalarImageReader, VectorsAreRefused)
{
  const TestFolder                             folder;
  const auto                                   image = itk::VectorImage<float, 3>::New();
  const itk::VectorImage<float, 3>::RegionType region({ { 0, 0, 0 } }, { { 4, 4, 4 } });
  image->SetRegions(region);
  image->SetNumberOfComponentsPerPixel(3);
  image->Allocate(true);
  write(folder / "a.nrrd", image.GetPointer());
  EXPECT_THROW((void)readScalarImage(folder / "a.nrrd"), BadInput);
}

TEST(ScalarImageReader, FlatImageIsRefused)
{
  const TestFolder folder;
  const auto       image = itk::Image<float, 2>::New();
  image->SetRegions(itk::Image<float, 2>::SizeType{ { 4, 4 } });
  image->Allocate(true);
  write(folder / "a.mha", image.GetPointer());
  EXPECT_THROW((void)readScalarImage(folder / "a.mha"), BadInput);
}

TEST(ScalarImageReader, MissingFileIsRefused)
{
  EXPECT_THROW((void)readScalarImage("/nonexistent/a.nrrd"), BadInput);
}

TEST(ScalarImageReader, OtherFormatsAreRefused)
{
  EXPECT_NE(messageOf<BadInput>([] { (void)readScalarImage("a.tif"); }).find(".nrrd"), std::string::npos);
}
