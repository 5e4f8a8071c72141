// Exact: reports of runs, found and summed up by the command.
#include "CommandTest.h"
#include "PageName.h"
#include "TextTable.h"
#include "moserhex/HexMeshIO/LabelImageWriter.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>

using namespace moserhex;
using namespace moserhex::app;
namespace fs = std::filesystem;

namespace
{

class CollectCommand : public CommandTest
{
protected:
  /** in/a.nrrd can be meshed, in/tunnel.nrrd is refused, in/never.nrrd is not run; reports in out. */
  void
  runCases() const
  {
    fs::create_directories(path("in"));
    fs::create_directories(path("out"));
    writeSample();
    fs::rename(path("prostate.nrrd"), path("in/a.nrrd"));
    fs::copy_file(path("in/a.nrrd"), path("in/never.nrrd"));
    writeLabelImage(path("in/tunnel.nrrd"), cubeWithTunnel());
    EXPECT_EQ(meshCase("a"), 0);
    EXPECT_EQ(meshCase("tunnel"), 3);
  }

  [[nodiscard]] int
  meshCase(const std::string & stem, const std::vector<std::string> & more = {}) const
  {
    std::vector<std::string> arguments{ "mesh",
                                        path("in/" + stem + ".nrrd"),
                                        path("out/" + stem + ".vtu"),
                                        "--report",
                                        path("out/" + stem + ".json"),
                                        "--shells=3",
                                        "--stage=initial",
                                        "--topology=reject",
                                        "--quiet" };
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments).exitCode;
  }

  [[nodiscard]] Outcome
  collect(const std::vector<std::string> & more = {}) const
  {
    std::vector<std::string> arguments{ "collect", path("out") };
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }

  /** case:status, in the order of the rows. */
  [[nodiscard]] std::vector<std::string>
  statuses(const std::string & table = "out/summary.csv") const
  {
    std::vector<std::string> found;
    for (const TextTable::Row & row : readTextTable(path(table)).rows)
    {
      found.push_back(row.cells.at(0) + ":" + row.cells.at(1));
    }
    return found;
  }
};

} // namespace

TEST_F(CollectCommand, CasesThatAreNotDoneAreCountedAndEndWithOne)
{
  runCases();
  const Outcome outcome = collect({ "--cases", path("in") });
  EXPECT_EQ(outcome.exitCode, 1) << outcome.error;
  EXPECT_EQ(outcome.error, "");
  EXPECT_EQ(statuses(), (std::vector<std::string>{ "a.vtu:done", "never.vtu:missing", "tunnel.vtu:failed" }));
  EXPECT_NE(outcome.out.find("  E_TOPOLOGY              1\n"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("sj_min"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("hours in all"), std::string::npos) << outcome.out;
  const auto figures = nlohmann::json::parse(contentOf(path("out/summary.json")));
  EXPECT_EQ(figures["done"], 1);
  EXPECT_EQ(figures["failures"]["E_TOPOLOGY"], 1);
  EXPECT_EQ(figures["missing"], 1);
  EXPECT_EQ(figures["figures"]["nodes"]["median"], 216);
}

TEST_F(CollectCommand, OneMissingCaseEndsWithOne)
{
  runCases();
  EXPECT_EQ(collect({ "--cases", path("in/a.nrrd"), path("in/never.nrrd"), "--quiet" }).exitCode, 1);
  EXPECT_EQ(statuses(), (std::vector<std::string>{ "a.vtu:done", "never.vtu:missing" }));
}

TEST_F(CollectCommand, AllDoneEndsWithZeroAndQuietPrintsNothing)
{
  runCases();
  const Outcome outcome =
    collect({ "--cases", path("in/a.nrrd"), "--csv", path("t.csv"), "--json", path("f.json"), "--quiet" });
  EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(statuses("t.csv"), std::vector<std::string>{ "a.vtu:done" });
  EXPECT_EQ(nlohmann::json::parse(contentOf(path("f.json")))["cases"], 1);
  EXPECT_FALSE(fs::exists(path("out/summary.csv")));
}

TEST_F(CollectCommand, WithoutCasesWhatHasAReportIsTaken)
{
  runCases();
  EXPECT_EQ(collect().exitCode, 1);
  EXPECT_EQ(statuses(), (std::vector<std::string>{ "a.vtu:done", "tunnel.vtu:failed" }));
  fs::remove(path("out/tunnel.json"));
  EXPECT_EQ(collect().exitCode, 0);
  EXPECT_EQ(statuses(), std::vector<std::string>{ "a.vtu:done" });
}

TEST_F(CollectCommand, ListGivesNamesAndColumns)
{
  runCases();
  std::ofstream(path("in/list.csv")) << "input,output,age\na.nrrd,a.vtu,61\n";
  EXPECT_EQ(collect({ "--cases", path("in/list.csv"), "--keep-columns", "age" }).exitCode, 0);
  const TextTable table = readTextTable(path("out/summary.csv"));
  EXPECT_EQ(table.columns.back(), "age");
  EXPECT_EQ(table.rows.at(0).cells.back(), "61");
}

TEST_F(CollectCommand, ReproducibleRunsGiveTheSameBytesAndNoTimes)
{
  runCases();
  std::string before;
  for (const char * threads : { "--threads=1", "--threads=2" })
  {
    ASSERT_EQ(meshCase("a", { "--reproducible", threads }), 0);
    ASSERT_EQ(meshCase("tunnel", { "--reproducible", threads }), 3);
    const Outcome outcome = collect();
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_EQ(outcome.out.find("hours"), std::string::npos) << outcome.out;
    const std::string now = contentOf(path("out/summary.csv")) + contentOf(path("out/summary.json"));
    EXPECT_EQ(now.find("seconds"), std::string::npos) << now;
    EXPECT_TRUE(before.empty() || before == now);
    before = now;
  }
}

TEST_F(CollectCommand, WhatItIsMadeOfIsNotOverwritten)
{
  runCases();
  std::ofstream(path("out/summary.csv")) << "input\n../in/a.nrrd\n";
  expectErrorCode(collect({ "--cases", path("out/summary.csv") }), "E_USAGE");
  EXPECT_EQ(contentOf(path("out/summary.csv")), "input\n../in/a.nrrd\n");
  for (const char * file : { "in/a.nrrd", "out/a.vtu", "out/a.json" })
  {
    const std::string before = contentOf(path(file));
    expectErrorCode(collect({ "--cases", path("in"), "--csv", path(file) }), "E_USAGE");
    expectErrorCode(collect({ "--cases", path("in"), "--json", path(file) }), "E_USAGE");
    EXPECT_EQ(contentOf(path(file)), before);
  }
}

TEST_F(CollectCommand, WrongUsageAndMissingFoldersAreRefused)
{
  expectErrorCode(run({ "collect" }), "E_USAGE");
  expectErrorCode(run({ "collect", path("missing") }), "E_NOINPUT");
  fs::create_directories(path("out"));
  expectErrorCode(collect(), "E_NOINPUT");
  expectErrorCode(collect({ "--keep-columns", "age" }), "E_USAGE");
  expectErrorCode(collect({ "--csv", path("x"), "--json", path("x") }), "E_USAGE");
  EXPECT_EQ(fileCount(), 1u);
}

TEST_F(CollectCommand, FolderThatCannotBeWrittenEndsWithSeventyFour)
{
  runCases();
  expectOneLineError(collect({ "--csv", path("no/t.csv") }), 74);
}

TEST_F(CollectCommand, PageIsWrittenWhereItIsWantedWithLinksFromThere)
{
  if (!pagesAreBuilt())
  {
    GTEST_SKIP() << "MoserHex_BUILD_REPORTS is OFF";
  }
  runCases();
  EXPECT_EQ(meshCase("a", { "--report", path("out/a.html") }), 0);
  EXPECT_EQ(collect({ "--html", path("group.html") }).exitCode, 1);
  EXPECT_NE(contentOf(path("group.html")).find("\"page\":\"out/a.html\""), std::string::npos);
  EXPECT_FALSE(fs::exists(path("out/summary.html")));
  expectErrorCode(collect({ "--html", path("out/summary.csv") }), "E_USAGE");
}
