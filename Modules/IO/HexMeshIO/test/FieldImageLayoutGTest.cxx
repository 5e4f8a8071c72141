// How several numbers of a voxel lie in a file. Numbers exact; places to 1e-6 mm, NIfTI's single precision.
#include "moserhex/HexMeshIO/FieldImageReader.h"
#include "moserhex/HexMeshIO/FieldImageWriter.h"

#include "FullDisk.h"
#include "NiftiText.h"
#include "TestErrors.h"
#include "moserhex/Analytic/SolidShapes.h"
#include "moserhex/HexMeshIO/LabelImageReader.h"
#include "moserhex/HexMeshIO/ScalarImageReader.h"

#include <itkNiftiImageIO.h>
#include <itkNrrdImageIO.h>

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>

using namespace moserhex;

namespace
{

constexpr int voxels = 60;

/** Value of component c of voxel v, as every test file has it. */
double
valueOf(int voxel, int component)
{
  return 10.0 * voxel + component;
}

template <typename T>
void
append(std::string & bytes, double value, bool swapped)
{
  const auto number = static_cast<T>(value);
  char       own[sizeof number];
  std::memcpy(own, &number, sizeof number);
  if (swapped)
  {
    std::reverse(own, own + sizeof own);
  }
  bytes.append(own, sizeof own);
}

/** All voxels' value of the first component, then of the second, ... as 16-bit integers. */
std::string
planesOf(const std::vector<int> & components, bool swapped = false)
{
  std::string bytes;
  for (const int component : components)
  {
    for (int voxel = 0; voxel < voxels; ++voxel)
    {
      append<std::int16_t>(bytes, valueOf(voxel, component), swapped);
    }
  }
  return bytes;
}

/** A 5-D header over the voxels of ImageText. */
NiftiText
niftiOf(int components, int intent, float rows = 0.0F, bool swapped = false)
{
  NiftiText text(swapped);
  text.set<std::int16_t>(40, 5).set<std::int16_t>(50, static_cast<std::int16_t>(components));
  text.set<float>(56, rows).set<std::int16_t>(68, static_cast<std::int16_t>(intent));
  return text.set<std::int16_t>(70, 4).set<std::int16_t>(72, 16);
}

void
expectValues(const FieldVolume & image, int components, double slope = 1.0, double intercept = 0.0)
{
  ASSERT_EQ(image.components, components);
  ASSERT_EQ(image.gridVoxels(), static_cast<std::size_t>(voxels));
  for (int voxel = 0; voxel < voxels; ++voxel)
  {
    for (int component = 0; component < components; ++component)
    {
      EXPECT_EQ(image.at(static_cast<std::size_t>(voxel))[component], slope * valueOf(voxel, component) + intercept)
        << voxel << ' ' << component;
    }
  }
}

/** What ITK's own reader delivers, as TComponent. */
template <typename TImageIO, typename TComponent>
std::vector<TComponent>
readByOtherReader(const std::string & fileName, unsigned int components)
{
  const auto reader = TImageIO::New();
  reader->SetFileName(fileName);
  reader->ReadImageInformation();
  EXPECT_EQ(reader->GetNumberOfComponents(), components);
  itk::ImageIORegion region(reader->GetNumberOfDimensions());
  for (unsigned int axis = 0; axis < reader->GetNumberOfDimensions(); ++axis)
  {
    region.SetSize(axis, reader->GetDimensions(axis));
  }
  reader->SetIORegion(region);
  std::vector<TComponent> values(static_cast<std::size_t>(voxels) * components);
  EXPECT_EQ(static_cast<std::size_t>(reader->GetImageSizeInBytes()), values.size() * sizeof(TComponent));
  reader->Read(values.data());
  return values;
}

ImageText
nrrdOf(const std::string & sizes, const std::string & kinds, bool isFirst)
{
  const std::string space = "(0.5,0,0) (0,0.75,0) (0,0,2)";
  return ImageText::nrrd()
    .with("type", "int16")
    .withLine("endian: little")
    .with("dimension", "4")
    .with("sizes", sizes)
    .with("space directions", isFirst ? "none " + space : space + " none")
    .with("kinds", kinds);
}

/** All values of the first voxel, then of the second, ...; `first` goes before each voxel's. */
template <typename TFirst>
std::string
voxelsWith(const TFirst & first, int components)
{
  std::string bytes;
  for (int voxel = 0; voxel < voxels; ++voxel)
  {
    append<std::int16_t>(bytes, first(voxel), false);
    for (int component = 0; component < components; ++component)
    {
      append<std::int16_t>(bytes, valueOf(voxel, component), false);
    }
  }
  return bytes;
}

FieldVolume
fieldOf(int components)
{
  FieldVolume image;
  image.size = { { 5, 4, 3 } };
  image.spacing = { 0.5, 0.75, 3.0 };
  image.origin = { -7.0, 3.0, 13.0 };
  image.direction = analytic::obliqueDirection();
  image.components = components;
  for (int voxel = 0; voxel < voxels; ++voxel)
  {
    for (int component = 0; component < components; ++component)
    {
      image.values.push_back(valueOf(voxel, component) / 8.0);
    }
  }
  return image;
}

/** "no error", or the error of readFieldImage. */
std::string
answerTo(const std::string & fileName, const std::string & content)
{
  const TestFolder folder;
  writeBytes(folder / fileName, content);
  return errorOf([&] { (void)readFieldImage(folder / fileName); });
}

} // namespace

TEST(FieldImageLayout, NiftiVectorsOfEveryIntentLieAlongTheFifthAxis)
{
  const TestFolder folder;
  for (const int intent : { 0, 1006, 1007, 2003 })
  {
    for (const bool swapped : { false, true })
    {
      writeBytes(folder / "a.nii", niftiOf(3, intent, 0.0F, swapped).header() + planesOf({ 0, 1, 2 }, swapped));
      const FieldImage read = readFieldImage(folder / "a.nii");
      expectValues(read.volume, 3);
      EXPECT_FALSE(read.valuesToLps);
      EXPECT_TRUE(read.hasValue.empty());
      EXPECT_LE((read.volume.spacing - Vector3(0.5, 0.75, 2.0)).norm(), 1e-6);
    }
  }
}

TEST(FieldImageLayout, NiftiTriangleOfAMatrixComesOutByItsUpperRows)
{
  const TestFolder folder;
  // In the file xx, yx, yy, zx, zy, zz.
  writeBytes(folder / "a.nii", niftiOf(6, 1005, 3.0F).header() + planesOf({ 0, 1, 3, 2, 4, 5 }));
  expectValues(readFieldImage(folder / "a.nii").volume, 6);
  // Of 4 x 4 the lower triangle is 00, 10, 11, 20, 21, 22, 30, 31, 32, 33.
  writeBytes(folder / "b.nii", niftiOf(10, 1005, 4.0F).header() + planesOf({ 0, 1, 4, 2, 5, 7, 3, 6, 8, 9 }));
  expectValues(readFieldImage(folder / "b.nii").volume, 10);
}

TEST(FieldImageLayout, NiftiValuesAreThoseThatItkReads)
{
  const TestFolder folder;
  writeBytes(folder / "a.nii", niftiOf(3, 1007).header() + planesOf({ 0, 1, 2 }));
  writeBytes(folder / "b.nii", niftiOf(6, 1005, 3.0F).header() + planesOf({ 0, 1, 3, 2, 4, 5 }));
  for (const auto & [name, components] : { std::pair("a.nii", 3U), std::pair("b.nii", 6U) })
  {
    const std::vector<double> ours = readFieldImage(folder / name).volume.values;
    const auto                theirs = readByOtherReader<itk::NiftiImageIO, std::int16_t>(folder / name, components);
    EXPECT_EQ(ours, std::vector<double>(theirs.begin(), theirs.end())) << name;
  }
}

TEST(FieldImageLayout, NiftiSlopeIsOfEveryValue)
{
  const TestFolder folder;
  NiftiText        text = niftiOf(3, 1007);
  text.set<float>(112, 0.25F).set<float>(116, -2.0F);
  writeBytes(folder / "a.nii", text.header() + planesOf({ 0, 1, 2 }));
  expectValues(readFieldImage(folder / "a.nii").volume, 3, 0.25, -2.0);
}

TEST(FieldImageLayout, NiftiNumbersThatAreNotFiniteAreWithoutData)
{
  const TestFolder  folder;
  const FieldVolume image = fieldOf(1);
  writeFieldImage(folder / "a.nii", image);
  std::string  bytes = readBytes(folder / "a.nii");
  const double wrong = std::numeric_limits<double>::quiet_NaN();
  std::memcpy(bytes.data() + 352 + 3 * sizeof wrong, &wrong, sizeof wrong);
  writeBytes(folder / "a.nii", bytes);
  const FieldImage read = readFieldImage(folder / "a.nii");
  EXPECT_TRUE(std::isnan(read.volume.values[3]));
  ASSERT_EQ(read.hasValue.size(), image.gridVoxels());
  EXPECT_EQ(std::count(read.hasValue.begin(), read.hasValue.end(), 0), 1);
  EXPECT_EQ(read.hasValue[3], 0);
  EXPECT_EQ(read.volume.values[4], image.values[4]);
  EXPECT_EQ(readScalarImage(folder / "a.nii").image->GetBufferPointer()[3], 0.0); // as ITK has it
}

TEST(FieldImageLayout, NiftiMatricesHaveAsManyValuesAsTheirRowsSay)
{
  EXPECT_EQ(answerTo("a.nii", niftiOf(6, 1005, 2.0F).header() + planesOf({ 0, 1, 2, 3, 4, 5 })).substr(0, 8),
            "E_HEADER");
  EXPECT_EQ(answerTo("a.nii", niftiOf(6, 1004, 3.0F).header() + planesOf({ 0, 1, 2, 3, 4, 5 })).substr(0, 8),
            "E_HEADER");
  EXPECT_EQ(answerTo("a.nii", niftiOf(6, 1004, 3.0F).set<float>(60, 2.0F).header() + planesOf({ 0, 1, 2, 3, 4, 5 })),
            "no error");
}

TEST(FieldImageLayout, NiftiVectorsThatAreCutOrInTimeAreRefused)
{
  const std::string whole = niftiOf(3, 1007).header() + planesOf({ 0, 1, 2 });
  EXPECT_NE(answerTo("a.nii", whole.substr(0, whole.size() - 1)).find("E_TRUNCATED"), std::string::npos);
  EXPECT_EQ(answerTo("a.nii", niftiOf(3, 1007).set<std::int16_t>(48, 2).header() + planesOf({ 0, 1, 2, 3, 4, 5 }))
              .substr(0, 11),
            "E_DIMENSION");
  EXPECT_EQ(answerTo("a.nii", niftiOf(5000, 1007).header() + planesOf({ 0 })).substr(0, 11), "E_PIXELTYPE");
  const TestFolder folder;
  writeBytes(folder / "a.nii", whole);
  EXPECT_NE(errorOf([&] { (void)readScalarImage(folder / "a.nii"); }).find("3 values per voxel"), std::string::npos);
  EXPECT_NE(errorOf([&] { (void)readLabelImage(folder / "a.nii"); }).find("3 values per voxel"), std::string::npos);
}

TEST(FieldImageLayout, WrittenNiftiComesBack)
{
  const TestFolder folder;
  for (const char * name : { "a.nii", "a.nii.gz" })
  {
    for (const int components : { 1, 2, 3, 6, 9 })
    {
      const FieldVolume image = fieldOf(components);
      writeFieldImage(folder / name, image, components == 6 ? FieldValues::SymmetricTensors : FieldValues::Numbers);
      const FieldImage read = readFieldImage(folder / name);
      EXPECT_EQ(read.volume.components, components);
      EXPECT_EQ(read.volume.values, image.values);
      EXPECT_LE((read.volume.origin - image.origin).norm(), 1e-5);
      EXPECT_TRUE(read.volume.direction.isApprox(image.direction, 1e-6));
      EXPECT_TRUE(read.volume.spacing.isApprox(image.spacing, 1e-6));
      EXPECT_TRUE(read.valuesToLps);
      EXPECT_TRUE(read.warnings.empty()) << read.warnings.front();
    }
  }
}

TEST(FieldImageLayout, WrittenNiftiOfALeftHandedGridComesBack)
{
  const TestFolder folder;
  FieldVolume      image = fieldOf(2);
  image.direction.col(1) *= -1.0;
  writeFieldImage(folder / "a.nii", image);
  std::string bytes = readBytes(folder / "a.nii");
  EXPECT_TRUE(readFieldImage(folder / "a.nii").volume.direction.isApprox(image.direction, 1e-6));
  bytes[254] = 0; // without the sform, the qform says the same
  writeBytes(folder / "b.nii", bytes);
  EXPECT_TRUE(readFieldImage(folder / "b.nii").volume.direction.isApprox(image.direction, 1e-3));
}

TEST(FieldImageLayout, WrittenNiftiIsWhatItkReads)
{
  const TestFolder  folder;
  const FieldVolume image = fieldOf(6);
  writeFieldImage(folder / "a.nii.gz", image, FieldValues::SymmetricTensors);
  const auto theirs = readByOtherReader<itk::NiftiImageIO, double>(folder / "a.nii.gz", 6);
  EXPECT_EQ(theirs, image.values);
  const auto reader = itk::NiftiImageIO::New();
  reader->SetFileName(folder / "a.nii.gz");
  reader->ReadImageInformation();
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    EXPECT_NEAR(reader->GetOrigin(axis), image.origin[axis], 1e-5);
    EXPECT_NEAR(reader->GetSpacing(axis), image.spacing[axis], 1e-6);
    EXPECT_NEAR(reader->GetDirection(axis)[0], image.direction(0, axis), 1e-6);
  }
}

TEST(FieldImageLayout, WrittenNiftiLabelsAreALabelmap)
{
  const TestFolder folder;
  FieldVolume      image = fieldOf(1);
  for (double & value : image.values)
  {
    value = value < 3.0 ? 0.0 : 70000.0;
  }
  writeFieldImage(folder / "a.nii.gz", image, FieldValues::Labels);
  const LabelImage read = readLabelImage(folder / "a.nii.gz");
  ASSERT_EQ(read.labels.size(), 1u);
  EXPECT_EQ(read.labels[0].value, 70000);
}

TEST(FieldImageLayout, WhatNiftiDoesNotHoldIsNotWritten)
{
  const TestFolder folder;
  FieldVolume      image = fieldOf(2);
  image.values[3] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(errorOf([&] { writeFieldImage(folder / "a.nii", image); }).find("not finite"), std::string::npos);
  FieldVolume large{ VoxelGrid{}, 1, {} };
  large.size = { { 32768, 1, 1 } };
  large.values.resize(32768);
  EXPECT_NE(errorOf([&] { writeFieldImage(folder / "a.nii", large); }).find("32768"), std::string::npos);
  EXPECT_EQ(folder.fileCount(), 0u);
}

TEST(FieldImageLayout, AFullDiskIsReported)
{
  const TestFolder  folder;
  const FieldVolume image = fieldOf(20);
  EXPECT_TRUE(reportsFullDisk([&] { writeFieldImage(folder / "a.nii", image); }));
  EXPECT_EQ(folder.fileCount(), 0u);
}

TEST(FieldImageLayout, NrrdValuesAlongTheLastAxisAreThoseOfTheFirst)
{
  const TestFolder folder;
  for (const char * kind : { "vector", "list", "3-vector", "RGB-color", "covariant-vector" })
  {
    writeBytes(folder / "a.nrrd",
               nrrdOf("5 4 3 3", std::string("domain domain domain ") + kind, false).header() + planesOf({ 0, 1, 2 }));
    const FieldImage read = readFieldImage(folder / "a.nrrd");
    expectValues(read.volume, 3);
    EXPECT_TRUE(read.valuesToLps);
  }
  writeBytes(folder / "a.nrrd",
             nrrdOf("5 4 3 6", "domain domain domain 3D-symmetric-matrix", false).header() +
               planesOf({ 0, 1, 2, 3, 4, 5 }));
  expectValues(readFieldImage(folder / "a.nrrd").volume, 6);
}

TEST(FieldImageLayout, NrrdValuesAlongTheLastAxisAreThoseThatItkReads)
{
  const TestFolder folder;
  writeBytes(folder / "a.nrrd",
             nrrdOf("5 4 3 3", "domain domain domain vector", false).header() + planesOf({ 0, 1, 2 }));
  const auto theirs = readByOtherReader<itk::NrrdImageIO, std::int16_t>(folder / "a.nrrd", 3);
  EXPECT_EQ(readFieldImage(folder / "a.nrrd").volume.values, std::vector<double>(theirs.begin(), theirs.end()));
}

TEST(FieldImageLayout, NrrdTextAlongTheLastAxisIsRead)
{
  const TestFolder folder;
  std::string      words;
  for (int component = 0; component < 2; ++component)
  {
    for (int voxel = 0; voxel < voxels; ++voxel)
    {
      words += std::to_string(static_cast<int>(valueOf(voxel, component))) + '\n';
    }
  }
  writeBytes(folder / "a.nrrd",
             nrrdOf("5 4 3 2", "domain domain domain list", false).with("encoding", "ascii").header() + words);
  expectValues(readFieldImage(folder / "a.nrrd").volume, 2);
}

TEST(FieldImageLayout, NrrdAxesOfTimeOrTwoAxesOfValuesAreRefused)
{
  const std::string planes = planesOf({ 0, 1, 2 });
  EXPECT_NE(answerTo("a.nrrd", nrrdOf("5 4 3 3", "domain domain domain time", false).header() + planes).find("3-D"),
            std::string::npos);
  EXPECT_NE(answerTo("a.nrrd", nrrdOf("5 4 3 3", "domain domain domain domain", false).header() + planes).find("3-D"),
            std::string::npos);
  const ImageText both = nrrdOf("2 5 4 3 3", "vector domain domain domain vector", true)
                           .with("dimension", "5")
                           .with("space directions", "none (0.5,0,0) (0,0.75,0) (0,0,2) none");
  EXPECT_EQ(answerTo("a.nrrd", both.header() + planes + planes).substr(0, 11), "E_PIXELTYPE");
}

TEST(FieldImageLayout, NrrdMasksAreTakenApart)
{
  const TestFolder folder;
  const auto       odd = [](int voxel) { return voxel % 2; };
  for (const auto & [kind, components] :
       { std::pair("3D-masked-symmetric-matrix", 6), std::pair("3D-masked-matrix", 9) })
  {
    const std::string count = std::to_string(components + 1);
    writeBytes(folder / "a.nrrd",
               nrrdOf(count + " 5 4 3", std::string(kind) + " domain domain domain", true).header() +
                 voxelsWith(odd, components));
    const FieldImage read = readFieldImage(folder / "a.nrrd");
    expectValues(read.volume, components);
    ASSERT_EQ(read.hasValue.size(), static_cast<std::size_t>(voxels));
    for (int voxel = 0; voxel < voxels; ++voxel)
    {
      EXPECT_EQ(read.hasValue[static_cast<std::size_t>(voxel)], voxel % 2);
    }
  }
}

TEST(FieldImageLayout, NrrdMasksAlongTheLastAxisAreTakenApart)
{
  const TestFolder folder;
  std::string      bytes;
  for (int voxel = 0; voxel < voxels; ++voxel)
  {
    append<std::int16_t>(bytes, voxel < 7 ? 1.0 : 0.0, false);
  }
  writeBytes(folder / "a.nrrd",
             nrrdOf("5 4 3 7", "domain domain domain 3D-masked-symmetric-matrix", false).header() + bytes +
               planesOf({ 0, 1, 2, 3, 4, 5 }));
  const FieldImage read = readFieldImage(folder / "a.nrrd");
  expectValues(read.volume, 6);
  EXPECT_EQ(std::count(read.hasValue.begin(), read.hasValue.end(), 1), 7);
  EXPECT_EQ(read.hasValue[6], 1);
}

TEST(FieldImageLayout, NrrdKindsHaveTheirNumberOfValues)
{
  const std::string planes = planesOf({ 0, 1, 2, 3, 4, 5 });
  EXPECT_EQ(
    answerTo("a.nrrd", nrrdOf("6 5 4 3", "3D-masked-symmetric-matrix domain domain domain", true).header() + planes)
      .substr(0, 8),
    "E_HEADER");
  EXPECT_EQ(
    answerTo("a.nrrd", nrrdOf("5 4 3 6", "domain domain domain 3D-matrix", false).header() + planes).substr(0, 8),
    "E_HEADER");
  EXPECT_EQ(answerTo("a.nrrd", nrrdOf("5 4 3 6", "domain domain domain 4D-masked-matrix", false).header() + planes)
              .substr(0, 8),
            "E_HEADER");
}
