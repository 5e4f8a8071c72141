// Exact: a report is read back as it was written, or not at all.
#include "CaseReport.h"
#include "Summary.h"
#include "TestFolder.h"
#include "moserhex/HexMeshIO/RunReport.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>

using namespace moserhex;
using namespace moserhex::app;

namespace
{

RunReport
someReport()
{
  RunReport report;
  report.versions.moserhex = "1.2.3";
  report.input.file = "in/case.nrrd";
  report.input.labels = { 3 };
  report.input.labelName = "Left Putamen";
  report.input.volume = 5000.5;
  report.conditioning.emplace().changedPercent = 0.5;
  report.stages = { { "conditioning", 0.5, {} },
                    { "initial", 0.25, StageQuality{ 0.5, 2.0, -0.5, 0.25 } },
                    { "exact", 0.25, StageQuality{ 1e-19, 0.0, 0.125, 0.75, 0.625 } },
                    { "writing", 0.25, {} } };
  report.conditioning->dice = 0.99;
  report.mesh = { "out/case.vtu", 8000, 6859, 5000.25, "0,0 1,0 1,1" };
  report.surface = RunReport::Surface{ 0.1, 0.4 };
  report.exact.emplace().reached = true;
  report.warnings = { "one", "two" };
  report.seconds = 12.5;
  report.peakMemory = 321.25;
  return report;
}

class CaseReportFile : public testing::Test
{
protected:
  [[nodiscard]] std::optional<CaseReport>
  read(const std::string & text) const
  {
    writeBytes(m_Folder / "r.json", text);
    return readCaseReport(m_Folder / "r.json");
  }

  TestFolder m_Folder;
};

} // namespace

TEST_F(CaseReportFile, OfAMeshHasItsNamesLabelsAndFigures)
{
  const auto report = read(toJson(someReport()));
  ASSERT_TRUE(report);
  EXPECT_TRUE(report->meshed);
  EXPECT_EQ(report->inputFile, "in/case.nrrd");
  EXPECT_EQ(report->meshFile, "out/case.vtu");
  EXPECT_EQ(report->labels, "3");
  EXPECT_EQ(report->labelName, "Left Putamen");
  EXPECT_EQ(report->outline, "0,0 1,0 1,1");
  const std::map<std::string, double> expected{ { "nodes", 8000.0 },
                                                { "cells", 6859.0 },
                                                { "label_volume_mm3", 5000.5 },
                                                { "mesh_volume_mm3", 5000.25 },
                                                { "volume_variance", 1e-19 },
                                                { "concave_percent", 0.0 },
                                                { "sj_min", 0.125 },
                                                { "sj_median", 0.75 },
                                                { "sj_mean", 0.625 },
                                                { "exact", 1.0 },
                                                { "certified", 0.0 },
                                                { "surface_rms_mm", 0.1 },
                                                { "surface_max_mm", 0.4 },
                                                { "repair_percent", 0.5 },
                                                { "dice", 0.99 },
                                                { "warnings", 2.0 },
                                                { "seconds", 12.5 },
                                                { "peak_memory_mib", 321.25 } };
  EXPECT_EQ(report->figures, expected);
}

TEST_F(CaseReportFile, NumbersThatItDoesNotHaveAreNaN)
{
  RunReport report = someReport();
  report.exact.reset();
  report.reproducible = true;
  report.stages[2].quality->volumeVariance = std::nan("");
  const auto read = this->read(toJson(report));
  ASSERT_TRUE(read);
  for (const char * name : { "exact", "certified", "seconds", "peak_memory_mib", "volume_variance" })
  {
    EXPECT_TRUE(std::isnan(read->figures.at(name))) << name;
  }
  EXPECT_EQ(read->figures.at("sj_min"), 0.125);
  EXPECT_EQ(read->figures.size(), summaryFigures().size());
}

TEST_F(CaseReportFile, OfAFailureHasCodeAndMessage)
{
  RunReport report = someReport();
  report.input.labels = { 1, 2 };
  report.failure = RunReport::Failure{ ErrorCode::Topology, "case.nrrd: 2 handles; correct it" };
  const auto read = this->read(toJson(report));
  ASSERT_TRUE(read);
  EXPECT_FALSE(read->meshed);
  EXPECT_EQ(read->code, "E_TOPOLOGY");
  EXPECT_EQ(read->message, "case.nrrd: 2 handles; correct it");
  EXPECT_EQ(read->labels, "1 2");
  EXPECT_TRUE(std::isnan(read->figures.at("nodes")));
}

TEST_F(CaseReportFile, WhatIsDamagedOrForeignIsNone)
{
  const std::string whole = toJson(someReport());
  EXPECT_FALSE(readCaseReport(m_Folder / "missing.json"));
  EXPECT_FALSE(readCaseReport(m_Folder / "."));
  for (std::size_t length = 0; length + 2 < whole.size(); length += 7)
  {
    ASSERT_FALSE(read(whole.substr(0, length))) << length;
  }
  for (const char * foreign : { "{}", "[]", "null", "\"status\"", "{\"status\": \"\xff\"}", "{\"status\": 1e999}" })
  {
    EXPECT_FALSE(read(foreign)) << foreign;
  }
}

TEST_F(CaseReportFile, WithoutOneOfItsMarksItIsForeign)
{
  using Json = nlohmann::json;
  RunReport failed = someReport();
  failed.failure = RunReport::Failure{ ErrorCode::Thin, "case.nrrd: too thin" };
  const Json whole = Json::parse(toJson(failed));
  ASSERT_TRUE(read(whole.dump()));
  for (const char * mark : { "/status", "/error/code", "/input/file", "/mesh/file", "/versions/moserhex" })
  {
    for (const Json & other : { Json(3), Json(), Json(""), Json({ "a" }) })
    {
      Json json = whole;
      json[Json::json_pointer(mark)] = other;
      EXPECT_FALSE(read(json.dump())) << mark << " " << other;
    }
  }
  Json json = whole;
  json["status"] = "done";
  EXPECT_FALSE(read(json.dump()));
  json = whole;
  json["input"]["file"] = std::string(5000, '/');
  EXPECT_FALSE(read(json.dump()));
}

TEST_F(CaseReportFile, ValuesOfOtherTypesAreNotThere)
{
  const auto report = read(R"({"status": "meshed", "input": {"file": "a", "labels": {"a": "b"}, "volume_mm3": "x"},
    "versions": {"moserhex": "1"}, "mesh": {"file": "b", "nodes": []}, "stages": [1, [], {"sj_min": []}], "exact": [true]})");
  ASSERT_TRUE(report);
  EXPECT_EQ(report->labels, "");
  for (const std::string & name : summaryFigures())
  {
    EXPECT_TRUE(std::isnan(report->figures.at(name))) << name;
  }
}

TEST_F(CaseReportFile, LargerThanTheLimitIsNone)
{
  std::string text = toJson(someReport());
  text.resize(largestReport, ' ');
  EXPECT_TRUE(read(text));
  EXPECT_FALSE(read(text + " "));
}

TEST_F(CaseReportFile, NestedToTheLimitOfItsSizeIsNoCrash)
{
  EXPECT_FALSE(read(std::string(largestReport, '[')));
  const std::size_t depth = largestReport / 2 - 200;
  const std::string nested = std::string(depth, '[') + std::string(depth, ']');
  const auto        report = read(R"({"status": "meshed", "input": {"file": "a"}, "mesh": {"file": "b"},)"
                                  R"("versions": {"moserhex": "1"}, "stages": [{"sj_min": 0.5, "note": )" +
                           nested + "}]}");
  ASSERT_TRUE(report);
  EXPECT_EQ(report->figures.at("sj_min"), 0.5);
}
