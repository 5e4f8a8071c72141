// Exact: texts, counts and sums of few numbers; quantiles are linear between order statistics, to round-off.
#include "Summary.h"
#include "SummaryText.h"
#include "TestFolder.h"
#include "TextTable.h"
#include "moserhex/HexMeshIO/RunReport.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <clocale>
#include <cmath>
#include <limits>

using namespace moserhex;
using namespace moserhex::app;
namespace fs = std::filesystem;

namespace
{

/** Cases a.vtu, b.vtu of files that are there, in a folder of their own. */
class Summary : public testing::Test
{
protected:
  [[nodiscard]] BatchCase
  makeCase(const std::string & stem) const
  {
    BatchCase batchCase;
    batchCase.name = stem + ".vtu";
    batchCase.options.input.file = m_Folder / stem + ".nrrd";
    batchCase.options.output = m_Folder / stem + ".vtu";
    batchCase.options.reportFile = m_Folder / stem + ".json";
    writeBytes(batchCase.options.input.file, "labels");
    return batchCase;
  }

  [[nodiscard]] static RunReport
  reportOf(const BatchCase & batchCase)
  {
    RunReport report;
    report.versions.moserhex = "1.2.3";
    report.input.file = batchCase.options.input.file;
    report.input.labels = { 3 };
    report.mesh = { batchCase.options.output, 8000, 6859, 5000.25 };
    report.seconds = 2.0;
    return report;
  }

  static void
  writeMeshAnd(const BatchCase & batchCase, const RunReport & report)
  {
    writeBytes(batchCase.options.output, "mesh");
    writeRunReport(batchCase.options.reportFile, report);
  }

  [[nodiscard]] static SummaryRow
  rowOf(const BatchCase & batchCase)
  {
    CaseList list;
    list.cases = { batchCase };
    return summarise(list, 1).front();
  }

  [[nodiscard]] TextTable
  tableOf(const std::vector<SummaryRow> & rows, const std::vector<std::string> & keptColumns = {}) const
  {
    writeSummaryTable(m_Folder / "summary.csv", rows, keptColumns);
    return readTextTable(m_Folder / "summary.csv");
  }

  TestFolder m_Folder;
};

SummaryRow
doneRow(const std::string & figure, double value)
{
  SummaryRow row;
  row.name = "a.vtu";
  row.status = CaseStatus::Done;
  row.figures[figure] = value;
  return row;
}

/** The cell of the only row. */
std::string
cellOf(const TextTable & table, const std::string & column)
{
  for (std::size_t i = 0; i < table.columns.size(); ++i)
  {
    if (table.columns[i] == column)
    {
      return table.rows.at(0).cells[i];
    }
  }
  return "no column " + column;
}

} // namespace

TEST_F(Summary, MeshWithItsReportIsDone)
{
  BatchCase batchCase = makeCase("a");
  batchCase.labelName = "Left Putamen";
  batchCase.kept = { "control" };
  writeMeshAnd(batchCase, reportOf(batchCase));
  const SummaryRow row = rowOf(batchCase);
  EXPECT_EQ(row.status, CaseStatus::Done);
  EXPECT_EQ(row.name, "a.vtu");
  EXPECT_EQ(row.message, "");
  EXPECT_EQ(row.input, batchCase.options.input.file);
  EXPECT_EQ(row.labels, "3");
  EXPECT_EQ(row.labelName, "Left Putamen");
  EXPECT_EQ(row.figures.at("nodes"), 8000.0);
  EXPECT_EQ(row.kept, std::vector<std::string>{ "control" });
}

TEST_F(Summary, ReportOfAFailureCountsEvenBesideAnOldMesh)
{
  const BatchCase batchCase = makeCase("a");
  RunReport       report = reportOf(batchCase);
  report.failure = RunReport::Failure{ ErrorCode::Thin, "a.nrrd: too thin; use a finer image" };
  writeMeshAnd(batchCase, report);
  const SummaryRow row = rowOf(batchCase);
  EXPECT_EQ(row.status, CaseStatus::Failed);
  EXPECT_EQ(row.code, "E_THIN");
  EXPECT_EQ(row.message, "a.nrrd: too thin; use a finer image");
  EXPECT_EQ(row.figures.at("seconds"), 2.0);
}

TEST_F(Summary, CaseWithoutReportIsMissingWithWhatIsKnown)
{
  BatchCase batchCase = makeCase("a");
  batchCase.options.input.label = 7;
  writeBytes(batchCase.options.output, "mesh");
  const SummaryRow row = rowOf(batchCase);
  EXPECT_EQ(row.status, CaseStatus::Missing);
  EXPECT_EQ(row.message, "no report");
  EXPECT_EQ(row.code, "");
  EXPECT_EQ(row.labels, "7");
  EXPECT_TRUE(std::isnan(row.figures.at("nodes")));
}

TEST_F(Summary, ReportThatDoesNotFitIsMissingAndSaysWhy)
{
  const BatchCase batchCase = makeCase("a");
  writeBytes(batchCase.options.reportFile, "{");
  EXPECT_EQ(rowOf(batchCase).message, "the report is damaged, or not one of mesh");

  RunReport report = reportOf(batchCase);
  writeRunReport(batchCase.options.reportFile, report);
  EXPECT_EQ(rowOf(batchCase).status, CaseStatus::Missing);
  EXPECT_EQ(rowOf(batchCase).message, "the mesh of the report is not there");
  EXPECT_TRUE(std::isnan(rowOf(batchCase).figures.at("nodes")));

  report.input.file = makeCase("b").options.input.file;
  writeMeshAnd(batchCase, report);
  EXPECT_EQ(rowOf(batchCase).status, CaseStatus::Missing);
  EXPECT_EQ(rowOf(batchCase).message, "the report is of another input, " + m_Folder / "b.nrrd");
}

TEST_F(Summary, InputMayHaveAnotherName)
{
  BatchCase batchCase = makeCase("a");
  writeMeshAnd(batchCase, reportOf(batchCase));
  batchCase.options.input.file = m_Folder / "./a.nrrd";
  EXPECT_EQ(rowOf(batchCase).status, CaseStatus::Done);
  fs::create_symlink(m_Folder / "a.nrrd", m_Folder / "link.nrrd");
  batchCase.options.input.file = m_Folder / "link.nrrd";
  EXPECT_EQ(rowOf(batchCase).status, CaseStatus::Done);
}

TEST_F(Summary, InputWhoseNameIsNotUtf8IsFound)
{
  const BatchCase batchCase = makeCase("\xE9");
  writeMeshAnd(batchCase, reportOf(batchCase));
  EXPECT_EQ(rowOf(batchCase).status, CaseStatus::Done);
}

TEST_F(Summary, RowsAreInTheOrderOfTheCasesForAnyNumberOfThreads)
{
  CaseList list;
  for (const char * stem : { "c", "a", "d", "b" })
  {
    list.cases.push_back(makeCase(stem));
    RunReport report = reportOf(list.cases.back());
    report.mesh.nodes = static_cast<std::size_t>(stem[0]);
    writeMeshAnd(list.cases.back(), report);
  }
  for (const unsigned int threads : { 1u, 2u, 7u })
  {
    const std::vector<SummaryRow> rows = summarise(list, threads);
    ASSERT_EQ(rows.size(), 4u);
    for (std::size_t i = 0; i < rows.size(); ++i)
    {
      EXPECT_EQ(rows[i].name, list.cases[i].name);
      EXPECT_EQ(rows[i].figures.at("nodes"), static_cast<double>(rows[i].name[0]));
    }
  }
}

TEST_F(Summary, TableHasARowACaseWithAllItsColumns)
{
  SummaryRow row = doneRow("nodes", 8000.0);
  row.status = CaseStatus::Failed;
  row.code = "E_THIN";
  row.message = "a, \"b\"\nc";
  row.input = "in/a.nrrd";
  row.labels = "1 2";
  row.labelName = "Left Putamen";
  row.figures["seconds"] = 1.5;
  row.kept = { "control", "61" };
  const TextTable          table = tableOf({ row }, { "group", "age" });
  std::vector<std::string> columns{ "case", "status", "code", "message", "input", "labels", "label_name" };
  for (const std::string & name : summaryFigures())
  {
    if (name != "peak_memory_mib")
    {
      columns.push_back(name);
    }
  }
  columns.insert(columns.end(), { "group", "age" });
  EXPECT_EQ(table.columns, columns);
  EXPECT_EQ(cellOf(table, "case"), "a.vtu");
  EXPECT_EQ(cellOf(table, "status"), "failed");
  EXPECT_EQ(cellOf(table, "code"), "E_THIN");
  EXPECT_EQ(cellOf(table, "message"), "a, \"b\"\nc");
  EXPECT_EQ(cellOf(table, "input"), "in/a.nrrd");
  EXPECT_EQ(cellOf(table, "labels"), "1 2");
  EXPECT_EQ(cellOf(table, "label_name"), "Left Putamen");
  EXPECT_EQ(cellOf(table, "nodes"), "8000");
  EXPECT_EQ(cellOf(table, "cells"), "");
  EXPECT_EQ(cellOf(table, "seconds"), "1.5");
  EXPECT_EQ(cellOf(table, "group"), "control");
  EXPECT_EQ(cellOf(table, "age"), "61");
}

TEST_F(Summary, KeptColumnsWhoseNamesAreTakenAreStillThere)
{
  SummaryRow row = doneRow("nodes", 8.0);
  row.kept = { "mine" };
  EXPECT_EQ(cellOf(tableOf({ row }, { "status" }), "list_status"), "mine");
  row.kept.clear();
  EXPECT_EQ(cellOf(tableOf({ row }, { "group" }), "group"), "");
}

TEST_F(Summary, SecondsAndMemoryAreColumnsOnlyIfAReportHasThem)
{
  SummaryRow without = doneRow("nodes", 8.0);
  without.figures["seconds"] = std::nan("");
  const TextTable table = tableOf({ without });
  EXPECT_EQ(cellOf(table, "seconds"), "no column seconds");
  EXPECT_EQ(cellOf(table, "peak_memory_mib"), "no column peak_memory_mib");
  EXPECT_EQ(cellOf(tableOf({ without, doneRow("seconds", 1.0) }), "seconds"), "");
}

TEST_F(Summary, NumbersComeBackWithEveryBitWhateverTheLocale)
{
  for (const char * locale : { "C", "de_DE.UTF-8", "de_DE" })
  {
    if (!std::setlocale(LC_ALL, locale))
    {
      continue;
    }
    for (const double value : { 0.1, 1.0 / 3.0, 1e-19, -2.5e-300, 5000.25, std::numeric_limits<double>::max() })
    {
      EXPECT_EQ(nlohmann::json::parse(cellOf(tableOf({ doneRow("sj_min", value) }), "sj_min")).get<double>(), value);
    }
    EXPECT_EQ(cellOf(tableOf({ doneRow("sj_min", 0.1) }), "sj_min"), "0.1");
    EXPECT_EQ(cellOf(tableOf({ doneRow("nodes", 1000000.0) }), "nodes"), "1000000");
    EXPECT_EQ(cellOf(tableOf({ doneRow("nodes", std::nan("")) }), "nodes"), "");
  }
  std::setlocale(LC_ALL, "C");
}

TEST_F(Summary, FolderThatCannotBeWrittenIsReported)
{
  EXPECT_THROW(writeSummaryTable(m_Folder / "no/summary.csv", {}, {}), IOError);
  EXPECT_THROW(writeGroupFigures(m_Folder / "no/summary.json", {}), IOError);
}

TEST(GroupFigures, CountsCasesAndCodes)
{
  SummaryRow failed = doneRow("nodes", 1.0);
  failed.status = CaseStatus::Failed;
  failed.code = "E_THIN";
  SummaryRow other = failed;
  other.code = "E_TOPOLOGY";
  const GroupFigures group = groupFigures({ doneRow("nodes", 8.0), failed, other, failed, SummaryRow{} });
  EXPECT_EQ(group.done, 1u);
  EXPECT_EQ(group.failed, 3u);
  EXPECT_EQ(group.missing, 1u);
  EXPECT_EQ(group.failures, (std::map<std::string, std::size_t>{ { "E_THIN", 2 }, { "E_TOPOLOGY", 1 } }));
  EXPECT_EQ(group.figures.at("nodes").count, 1u);
}

TEST(GroupFigures, QuantilesAreOfTheCasesThatAreDone)
{
  std::vector<SummaryRow> rows;
  for (const int value : { 20, 3, 0, 17 })
  {
    rows.push_back(doneRow("sj_min", value));
  }
  for (int value = 1; value <= 19; ++value)
  {
    if (value != 3 && value != 17)
    {
      rows.push_back(doneRow("sj_min", value));
    }
  }
  rows.push_back(doneRow("sj_min", std::nan("")));
  rows.push_back(doneRow("sj_min", 1000.0));
  rows.back().status = CaseStatus::Failed;
  const GroupFigures::Distribution figure = groupFigures(rows).figures.at("sj_min"); // 0 to 20
  EXPECT_EQ(figure.count, 21u);
  EXPECT_EQ(figure.minimum, 0.0);
  EXPECT_NEAR(figure.p05, 1.0, 1e-12);
  EXPECT_EQ(figure.median, 10.0);
  EXPECT_NEAR(figure.p95, 19.0, 1e-12);
  EXPECT_EQ(figure.maximum, 20.0);
  EXPECT_NEAR(figure.mean, 10.0, 1e-12);
}

TEST(GroupFigures, SecondsAreSummedOverFailedCasesToo)
{
  SummaryRow failed = doneRow("seconds", 0.5);
  failed.status = CaseStatus::Failed;
  EXPECT_EQ(groupFigures({ doneRow("seconds", 1.5), failed, SummaryRow{} }).totalSeconds, 2.0);
}

TEST(GroupFigures, JsonHasWhatThereIs)
{
  const TestFolder folder;
  SummaryRow       failed = doneRow("nodes", 1.0);
  failed.status = CaseStatus::Failed;
  failed.code = "E_THIN";
  const auto read = [&folder](const std::vector<SummaryRow> & rows) {
    writeGroupFigures(folder / "g.json", groupFigures(rows));
    return nlohmann::json::parse(readBytes(folder / "g.json"));
  };
  const auto json = read({ doneRow("seconds", 1.5), doneRow("seconds", 2.5), failed });
  EXPECT_EQ(json["cases"], 3);
  EXPECT_EQ(json["done"], 2);
  EXPECT_EQ(json["failed"], 1);
  EXPECT_EQ(json["missing"], 0);
  EXPECT_EQ(json["failures"], nlohmann::json({ { "E_THIN", 1 } }));
  EXPECT_EQ(json["total_seconds"], 4.0);
  EXPECT_EQ(json["figures"].size(), 1u);
  const auto seconds = json["figures"]["seconds"];
  EXPECT_EQ(seconds["count"], 2);
  EXPECT_EQ(seconds["min"], 1.5);
  EXPECT_EQ(seconds["median"], 2.0);
  EXPECT_EQ(seconds["mean"], 2.0);
  EXPECT_EQ(seconds["max"], 2.5);
  EXPECT_TRUE(seconds.contains("p05"));
  EXPECT_TRUE(seconds.contains("p95"));

  const auto without = read({ doneRow("nodes", 8.0) });
  EXPECT_FALSE(without.contains("total_seconds"));
  EXPECT_EQ(without["failures"], nlohmann::json::object());
}

TEST(GroupFigures, TextHasCountsQuantilesAndHours)
{
  SummaryRow failed = doneRow("seconds", 3600.0);
  failed.status = CaseStatus::Failed;
  failed.code = "E_THIN";
  const std::string text = describe(groupFigures({ doneRow("sj_min", 0.25), doneRow("seconds", 1800.0), failed }));
  EXPECT_EQ(text.compare(0, 28, "done                      2\n"), 0) << text;
  EXPECT_NE(text.find("\n  E_THIN                  1\n"), std::string::npos) << text;
  EXPECT_NE(text.find("\nmissing                   0\n"), std::string::npos) << text;
  EXPECT_NE(text.find("\nsj_min                    1        0.25        0.25"), std::string::npos) << text;
  EXPECT_NE(text.find("\n1.5 hours in all\n"), std::string::npos) << text;
  EXPECT_EQ(describe(groupFigures({})).find("hours"), std::string::npos);
}
