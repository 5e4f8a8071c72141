#include "TransferTest.h"

#include <cstdio>
#include <cstring>
#include <fstream>

using namespace moserhex;
using namespace moserhex::app;

TEST_F(TransferCommand, LabelsGoToMostOfACellAndBack)
{
  writeFieldImage(path("labels.nrrd"),
                  imageOf(1,
                          [](const Vector3 & p, std::vector<double> & values) {
                            values.push_back(p[0] < 14.0 ? 0.0 : p[0] < 24.0 ? 3.0 : 300.0);
                          }),
                  FieldValues::Labels);
  transfer("labels.nrrd", { "--to-cube", path("cube.nrrd"), "--labels" });
  transfer("labels.nrrd", { "--to-cube", path("parts.nrrd"), "--labels", "--fractions" });
  const FieldVolume cube = image("cube.nrrd");
  const FieldVolume parts = image("parts.nrrd");
  ASSERT_EQ(parts.components, 2);
  EXPECT_EQ(cube.values[0], 0.0);
  EXPECT_EQ(cube.values[3], 3.0);
  EXPECT_EQ(cube.values[6], 300.0);
  EXPECT_NEAR(parts.at(3)[0], 1.0, 1e-12);
  EXPECT_NEAR(parts.at(4)[0] + parts.at(4)[1], 1.0, 1e-12);
  EXPECT_NEAR(parts.at(0)[0] + parts.at(0)[1], 0.0, 1e-12);
  transfer("cube.nrrd", { "--to-image", path("back.nrrd"), "--like", path("labels.nrrd"), "--labels" });
  for (const double value : image("back.nrrd").values)
  {
    EXPECT_TRUE(value == 0.0 || value == 3.0 || value == 300.0) << value;
  }
}

namespace
{

/** 1 nearly everywhere, 2 in one voxel in the middle of the bar. */
void
withSmallLabel(const Vector3 & p, std::vector<double> & values)
{
  values.push_back((p - Vector3(19.6, 15.0, 9.2)).cwiseAbs().maxCoeff() < 0.45 ? 2.0 : 1.0);
}

} // namespace

TEST_F(TransferCommand, ALabelThatHasNoPlaceAnyMoreIsAWarning)
{
  writeFieldImage(path("labels.nrrd"), imageOf(1, withSmallLabel), FieldValues::Labels);
  const auto with = [this](std::vector<std::string> options) {
    options.emplace_back("--labels");
    return transferOf("labels.nrrd", options);
  };
  const Outcome cells = with({ "--to-cube", path("cube.nrrd") });
  EXPECT_EQ(cells.exitCode, 0) << cells.error;
  EXPECT_NE(cells.error.find("label 2 has "), std::string::npos) << cells.error;
  EXPECT_NE(
    cells.error.find(" mm3 in the organ, but is in no box of the cube; take --sampling N above 7, or --fractions"),
    std::string::npos)
    << cells.error;
  double             before = 0.0;
  double             after = -1.0;
  const char * const line = std::strstr(cells.out.c_str(), "label 2: ");
  ASSERT_NE(line, nullptr) << cells.out;
  ASSERT_EQ(std::sscanf(line, "label 2: %lf mm3 in the organ, %lf mm3 in the cube", &before, &after), 2) << line;
  EXPECT_NEAR(before, 0.9 * 1.0 * 1.7, 0.8); // a voxel, by some 16 points in it
  EXPECT_EQ(after, 0.0);
  EXPECT_EQ(with({ "--to-cube", path("cube.nrrd"), "--fractions" }).error, "");
  EXPECT_EQ(with({ "--to-cube", path("cube.nrrd"), "--sampling", "60" }).error, "");
  EXPECT_NE(with({ "--to-cube", path("cube.nrrd"), "--sampling", "nodes" }).error.find("in no node of the cube"),
            std::string::npos);
  const std::vector<std::string> coarse{ "--to-mesh", path("b.vtu"), "--to-image", path("out.nrrd"), "--spacing", "7" };
  EXPECT_NE(with(coarse).error.find("in no voxel; take smaller voxels"), std::string::npos);
}

TEST_F(TransferCommand, AnEmptyLabelmapIsTransferred)
{
  writeFieldImage(path("labels.nrrd"), constantImage({ 0.0 }), FieldValues::Labels);
  const Outcome outcome = transferOf("labels.nrrd", { "--labels", "--to-cube", path("cube.nrrd") });
  EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_NE(outcome.error.find("no voxel differs from 0"), std::string::npos) << outcome.error;
  EXPECT_EQ(image("cube.nrrd").values, std::vector<double>(343, 0.0));
}

TEST_F(TransferCommand, BeyondTheImageIsTheLabelOfTheBackground)
{
  FieldVolume half = constantImage({ 3.0 });
  half.origin[0] -= 25.0;
  writeFieldImage(path("half.nrrd"), half, FieldValues::Labels);
  const auto with = [this](std::vector<std::string> options) {
    options.emplace_back("--labels");
    return transferOf("half.nrrd", options);
  };
  ASSERT_EQ(with({ "--to-cube", path("cube.nrrd"), "--background", "7" }).exitCode, 0);
  const FieldVolume cube = image("cube.nrrd");
  EXPECT_EQ(cube.values[0], 3.0);
  EXPECT_EQ(cube.values[6], 7.0);
  ASSERT_EQ(with({ "--to-cube", path("parts.nrrd"), "--background", "7", "--fractions" }).exitCode, 0);
  const FieldVolume parts = image("parts.nrrd");
  ASSERT_EQ(parts.components, 2); // of 3 and 7
  EXPECT_NEAR(parts.at(6)[1], 1.0, 1e-12);
  expectErrorCode(with({ "--to-cube", path("no.nrrd"), "--background", "0.5" }), "E_USAGE");
  expectErrorCode(with({ "--to-cube", path("no.nrrd"), "--background", "-1" }), "E_USAGE");
}

TEST_F(TransferCommand, OneSegmentIsTakenByItsName)
{
  std::string text = "NRRD0004\ntype: uint8\ndimension: 3\nspace: left-posterior-superior\nsizes: 50 45 14\n"
                     "space directions: (0.9,0,0) (0,1,0) (0,0,1.7)\nkinds: domain domain domain\n"
                     "encoding: raw\nspace origin: (-2,-2,-1)\n"
                     "Segment0_ID:=S1\nSegment0_Name:=gland\nSegment0_LabelValue:=1\nSegment0_Layer:=0\n"
                     "Segment1_ID:=S2\nSegment1_Name:=lesion\nSegment1_LabelValue:=2\nSegment1_Layer:=0\n\n";
  for (std::size_t voxel = 0; voxel < std::size_t{ 50 } * 45 * 14; ++voxel)
  {
    text += voxel % 50 < 25 ? '\1' : '\2';
  }
  std::ofstream(path("a.seg.nrrd"), std::ios::binary) << text;
  const Outcome outcome =
    transferOf("a.seg.nrrd", { "--labels", "--segment", "lesion", "--to-cube", path("cube.nrrd") });
  ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_NE(outcome.out.find("label 2 (lesion): "), std::string::npos) << outcome.out;
  EXPECT_EQ(image("cube.nrrd").values[0], 0.0);
  EXPECT_EQ(image("cube.nrrd").values[6], 2.0);
}

TEST_F(TransferCommand, LabelsElsewhereInTheImageDoNotCount)
{
  // 300 labels in the first row of voxels, far from the bar, and label 1 around it.
  FieldVolume many = constantImage({ 1.0 });
  for (std::size_t voxel = 0; voxel < 40; ++voxel)
  {
    many.values[voxel] = 100.0 + static_cast<double>(voxel);
    many.values[50 + voxel] = 200.0 + static_cast<double>(voxel);
    many.values[45 * 50 + voxel] = 300.0 + static_cast<double>(voxel);
    many.values[46 * 50 + voxel] = 400.0 + static_cast<double>(voxel);
    many.values[2 * 45 * 50 + voxel] = 500.0 + static_cast<double>(voxel);
    many.values[(2 * 45 + 1) * 50 + voxel] = 600.0 + static_cast<double>(voxel);
    many.values[(2 * 45 + 2) * 50 + voxel] = 700.0 + static_cast<double>(voxel);
  }
  writeFieldImage(path("many.nrrd"), many, FieldValues::Labels);
  for (const char * sampling : { "cells", "nodes" })
  {
    const Outcome outcome =
      transferOf("many.nrrd", { "--labels", "--to-cube", path("c.nrrd"), "--sampling", sampling });
    EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
    EXPECT_NE(outcome.out.find("label 1: "), std::string::npos) << outcome.out;
    EXPECT_EQ(outcome.out.find("label 100: "), std::string::npos) << outcome.out;
  }
}
