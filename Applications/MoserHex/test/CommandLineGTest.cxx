// Exact: exit codes, streams and files of the program as a user runs it. A lattice of 4 shells keeps the runs short.
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
#include <set>
#include <sstream>
#include <thread>

using namespace moserhex;
using namespace moserhex::app;
namespace fs = std::filesystem;

namespace
{

class CommandLine : public CommandTest
{};

} // namespace

TEST_F(CommandLine, VersionNamesTheProgramAndItsLibraries)
{
  const Outcome outcome = run({ "--version" });
  EXPECT_EQ(outcome.exitCode, 0);
  EXPECT_EQ(outcome.out.compare(0, 9, "moserhex "), 0);
  EXPECT_NE(outcome.out.find("ITK"), std::string::npos);
  EXPECT_TRUE(outcome.error.empty());
}

TEST_F(CommandLine, HelpNamesEveryOption)
{
  const Outcome outcome = run({ "mesh", "--help" });
  EXPECT_EQ(outcome.exitCode, 0);
  for (const char * option :
       { "INPUT",           "OUTPUT",     "--shells",       "--padding",      "--label",   "--segment", "--threshold",
         "--no-sandbox",    "--topology", "--max-repair",   "--stage",        "--way",     "--frame",   "--density",
         "--allow-partial", "--report",   "--reproducible", "--shell-method", "--threads", "--quiet" })
  {
    EXPECT_NE(outcome.out.find(option), std::string::npos) << option;
  }
  const Outcome quality = run({ "quality", "--help" });
  for (const char * option : { "MESH", "--label-image", "--label ", "--json", "--threads", "--quiet" })
  {
    EXPECT_NE(quality.out.find(option), std::string::npos) << option;
  }
}

TEST_F(CommandLine, DescriptionHasEveryCommandAndEveryOptionOfItsHelp)
{
  const Outcome described = run({ "--describe-commands" });
  EXPECT_EQ(described.exitCode, 0) << described.error;
  const std::string general = run({ "--help" }).out;
  const auto        commands = nlohmann::json::parse(described.out);
  const std::size_t subcommands = general.find("Subcommands:");
  ASSERT_NE(subcommands, std::string::npos);
  EXPECT_EQ(general.find("--describe-commands"), std::string::npos);
  for (const auto & command : commands)
  {
    const std::string name = command["name"];
    EXPECT_NE(general.find("\n  " + name + " ", subcommands), std::string::npos) << name;
    const std::string     help = run({ name, "--help" }).out;
    std::set<std::string> helped; // words that begin with -- at the beginning of a line
    std::istringstream    lines(help);
    for (std::string line; std::getline(lines, line);)
    {
      const std::size_t at = line.find("--");
      if (at != std::string::npos && at <= 5)
      {
        helped.insert(line.substr(at, line.find_first_of(" ,{", at) - at));
      }
    }
    std::set<std::string> named;
    for (const auto & option : command["options"])
    {
      for (const std::string option_name : option["names"])
      {
        named.insert(option_name.rfind("--", 0) == 0 ? option_name : "");
      }
    }
    named.erase("");
    EXPECT_EQ(helped, named) << name;
  }
  EXPECT_EQ(
    commands.size(),
    static_cast<std::size_t>(std::count(general.begin() + static_cast<long>(subcommands), general.end(), '\n')) - 3)
    << general;
}

TEST_F(CommandLine, WrongUsageEndsWithTwo)
{
  expectOneLineError(run({}), 2);
  expectOneLineError(run({ "polish" }), 2);
  expectOneLineError(run({ "mesh", "a.nrrd" }), 2);
  expectOneLineError(run({ "mesh", "a.nrrd", "b.vtu", "--shells", "1" }), 2);
  expectOneLineError(run({ "mesh", "a.nrrd", "b.vtu", "--stage", "polished" }), 2);
  expectOneLineError(run({ "mesh", "a.nrrd", "b.vtu", "--threads", "0" }), 2);
  expectOneLineError(run({ "mesh", "a.nrrd", "b.stl" }), 2);
  expectOneLineError(run({ "mesh", "a.vtk", "a.vtk" }), 2);
  expectOneLineError(run({ "mesh", "a.nrrd", "b.vtu", "--report", "./b.vtu" }), 2);
}

TEST_F(CommandLine, OptionsOfTheExactStageAreRefusedWithAnother)
{
  for (const char * option : { "--way=fast", "--way=faithful", "--density=d.nrrd", "--padding=1" })
  {
    for (const char * stage : { "initial", "smoothed", "moser" })
    {
      const Outcome outcome = run({ "mesh", "a.nrrd", "b.vtu", "--stage", stage, option });
      expectOneLineError(outcome, 2);
      EXPECT_NE(outcome.error.find("needs --stage exact"), std::string::npos) << outcome.error;
    }
  }
}

TEST_F(CommandLine, WrongUsageSaysWhereToLook)
{
  EXPECT_NE(run({ "qualty", "a.vtu" }).error.find("no command qualty"), std::string::npos);
  EXPECT_NE(run({ "quality", "a.vtu", "--lable", "1" }).error.find("see moserhex quality --help"), std::string::npos);
  EXPECT_NE(run({ "mesh", "a.nrrd" }).error.find("see moserhex mesh --help"), std::string::npos);
}

TEST_F(CommandLine, BadInputEndsWithThreeAndLeavesNothing)
{
  expectOneLineError(run({ "mesh", path("missing.nrrd"), path("b.vtu") }), 3);
  expectOneLineError(run({ "mesh", path("image.png"), path("b.vtu") }), 3);
  EXPECT_EQ(fileCount(), 0u);
}

TEST_F(CommandLine, SeveralLabelsAreMeshedTogetherAndTheCellsSayWhichTheyLieIn)
{
  writeLabelImage(path("zones.nrrd"), makeSampleProstate().zones);
  const Outcome outcome =
    run({ "mesh", path("zones.nrrd"), path("b.vtk"), "--shells", "4", "--stage=initial", "--report", path("r.json") });
  ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_NE(outcome.out.find("labels 1, 2 together"), std::string::npos) << outcome.out;
  const auto input = nlohmann::json::parse(contentOf(path("r.json")))["input"];
  EXPECT_EQ(input["labels"], (std::vector<int>{ 1, 2 }));
  EXPECT_TRUE(input["label"].is_null());
  EXPECT_NE(contentOf(path("b.vtk")).find("Label 1 343 int"), std::string::npos);
}

TEST_F(CommandLine, PaddingSurroundsTheLatticeWithCellsOfTheSameVolume)
{
  writeSample();
  const Outcome outcome =
    run({ "mesh", path("prostate.nrrd"), path("b.inp"), "--shells=4", "--padding=2", "--report", path("r.json") });
  ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
  const auto report = nlohmann::json::parse(contentOf(path("r.json")));
  EXPECT_EQ(report["parameters"]["padding"], 2);
  EXPECT_EQ(report["mesh"]["cells"], 343 + 2 * 294);
  EXPECT_EQ(report["stages"].back()["name"], "padding");
  EXPECT_EQ(readHexMesh(path("b.inp")).paddingLayers, 2);
  EXPECT_NE(contentOf(path("b.inp")).find("ELSET=PADDING_2"), std::string::npos);
  const Outcome quality = run({ "quality", path("b.inp") });
  EXPECT_NE(quality.out.find("lattice with 2 layers of padding"), std::string::npos) << quality.out;
  expectErrorCode(run({ "mesh", path("prostate.nrrd"), path("b.inp"), "--padding=9" }), "E_USAGE");
}

TEST_F(CommandLine, LabelThatIsNotThereIsRefusedWithTheOnesThatAre)
{
  writeLabelImage(path("zones.nrrd"), makeSampleProstate().zones);
  const Outcome outcome = run({ "mesh", path("zones.nrrd"), path("b.vtu"), "--label", "7" });
  expectErrorCode(outcome, "E_LABELS");
  EXPECT_NE(outcome.error.find("no label 7, it has 1, 2"), std::string::npos) << outcome.error;
}

TEST_F(CommandLine, LabelWithAHandleIsRepairedOrRefusedWithItsNumbers)
{
  writeLabelImage(path("tunnel.nrrd"), cubeWithTunnel());
  const Outcome rejected = run({ "mesh", path("tunnel.nrrd"), path("b.vtu"), "--topology", "reject" });
  expectErrorCode(rejected, "E_TOPOLOGY");
  EXPECT_NE(rejected.error.find("1 handle"), std::string::npos) << rejected.error;
  const Outcome limited = run({ "mesh", path("tunnel.nrrd"), path("b.vtu"), "--max-repair", "0.01" });
  expectErrorCode(limited, "E_TOPOLOGY");
  EXPECT_NE(limited.error.find("limit 0.01 %"), std::string::npos) << limited.error;
  EXPECT_EQ(fileCount(), 1u);

  const Outcome repaired = run({ "mesh",
                                 path("tunnel.nrrd"),
                                 path("b.vtu"),
                                 "--shells=3",
                                 "--stage=initial",
                                 "--quiet",
                                 "--report",
                                 path("r.json") });
  EXPECT_EQ(repaired.exitCode, 0) << repaired.error;
  EXPECT_NE(repaired.error.find("warning: "), std::string::npos) << repaired.error;
  const auto report = nlohmann::json::parse(contentOf(path("r.json")));
  EXPECT_EQ(report["conditioning"]["handles"], 1);
  EXPECT_EQ(report["conditioning"]["changes"][0]["kind"], "tunnel filled");
  EXPECT_GT(report["conditioning"]["voxels_added"].get<int>(), 0);
  EXPECT_EQ(report["warning_count"], report["warnings"].size());
}

TEST_F(CommandLine, UnwritableOutputEndsWithSeventyFourBeforeTheWork)
{
  writeSample();
  expectOneLineError(run({ "mesh", path("prostate.nrrd"), path("no/b.vtu") }), 74);
  expectOneLineError(run({ "mesh", path("prostate.nrrd"), path("b.vtu"), "--report", path("no/r.json") }), 74);
  EXPECT_EQ(fileCount(), 1u);
}

TEST_F(CommandLine, SampleWritesThreeLabelmaps)
{
  const Outcome outcome = run({ "sample", path("sample") });
  EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_TRUE(outcome.error.empty());
  EXPECT_EQ(readLabelImage(path("sample/prostate.nrrd")).labels.size(), 1u);
  EXPECT_EQ(readLabelImage(path("sample/prostate_zones.nrrd")).labels.size(), 2u);
  EXPECT_EQ(readLabelImage(path("sample/prostate_followup.nrrd")).labels.size(), 1u);
}

TEST_F(CommandLine, SampleOnAFullDiskEndsWithSeventyFourAndLeavesNoFile)
{
  const Outcome outcome = run({ "sample", path("sample") }, 300);
  EXPECT_EQ(outcome.exitCode, 74);
  EXPECT_TRUE(fs::is_empty(path("sample")));
}

TEST_F(CommandLine, MeshWritesLatticeReportAndTable)
{
  writeSample();
  const Outcome outcome = run(
    { "mesh", path("prostate.nrrd"), path("b.vtu"), "--shells", "4", "--stage=initial", "--report", path("r.json") });
  ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_EQ(readHexMesh(path("b.vtu")).nodesPerSide, 8);
  EXPECT_NE(outcome.out.find("vol. var."), std::string::npos);
  EXPECT_NE(outcome.out.find(path("b.vtu")), std::string::npos);
  EXPECT_EQ(fileCount(), 3u);

  const auto report = nlohmann::json::parse(contentOf(path("r.json")));
  EXPECT_EQ(report["input"]["sha256"], sha256OfFile(path("prostate.nrrd")));
  EXPECT_EQ(report["input"]["label"], 1);
  EXPECT_EQ(report["conditioning"]["handles"], 0);
  EXPECT_TRUE(report["conditioning"]["changes"].empty());
  EXPECT_EQ(report["parameters"]["stage"], "initial");
  EXPECT_EQ(report["mesh"]["nodes"], 512);
  EXPECT_EQ(report["mesh"]["cells"], 343);
  EXPECT_NEAR(report["mesh"]["volume_mm3"].get<double>(), report["input"]["volume_mm3"].get<double>(), 0.1 * 51000);
  EXPECT_TRUE(report["stages"].back().contains("volume_variance"));
  EXPECT_EQ(report["stages"][1]["name"], "shell ordering");
  EXPECT_NE(report["stages"][1]["note"].get<std::string>().find("chan-vese"), std::string::npos) << report["stages"][1];
  EXPECT_GT(report["threads"], 0);
}

TEST_F(CommandLine, RidgeFrameSaysHowFarItIsTurned)
{
  writeSample();
  const Outcome outcome = run({ "mesh",
                                path("prostate.nrrd"),
                                path("b.vtu"),
                                "--shells=4",
                                "--stage=initial",
                                "--frame=ridge",
                                "--report",
                                path("r.json") });
  ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_NE(outcome.out.find("\nframe: turned by "), std::string::npos) << outcome.out;
  const auto report = nlohmann::json::parse(contentOf(path("r.json")));
  const auto frame = report["frame"];
  EXPECT_GT(frame["turned_degrees"].get<double>(), 0.0);
  const HexMeshFile mesh = readHexMeshFile(path("b.vtu"));
  ASSERT_EQ(mesh.meshArrays.size(), 2u);
  EXPECT_EQ(mesh.meshArrays[0].name, "LatticeTurn");
  EXPECT_EQ(mesh.meshArrays[1].name, "NotExact"); // the stage is another
  EXPECT_EQ(report["lattice_turn_degrees"], nlohmann::json(mesh.meshArrays[0].values));
  EXPECT_NEAR(
    Eigen::Map<const Vector3>(mesh.meshArrays[0].values.data()).norm(), frame["turned_degrees"].get<double>(), 1e-9);
  EXPECT_LE(frame["turned_degrees"].get<double>(), 10.0);
  EXPECT_LE(frame["edge_score_after"].get<double>(), frame["edge_score_before"].get<double>());
}

TEST_F(CommandLine, QuietRunPrintsNothing)
{
  writeSample();
  const Outcome outcome =
    run({ "mesh", path("prostate.nrrd"), path("b.vtk"), "--shells", "3", "--stage", "initial", "--quiet" });
  EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_TRUE(outcome.out.empty()) << outcome.out;
}

TEST_F(CommandLine, OneAndTwoThreadsWriteTheSameBytes)
{
  writeSample();
  for (const char * threads : { "1", "2" })
  {
    const Outcome outcome = run({ "mesh",
                                  path("prostate.nrrd"),
                                  path(std::string("mesh") + threads + ".vtu"),
                                  "--shells",
                                  "3",
                                  "--threads",
                                  threads });
    ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
  }
  EXPECT_EQ(contentOf(path("mesh1.vtu")), contentOf(path("mesh2.vtu")));
}

TEST_F(CommandLine, MeshOnAFullDiskEndsWithSeventyFourAndLeavesNoFile)
{
  writeSample();
  const Outcome outcome =
    run({ "mesh", path("prostate.nrrd"), path("b.vtu"), "--shells", "3", "--stage", "initial", "--quiet" }, 2000);
  expectOneLineError(outcome, 74);
  EXPECT_EQ(fileCount(), 1u);
}

TEST_F(CommandLine, ClosedSurfaceIsMeshed)
{
  // A cube of 40 mm, two triangles a side.
  std::ofstream(path("cube.off")) << "OFF\n8 12 0\n0 0 0\n40 0 0\n0 40 0\n40 40 0\n0 0 40\n40 0 40\n0 40 40\n40 40 40\n"
                                     "3 0 2 3\n3 0 3 1\n3 4 5 7\n3 4 7 6\n3 0 1 5\n3 0 5 4\n"
                                     "3 2 6 7\n3 2 7 3\n3 0 4 6\n3 0 6 2\n3 1 3 7\n3 1 7 5\n";
  const Outcome outcome = run({ "mesh", path("cube.off"), path("b.vtu"), "--shells", "3", "--stage", "initial" });
  EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_TRUE(fs::exists(path("b.vtu")));
}

TEST_F(CommandLine, InterruptedRunLeavesNoFile)
{
  writeSample();
  for (const int milliseconds : { 50, 400, 1200 })
  {
    const pid_t child = startProgram({ "mesh", path("prostate.nrrd"), path("b.vtu") }, m_Root / "streams");
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
    ::kill(child, SIGINT);
    const Outcome outcome = waitForProgram(child, m_Root / "streams");
    if (outcome.signalNumber == 0)
    {
      EXPECT_EQ(outcome.exitCode, 0); // it was faster
      return;
    }
    EXPECT_EQ(outcome.signalNumber, SIGINT);
    EXPECT_EQ(fileCount(), 1u);
  }
}
