// Exact: what the report of a run says, whatever came of the run.
#include "CommandTest.h"
#include "PageName.h"
#include "PeakMemory.h"
#include "moserhex/HexMeshIO/HexMeshReader.h"
#include "moserhex/HexMeshIO/LabelImageWriter.h"
#include "moserhex/HexMeshIO/Sha256.h"

#include <nlohmann/json.hpp>

#include <fstream>
#include <vector>

using namespace moserhex;
using namespace moserhex::app;
namespace fs = std::filesystem;

namespace
{

class Report : public CommandTest
{
protected:
  [[nodiscard]] Outcome
  mesh(const std::string &              input,
       const std::vector<std::string> & options = { "--shells=3", "--stage=initial" },
       rlim_t                           fileSizeLimit = 0) const
  {
    std::vector<std::string> arguments{ "mesh", path(input), path("b.vtu"), "--quiet", "--report", path("r.json") };
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run(arguments, fileSizeLimit);
  }

  [[nodiscard]] nlohmann::json
  report() const
  {
    return nlohmann::json::parse(contentOf(path("r.json")));
  }

  void
  expectFailure(const Outcome & outcome, const std::string & code) const
  {
    expectErrorCode(outcome, code);
    EXPECT_EQ(report()["status"], "failed");
    EXPECT_EQ(report()["error"]["code"], code);
    EXPECT_EQ(outcome.error, "error: " + report()["error"]["message"].get<std::string>() + " [" + code + "]\n");
  }
};

class ReportPage : public Report
{
protected:
  void
  SetUp() override
  {
    Report::SetUp();
    if (!pagesAreBuilt())
    {
      GTEST_SKIP() << "MoserHex_BUILD_REPORTS is OFF";
    }
  }
};

} // namespace

TEST_F(Report, OfAMeshSaysSoAndWhatItTook)
{
  writeSample();
  ASSERT_EQ(mesh("prostate.nrrd").exitCode, 0);
  EXPECT_EQ(report()["status"], "meshed");
  EXPECT_FALSE(report().contains("error"));
  EXPECT_GT(report()["seconds"].get<double>(), 0.0);
  EXPECT_GT(report()["peak_memory_mib"].get<double>(), 1.0);
}

TEST_F(Report, OfAMissingInputHasTheErrorAndNoChecksum)
{
  expectFailure(mesh("missing.nrrd"), "E_NOINPUT");
  EXPECT_EQ(report()["input"], nlohmann::json({ { "file", path("missing.nrrd") } }));
  EXPECT_EQ(report()["parameters"]["shells"], 3);
  EXPECT_EQ(fileCount(), 1u);
}

TEST_F(Report, OfADamagedInputHasItsChecksum)
{
  std::ofstream(path("damaged.nrrd")) << "NRRD0004\n";
  const Outcome outcome = mesh("damaged.nrrd");
  EXPECT_EQ(outcome.exitCode, 3);
  EXPECT_EQ(report()["status"], "failed");
  EXPECT_EQ(report()["input"]["sha256"], sha256OfFile(path("damaged.nrrd")));
  EXPECT_FALSE(report()["input"].contains("voxels"));
}

TEST_F(Report, OfARefusedLabelSaysWhichItWas)
{
  writeLabelImage(path("tunnel.nrrd"), cubeWithTunnel());
  expectFailure(mesh("tunnel.nrrd", { "--topology=reject" }), "E_TOPOLOGY");
  EXPECT_EQ(report()["input"]["label"], 1);
  EXPECT_GT(report()["input"]["voxels"].get<int>(), 0);
  EXPECT_FALSE(report().contains("conditioning"));
  EXPECT_FALSE(fs::exists(path("b.vtu")));
}

TEST_F(Report, OfAFullDiskKeepsWhatWasMadeAndTheOldMesh)
{
  writeSample();
  ASSERT_EQ(mesh("prostate.nrrd").exitCode, 0);
  const std::string old = contentOf(path("b.vtu"));
  expectFailure(mesh("prostate.nrrd", { "--shells=6", "--stage=initial" }, 8192), "E_IO");
  EXPECT_EQ(contentOf(path("b.vtu")), old);
  EXPECT_TRUE(report().contains("conditioning"));
  EXPECT_FALSE(report()["stages"].empty());
  EXPECT_EQ(report()["mesh"], nlohmann::json({ { "file", path("b.vtu") } }));
}

TEST_F(Report, OfAnOutputThatCannotBeWrittenIsStillWritten)
{
  writeSample();
  const Outcome outcome = run({ "mesh", path("prostate.nrrd"), path("no/b.vtu"), "--report", path("r.json") });
  expectFailure(outcome, "E_CANTCREAT");
}

TEST_F(Report, OfWrongUsageIsNotWritten)
{
  std::ofstream(path("r.json")) << "old";
  expectErrorCode(mesh("missing.nrrd", { "--way=fast", "--stage=initial" }), "E_USAGE");
  std::ofstream(path("cube.off")) << "OFF\n";
  expectErrorCode(mesh("cube.off", { "--threshold=1" }), "E_USAGE");
  EXPECT_EQ(contentOf(path("r.json")), "old");
}

TEST_F(Report, ThatCannotBeWrittenDoesNotHideTheErrorBeforeIt)
{
  expectErrorCode(run({ "mesh", path("missing.nrrd"), path("b.vtu"), "--report", path("no/r.json") }), "E_NOINPUT");
  EXPECT_EQ(fileCount(), 0u);
}

TEST_F(Report, ThatIsReproducibleHasTheSameBytesForAnyNumberOfThreads)
{
  writeSample();
  ASSERT_EQ(mesh("prostate.nrrd", { "--shells=3", "--reproducible", "--threads=1" }).exitCode, 0);
  const std::string one = contentOf(path("r.json"));
  ASSERT_EQ(mesh("prostate.nrrd", { "--shells=3", "--reproducible", "--threads=2" }).exitCode, 0);
  EXPECT_EQ(contentOf(path("r.json")), one);
  EXPECT_EQ(one.find("seconds"), std::string::npos);
  ASSERT_EQ(mesh("missing.nrrd", { "--reproducible", "--threads=1" }).exitCode, 3);
  EXPECT_EQ(contentOf(path("r.json")).find("seconds"), std::string::npos);
}

TEST_F(ReportPage, IsHtmlAndHoldsTheOtherReport)
{
  writeSample();
  ASSERT_EQ(mesh("prostate.nrrd", { "--shells=3", "--report", path("r.html"), "--reproducible" }).exitCode, 0);
  const std::string page = contentOf(path("r.html"));
  EXPECT_EQ(page.find("<!DOCTYPE html>"), 0u);
  const std::string begin = "id=\"report-data\">";
  const std::size_t at = page.find(begin) + begin.size();
  EXPECT_EQ(nlohmann::json::parse(page.substr(at, page.find("</script>", at) - at)), report());
}

TEST_F(ReportPage, ThatIsReproducibleHasTheSameBytesForAnyNumberOfThreads)
{
  writeSample();
  const auto pageWith = [this](const std::string & threads) {
    EXPECT_EQ(mesh("prostate.nrrd", { "--shells=3", "--reproducible", threads, "--report", path("r.html") }).exitCode,
              0);
    return contentOf(path("r.html"));
  };
  const std::string one = pageWith("--threads=1");
  EXPECT_GT(one.size(), 100000u);
  EXPECT_TRUE(pageWith("--threads=3") == one);
}

TEST_F(ReportPage, IsWrittenOfAFailureToo)
{
  writeLabelImage(path("tunnel.nrrd"), cubeWithTunnel());
  expectFailure(mesh("tunnel.nrrd", { "--topology=reject", "--report", path("r.html") }), "E_TOPOLOGY");
  const std::string page = contentOf(path("r.html"));
  EXPECT_NE(page.find("Do not use"), std::string::npos);
  EXPECT_NE(page.find("E_TOPOLOGY"), std::string::npos);
  EXPECT_NE(page.find("<svg class=\"slice\""), std::string::npos);
}

TEST_F(Report, HasOneNameOfEachKind)
{
  writeSample();
  expectErrorCode(mesh("prostate.nrrd", { "--report", path("s.json") }), "E_USAGE");
  expectErrorCode(mesh("prostate.nrrd", { "--report", path("a.html"), "--report", path("b.htm") }), "E_USAGE");
  EXPECT_EQ(fileCount(), 1u);
}

TEST_F(Report, ThatIsAPageIsRefusedByAProgramWithoutPages)
{
  if (pagesAreBuilt())
  {
    GTEST_SKIP() << "MoserHex_BUILD_REPORTS is ON";
  }
  writeSample();
  expectErrorCode(mesh("prostate.nrrd", { "--report", path("r.html") }), "E_USAGE");
  EXPECT_EQ(fileCount(), 1u);
}

TEST_F(Report, CountsTheMemoryOfTheRunAndNotOfTheProgramThatStartedIt)
{
  constexpr std::size_t   mebibytes = 600;
  const std::vector<char> held(mebibytes << 20, 'x');
  ASSERT_EQ(mesh("missing.nrrd").exitCode, 3);
  EXPECT_LT(report()["peak_memory_mib"].get<double>(), static_cast<double>(mebibytes) / 2.0) << held.back();
}

TEST(PeakMemory, GrowsByWhatIsHeld)
{
  const double before = peakMemory().value();
  const auto   more = static_cast<std::size_t>(before) + 64;
  {
    const std::vector<char> held(more << 20, 'x');
    EXPECT_GT(peakMemory().value(), before + 60.0) << held.back();
  }
  EXPECT_GT(peakMemory().value(), before + 60.0);
}
