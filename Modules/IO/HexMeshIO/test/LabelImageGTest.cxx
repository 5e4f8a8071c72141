// Exact: voxels, counts and labels. Places to 1e-6 mm where a header holds single precision.
#include "moserhex/HexMeshIO/LabelImageReader.h"
#include "moserhex/HexMeshIO/LabelImageWriter.h"

#include "TestErrors.h"
#include "TestFolder.h"
#include "moserhex/Analytic/SolidShapes.h"

#include <gtest/gtest.h>

#include <itkImageFileWriter.h>
#include <itkMetaImageIO.h>
#include <itkNiftiImageIO.h>
#include <itkNrrdImageIO.h>
#include <itkVectorImage.h>

#include <cmath>
#include <cstring>
#include <limits>

using namespace moserhex;

namespace
{

/** Labels 0, 1 and 3 on a small oblique grid. */
LabelVolume
twoLabels()
{
  LabelVolume labels =
    analytic::labelVolume(analytic::ball(5.0), { Vector3(1.0, 1.25, 2.0), analytic::obliqueDirection() });
  for (std::size_t voxel = labels.inside.size() / 2; voxel < labels.inside.size(); ++voxel)
  {
    labels.inside[voxel] = static_cast<std::uint8_t>(3 * labels.inside[voxel]);
  }
  return labels;
}

template <typename TVoxel, unsigned int VDimension = 3>
typename itk::Image<TVoxel, VDimension>::Pointer
filledImage(TVoxel value)
{
  auto                                              image = itk::Image<TVoxel, VDimension>::New();
  typename itk::Image<TVoxel, VDimension>::SizeType size;
  size.Fill(4);
  image->SetRegions(size);
  image->Allocate();
  image->FillBuffer(TVoxel{});
  image->GetBufferPointer()[21] = value;
  return image;
}

template <typename TImageIO, typename TImage>
void
writeBy(const std::string & fileName, const TImage * image, bool compress = false)
{
  auto writer = itk::ImageFileWriter<TImage>::New();
  writer->SetImageIO(TImageIO::New());
  writer->SetFileName(fileName);
  writer->SetInput(image);
  writer->SetUseCompression(compress);
  writer->Update();
}

/** The labels of `twoLabels` in a file of the given name. */
void
writeTwoLabels(const std::string & fileName, bool compress)
{
  const auto image = labelImageOf(twoLabels());
  if (fileName.find(".nii") != std::string::npos)
  {
    writeBy<itk::NiftiImageIO>(fileName, image.GetPointer());
  }
  else if (fileName.find(".mh") != std::string::npos)
  {
    writeBy<itk::MetaImageIO>(fileName, image.GetPointer(), compress);
  }
  else
  {
    writeBy<itk::NrrdImageIO>(fileName, image.GetPointer(), compress);
  }
}

struct Format
{
  const char * name;
  const char * fileName;
  bool         compress;
};

void
PrintTo(const Format & format, std::ostream * stream)
{
  *stream << format.name;
}

/** A NIfTI header of `twoLabels` with the bytes at `offset` replaced by a float. */
void
writePatchedNifti(const std::string & fileName, std::size_t offset, float value)
{
  writeTwoLabels(fileName, false);
  std::string bytes = readBytes(fileName);
  std::memcpy(bytes.data() + offset, &value, sizeof value);
  writeBytes(fileName, bytes);
}

void
writePatchedText(const std::string & fileName, const std::string & what, const std::string & replacement)
{
  writeTwoLabels(fileName, false);
  std::string bytes = readBytes(fileName);
  const auto  begin = bytes.find(what);
  ASSERT_NE(begin, std::string::npos) << what;
  bytes.replace(begin, bytes.find('\n', begin) - begin, replacement);
  writeBytes(fileName, bytes);
}

} // namespace

class EveryLabelFormat : public testing::TestWithParam<Format>
{};
INSTANTIATE_TEST_SUITE_P(LabelImage,
                         EveryLabelFormat,
                         testing::Values(Format{ "nrrd", "a.nrrd", false },
                                         Format{ "nrrdGzip", "a.nrrd", true },
                                         Format{ "nii", "a.nii", false },
                                         Format{ "niiGz", "a.nii.gz", true },
                                         Format{ "mha", "a.mha", false },
                                         Format{ "mhaZlib", "a.mha", true },
                                         Format{ "mhd", "a.mhd", false }),
                         [](const auto & instance) { return instance.param.name; });

TEST_P(EveryLabelFormat, GivesVoxelsAndPlace)
{
  const TestFolder folder;
  writeTwoLabels(folder / GetParam().fileName, GetParam().compress);
  const LabelImage  read = readLabelImage(folder / GetParam().fileName);
  const LabelVolume expected = twoLabels();
  const LabelVolume frame = labelVolumeOf(*read.image, 1);
  EXPECT_EQ(frame.size, expected.size);
  EXPECT_TRUE(frame.spacing.isApprox(expected.spacing, 1e-6));
  EXPECT_LT((frame.origin - expected.origin).norm(), 1e-5);
  EXPECT_TRUE(frame.direction.isApprox(expected.direction, 1e-5));
  EXPECT_TRUE(std::equal(expected.inside.begin(), expected.inside.end(), read.image->GetBufferPointer()));
  ASSERT_EQ(read.labels.size(), 2u);
  EXPECT_EQ(read.labels[0].value, 1);
  EXPECT_EQ(read.labels[1].value, 3);
  EXPECT_EQ(read.labels[0].voxels + read.labels[1].voxels, voxelCount(expected));
  EXPECT_TRUE(read.warnings.empty());
}

TEST_P(EveryLabelFormat, DirectionIsOrthonormalToRoundOff)
{
  const TestFolder folder;
  writeTwoLabels(folder / GetParam().fileName, GetParam().compress);
  const LabelVolume frame = labelVolumeOf(*readLabelImage(folder / GetParam().fileName).image, 1);
  EXPECT_TRUE((frame.direction.transpose() * frame.direction).isApprox(Matrix3::Identity(), 1e-14));
}

TEST_P(EveryLabelFormat, EveryCutIsRefused)
{
  const TestFolder folder;
  writeTwoLabels(folder / GetParam().fileName, GetParam().compress);
  // A .mhd keeps its voxels beside it.
  const bool        detached = std::string(GetParam().fileName) == "a.mhd";
  const std::string name = folder / (detached ? "a.raw" : GetParam().fileName);
  const std::string bytes = readBytes(name);
  for (int tenths = 0; tenths < 20; ++tenths)
  {
    writeBytes(name, bytes.substr(0, bytes.size() * static_cast<std::size_t>(tenths) / 20));
    EXPECT_THROW((void)readLabelImage(folder / GetParam().fileName), BadInput) << tenths << "/20";
  }
  writeBytes(name, bytes.substr(0, bytes.size() - 1));
  EXPECT_THROW((void)readLabelImage(folder / GetParam().fileName), BadInput);
}

TEST(LabelImageReader, WholeNumbersInFloatsAreLabels)
{
  const TestFolder folder;
  writeBy<itk::NiftiImageIO>(folder / "a.nii.gz", filledImage<float>(7.0F).GetPointer());
  EXPECT_EQ(readLabelImage(folder / "a.nii.gz").labels.front().value, 7);
}

TEST(LabelImageReader, ProbabilitiesAreRefused)
{
  const TestFolder folder;
  writeBy<itk::NiftiImageIO>(folder / "a.nii.gz", filledImage<float>(0.5F).GetPointer());
  EXPECT_NE(messageOf<BadInput>([&] { (void)readLabelImage(folder / "a.nii.gz"); }).find("not a label"),
            std::string::npos);
}

TEST(LabelImageReader, NotANumberIsRefused)
{
  const TestFolder folder;
  writeBy<itk::NrrdImageIO>(folder / "a.nrrd",
                            filledImage<double>(std::numeric_limits<double>::quiet_NaN()).GetPointer());
  EXPECT_THROW((void)readLabelImage(folder / "a.nrrd"), BadInput);
}

TEST(LabelImageReader, LargeLabelDoesNotWrapAround)
{
  const TestFolder folder;
  writeBy<itk::NrrdImageIO>(folder / "a.nrrd", filledImage<int>(100000).GetPointer());
  EXPECT_EQ(readLabelImage(folder / "a.nrrd").labels.front().value, 100000);
}

TEST(LabelImageReader, LabelBeyond32BitsIsRefused)
{
  const TestFolder folder;
  writeBy<itk::NrrdImageIO>(folder / "a.nrrd", filledImage<unsigned int>(4000000000u).GetPointer());
  EXPECT_THROW((void)readLabelImage(folder / "a.nrrd"), BadInput);
}

TEST(LabelImageReader, NegativeValueIsNoLabel)
{
  const TestFolder folder;
  writeBy<itk::NrrdImageIO>(folder / "a.nrrd", filledImage<short>(-3).GetPointer());
  const std::string error = errorOf([&] { (void)readLabelImage(folder / "a.nrrd"); });
  EXPECT_NE(error.find("E_LABELS"), std::string::npos);
  EXPECT_NE(error.find("voxel (1, 1, 1) holds -3"), std::string::npos) << error;
}

TEST(LabelImageReader, NoiseOfFloatsIsRoundedAndCounted)
{
  const TestFolder folder;
  writeBy<itk::NrrdImageIO>(folder / "a.nrrd", filledImage<float>(2.9999998F).GetPointer());
  const LabelImage image = readLabelImage(folder / "a.nrrd");
  EXPECT_EQ(image.labels.front().value, 3);
  ASSERT_EQ(image.warnings.size(), 1u);
  EXPECT_NE(image.warnings[0].find(": 1 values within 1e-4"), std::string::npos) << image.warnings[0];
  writeBy<itk::NrrdImageIO>(folder / "a.nrrd", filledImage<float>(33554432.0F).GetPointer());
  EXPECT_THROW((void)readLabelImage(folder / "a.nrrd"), BadInput); // a float does not tell it from its neighbours
}

TEST(LabelImageReader, ThresholdMakesALabelOfAProbabilityMap)
{
  const TestFolder folder;
  const auto       image = filledImage<float>(0.5F);
  image->GetBufferPointer()[22] = 0.49F;
  image->GetBufferPointer()[23] = std::numeric_limits<float>::quiet_NaN();
  writeBy<itk::NrrdImageIO>(folder / "a.nrrd", image.GetPointer());
  LabelReadOptions options;
  options.threshold = 0.5;
  const LabelImage read = readLabelImage(folder / "a.nrrd", options);
  ASSERT_EQ(read.labels.size(), 1u);
  EXPECT_EQ(read.labels[0].value, 1);
  EXPECT_EQ(read.labels[0].voxels, 1u);
  EXPECT_EQ(read.image->GetBufferPointer()[21], 1);
  ASSERT_EQ(read.warnings.size(), 1u);
  EXPECT_NE(read.warnings[0].find("1 voxels are not numbers"), std::string::npos);
  options.threshold = 0.6;
  EXPECT_NE(errorOf([&] { (void)readLabelImage(folder / "a.nrrd", options); }).find("E_EMPTY_LABEL"),
            std::string::npos);
  EXPECT_NE(errorOf([&] { (void)readLabelImage(folder / "a.nrrd"); }).find("--threshold"), std::string::npos);
}

TEST(LabelImageReader, ThresholdOfIntegersCountsTheThresholdIn)
{
  const TestFolder folder;
  writeBy<itk::NrrdImageIO>(folder / "a.nrrd", filledImage<short>(-3).GetPointer());
  LabelReadOptions options;
  options.threshold = -3.0;
  EXPECT_EQ(readLabelImage(folder / "a.nrrd", options).labels[0].voxels, 64u);
  options.threshold = -2.0;
  EXPECT_EQ(readLabelImage(folder / "a.nrrd", options).labels[0].voxels, 63u);
}

TEST(LabelImageReader, ThresholdAndSegmentExcludeEachOther)
{
  LabelReadOptions options;
  options.threshold = 0.5;
  options.segment = "1";
  EXPECT_EQ(errorOf([&] { (void)readLabelImage("a.nrrd", options); }).substr(0, 7), "E_USAGE");
  options.segment.reset();
  options.threshold = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(errorOf([&] { (void)readLabelImage("a.nrrd", options); }).substr(0, 7), "E_USAGE");
}

TEST(LabelImageReader, MoreThan4096ValuesAreAnImage)
{
  const TestFolder folder;
  const auto       image = itk::Image<int, 3>::New();
  image->SetRegions(itk::Size<3>{ { 17, 17, 17 } });
  image->Allocate();
  for (int n = 0; n < 17 * 17 * 17; ++n)
  {
    image->GetBufferPointer()[n] = n;
  }
  writeBy<itk::NrrdImageIO>(folder / "a.nrrd", image.GetPointer());
  EXPECT_NE(errorOf([&] { (void)readLabelImage(folder / "a.nrrd"); }).find("E_LABELS"), std::string::npos);
}

TEST(LabelImageReader, SandboxChangesNothing)
{
  const TestFolder folder;
  for (const int largest : { 200, 60000, 100000 })
  {
    writeBy<itk::NrrdImageIO>(folder / "a.nrrd", filledImage<int>(largest).GetPointer());
    LabelReadOptions here;
    here.sandbox = false;
    const LabelImage a = readLabelImage(folder / "a.nrrd");
    const LabelImage b = readLabelImage(folder / "a.nrrd", here);
    EXPECT_TRUE(std::equal(a.image->GetBufferPointer(), a.image->GetBufferPointer() + 64, b.image->GetBufferPointer()));
    EXPECT_EQ(a.image->GetBufferPointer()[21], largest);
    EXPECT_EQ(a.labels.front().voxels, b.labels.front().voxels);
    EXPECT_EQ(a.image->GetOrigin(), b.image->GetOrigin());
    EXPECT_EQ(a.image->GetDirection(), b.image->GetDirection());
  }
}

TEST(LabelVolumeOfAll, TakesEveryLabel)
{
  const TestFolder folder;
  writeTwoLabels(folder / "a.nrrd", true);
  const LabelImage image = readLabelImage(folder / "a.nrrd");
  EXPECT_EQ(voxelCount(labelVolumeOfAll(*image.image)), image.labels[0].voxels + image.labels[1].voxels);
}

TEST(LabelImageReader, EmptyLabelmapIsRefused)
{
  const TestFolder folder;
  writeBy<itk::NrrdImageIO>(folder / "a.nrrd", filledImage<unsigned char>(0).GetPointer());
  EXPECT_NE(messageOf<BadInput>([&] { (void)readLabelImage(folder / "a.nrrd"); }).find("no voxel"), std::string::npos);
}

TEST(LabelImageReader, EmptyLabelmapIsReadWhereItIsAllowed)
{
  const TestFolder folder;
  writeBy<itk::NrrdImageIO>(folder / "a.nrrd", filledImage<short>(0).GetPointer());
  LabelReadOptions options;
  options.allowEmpty = true;
  const LabelImage image = readLabelImage(folder / "a.nrrd", options);
  EXPECT_TRUE(image.labels.empty());
  ASSERT_EQ(image.warnings.size(), 1u);
  EXPECT_NE(image.warnings[0].find("no voxel differs from 0"), std::string::npos) << image.warnings[0];
}

TEST(LabelImageReader, TheRemedyForFractionsIsTheCallers)
{
  const TestFolder folder;
  writeBy<itk::NrrdImageIO>(folder / "a.nrrd", filledImage<float>(0.5F).GetPointer());
  LabelReadOptions options;
  options.remedyForFractions = "leave it";
  const std::string message = errorOf([&] { (void)readLabelImage(folder / "a.nrrd", options); });
  EXPECT_NE(message.find("leave it"), std::string::npos) << message;
  EXPECT_EQ(message.find("--threshold"), std::string::npos) << message;
}

TEST(LabelImageReader, FourDimensionsAreRefusedByName)
{
  const TestFolder folder;
  const auto       image = filledImage<unsigned char, 4>(1);
  writeBy<itk::NrrdImageIO>(folder / "a.nrrd", image.GetPointer());
  writeBy<itk::NiftiImageIO>(folder / "a.nii", image.GetPointer());
  writeBy<itk::MetaImageIO>(folder / "a.mha", image.GetPointer());
  for (const char * name : { "a.nrrd", "a.nii", "a.mha" })
  {
    EXPECT_NE(messageOf<BadInput>([&] { (void)readLabelImage(folder / name); }).find("3-D"), std::string::npos) << name;
  }
}

TEST(LabelImageReader, VectorsAreRefused)
{
  const TestFolder folder;
  auto             image = itk::VectorImage<unsigned char, 3>::New();
  image->SetRegions(itk::Size<3>{ { 4, 4, 4 } });
  image->SetVectorLength(3);
  image->Allocate();
  writeBy<itk::NrrdImageIO>(folder / "a.nrrd", image.GetPointer());
  writeBy<itk::MetaImageIO>(folder / "a.mha", image.GetPointer());
  EXPECT_THROW((void)readLabelImage(folder / "a.nrrd"), BadInput);
  EXPECT_NE(messageOf<BadInput>([&] { (void)readLabelImage(folder / "a.mha"); }).find("per voxel"), std::string::npos);
}

TEST(LabelImageReader, GeometryThatIsNotFiniteIsRefusedBeforeItkAborts)
{
  const TestFolder folder;
  const float      nan = std::numeric_limits<float>::quiet_NaN();
  for (const std::size_t offset : { 80u, 256u, 268u, 280u, 300u, 324u })
  {
    writePatchedNifti(folder / "a.nii", offset, nan);
    EXPECT_THROW((void)readLabelImage(folder / "a.nii"), BadInput) << offset;
    writePatchedNifti(folder / "a.nii", offset, 1.7e38F);
    EXPECT_THROW((void)readLabelImage(folder / "a.nii"), BadInput) << offset;
  }
}

TEST(LabelImageReader, ZeroSpacingIsRefused)
{
  const TestFolder folder;
  writePatchedNifti(folder / "a.nii", 80, 0.0F);
  EXPECT_NE(messageOf<BadInput>([&] { (void)readLabelImage(folder / "a.nii"); }).find("voxel size"), std::string::npos);
}

TEST(LabelImageReader, VoxelOfANiftiFileHasTheVolumeOfTheSform)
{
  const TestFolder folder;
  const auto       spacingOf = [&] { return readLabelImage(folder / "a.nii").image->GetSpacing()[0]; };
  writeTwoLabels(folder / "a.nii", false);
  const std::string bytes = readBytes(folder / "a.nii");
  const double      before = spacingOf();
  // Makes the sform's first column longer; returns its length, which pixdim does not follow.
  const auto stretch = [&](float factor) {
    std::string changed = bytes;
    double      squares = 0.0;
    for (const std::size_t offset : { 280, 296, 312 })
    {
      float component = 0.0F;
      std::memcpy(&component, changed.data() + offset, sizeof component);
      component *= factor;
      squares += static_cast<double>(component) * static_cast<double>(component);
      std::memcpy(changed.data() + offset, &component, sizeof component);
    }
    writeBytes(folder / "a.nii", changed);
    return std::sqrt(squares);
  };
  const double longer = stretch(1.000001F);
  ASSERT_GT(longer, before * (1.0 + 5e-7));
  EXPECT_NEAR(spacingOf() / longer, 1.0, 1e-11);
  // Beyond rounding there is a warning, beyond 0.1 % no voxel size to be sure of.
  (void)stretch(1.0001F);
  EXPECT_EQ(readLabelImage(folder / "a.nii").warnings.size(), 1u);
  (void)stretch(1.01F);
  EXPECT_NE(errorOf(spacingOf).find("E_GEOMETRY"), std::string::npos);
}

TEST(LabelImageReader, ShearIsRefused)
{
  const TestFolder folder;
  writePatchedText(folder / "a.nrrd", "space directions:", "space directions: (1,0,0) (0.5,1,0) (0,0,1)");
  EXPECT_THROW((void)readLabelImage(folder / "a.nrrd"), BadInput);
}

TEST(LabelImageReader, MetresAreRefused)
{
  const TestFolder folder;
  writePatchedText(folder / "a.nrrd", "encoding: raw", "encoding: raw\nspace units: \"m\" \"m\" \"m\"");
  EXPECT_NE(messageOf<BadInput>([&] { (void)readLabelImage(folder / "a.nrrd"); }).find("units"), std::string::npos);
}

TEST(LabelImageReader, HostileMetaHeadersAreRefused)
{
  const TestFolder folder;
  for (const char * dimensions : { "NDims = 0", "NDims = -1", "NDims = 100000", "NDims = 4" })
  {
    writePatchedText(folder / "a.mha", "NDims", dimensions);
    EXPECT_THROW((void)readLabelImage(folder / "a.mha"), BadInput) << dimensions;
  }
  for (const std::string & dataFile : { std::string("%s%s%n 1 10 1"),
                                        std::string("/etc/passwd"),
                                        std::string("LIST"),
                                        std::string("../a.raw"),
                                        std::string("missing.raw") })
  {
    writePatchedText(folder / "a.mha", "ElementDataFile", "ElementDataFile = " + dataFile);
    EXPECT_THROW((void)readLabelImage(folder / "a.mha"), BadInput) << dataFile;
  }
  writePatchedText(folder / "a.mha", "NDims", std::string(300, 'k') + " = 1\nNDims = 3");
  EXPECT_THROW((void)readLabelImage(folder / "a.mha"), BadInput);
}

TEST(LabelImageReader, HostileNrrdHeadersAreRefused)
{
  const TestFolder folder;
  for (const std::string & sizes : { std::string("sizes: 1000000 1000000 1000000"),
                                     std::string("sizes: 4294967296 2 2"),
                                     std::string("sizes: 4 4"),
                                     std::string("sizes: 4 4 x"),
                                     "sizes: " + std::string(2000, '1') })
  {
    writePatchedText(folder / "a.nrrd", "sizes:", sizes);
    EXPECT_THROW((void)readLabelImage(folder / "a.nrrd"), BadInput) << sizes;
  }
  writePatchedText(folder / "a.nrrd", "encoding:", "encoding: raw\ndata file: /etc/passwd");
  EXPECT_THROW((void)readLabelImage(folder / "a.nrrd"), BadInput);
}

TEST(LabelImageReader, FlippedBitsInCompressedVoxelsNeverChangeTheLabels)
{
  // Some flips decode to the same voxels (runs of zeros cut otherwise); all others must be noticed.
  const TestFolder  folder;
  const LabelVolume expected = twoLabels();
  for (const char * name : { "a.nii.gz", "a.mha", "a.nrrd" })
  {
    writeTwoLabels(folder / name, true);
    const std::string good = readBytes(folder / name);
    std::size_t       refused = 0;
    for (std::size_t back = 1; back < 150; ++back)
    {
      std::string bytes = good;
      char &      byte = bytes[bytes.size() - back];
      byte = static_cast<char>(byte ^ (1 << (back % 8)));
      writeBytes(folder / name, bytes);
      try
      {
        const LabelImage read = readLabelImage(folder / name);
        EXPECT_TRUE(std::equal(expected.inside.begin(), expected.inside.end(), read.image->GetBufferPointer()))
          << name << ' ' << back;
      }
      catch (const BadInput &)
      {
        ++refused;
      }
    }
    EXPECT_GT(refused, 75u) << name;
  }
}

TEST(LabelImageReader, OtherContentIsRefused)
{
  const TestFolder folder;
  for (const char * name : { "a.nrrd", "a.nii", "a.nii.gz", "a.mha", "a.mhd" })
  {
    writeBytes(folder / name, "<html>\n<body>404 Not Found</body>\n</html>\n" + std::string(500, ' '));
    EXPECT_THROW((void)readLabelImage(folder / name), BadInput) << name;
    writeBytes(folder / name, "");
    EXPECT_THROW((void)readLabelImage(folder / name), BadInput) << name;
  }
}

TEST(LabelImageReader, MissingFileFolderAndForeignNameAreRefused)
{
  const TestFolder folder;
  std::filesystem::create_directory(folder / "folder.nrrd");
  EXPECT_THROW((void)readLabelImage(folder / "missing.nrrd"), BadInput);
  EXPECT_THROW((void)readLabelImage(folder / "folder.nrrd"), BadInput);
  EXPECT_THROW((void)readLabelImage(folder / "image.png"), BadInput);
}

TEST(LabelImageReader, TrailingBytesAreWarnedAbout)
{
  const TestFolder folder;
  writeTwoLabels(folder / "a.nii", false);
  writeBytes(folder / "a.nii", readBytes(folder / "a.nii") + std::string(777, 'x'));
  const LabelImage read = readLabelImage(folder / "a.nii");
  ASSERT_EQ(read.warnings.size(), 1u);
  EXPECT_NE(read.warnings.front().find("777"), std::string::npos);
}

TEST(LabelImageReader, SegmentNamesComeFromSlicersHeader)
{
  const TestFolder folder;
  writePatchedText(folder / "a.nrrd",
                   "encoding: raw",
                   "encoding: raw\nSegment0_LabelValue:=3\nSegment0_Name:=Transition zone\nSegment1_LabelValue:=1\n"
                   "Segment1_Name:=Peripheral zone\nSegment1_Tags:=" +
                     std::string(3000, 't'));
  const LabelImage read = readLabelImage(folder / "a.nrrd");
  EXPECT_EQ(read.labels[0].name, "Peripheral zone");
  EXPECT_EQ(read.labels[1].name, "Transition zone");
}

TEST(ChooseLabel, TakesTheOnlyLabel)
{
  const TestFolder folder;
  writeBy<itk::NrrdImageIO>(folder / "a.nrrd", filledImage<short>(9).GetPointer());
  EXPECT_EQ(chooseLabel(readLabelImage(folder / "a.nrrd"), std::nullopt).value, 9);
}

TEST(ChooseLabel, SeveralLabelsAreListed)
{
  const TestFolder folder;
  writeTwoLabels(folder / "a.nrrd", true);
  const LabelImage image = readLabelImage(folder / "a.nrrd");
  EXPECT_NE(messageOf<BadInput>([&] { (void)chooseLabel(image, std::nullopt); }).find("1, 3"), std::string::npos);
  EXPECT_EQ(chooseLabel(image, 3).value, 3);
}

TEST(ChooseLabel, AbsentLabelIsRefusedWithThePresentOnes)
{
  const TestFolder folder;
  writeTwoLabels(folder / "a.nrrd", true);
  const LabelImage image = readLabelImage(folder / "a.nrrd");
  EXPECT_NE(messageOf<BadInput>([&] { (void)chooseLabel(image, 2); }).find("no label 2, it has 1, 3"),
            std::string::npos);
}

TEST(LabelImageWriter, SameLabelsGiveTheSameBytes)
{
  const TestFolder folder;
  writeLabelImage(folder / "a.nrrd", twoLabels());
  writeLabelImage(folder / "b.nrrd", twoLabels());
  EXPECT_EQ(readBytes(folder / "a.nrrd"), readBytes(folder / "b.nrrd"));
  EXPECT_EQ(folder.fileCount(), 2u);
}

TEST(LabelImageWriter, KeepsVoxelsAndPlace)
{
  const TestFolder folder;
  writeLabelImage(folder / "a.nrrd", twoLabels());
  const LabelImage  read = readLabelImage(folder / "a.nrrd");
  const LabelVolume expected = twoLabels();
  const LabelVolume frame = labelVolumeOf(*read.image, 3);
  EXPECT_LT((frame.point(3, 4, 5) - expected.point(3, 4, 5)).norm(), 1e-9);
  EXPECT_EQ(voxelCount(frame), read.labels[1].voxels);
}

TEST(LabelImageWriter, OtherExtensionAndUnwritableFolderAreRefused)
{
  const TestFolder folder;
  EXPECT_THROW(writeLabelImage(folder / "a.nii", twoLabels()), BadInput);
  EXPECT_THROW(writeLabelImage(folder / "no/a.nrrd", twoLabels()), IOError);
}
