// The contract of a module of 3D Slicer, by running the program as Slicer does. What transfers do is tested with the
// command.
#include "CommandTest.h"
#include "ModuleDescription.h"
#include "moserhex/HexMeshIO/FieldImageReader.h"
#include "moserhex/HexMeshIO/HexMeshWriter.h"

#include <filesystem>
#include <fstream>

using namespace moserhex;
using namespace moserhex::app;

namespace
{

namespace fs = std::filesystem;

/** With a box within the sample's gland as its mesh. */
class MoserHexTransfer : public CommandTest
{
protected:
  void
  SetUp() override
  {
    CommandTest::SetUp();
    writeSample();
    HexMesh mesh;
    mesh.nodesPerSide = 4;
    for (int node = 0; node < 64; ++node)
    {
      mesh.nodes.emplace_back(-2.0 + 3.0 * (node % 4), -26.0 + 3.0 * (node / 4 % 4), 9.0 + 3.0 * (node / 16));
    }
    writeHexMesh(path("mesh.vtk"), mesh);
  }
};

} // namespace

TEST_F(MoserHexTransfer, XmlIsTheFileBesideItAndNothingElse)
{
  const Outcome outcome = run({ "--xml" });
  EXPECT_EQ(outcome.exitCode, 0);
  EXPECT_EQ(outcome.error, "");
  EXPECT_EQ(outcome.out, contentOf(MOSERHEX_MODULE_XML));
  EXPECT_EQ(slicer::parseModuleDescription(outcome.out).category, "Segmentation.Meshing");
  EXPECT_EQ(fs::path(MOSERHEX_EXECUTABLE).filename().string(), "MoserHexTransfer");
}

TEST_F(MoserHexTransfer, GoesToTheCubeBackAndToAnotherSubject)
{
  const Outcome there = run({ path("prostate.nrrd"), path("mesh.vtk"), path("cube.nrrd"), "--labels" });
  ASSERT_EQ(there.exitCode, 0) << there.error;
  EXPECT_EQ(there.error, "");
  EXPECT_NE(there.out.find("<filter-progress>1.000</filter-progress>"), std::string::npos);
  EXPECT_EQ(readFieldImage(path("cube.nrrd")).volume.values, std::vector<double>(27, 1.0));

  const Outcome back = run({ path("cube.nrrd"),
                             path("mesh.vtk"),
                             path("back.nrrd"),
                             "--direction",
                             "from-cube",
                             "--reference",
                             path("prostate.nrrd"),
                             "--labels" });
  ASSERT_EQ(back.exitCode, 0) << back.error;
  const Outcome other = run({ path("prostate.nrrd"),
                              path("mesh.vtk"),
                              path("other.nrrd"),
                              "--direction",
                              "to-subject",
                              "--otherMesh",
                              path("mesh.vtk"),
                              "--reference",
                              path("prostate.nrrd"),
                              "--labels" });
  ASSERT_EQ(other.exitCode, 0) << other.error;
  EXPECT_EQ(readFieldImage(path("other.nrrd")).volume.values, readFieldImage(path("back.nrrd")).volume.values);
}

TEST_F(MoserHexTransfer, ImagesOfAnyTypeCanBeChosen)
{
  const std::string xml = run({ "--xml" }).out;
  std::size_t       images = 0;
  for (std::size_t at = xml.find("<image"); at != std::string::npos; at = xml.find("<image", at + 1))
  {
    EXPECT_EQ(xml.compare(at, 18, "<image type=\"any\">"), 0) << xml.substr(at, 30);
    ++images;
  }
  EXPECT_EQ(images, 3u);
}

TEST_F(MoserHexTransfer, WhatIsLeftFromAnotherDirectionIsLeftOut)
{
  const Outcome there = run({ path("prostate.nrrd"),
                              path("mesh.vtk"),
                              path("cube.nrrd"),
                              "--labels",
                              "--reference",
                              path("prostate.nrrd"),
                              "--valuesIn",
                              "RAS" });
  ASSERT_EQ(there.exitCode, 0) << there.error;
  EXPECT_EQ(there.error, "");
  EXPECT_NE(there.out.find("warning: the reference image has no part in this"), std::string::npos) << there.out;
  EXPECT_NE(there.out.find("warning: the space of vectors and tensors has no part"), std::string::npos) << there.out;
  const Outcome back = run({ path("cube.nrrd"),
                             path("mesh.vtk"),
                             path("back.nrrd"),
                             "--direction",
                             "from-cube",
                             "--reference",
                             path("prostate.nrrd"),
                             "--labels",
                             "--sampling",
                             "40" });
  ASSERT_EQ(back.exitCode, 0) << back.error;
  EXPECT_NE(back.out.find("warning: the sampling of the cube has no part"), std::string::npos) << back.out;
}

TEST_F(MoserHexTransfer, VectorsAreTurnedFromTheSpaceThatIsSaid)
{
  // As Slicer writes them: with a measurement frame; and without one, in RAS.
  const auto vectors = [](const std::string & space, const std::string & frame, const std::vector<float> & vector) {
    std::string text = "NRRD0004\ntype: float\ndimension: 4\nspace: " + space +
                       "\nsizes: 3 8 8 8\nspace directions: none (4,0,0) (0,4,0) (0,0,4)\n"
                       "kinds: vector domain domain domain\nendian: little\nencoding: raw\n"
                       "space origin: (-12,-34,0)\n" +
                       frame + "\n";
    for (int voxel = 0; voxel < 512; ++voxel)
    {
      text.append(reinterpret_cast<const char *>(vector.data()), vector.size() * sizeof(float));
    }
    return text;
  };
  const std::string identity = "measurement frame: (1,0,0) (0,1,0) (0,0,1)\n";
  std::ofstream(path("framed.nrrd"), std::ios::binary)
    << vectors("left-posterior-superior", identity, { 1.0F, 2.0F, -2.0F });
  std::ofstream(path("said.nrrd"), std::ios::binary) << vectors("left-posterior-superior", "", { -1.0F, -2.0F, -2.0F });
  const Outcome framed = run({ path("framed.nrrd"), path("mesh.vtk"), path("a.nrrd"), "--rotate" });
  ASSERT_EQ(framed.exitCode, 0) << framed.error;
  const Outcome said = run({ path("said.nrrd"), path("mesh.vtk"), path("b.nrrd"), "--rotate", "--valuesIn", "RAS" });
  ASSERT_EQ(said.exitCode, 0) << said.error;
  EXPECT_EQ(readFieldImage(path("a.nrrd")).volume.values, readFieldImage(path("b.nrrd")).volume.values);
}

TEST_F(MoserHexTransfer, RefusesInOneLine)
{
  const std::vector<std::string> files{ path("prostate.nrrd"), path("mesh.vtk"), path("out.nrrd") };
  const auto                     with = [&](std::vector<std::string> options) {
    options.insert(options.end(), files.begin(), files.end());
    return run(options);
  };
  expectErrorCode(with({ "--direction", "to-subject" }), "E_USAGE");
  expectErrorCode(with({ "--otherMesh", path("mesh.vtk") }), "E_USAGE");
  expectErrorCode(with({ "--direction", "elsewhere" }), "E_USAGE");
  expectErrorCode(with({ "--direction", "from-cube", "--reference", path("prostate.nrrd") }), "E_GEOMETRY");
  EXPECT_FALSE(fs::exists(path("out.nrrd")));
}
