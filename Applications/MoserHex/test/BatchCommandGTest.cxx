// Exact: what a batch run makes, what it makes again, and what it says.
#include "BatchFolder.h"
#include "PageName.h"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

using namespace moserhex;
using namespace moserhex::app;
namespace fs = std::filesystem;

namespace
{

using BatchCommand = BatchFolder;

std::vector<std::string>
linesOf(const std::string & text)
{
  std::vector<std::string> lines;
  std::istringstream       stream(text);
  for (std::string line; std::getline(stream, line);)
  {
    lines.push_back(line);
  }
  return lines;
}

} // namespace

TEST_F(BatchCommand, MakesTheMeshesThatTheCommandMakes)
{
  writeSolids(3);
  writeBadFile("bad.nrrd");
  const Outcome outcome = batch();
  EXPECT_EQ(outcome.exitCode, 1);
  EXPECT_EQ(linesOf(outcome.error).size(), 1u) << outcome.error;
  EXPECT_EQ(outcome.error.find("warning: bad.vtu: "), 0u) << outcome.error;
  EXPECT_NE(outcome.error.find(" [E_"), std::string::npos) << outcome.error;
  ASSERT_EQ(run({ "mesh", path("in/case-002.nrrd"), path("alone.vtu"), "--shells", "2", "--quiet" }).exitCode, 0);
  EXPECT_EQ(contentOf(path("alone.vtu")), contentOf(path("out/case-002.vtu")));
  EXPECT_TRUE(fs::exists(path("out/case-002.json")));
  EXPECT_FALSE(fs::exists(path("out/bad.vtu")));
  EXPECT_NE(contentOf(path("out/bad.json")).find("\"failed\""), std::string::npos);
  EXPECT_EQ(linesOf(contentOf(path("out/summary.csv"))).size(), 5u);
  EXPECT_EQ(filesWithEnding("out", ".nrrd"), 0u);
}

TEST_F(BatchCommand, ResultsDoNotDependOnJobsOrShards)
{
  writeSolids(5);
  ASSERT_EQ(batch({ "--jobs", "1" }, "one").exitCode, 0);
  ASSERT_EQ(batch({ "--jobs", "3" }, "three").exitCode, 0);
  EXPECT_TRUE(sameTree(treeOf("one"), treeOf("three")));
  ASSERT_EQ(batch({ "--shard", "1/2" }, "shards").exitCode, 0);
  EXPECT_EQ(filesWithEnding("shards", ".vtu"), 3u);
  ASSERT_EQ(batch({ "--shard", "2/2" }, "shards").exitCode, 0);
  const std::string journals = contentOf(path("shards/journal.1-of-2.jsonl"));
  EXPECT_EQ(linesOf(journals).size(), 3u);
  ASSERT_EQ(batch({}, "shards").exitCode, 0); // nothing to do but the summary
  EXPECT_EQ(contentOf(path("shards/journal.jsonl")), "");
  EXPECT_TRUE(sameTree(treeOf("one"), treeOf("shards")));
}

TEST_F(BatchCommand, OnlyWhatChangedIsMadeAgain)
{
  writeSolids(4);
  writeBadFile("bad.nrrd");
  ASSERT_EQ(batch().exitCode, 1);
  const auto plan = [this](const std::vector<std::string> & more) {
    std::vector<std::string> arguments{ "--dry-run" };
    arguments.insert(arguments.end(), more.begin(), more.end());
    return batch(arguments).out;
  };
  EXPECT_NE(plan({}).find("4  done"), std::string::npos) << plan({});
  EXPECT_NE(plan({}).find("1  failed   failed before: E_HEADER"), std::string::npos) << plan({});
  EXPECT_NE(plan({ "--retry-failed" }).find("1  to run   failed before"), std::string::npos);
  EXPECT_NE(plan({ "--padding", "1" }).find("5  to run   options changed"), std::string::npos);

  fs::remove(path("in/bad.nrrd"));
  fs::copy_file(path("in/case-001.nrrd"), path("in/bad.nrrd"));
  fs::copy_file(path("in/case-003.nrrd"), path("in/case-002.nrrd"), fs::copy_options::overwrite_existing);
  EXPECT_NE(plan({}).find("2  to run   input changed"), std::string::npos) << plan({});
  EXPECT_NE(plan({}).find("3  done"), std::string::npos) << plan({});
  const auto before = fs::last_write_time(path("out/case-001.vtu"));
  EXPECT_EQ(batch().exitCode, 0);
  EXPECT_EQ(fs::last_write_time(path("out/case-001.vtu")), before);
  EXPECT_EQ(contentOf(path("out/case-002.vtu")), contentOf(path("out/case-003.vtu")));
  EXPECT_EQ(doneEntries().at("case-001.vtu"), 1);
  EXPECT_EQ(doneEntries().at("case-002.vtu"), 2);
}

TEST_F(BatchCommand, PagesAreWrittenAndMadeAgainWhereTheyAreMissing)
{
  if (!pagesAreBuilt())
  {
    GTEST_SKIP() << "MoserHex_BUILD_REPORTS is OFF";
  }
  writeSolids(2);
  ASSERT_EQ(batch().exitCode, 0);
  EXPECT_EQ(filesWithEnding("out", ".html"), 1u);
  EXPECT_EQ(contentOf(path("out/summary.html")).find("href=\"case-001.html\""), std::string::npos);
  EXPECT_NE(batch({ "--dry-run", "--case-pages" }).out.find("2  to run   page missing"), std::string::npos);
  ASSERT_EQ(batch({ "--case-pages" }).exitCode, 0);
  EXPECT_EQ(filesWithEnding("out", ".html"), 3u);
  EXPECT_NE(contentOf(path("out/summary.html")).find("\"page\":\"case-001.html\""), std::string::npos);
  EXPECT_NE(batch({ "--dry-run", "--case-pages" }).out.find("2  done"), std::string::npos);
}

TEST_F(BatchCommand, AMeshOfOtherInputsDoesNotOutliveAFailure)
{
  writeSolids(1);
  ASSERT_EQ(batch().exitCode, 0);
  writeBadFile("case-001.nrrd");
  EXPECT_EQ(batch().exitCode, 1);
  EXPECT_FALSE(fs::exists(path("out/case-001.vtu")));
  std::ofstream(path("out/case-001.vtu")) << "somebody's";
  EXPECT_EQ(batch({ "--retry-failed" }).exitCode, 1);
  EXPECT_EQ(contentOf(path("out/case-001.vtu")), "somebody's");
}

TEST_F(BatchCommand, DryRunAndVerifyAndListingMakeNothing)
{
  writeSolids(2);
  EXPECT_EQ(batch({ "--dry-run" }).exitCode, 0);
  EXPECT_FALSE(fs::exists(path("out")));
  EXPECT_EQ(batch({ "--list-cases", path("cases.tsv"), "--label", "1" }).exitCode, 0);
  EXPECT_FALSE(fs::exists(path("out")));
  const std::vector<std::string> lines = linesOf(contentOf(path("cases.tsv")));
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0], "case\tinput\toutput\treport\targuments");
  EXPECT_EQ(lines[1].find("case-001.vtu\t" + path("in/case-001.nrrd") + "\t" + path("out/case-001.vtu") + "\t" +
                          path("out/case-001.json") + "\t--shells=2 --padding=0 --label=1 "),
            0u)
    << lines[1];
  const auto written = fs::last_write_time(path("cases.tsv"));
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_EQ(batch({ "--list-cases", path("cases.tsv"), "--label", "1" }).exitCode, 0);
  EXPECT_EQ(fs::last_write_time(path("cases.tsv")), written);
}

TEST_F(BatchCommand, OptionsOfTheListCountBeforeThoseOfTheCommand)
{
  writeSolids(2);
  std::ofstream(path("list.csv")) << "input,output,shells\r\nin/case-001.nrrd,a/first.vtk,3\r\nin/case-002.nrrd,,\r\n";
  const Outcome outcome = run({ "batch", path("list.csv"), "--output", path("out"), "--shells", "2", "--quiet" });
  EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_NE(contentOf(path("out/a/first.json")).find("\"nodes\": 216"), std::string::npos);
  EXPECT_NE(contentOf(path("out/in/case-002.json")).find("\"nodes\": 64"), std::string::npos);
  EXPECT_TRUE(fs::exists(path("out/a/first.vtk")));
}

TEST_F(BatchCommand, OutputsWithinTheInputFolderAreNoInputs)
{
  writeSolids(2);
  ASSERT_EQ(batch({}, "in/out").exitCode, 0);
  fs::copy_file(path("in/case-001.nrrd"), path("in/out/copy.nrrd"));
  const Outcome again = batch({ "--dry-run" }, "in/out");
  EXPECT_NE(again.out.find("2  cases"), std::string::npos) << again.out;
}

TEST_F(BatchCommand, ContradictionsAreFoundBeforeAnyWork)
{
  writeSolids(1);
  fs::copy_file(path("in/case-001.nrrd"), path("in/case-001.mha"));
  expectErrorCode(batch(), "E_USAGE");
  EXPECT_FALSE(fs::exists(path("out")));
  fs::remove(path("in/case-001.mha"));
  expectErrorCode(batch({ "--shard", "3/2" }), "E_USAGE");
  expectErrorCode(batch({ "--format", ".stl" }), "E_USAGE");
  expectErrorCode(batch({ "--padding", "1", "--stage", "moser" }), "E_USAGE");
  fs::create_directory(path("empty"));
  expectErrorCode(run({ "batch", path("empty"), "--output", path("out") }), "E_USAGE");
  expectErrorCode(run({ "batch", path("in") }), "E_USAGE");
  std::ofstream(path("file")) << "x";
  expectErrorCode(batch({}, "file/out"), "E_CANTCREAT");
}

TEST_F(BatchCommand, SeparateVoxelFilesBelongToTheInput)
{
  writeSolids(1);
  fs::remove(path("in/case-001.nrrd"));
  std::string voxels(16 * 16 * 16, '\0');
  for (std::size_t v = 0; v < voxels.size(); ++v)
  {
    const std::size_t i = v % 16;
    const std::size_t j = v / 16 % 16;
    const std::size_t k = v / 256;
    voxels[v] = i > 2 && i < 13 && j > 2 && j < 13 && k > 2 && k < 13 ? '\1' : '\0';
  }
  std::ofstream(path("in/a.raw"), std::ios::binary) << voxels;
  std::ofstream(path("in/a.nhdr")) << "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 16 16 16\nencoding: raw\n"
                                      "space: left-posterior-superior\nspace directions: (1,0,0) (0,1,0) (0,0,1)\n"
                                      "space origin: (0,0,0)\ndata file: a.raw\n";
  ASSERT_EQ(batch().exitCode, 0);
  EXPECT_NE(batch({ "--dry-run" }).out.find("1  done"), std::string::npos);
  voxels[0 + 16 * (8 + 16 * 8) + 2] = '\1';
  std::ofstream(path("in/a.raw"), std::ios::binary) << voxels;
  EXPECT_NE(batch({ "--dry-run" }).out.find("1  to run   input changed"), std::string::npos);
}
