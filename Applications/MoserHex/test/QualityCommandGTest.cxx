// Exact: exit codes, streams and files of moserhex quality.
#include "CommandTest.h"

#include "SampleProstate.h"
#include "moserhex/HexMeshIO/HexMeshReader.h"
#include "moserhex/HexMeshIO/LabelImageReader.h"
#include "moserhex/HexMeshIO/LabelImageWriter.h"
#include "moserhex/HexMeshIO/Sha256.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <sstream>
#include <thread>

using namespace moserhex;
using namespace moserhex::app;
namespace fs = std::filesystem;

namespace
{

class QualityCommand : public CommandTest
{};

/** A box of 4^3 voxels of 10 mm as two hexahedra, MSH 2.2, left-handed when asked for; of other heights when given. */
void
writeBoxMesh(const std::string & fileName, bool leftHanded, const std::array<int, 3> & heights = { 0, 20, 40 })
{
  std::ofstream file(fileName);
  file << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n12\n";
  for (int node = 0; node < 12; ++node)
  {
    file << node + 1 << ' ' << 40 * (node % 2) << ' ' << 40 * (node / 2 % 2) << ' '
         << heights[static_cast<std::size_t>(node / 4)] << '\n';
  }
  file << "$EndNodes\n$Elements\n3\n1 15 2 0 0 1\n";
  for (const int first : { 1, 5 })
  {
    const int a = leftHanded ? first + 4 : first;
    const int b = leftHanded ? first : first + 4;
    file << first + 1 << " 5 2 0 0";
    for (const int node : { a, a + 1, a + 3, a + 2, b, b + 1, b + 3, b + 2 })
    {
      file << ' ' << node;
    }
    file << '\n';
  }
  file << "$EndElements\n";
}

/** Voxels [2,6)^3 of 10 mm; their faces lie at 0 and 40 mm. */
LabelVolume
boxLabel()
{
  LabelVolume label;
  label.size = { 8, 8, 8 };
  label.spacing = Vector3::Constant(10.0);
  label.origin = Vector3::Constant(-15.0);
  for (int voxel = 0; voxel < 512; ++voxel)
  {
    const auto within = [](int i) { return i >= 2 && i < 6; };
    label.inside.push_back(within(voxel % 8) && within(voxel / 8 % 8) && within(voxel / 64) ? 1 : 0);
  }
  return label;
}

} // namespace

TEST_F(QualityCommand, QualityOfAnotherToolsMeshIsMeasuredAndComparedWithTheLabel)
{
  writeBoxMesh(path("box.msh"), false);
  writeLabelImage(path("box.nrrd"), boxLabel());
  const Outcome outcome =
    run({ "quality", path("box.msh"), "--label-image", path("box.nrrd"), "--label=1", "--json", path("q.json") });
  ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_NE(outcome.error.find("warning: ignored: 1 x point"), std::string::npos) << outcome.error;
  EXPECT_NE(outcome.out.find("2 certified, 0 are not, 0 undecided"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("Dice 1.0000"), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.out.find("corner"), std::string::npos) << outcome.out; // no lattice, no classes

  const auto json = nlohmann::json::parse(contentOf(path("q.json")));
  EXPECT_EQ(json["mesh"]["cells"], 2);
  EXPECT_EQ(json["mesh"]["lattice"], false);
  EXPECT_NEAR(json["quality"]["volume_mm3"].get<double>(), 64000.0, 1e-6);
  EXPECT_NEAR(json["label"]["volume_error"].get<double>(), 0.0, 1e-12);
  EXPECT_NEAR(json["label"]["dice"].get<double>(), 1.0, 1e-12);
  EXPECT_NEAR(json["label"]["face_centres_mm"]["max"].get<double>(), 0.0, 1e-9);
}

TEST_F(QualityCommand, QualityOfALatticeShowsItsClasses)
{
  writeSample();
  ASSERT_EQ(run({ "mesh", path("prostate.nrrd"), path("b.vtu"), "--shells", "3", "--stage", "initial" }).exitCode, 0);
  const Outcome outcome = run({ "quality", path("b.vtu"), "--json", path("q.json") });
  ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
  for (const char * name : { "\ncorner ", "\nedge ", "\nrest ", "\nall ", "(lattice)" })
  {
    EXPECT_NE(outcome.out.find(name), std::string::npos) << name << outcome.out;
  }
  const auto classes = nlohmann::json::parse(contentOf(path("q.json")))["quality"]["classes"];
  EXPECT_EQ(classes["corner"]["cells"], 8);
  EXPECT_EQ(classes["edge"]["cells"], 36);
  EXPECT_EQ(classes["rest"]["cells"], 81);
}

TEST_F(QualityCommand, QualityOfALeftHandedMeshWarns)
{
  writeBoxMesh(path("box.msh"), true);
  const Outcome outcome = run({ "quality", path("box.msh"), "--quiet" });
  EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_TRUE(outcome.out.empty()) << outcome.out;
  EXPECT_NE(outcome.error.find("left-handed"), std::string::npos) << outcome.error;
}

TEST_F(QualityCommand, QualityOfAMeshWithoutVolumeSaysThatRatiosAreUndefined)
{
  // Two flat cells; a cell of positive volume on one of negative volume.
  for (const std::array<int, 3> & heights : { std::array<int, 3>{ 0, 0, 0 }, std::array<int, 3>{ 0, 20, 0 } })
  {
    writeBoxMesh(path("box.msh"), false, heights);
    const Outcome outcome = run({ "quality", path("box.msh"), "--json", path("q.json") });
    EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
    EXPECT_NE(outcome.error.find("the mesh has no volume: the variance"), std::string::npos) << outcome.error;
    EXPECT_NE(outcome.out.find("volume ratio undefined to undefined"), std::string::npos) << outcome.out;
    EXPECT_EQ(outcome.out.find("nan"), std::string::npos) << outcome.out;
    EXPECT_EQ(outcome.out.find("inf "), std::string::npos) << outcome.out;
    const auto quality = nlohmann::json::parse(contentOf(path("q.json")))["quality"];
    EXPECT_NEAR(quality["volume_mm3"].get<double>(), 0.0, 1e-9);
    EXPECT_TRUE(quality["volume_variance"].is_null());
    EXPECT_TRUE(quality["ratio_max"].is_null());
    EXPECT_TRUE(quality["minimum_jacobian"]["min"].is_null());
  }
}

TEST_F(QualityCommand, QualityWarnsOfALabelElsewhere)
{
  writeBoxMesh(path("box.msh"), false);
  LabelVolume label = boxLabel();
  label.origin += Vector3(300.0, 0.0, 0.0);
  writeLabelImage(path("box.nrrd"), label);
  const Outcome outcome = run({ "quality", path("box.msh"), "--label-image", path("box.nrrd"), "--quiet" });
  EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_NE(outcome.error.find("hardly overlap"), std::string::npos) << outcome.error;
}

TEST_F(QualityCommand, QualityRefusesWithTheExitCodesOfTheOthers)
{
  writeBoxMesh(path("box.msh"), false);
  expectOneLineError(run({ "quality" }), 2);
  expectOneLineError(run({ "quality", path("box.msh"), "--label", "1" }), 2);
  expectOneLineError(run({ "quality", path("box.msh"), "--json", path("box.msh") }), 2);
  expectOneLineError(run({ "quality", path("missing.msh") }), 3);
  expectOneLineError(run({ "quality", path("box.stl") }), 3);
  expectOneLineError(run({ "quality", path("box.msh"), "--label-image", path("missing.nrrd") }), 3);
  expectOneLineError(run({ "quality", path("box.msh"), "--json", path("no/q.json") }), 74);
  writeLabelImage(path("box.nrrd"), boxLabel());
  expectOneLineError(run({ "quality", path("box.msh"), "--label-image", path("box.nrrd"), "--label", "7" }), 3);
  EXPECT_EQ(fileCount(), 2u);
}

TEST_F(QualityCommand, MeshSavedAgainByMeshioHasTheSameQuality)
{
  if (std::system("/usr/bin/python3 -c 'import meshio' > /dev/null 2>&1") != 0)
  {
    GTEST_SKIP() << "no python3-meshio here";
  }
  writeSample();
  ASSERT_EQ(run({ "mesh", path("prostate.nrrd"), path("b.vtk"), "--shells", "3", "--stage", "initial" }).exitCode, 0);
  const auto qualityOf = [this](const std::string & name) {
    const Outcome outcome = run({ "quality", path(name), "--json", path("q.json"), "--quiet" });
    EXPECT_EQ(outcome.exitCode, 0) << name << outcome.error;
    return nlohmann::json::parse(contentOf(path("q.json")))["quality"];
  };
  const auto        expected = qualityOf("b.vtk");
  const std::string script = "import sys, meshio\nm = meshio.read(sys.argv[1])\n"
                             "cells = [(c.type, c.data.astype(int)) for c in m.cells]\n"
                             "for name in sys.argv[2:]: meshio.Mesh(m.points.astype(float), cells).write(name)\n";
  std::ofstream(path("convert.py")) << script;
  std::string command = "/usr/bin/python3 '" + path("convert.py") + "' '" + path("b.vtk") + "'";
  const auto  names = { "c.inp", "c.mesh", "c.vtk", "c.vtu" };
  for (const char * name : names)
  {
    command += " '" + path(name) + "'";
  }
  ASSERT_EQ(std::system((command + " > /dev/null 2>&1").c_str()), 0);
  for (const char * name : names)
  {
    EXPECT_EQ(qualityOf(name), expected) << name; // meshio writes all digits
  }
}
