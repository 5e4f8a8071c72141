// Exact: the numbers of the summary under their keys.
#include "moserhex/HexMeshIO/QualityReport.h"

#include "TestFolder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <limits>

using namespace moserhex;

namespace
{

QualityReport
someReport(bool lattice)
{
  QualityReport report;
  report.file = "mesh.msh";
  report.nodes = 27;
  report.quality.cells = 8;
  report.quality.volume = 1.0 / 3.0;
  report.quality.certified = { 6, 1, 1 };
  report.quality.scaledJacobian.p01 = 0.25;
  report.quality.isLattice = lattice;
  report.quality.corners.cells = 8;
  report.quality.corners.scaledJacobianMin = 0.5;
  report.warnings = { "ignored: 2 x line" };
  return report;
}

nlohmann::json
jsonOf(const QualityReport & report)
{
  return nlohmann::json::parse(toJson(report));
}

} // namespace

TEST(QualityReport, HoldsTheSummarysNumbers)
{
  const auto json = jsonOf(someReport(true));
  EXPECT_EQ(json["mesh"]["nodes"], 27);
  EXPECT_EQ(json["mesh"]["cells"], 8);
  EXPECT_EQ(json["quality"]["volume_mm3"].get<double>(), 1.0 / 3.0);
  EXPECT_EQ(json["quality"]["certified"]["positive"], 6);
  EXPECT_EQ(json["quality"]["certified"]["not_positive"], 1);
  EXPECT_EQ(json["quality"]["certified"]["undecided"], 1);
  EXPECT_EQ(json["quality"]["scaled_jacobian"]["p01"], 0.25);
  EXPECT_EQ(json["quality"]["classes"]["corner"]["sj_min"], 0.5);
  EXPECT_EQ(json["quality"]["classes"]["edge"]["cells"], 0);
  EXPECT_EQ(json["warnings"][0], "ignored: 2 x line");
}

TEST(QualityReport, ClassesAndLabelAreThereOnlyWhenTheyWereFound)
{
  QualityReport report = someReport(false);
  EXPECT_FALSE(jsonOf(report)["quality"].contains("classes"));
  EXPECT_FALSE(jsonOf(report).contains("label"));
  report.label = QualityReport::Label{ "label.nrrd", { 3 }, "label 3", {} };
  report.label->agreement.dice = 0.97;
  EXPECT_EQ(jsonOf(report)["label"]["dice"], 0.97);
  EXPECT_EQ(jsonOf(report)["label"]["label"], 3);
}

TEST(QualityReport, NumberThatIsNotFiniteIsNull)
{
  QualityReport report = someReport(false);
  report.quality.ratioMax = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(jsonOf(report)["quality"]["ratio_max"].is_null());
}

TEST(QualityReport, FileHoldsTheJson)
{
  const TestFolder folder;
  writeQualityReport(folder / "q.json", someReport(true));
  EXPECT_EQ(readBytes(folder / "q.json"), toJson(someReport(true)));
  EXPECT_THROW(writeQualityReport(folder / "no/q.json", someReport(true)), IOError);
}
