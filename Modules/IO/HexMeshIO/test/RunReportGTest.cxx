// Numbers must come back with every bit: exact.
#include "moserhex/HexMeshIO/RunReport.h"

#include "TestFolder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <limits>

using namespace moserhex;
using Json = nlohmann::json;

namespace
{
RunReport
someReport()
{
  RunReport report;
  report.input.file = "case.nrrd";
  report.input.sha256 = std::string(64, 'a');
  report.input.labels = { 3 };
  report.input.spacing = Vector3(0.1, 1.0 / 3.0, 3.0);
  report.input.voxels = 68000;
  report.input.volume = 51000.1;
  report.parameters.shells = 10;
  report.parameters.stage = "moser";
  report.parameters.shellMethod = "chan-vese";
  report.parameters.way = "";
  report.parameters.frame = "anatomical";
  report.parameters.density = "";
  report.parameters.topology = "repair";
  report.parameters.maximumRepair = 5.0;
  report.conditioning.emplace();
  report.conditioning->handles = 1;
  report.conditioning->voxelVolume = 2.0;
  report.conditioning->voxelsRemoved = 3;
  report.conditioning->changes = { { TopologyChangeKind::HandleCut, 0, 1, 3, Vector3(1.0, 2.0, 3.0) } };
  report.stages = { { "conditioning", 0.5, {} },
                    { "moser", 0.25, StageQuality{ 1e-3, 0.1, -0.05, 0.7 }, "31 steps, certified" } };
  report.mesh = { "mesh.vtu", 8000, 6859, 51000.2, "0,0 1,0 1,1" };
  report.surface = RunReport::Surface{ 0.1, 0.4 };
  report.warnings = { "the label touches the first slice" };
  report.versions = libraryVersions();
  report.threads = 2;
  report.seconds = 12.5;
  report.peakMemory = 321.25;
  return report;
}

/** Of a file that could not be read. */
RunReport
reportOfFailure()
{
  RunReport report;
  report.input.file = "case.nrrd";
  report.mesh.file = "mesh.vtu";
  report.failure = RunReport::Failure{ ErrorCode::Truncated, "case.nrrd: ends early; copy it again" };
  return report;
}
} // namespace

TEST(RunReport, HasTheDocumentedKeys)
{
  const Json json = Json::parse(toJson(someReport()));
  for (const char * key : { "input", "parameters", "stages", "mesh", "surface", "warnings", "versions", "threads" })
  {
    EXPECT_TRUE(json.contains(key)) << key;
  }
  for (const char * key : { "file", "sha256", "label", "spacing", "voxels", "volume_mm3" })
  {
    EXPECT_TRUE(json["input"].contains(key)) << key;
  }
  for (const char * key : { "name", "seconds", "volume_variance", "concave_percent", "sj_min", "sj_median", "sj_mean" })
  {
    EXPECT_TRUE(json["stages"][1].contains(key)) << key;
  }
  EXPECT_FALSE(json["stages"][0].contains("sj_min"));
  EXPECT_FALSE(json["stages"][0].contains("note"));
  EXPECT_EQ(json["stages"][1]["note"], "31 steps, certified");
  EXPECT_EQ(json["mesh"]["nodes"], 8000);
  EXPECT_EQ(json["mesh"]["outline"], "0,0 1,0 1,1");
  EXPECT_EQ(json["surface"]["max_mm"], 0.4);
  EXPECT_EQ(json["warnings"].size(), 1u);
  for (const char * key : { "moserhex", "git", "itk", "vtk", "eigen" })
  {
    EXPECT_TRUE(json["versions"].contains(key)) << key;
  }
}

TEST(RunReport, StatusSaysWhetherThereIsAMesh)
{
  const Json meshed = Json::parse(toJson(someReport()));
  EXPECT_EQ(meshed["status"], "meshed");
  EXPECT_FALSE(meshed.contains("error"));
  const Json failed = Json::parse(toJson(reportOfFailure()));
  EXPECT_EQ(failed["status"], "failed");
  EXPECT_EQ(failed["error"]["code"], "E_TRUNCATED");
  EXPECT_EQ(failed["error"]["message"], "case.nrrd: ends early; copy it again");
}

TEST(RunReport, WhatWasNotKnownAtAFailureIsLeftOut)
{
  RunReport report = reportOfFailure();
  Json      json = Json::parse(toJson(report));
  EXPECT_EQ(json["input"], Json({ { "file", "case.nrrd" } }));
  EXPECT_EQ(json["mesh"], Json({ { "file", "mesh.vtu" } }));
  EXPECT_FALSE(json.contains("conditioning"));
  report.input.sha256 = std::string(64, 'a');
  report.input.labels = { 3 };
  report.density = RunReport::Density{ "density.nrrd", std::string(64, 'b') };
  json = Json::parse(toJson(report));
  EXPECT_EQ(json["input"]["sha256"], std::string(64, 'a'));
  EXPECT_EQ(json["input"]["label"], 3);
  EXPECT_EQ(json["density"]["sha256"], std::string(64, 'b'));
  EXPECT_FALSE(json["density"].contains("mean"));
}

TEST(RunReport, ReproducibleOneHasNothingThatDiffersFromRunToRun)
{
  Json expected = Json::parse(toJson(someReport()));
  EXPECT_EQ(expected["peak_memory_mib"], 321.25);
  for (const char * key : { "threads", "seconds", "peak_memory_mib" })
  {
    EXPECT_EQ(expected.erase(key), 1u) << key;
  }
  for (Json & stage : expected["stages"])
  {
    EXPECT_EQ(stage.erase("seconds"), 1u);
  }
  RunReport report = someReport();
  report.reproducible = true;
  EXPECT_EQ(Json::parse(toJson(report)), expected);
}

TEST(RunReport, DensityAndFrameAreThereOnlyWhenTheyWereUsed)
{
  RunReport report = someReport();
  EXPECT_FALSE(Json::parse(toJson(report)).contains("density"));
  EXPECT_FALSE(Json::parse(toJson(report)).contains("frame"));
  report.density = RunReport::Density{ "density.nrrd", std::string(64, 'b'), 0.1, 5100.0, 5100.0 / 6859.0 };
  report.frame = RunReport::Frame{ 6.5, 3.0, 1.5 };
  const Json json = Json::parse(toJson(report));
  EXPECT_EQ(json["density"]["file"], "density.nrrd");
  EXPECT_EQ(json["density"]["sha256"], std::string(64, 'b'));
  EXPECT_EQ(json["density"]["mean"], 0.1);
  EXPECT_EQ(json["density"]["mass"], 5100.0);
  EXPECT_EQ(json["density"]["mass_per_cell"], 5100.0 / 6859.0);
  EXPECT_EQ(json["frame"]["turned_degrees"], 6.5);
  EXPECT_FALSE(json.contains("lattice_turn_degrees"));
  EXPECT_EQ(json["frame"]["edge_score_before"], 3.0);
  EXPECT_EQ(json["frame"]["edge_score_after"], 1.5);
  report.latticeTurn = Vector3(0.0, 6.5, 0.0);
  EXPECT_EQ(Json::parse(toJson(report))["lattice_turn_degrees"], Json({ 0.0, 6.5, 0.0 }));
}

TEST(RunReport, OfATemplateSaysHowItWasPlaced)
{
  RunReport report = someReport();
  EXPECT_FALSE(Json::parse(toJson(report)).contains("template"));
  report.templateMesh = RunReport::Template{};
  report.templateMesh->alignment = "rigid";
  EXPECT_EQ(Json::parse(toJson(report))["template"], Json({ { "alignment", "rigid" } }));
  AffineTransform motion;
  motion.matrix << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  motion.translation = Vector3(10.0, 20.0, 30.0);
  report.templateMesh->aligned = RunReport::Alignment{ 90.0, 37.5, 8.0, motion };
  report.templateMesh->placed = RunReport::Placement{ 1.25, 0.5, 0.375 };
  report.templateMesh->start = "own";
  EXPECT_EQ(Json::parse(toJson(report))["template"],
            Json({ { "alignment", "rigid" },
                   { "start", "own" },
                   { "turned_degrees", 90.0 },
                   { "moved_mm", 37.5 },
                   { "template_to_label", { { 0, -1, 0, 10 }, { 1, 0, 0, 20 }, { 0, 0, 1, 30 }, { 0, 0, 0, 1 } } },
                   { "surface_rms_before_mm", 8.0 },
                   { "scale", 1.25 },
                   { "surface_rms_after_mm", 0.5 },
                   { "surface_median_after_mm", 0.375 } }));
  EXPECT_STREQ(equalMeasureOf(report).plural, "volumes");
  report.templateMesh->growth = RunReport::Growth{ 0.5, 2.0, 3 };
  EXPECT_EQ(Json::parse(toJson(report))["template"]["local_growth"],
            Json({ { "smallest", 0.5 }, { "largest", 2.0 }, { "limited_cells", 3 } }));
  EXPECT_STREQ(equalMeasureOf(report).plural, "volumes over their growth");
}

TEST(RunReport, NumbersRoundTrip)
{
  const Json json = Json::parse(toJson(someReport()));
  EXPECT_EQ(json["input"]["spacing"][1].get<double>(), 1.0 / 3.0);
  EXPECT_EQ(json["mesh"]["volume_mm3"].get<double>(), 51000.2);
}

TEST(RunReport, NumberThatIsNotFiniteBecomesNull)
{
  RunReport report = someReport();
  report.stages[1].quality->volumeVariance = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(Json::parse(toJson(report))["stages"][1]["volume_variance"].is_null());
}

TEST(RunReport, NameThatIsNotUtf8IsStillWritten)
{
  RunReport report = someReport();
  report.input.file = "\xE9.nrrd";
  EXPECT_NO_THROW(Json::parse(toJson(report)));
}

TEST(RunReport, FileHoldsTheJson)
{
  const TestFolder folder;
  writeRunReport(folder / "report.json", someReport());
  EXPECT_EQ(readBytes(folder / "report.json"), toJson(someReport()));
  EXPECT_EQ(folder.fileCount(), 1u);
}

TEST(RunReport, UnwritableFolderIsReported)
{
  EXPECT_THROW(writeRunReport("/nonexistent/report.json", someReport()), IOError);
}

TEST(LibraryVersions, AreFilledIn)
{
  const RunReport::Versions versions = libraryVersions();
  EXPECT_FALSE(versions.itk.empty());
  EXPECT_FALSE(versions.vtk.empty());
  EXPECT_FALSE(versions.eigen.empty());
}

TEST(RunReport, RepairOfTheTopologySaysWhatWasChangedAndWhere)
{
  const auto json = nlohmann::json::parse(toJson(someReport()));
  EXPECT_EQ(json["conditioning"]["handles"], 1);
  EXPECT_EQ(json["conditioning"]["removed_mm3"], 6.0);
  const auto change = json["conditioning"]["changes"][0];
  EXPECT_EQ(change["kind"], "handle cut");
  EXPECT_EQ(change["voxels"], 3);
  EXPECT_EQ(change["volume_mm3"], 6.0);
  EXPECT_EQ(change["centre_lps"], (std::vector<double>{ 1.0, 2.0, 3.0 }));
  EXPECT_EQ(json["parameters"]["topology"], "repair");
  EXPECT_TRUE(json["parameters"]["threshold"].is_null());
}

TEST(RunReport, LabelsTakenTogetherAreAListAndNoSingleLabel)
{
  RunReport report = someReport();
  report.input.labels = { 1, 2 };
  report.warnings = { "a", "b" };
  const auto json = nlohmann::json::parse(toJson(report));
  EXPECT_TRUE(json["input"]["label"].is_null());
  EXPECT_EQ(json["input"]["labels"], (std::vector<int>{ 1, 2 }));
  EXPECT_EQ(json["warning_count"], 2);
}
