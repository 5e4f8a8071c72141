#include "TransferTest.h"

#include "moserhex/CubeTransfer/CubeImage.h"

#include <cmath>
#include <cstring>
#include <fstream>

using namespace moserhex;
using namespace moserhex::app;

namespace
{

/** NRRD text of 32-bit floats over the voxels of `image`, of another number of values each. */
std::string
nrrdLike(const FieldVolume & image, const std::string & kind, const std::vector<float> & values)
{
  const std::size_t count = values.size() / image.gridVoxels();
  std::string       text =
    "NRRD0004\ntype: float\ndimension: 4\nspace: left-posterior-superior\nsizes: " + std::to_string(count) +
    " 50 45 14\nspace directions: none (0.9,0,0) (0,1,0) (0,0,1.7)\nkinds: " + kind +
    " domain domain domain\nendian: little\nencoding: raw\nspace origin: (-2,-2,-1)\n\n";
  return text.append(reinterpret_cast<const char *>(values.data()), values.size() * sizeof(float));
}

} // namespace

TEST_F(TransferCommand, TurnedVectorsComeBackInTheSubjectsAxes)
{
  writeFieldImage(path("vectors.nrrd"), constantImage({ 1.0, 2.0, -2.0 }));
  transfer("vectors.nrrd",
           { "--to-mesh", path("a.vtu"), "--to-image", path("same.nrrd"), "--like", path("smooth.nrrd"), "--rotate" });
  transfer("vectors.nrrd", { "--to-cube", path("cube.nrrd"), "--rotate", "--sampling", "nodes" });
  const FieldVolume same = image("same.nrrd");
  const std::size_t middle = same.voxelNumber(24, 20, 6);
  EXPECT_NEAR(same.at(middle)[0], 1.0, 1e-9);
  EXPECT_NEAR(same.at(middle)[2], -2.0, 1e-9);
  const FieldVolume cube = image("cube.nrrd");
  double            largestTurn = 0.0;
  for (std::size_t node = 0; node < cube.gridVoxels(); ++node)
  {
    const Eigen::Map<const Vector3> vector(cube.at(node));
    EXPECT_NEAR(vector.norm(), 3.0, 1e-12);
    largestTurn = std::max(largestTurn, (vector - Vector3(1.0, 2.0, -2.0)).norm());
  }
  EXPECT_GT(largestTurn, 0.5);
}

TEST_F(TransferCommand, TurnedTensorsStayTensorsAndComeBack)
{
  const std::vector<double> tensor{ 3.0, 0.5, 0.0, 2.0, -0.25, 1.0 };
  writeFieldImage(path("tensors.nrrd"), constantImage(tensor), FieldValues::SymmetricTensors);
  transfer("tensors.nrrd", { "--to-cube", path("cube.nrrd"), "--rotate", "--sampling", "35" });
  transfer("cube.nrrd", { "--to-image", path("back.nrrd"), "--like", path("smooth.nrrd"), "--rotate" });
  EXPECT_NE(contentOf(path("back.nrrd")).find("3D-symmetric-matrix"), std::string::npos);
  const FieldVolume cube = image("cube.nrrd");
  const FieldVolume back = image("back.nrrd");
  const std::size_t middle = back.voxelNumber(24, 20, 6);
  double            largestTurn = 0.0;
  for (std::size_t n = 0; n < tensor.size(); ++n)
  {
    EXPECT_NEAR(back.at(middle)[n], tensor[n], 0.02); // the rotation is a mean over a box
    largestTurn = std::max(largestTurn, std::abs(cube.at(cube.gridVoxels() - 1)[n] - tensor[n]));
  }
  EXPECT_GT(largestTurn, 0.2);
}

TEST_F(TransferCommand, MaskedTensorsHaveNoDataOutsideTheirMask)
{
  const FieldVolume  grid = image("smooth.nrrd");
  std::vector<float> values;
  for (std::size_t voxel = 0; voxel < grid.gridVoxels(); ++voxel)
  {
    const bool isIn = voxel % 50 < 25; // the right half
    values.insert(values.end(), { isIn ? 1.0F : 0.0F, 3.0F, 0.5F, 0.0F, 2.0F, -0.25F, isIn ? 1.0F : 77.0F });
  }
  std::ofstream(path("masked.nrrd"), std::ios::binary) << nrrdLike(grid, "3D-masked-symmetric-matrix", values);
  const Outcome outcome =
    transferOf("masked.nrrd", { "--to-cube", path("cube.nrrd"), "--sampling", "nodes", "--background", "-9" });
  ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_NE(outcome.error.find("beyond the image or its mask"), std::string::npos) << outcome.error;
  const FieldVolume cube = image("cube.nrrd");
  ASSERT_EQ(cube.components, 6);
  std::size_t inside = 0;
  for (std::size_t node = 0; node < cube.gridVoxels(); ++node)
  {
    const bool isIn = m_Mesh.nodes[node][0] < -2.0 + 0.9 * 24.5;
    EXPECT_NEAR(cube.at(node)[0], isIn ? 3.0 : -9.0, 1e-12);
    EXPECT_NEAR(cube.at(node)[5], isIn ? 1.0 : -9.0, 1e-12);
    inside += isIn ? 1 : 0;
  }
  EXPECT_GT(inside, cube.gridVoxels() / 4);
  EXPECT_LT(inside, 3 * cube.gridVoxels() / 4);
}

TEST_F(TransferCommand, AMaskWithoutAnythingOfTheMeshIsRefused)
{
  const FieldVolume  grid = image("smooth.nrrd");
  std::vector<float> values(7 * grid.gridVoxels(), 0.0F);
  std::ofstream(path("masked.nrrd"), std::ios::binary) << nrrdLike(grid, "3D-masked-symmetric-matrix", values);
  expectErrorCode(transferOf("masked.nrrd", { "--to-cube", path("cube.nrrd") }), "E_GEOMETRY");
}

TEST_F(TransferCommand, NiftiVectorsGoToTheCubeAndBack)
{
  writeFieldImage(path("places.nii.gz"), imageOfPositions());
  transfer("places.nii.gz", { "--to-cube", path("cube.nii.gz"), "--sampling", "nodes" });
  const FieldVolume cube = image("cube.nii.gz");
  EXPECT_EQ(cubeSamplingOf(cube), CubeSampling::Nodes);
  for (std::size_t node = 0; node < m_Mesh.nodes.size(); ++node)
  {
    const Eigen::Map<const Vector3> place(cube.at(node));
    EXPECT_LE((place - m_Mesh.nodes[node]).norm(), 1e-5) << node; // the grid's place is single precision
  }
  transfer("cube.nii.gz", { "--to-image", path("back.nii"), "--like", path("smooth.nrrd") });
  const FieldVolume back = image("back.nii");
  const std::size_t middle = back.voxelNumber(24, 20, 6);
  EXPECT_LE((Eigen::Map<const Vector3>(back.at(middle)) - back.point(24, 20, 6)).norm(), 1e-4);
}

TEST_F(TransferCommand, VectorsOfAnUnknownSpaceAreTurnedWhenItIsSaid)
{
  writeFieldImage(path("lps.nii"), constantImage({ 1.0, 2.0, -2.0 }));
  std::string bytes = contentOf(path("lps.nii"));
  bytes.replace(328, 3, 3, '\0'); // intent_name
  std::ofstream(path("unknown.nii"), std::ios::binary) << bytes;
  writeFieldImage(path("ras.nrrd"), constantImage({ -1.0, -2.0, -2.0 }));
  const Outcome outcome = transferOf("unknown.nii", { "--rotate", "--to-cube", path("a.nrrd") });
  expectErrorCode(outcome, "E_GEOMETRY");
  EXPECT_NE(outcome.error.find("--values-in"), std::string::npos) << outcome.error;

  transfer("unknown.nii", { "--rotate", "--to-cube", path("a.nrrd"), "--values-in", "LPS" });
  transfer("lps.nii", { "--rotate", "--to-cube", path("b.nrrd") });
  transfer("ras.nrrd", { "--rotate", "--to-cube", path("c.nrrd"), "--values-in", "RAS" });
  EXPECT_EQ(image("a.nrrd").values, image("b.nrrd").values);
  EXPECT_EQ(image("a.nrrd").values, image("c.nrrd").values);
  expectErrorCode(transferOf("lps.nii", { "--to-cube", path("d.nrrd"), "--values-in", "LPS" }), "E_USAGE");
}

TEST_F(TransferCommand, NumbersThatAreNotFiniteAreNoDataInEveryFormat)
{
  const FieldVolume  grid = image("smooth.nrrd");
  std::vector<float> values(grid.gridVoxels(), 3.0F);
  for (std::size_t voxel = 0; voxel < values.size(); ++voxel)
  {
    if (voxel % 50 >= 25) // the left half
    {
      values[voxel] = voxel % 2 == 0 ? std::nanf("") : HUGE_VALF;
    }
  }
  const std::string voxels(reinterpret_cast<const char *>(values.data()), values.size() * sizeof(float));
  std::ofstream(path("a.nrrd"), std::ios::binary)
    << "NRRD0004\ntype: float\ndimension: 3\nspace: left-posterior-superior\nsizes: 50 45 14\n"
       "space directions: (0.9,0,0) (0,1,0) (0,0,1.7)\nkinds: domain domain domain\nendian: little\n"
       "encoding: raw\nspace origin: (-2,-2,-1)\n\n"
    << voxels;
  std::ofstream(path("a.mha"), std::ios::binary)
    << "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
       "TransformMatrix = 1 0 0 0 1 0 0 0 1\nOffset = -2 -2 -1\nElementSpacing = 0.9 1 1.7\nDimSize = 50 45 14\n"
       "ElementType = MET_FLOAT\nElementDataFile = LOCAL\n"
    << voxels;
  writeFieldImage(path("a.nii"), grid);
  std::string nifti = contentOf(path("a.nii")).substr(0, 352) + voxels;
  nifti[70] = 16; // 32-bit real numbers
  nifti[72] = 32;
  std::ofstream(path("a.nii"), std::ios::binary) << nifti;
  std::vector<double> first;
  for (const char * name : { "a.nrrd", "a.mha", "a.nii" })
  {
    const Outcome outcome = transferOf(name, { "--to-cube", path("c.nrrd"), "--background", "-9" });
    ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
    EXPECT_NE(outcome.error.find("voxels are not finite numbers"), std::string::npos) << outcome.error;
    EXPECT_NE(outcome.error.find("% of the mesh lies beyond the image or its mask, or on voxels that are not finite"),
              std::string::npos)
      << outcome.error;
    const FieldVolume cube = image("c.nrrd");
    EXPECT_NEAR(cube.values[0], 3.0, 1e-9) << name;
    EXPECT_NEAR(cube.values[6], -9.0, 1e-9) << name;
    first = first.empty() ? cube.values : first;
    for (std::size_t box = 0; box < first.size(); ++box)
    {
      EXPECT_NEAR(cube.values[box], first[box], 0.01) << name << ' ' << box; // the place of NIfTI is single precision
    }
  }
}

TEST_F(TransferCommand, AListOfSixNumbersIsNoTensor)
{
  const FieldVolume list = constantImage({ 1.0, 2.0, 3.0, 4.0, 5.0, 6.0 });
  writeFieldImage(path("list.nrrd"), list);
  transfer("list.nrrd", { "--to-cube", path("cube.nrrd") });
  EXPECT_EQ(contentOf(path("cube.nrrd")).find("3D-symmetric-matrix"), std::string::npos);
  transfer("list.nrrd", { "--to-cube", path("cube.nii") });
  const std::string nifti = contentOf(path("cube.nii"));
  constexpr int     vectors = 1007;
  EXPECT_EQ(static_cast<unsigned char>(nifti[68]) + 256 * static_cast<unsigned char>(nifti[69]), vectors);
  for (std::size_t plane = 0; plane < 6; ++plane)
  {
    double value = 0.0;
    std::memcpy(&value, nifti.data() + 352 + plane * 343 * sizeof value, sizeof value);
    EXPECT_NEAR(value, static_cast<double>(plane) + 1.0, 1e-12);
  }
  writeFieldImage(path("tensors.nii"), list, FieldValues::SymmetricTensors);
  transfer("tensors.nii", { "--to-cube", path("cube.nrrd") });
  EXPECT_NE(contentOf(path("cube.nrrd")).find("3D-symmetric-matrix"), std::string::npos);
}

TEST_F(TransferCommand, TheMeasurementFrameIsWhereTheNumbersAre)
{
  const auto withFrame = [this](const std::string & frame, const std::vector<float> & vector) {
    const FieldVolume  grid = image("smooth.nrrd");
    std::vector<float> values;
    for (std::size_t voxel = 0; voxel < grid.gridVoxels(); ++voxel)
    {
      values.insert(values.end(), vector.begin(), vector.end());
    }
    std::string text = nrrdLike(grid, "vector", values);
    return text.insert(text.find("endian"), frame);
  };
  std::ofstream(path("lps.nrrd"), std::ios::binary) << withFrame("", { 1.0F, 2.0F, -2.0F });
  // The first axis of the frame is the second one of the image, and so on.
  std::ofstream(path("framed.nrrd"), std::ios::binary)
    << withFrame("measurement frame: (0,1,0) (0,0,1) (1,0,0)\n", { 2.0F, -2.0F, 1.0F });
  transfer("lps.nrrd", { "--to-cube", path("lps_cube.nrrd"), "--rotate" });
  transfer("framed.nrrd", { "--to-cube", path("framed_cube.nrrd"), "--rotate" });
  EXPECT_EQ(image("lps_cube.nrrd").values, image("framed_cube.nrrd").values);
}

TEST_F(TransferCommand, WhatIsWrittenSaysInWhichAxesItsVectorsAre)
{
  writeFieldImage(path("lps.nii"), constantImage({ 1.0, 2.0, -2.0 }));
  std::string bytes = contentOf(path("lps.nii"));
  bytes.replace(328, 3, 3, '\0'); // intent_name: their space is unknown
  std::ofstream(path("unknown.nii"), std::ios::binary) << bytes;
  const std::vector<std::string> toB{ "--to-mesh", path("b.vtu"), "--like", path("smooth.nrrd"), "--to-image" };
  for (const char * name : { "copy.nii", "copy.nrrd" })
  {
    std::vector<std::string> options = toB;
    options.push_back(path(name));
    transfer("unknown.nii", options);
    expectErrorCode(transferOf(name, { "--rotate", "--to-cube", path("c.nrrd") }), "E_GEOMETRY");
  }
  // The first axis of the measurement frame is the second one of the image, and so on.
  std::string text = nrrdLike(image("smooth.nrrd"), "vector", std::vector<float>(3 * 50 * 45 * 14, 0.0F));
  text = text.substr(0, text.find("\n\n") + 2);
  for (int voxel = 0; voxel < 50 * 45 * 14; ++voxel)
  {
    const float vector[3] = { 2.0F, -2.0F, 1.0F };
    text.append(reinterpret_cast<const char *>(vector), sizeof vector);
  }
  std::ofstream(path("framed.nrrd"), std::ios::binary)
    << text.insert(text.find("endian"), "measurement frame: (0,1,0) (0,0,1) (1,0,0)\n");
  transfer("framed.nrrd", { "--to-cube", path("plain.nrrd"), "--sampling", "nodes" });
  const FieldVolume plain = image("plain.nrrd");
  EXPECT_NEAR(plain.values[0], 2.0, 1e-12); // each number by itself: it may be a list
  EXPECT_NEAR(plain.values[1], -2.0, 1e-12);
  EXPECT_NEAR(plain.values[2], 1.0, 1e-12);
  std::vector<std::string> toFramed = toB;
  toFramed.push_back(path("copied.nrrd"));
  transfer("framed.nrrd", toFramed);
  expectErrorCode(transferOf("copied.nrrd", { "--rotate", "--to-cube", path("c.nrrd") }), "E_GEOMETRY");
}

TEST_F(TransferCommand, VectorsInTheCubesAxesLeaveItTurnedBackOnly)
{
  writeFieldImage(path("vectors.nrrd"), constantImage({ 1.0, 2.0, -2.0 }));
  for (const char * cube : { "cube.nrrd", "cube.nii" })
  {
    transfer("vectors.nrrd", { "--to-cube", path(cube), "--rotate" });
    const std::vector<std::string> back{ "--to-image", path("back.nrrd"), "--like", path("smooth.nrrd") };
    expectErrorCode(transferOf(cube, back), "E_GEOMETRY");
    std::vector<std::string> turned = back;
    turned.emplace_back("--rotate");
    transfer(cube, turned);
    transfer("back.nrrd", { "--to-cube", path("again.nrrd"), "--rotate" }); // is in LPS again
  }
  transfer("vectors.nrrd", { "--to-cube", path("plain.nrrd") });
  const Outcome outcome =
    transferOf("plain.nrrd", { "--to-image", path("back.nrrd"), "--like", path("smooth.nrrd"), "--rotate" });
  EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_NE(outcome.error.find("does not say that its vectors or tensors are in the cube's axes"), std::string::npos)
    << outcome.error;
}

TEST_F(TransferCommand, TheBackgroundIsNotTurned)
{
  FieldVolume half = constantImage({ 1.0, 2.0, -2.0 });
  half.origin[0] -= 25.0;
  writeFieldImage(path("half.nrrd"), half);
  ASSERT_EQ(transferOf("half.nrrd",
                       { "--to-mesh",
                         path("b.vtu"),
                         "--to-image",
                         path("out.nrrd"),
                         "--like",
                         path("smooth.nrrd"),
                         "--rotate",
                         "--background",
                         "-9" })
              .exitCode,
            0);
  const FieldVolume out = image("out.nrrd");
  std::size_t       turned = 0;
  for (std::size_t voxel = 0; voxel < out.gridVoxels(); ++voxel)
  {
    const Eigen::Map<const Vector3> vector(out.at(voxel));
    const bool                      isBackground = vector == Vector3::Constant(-9.0);
    EXPECT_TRUE(isBackground || std::abs(vector.norm() - 3.0) < 1e-9) << vector.transpose();
    turned += isBackground ? 0 : 1;
  }
  EXPECT_GT(turned, 500u);
}
