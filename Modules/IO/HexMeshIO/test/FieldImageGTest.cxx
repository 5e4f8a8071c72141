// Exact: values of a file that stores doubles, refusals. Places to 1e-6 mm.
#include "moserhex/HexMeshIO/FieldImageReader.h"
#include "moserhex/HexMeshIO/FieldImageWriter.h"

#include "TestErrors.h"
#include "TestFolder.h"
#include "moserhex/Analytic/SolidShapes.h"
#include "moserhex/HexMeshIO/LabelImageReader.h"
#include "moserhex/HexMeshIO/ScalarImageReader.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>

using namespace moserhex;

namespace
{

/** Oblique and anisotropic, value n / 8 of number n. */
FieldVolume
fieldOf(int components)
{
  FieldVolume image;
  image.size = { { 5, 4, 3 } };
  image.spacing = { 0.5, 0.75, 3.0 };
  image.origin = { -7.0, 3.0, 13.0 };
  image.direction = analytic::obliqueDirection();
  image.components = components;
  for (int n = 0; n < 60 * components; ++n)
  {
    image.values.push_back(n / 8.0);
  }
  return image;
}

std::string
nrrd(const std::string & fields, std::size_t bytes)
{
  return "NRRD0004\ntype: uint8\nencoding: raw\nspace: left-posterior-superior\n" + fields + "\n" +
         std::string(bytes, '\1');
}

constexpr const char * vectorsOfThree = "dimension: 4\nsizes: 3 2 2 2\n"
                                        "space directions: none (1,0,0) (0,1,0) (0,0,1)\nkinds: vector domain domain "
                                        "domain\n";

/** "accepted", or the message of readFieldImage. */
std::string
answerTo(const std::string & fileName, const std::string & content)
{
  const TestFolder folder;
  writeBytes(folder / fileName, content);
  return errorOf([&] { (void)readFieldImage(folder / fileName); });
}

} // namespace

TEST(FieldImage, ComesBackAsWritten)
{
  const TestFolder folder;
  for (const int components : { 1, 2, 3, 6, 9 })
  {
    const FieldVolume image = fieldOf(components);
    writeFieldImage(folder / "a.nrrd", image, components == 6 ? FieldValues::SymmetricTensors : FieldValues::Numbers);
    const FieldImage read = readFieldImage(folder / "a.nrrd");
    EXPECT_EQ(read.volume.components, components);
    EXPECT_EQ(read.volume.values, image.values);
    EXPECT_LE((read.volume.origin - image.origin).norm(), 1e-6);
    EXPECT_TRUE(read.volume.direction.isApprox(image.direction, 1e-6));
    EXPECT_TRUE(read.valuesToLps);
    EXPECT_FALSE(read.inCubeAxes);
    EXPECT_TRUE(read.warnings.empty());
  }
}

TEST(FieldImage, WhatVoxelsAreStandsInTheHeader)
{
  const TestFolder folder;
  writeFieldImage(folder / "a.nrrd", fieldOf(3));
  EXPECT_NE(readBytes(folder / "a.nrrd").find("kinds: vector domain"), std::string::npos);
  writeFieldImage(folder / "a.nrrd", fieldOf(6), FieldValues::SymmetricTensors);
  EXPECT_NE(readBytes(folder / "a.nrrd").find("kinds: 3D-symmetric-matrix domain"), std::string::npos);
}

TEST(FieldImage, NumbersThatAreNoneAreKept)
{
  const TestFolder folder;
  FieldVolume      image = fieldOf(2);
  image.values[3] = std::numeric_limits<double>::quiet_NaN();
  image.values[4] = -std::numeric_limits<double>::infinity();
  writeFieldImage(folder / "a.nrrd", image);
  const FieldImage read = readFieldImage(folder / "a.nrrd");
  EXPECT_TRUE(std::isnan(read.volume.values[3]));
  EXPECT_EQ(read.volume.values[4], image.values[4]);
}

TEST(FieldImage, VoxelsThatAreNotFiniteAreWithoutData)
{
  const TestFolder folder;
  FieldVolume      image = fieldOf(2);
  image.values[3] = std::numeric_limits<double>::quiet_NaN();
  image.values[4] = std::numeric_limits<double>::infinity();
  writeFieldImage(folder / "a.nrrd", image);
  const FieldImage           read = readFieldImage(folder / "a.nrrd");
  std::vector<unsigned char> expected(60, 1);
  expected[1] = 0;
  expected[2] = 0;
  EXPECT_EQ(read.hasValue, expected);
  ASSERT_EQ(read.warnings.size(), 1u);
  EXPECT_NE(read.warnings[0].find("2 voxels are not finite"), std::string::npos) << read.warnings[0];
}

TEST(FieldImage, LabelsAreALabelmap)
{
  const TestFolder folder;
  FieldVolume      image = fieldOf(1);
  for (double & value : image.values)
  {
    value = value < 3.0 ? 0.0 : 70000.0;
  }
  writeFieldImage(folder / "a.nrrd", image, FieldValues::Labels);
  const LabelImage read = readLabelImage(folder / "a.nrrd");
  ASSERT_EQ(read.labels.size(), 1u);
  EXPECT_EQ(read.labels[0].value, 70000);
  EXPECT_EQ(read.labels[0].voxels, 36u);
  for (const double wrong : { -1.0, 0.5, 3e9, std::numeric_limits<double>::quiet_NaN() })
  {
    image.values[7] = wrong;
    EXPECT_THROW(writeFieldImage(folder / "b.nrrd", image, FieldValues::Labels), InvalidInput) << wrong;
  }
  EXPECT_THROW(writeFieldImage(folder / "b.nrrd", fieldOf(2), FieldValues::Labels), InvalidInput);
  EXPECT_THROW(writeFieldImage(folder / "b.nrrd", fieldOf(3), FieldValues::SymmetricTensors), InvalidInput);
  EXPECT_THROW(writeFieldImage(folder / "b.mha", fieldOf(1)), BadInput);
  EXPECT_FALSE(std::ifstream(folder / "b.nrrd"));
}

TEST(FieldImage, MetaImageChannelsAreComponents)
{
  const std::string head = "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
                           "ElementSpacing = 1 1 2\nDimSize = 2 2 2\nElementNumberOfChannels = 3\n"
                           "ElementType = MET_UCHAR\nElementDataFile = LOCAL\n";
  const TestFolder  folder;
  std::string       voxels;
  for (char n = 0; n < 24; ++n)
  {
    voxels += n;
  }
  writeBytes(folder / "a.mha", head + voxels);
  const FieldImage read = readFieldImage(folder / "a.mha");
  EXPECT_EQ(read.volume.components, 3);
  EXPECT_EQ(read.volume.at(1)[2], 5.0);
  EXPECT_EQ(read.volume.at(7)[0], 21.0);
  EXPECT_NE(answerTo("a.mha", head + voxels.substr(1)).find("ends early"), std::string::npos);
  EXPECT_NE(errorOf([&] { (void)readScalarImage(folder / "a.mha"); }).find("need a scalar image"), std::string::npos);
  EXPECT_NE(errorOf([&] { (void)readLabelImage(folder / "a.mha"); }).find("need a scalar image"), std::string::npos);
}

TEST(FieldImage, OnlyThisReaderTakesSeveralNumbersAVoxel)
{
  const TestFolder folder;
  writeBytes(folder / "a.nrrd", nrrd(vectorsOfThree, 24));
  EXPECT_EQ(readFieldImage(folder / "a.nrrd").volume.components, 3);
  EXPECT_NE(errorOf([&] { (void)readScalarImage(folder / "a.nrrd"); }).find("need one"), std::string::npos);
  EXPECT_NE(errorOf([&] { (void)readLabelImage(folder / "a.nrrd"); }).find("need one"), std::string::npos);
}

TEST(FieldImage, DamagedAndOtherFilesAreRefused)
{
  EXPECT_NE(answerTo("a.nrrd", nrrd(vectorsOfThree, 23)).find("ends early"), std::string::npos);
  const auto axes = [](const char * sizes, const char * kinds, const char * directions) {
    return nrrd(std::string("dimension: 4\nsizes: ") + sizes + "\nspace directions: " + directions +
                  "\nkinds: " + kinds + "\n",
                56);
  };
  const char * first = "none (1,0,0) (0,1,0) (0,0,1)";
  EXPECT_NE(answerTo("a.nrrd", axes("7 2 2 2", "time domain domain domain", first)).find("3-D"), std::string::npos);
  EXPECT_NE(answerTo("a.nrrd", axes("5000 2 2 2", "list domain domain domain", first)).find("3-D"), std::string::npos);
}

TEST(FieldImage, TheMeasurementFrameLeadsToLps)
{
  const TestFolder folder;
  const auto       readWith = [&folder](const std::string & frame, const std::string & space) {
    std::string text = nrrd(vectorsOfThree + frame, 24);
    text.replace(text.find("left-posterior-superior"), 23, space);
    writeBytes(folder / "a.nrrd", text);
    return readFieldImage(folder / "a.nrrd").valuesToLps;
  };
  const std::string lps = "left-posterior-superior";
  const std::string identity = "measurement frame: (1,0,0) (0,1,0) (0,0,1)\n";
  EXPECT_EQ(*readWith(identity, lps), Matrix3(Matrix3::Identity()));
  EXPECT_EQ(*readWith(identity, "right-anterior-superior"), Matrix3(Vector3(-1.0, -1.0, 1.0).asDiagonal()));
  Matrix3 turned;
  turned << 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0;
  EXPECT_EQ(*readWith("measurement frame: (0,1,0) (0,0,1) (1,0,0)\n", lps), turned); // columns
  EXPECT_FALSE(readWith("", "right-anterior-superior"));
  EXPECT_FALSE(readWith("measurement frame: (1,0,0) (1,0,0) (0,0,1)\n", lps));
}

TEST(FieldImage, OnlyTensorsAreTensors)
{
  const TestFolder folder;
  for (const char * name : { "a.nrrd", "a.nii" })
  {
    writeFieldImage(folder / name, fieldOf(6), FieldValues::SymmetricTensors);
    EXPECT_EQ(readFieldImage(folder / name).kind, FieldValues::SymmetricTensors) << name;
    writeFieldImage(folder / name, fieldOf(6));
    EXPECT_EQ(readFieldImage(folder / name).kind, FieldValues::Numbers) << name;
  }
}

TEST(FieldImage, TheAxesOfVectorsComeBack)
{
  const TestFolder  folder;
  const FieldVolume vectors{ VoxelGrid{ { { 2, 2, 2 } } }, 3, std::vector<double>(24, 1.0) };
  for (const char * name : { "a.nrrd", "a.nii" })
  {
    writeFieldImage(folder / name, vectors, FieldValues::Numbers, ValueAxes::Cube);
    EXPECT_TRUE(readFieldImage(folder / name).inCubeAxes) << name;
    EXPECT_FALSE(readFieldImage(folder / name).valuesToLps) << name;
    writeFieldImage(folder / name, vectors, FieldValues::Numbers, ValueAxes::Unknown);
    EXPECT_FALSE(readFieldImage(folder / name).inCubeAxes) << name;
    EXPECT_FALSE(readFieldImage(folder / name).valuesToLps) << name;
    writeFieldImage(folder / name, vectors);
    EXPECT_EQ(readFieldImage(folder / name).valuesToLps, Matrix3(Matrix3::Identity())) << name;
  }
}
