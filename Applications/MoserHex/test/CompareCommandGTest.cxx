// Exact: exit codes, streams and files of moserhex compare. Numbers of boxes to 1e-9.
#include "CommandTest.h"

#include "TextTable.h"
#include "moserhex/Analytic/Lattices.h"
#include "moserhex/HexMeshIO/HexMeshReader.h"
#include "moserhex/HexMeshIO/HexMeshWriter.h"
#include "moserhex/HexMeshIO/InputChecksum.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>

using namespace moserhex;
using namespace moserhex::app;
namespace fs = std::filesystem;

namespace
{

HexMesh
block(int n, const Vector3 & size, const Vector3 & origin)
{
  HexMesh mesh{ n, {}, 0 };
  for (int node = 0; node < n * n * n; ++node)
  {
    mesh.nodes.emplace_back(Vector3(node % n, node / n % n, node / (n * n)).cwiseProduct(size) / (n - 1) + origin);
  }
  return mesh;
}

class CompareCommand : public CommandTest
{
protected:
  void
  SetUp() override
  {
    CommandTest::SetUp();
    writeHexMesh(path("a.vtu"), block(4, { 10, 10, 10 }, { 0, 0, 0 }));
    writeHexMesh(path("b.vtu"), block(4, { 12, 10, 10 }, { 50, 0, 0 }));
    writeHexMesh(path("c.vtu"), block(4, { 14, 10, 10 }, { -50, 0, 7 }));
  }
};

} // namespace

TEST_F(CompareCommand, AGivenTransformIsTakenAway)
{
  std::ofstream(path("move.tfm")) << "#Insight Transform File V1.0\n#Transform 0\n"
                                     "Transform: AffineTransform_double_3_3\n"
                                     "Parameters: 1 0 0 0 1 0 0 0 1 50 0 0\nFixedParameters: 0 0 0\n";
  const std::vector<std::string> command{ "compare",   path("a.vtu"), path("b.vtu"),  "--output",
                                          path("out"), "--quiet",     "--transforms", path("move.tfm") };
  const Outcome                  outcome = run(command);
  ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_LE((readHexMesh(path("out/time-001.vtu")).nodes[0] - Vector3(0, 0, 0)).norm(), 1e-9);
  const auto summary = nlohmann::json::parse(contentOf(path("out/summary.json")));
  EXPECT_EQ(summary["align"], "file");
  const auto alignment = summary["times"][1]["alignment"];
  EXPECT_EQ(alignment["direction"], "this time to baseline");
  EXPECT_NEAR(alignment["translation_mm"][0].get<double>(), -50.0, 1e-9);
  EXPECT_EQ(alignment["transform"]["file"], path("move.tfm"));
  EXPECT_EQ(alignment["transform"]["sha256"], sha256OfInput(path("move.tfm")));
  EXPECT_EQ(alignment["transform"]["direction"], "baseline to this time");
  EXPECT_FALSE(summary["times"][0]["alignment"].contains("transform"));
  std::vector<std::string> twoForOne = command;
  twoForOne.back() += "," + path("move.tfm");
  expectErrorCode(run(twoForOne), "E_USAGE");
}

TEST_F(CompareCommand, ThreeTimesGiveASeriesATableAndASummary)
{
  const Outcome outcome = run({ "compare",
                                path("a.vtu"),
                                path("b.vtu"),
                                path("c.vtu"),
                                "--times",
                                "0,12,24",
                                "--names",
                                "first,second,third",
                                "--output",
                                path("out") });
  ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_EQ(outcome.error, "");
  EXPECT_NE(outcome.out.find("\nsecond                    12       1.20     20.00 "), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("cells grow alike by construction"), std::string::npos);

  const std::string series = contentOf(path("out/series.pvd"));
  EXPECT_NE(series.find("<DataSet timestep=\"24\" part=\"0\" file=\"time-002.vtu\"/>"), std::string::npos) << series;
  EXPECT_LE((readHexMesh(path("out/time-002.vtu")).nodes[0] - Vector3(-2, 0, 0)).norm(), 1e-9); // aligned

  const auto summary = nlohmann::json::parse(contentOf(path("out/summary.json")));
  ASSERT_EQ(summary["times"].size(), 3u);
  EXPECT_EQ(summary["align"], "rigid");
  EXPECT_EQ(summary["times"][2]["sha256"], sha256OfInput(path("c.vtu")));
  EXPECT_LE(summary["times"][2]["cell_volume_variance"].get<double>(), 1e-20);
  EXPECT_EQ(summary["times"][2]["concave_cells"], 0);
  EXPECT_NEAR(summary["times"][2]["volume_change_percent"].get<double>(), 40.0, 1e-9);
  EXPECT_NEAR(summary["times"][2]["organ"]["normal_motion_mm"]["max"].get<double>(), 2.0, 1e-9);
  EXPECT_NEAR(summary["times"][2]["largest_stretch"]["stretch"].get<double>(), 1.4 / std::cbrt(1.4), 1e-9);
  EXPECT_TRUE(summary["times"][0]["largest_stretch"].is_null());
  EXPECT_TRUE(summary["times"][2]["uniform_growth"].get<bool>());

  const TextTable table = readTextTable(path("out/regions.csv"));
  // 3 times, 12 measures of the organ, of 8 octants and of the outer shell, 7 of the inner one
  EXPECT_EQ(table.rows.size(), 3u * (12 * 10 + 7));
  EXPECT_EQ(table.rows.back().cells[1], "third");
}

TEST_F(CompareCommand, AlignmentAndRegionsAreChosen)
{
  std::ofstream(path("boxes.csv")) << "name,imin,imax,jmin,jmax,kmin,kmax\napex,0,1,0,1,0,0.25\n";
  ASSERT_EQ(run({ "compare",
                  path("a.vtu"),
                  path("b.vtu"),
                  "--align",
                  "none",
                  "--regions",
                  "halves," + path("boxes.csv"),
                  "--output",
                  path("out"),
                  "--quiet" })
              .out,
            "");
  EXPECT_EQ(readHexMesh(path("out/time-001.vtu")).nodes[0], Vector3(50, 0, 0));
  const std::string mesh = contentOf(path("out/time-001.vtu"));
  for (const char * array : { "HalvesRightLeft", "HalvesAnteriorPosterior", "HalvesInferiorSuperior", "Boxes" })
  {
    EXPECT_NE(mesh.find(std::string("Name=\"") + array + '"'), std::string::npos) << array;
  }
  const auto regions = nlohmann::json::parse(contentOf(path("out/summary.json")))["regions"];
  EXPECT_EQ(regions[0]["set"], "halves");
  EXPECT_FALSE(regions[0].contains("file"));
  EXPECT_EQ(regions[1]["file"], path("boxes.csv"));
  EXPECT_EQ(regions[1]["sha256"], sha256OfInput(path("boxes.csv")));
  const std::string table = contentOf(path("out/regions.csv"));
  EXPECT_NE(table.find("1,b,,halves,left,"), std::string::npos);
  EXPECT_NE(table.find("1,b,,boxes,apex,"), std::string::npos);
  EXPECT_EQ(table.find("octants"), std::string::npos);
}

TEST_F(CompareCommand, OptionsMayComeBeforeTheMeshes)
{
  std::ofstream(path("move.tfm")) << "#Insight Transform File V1.0\n#Transform 0\n"
                                     "Transform: TranslationTransform_double_3_3\n"
                                     "Parameters: 50 0 0\nFixedParameters: \n";
  const std::vector<std::vector<std::string>> options{
    { "--transforms", path("move.tfm") }, { "--regions", "octants" }, { "--times", "0,12" }, { "--names", "x,y" }
  };
  for (const std::vector<std::string> & option : options)
  {
    const Outcome outcome = run(
      { "compare", "--output", path("out"), "--quiet", option.front(), option.back(), path("a.vtu"), path("b.vtu") });
    EXPECT_EQ(outcome.exitCode, 0) << option.front() << ": " << outcome.error;
  }
}

TEST_F(CompareCommand, PaddingCountsAsPartOfTheOrgan)
{
  const auto withPadding = [](double thickness) { // of two layers around a cube of 3 mm [mm]
    return analytic::paddedLattice(4, 2, [thickness](const Vector3 & index) {
      const Vector3 inside = index.cwiseMax(0.0).cwiseMin(3.0);
      return Vector3(inside + 0.5 * thickness * (index - inside));
    });
  };
  writeHexMesh(path("thin.vtu"), withPadding(1.0));
  writeHexMesh(path("thick.vtu"), withPadding(2.0));
  const Outcome outcome =
    run({ "compare", path("thin.vtu"), path("thick.vtu"), "--align", "none", "--output", path("out") });
  ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
  const auto followUp = nlohmann::json::parse(contentOf(path("out/summary.json")))["times"][1];
  EXPECT_NEAR(followUp["volume_mm3"].get<double>(), 343.0, 1e-9);
  EXPECT_NEAR(followUp["volume_change_percent"].get<double>(), 100.0 * (343.0 / 125.0 - 1.0), 1e-9);
  EXPECT_NEAR(followUp["lattice_volume_mm3"].get<double>(), 27.0, 1e-9);
  EXPECT_NEAR(followUp["lattice_volume_change_percent"].get<double>(), 0.0, 1e-9);
  EXPECT_NE(outcome.out.find(" 174.40 "), std::string::npos) << outcome.out;
}

TEST_F(CompareCommand, ABadCellIsReportedWithItsFile)
{
  HexMesh bad = block(4, { 10, 10, 10 }, { 0, 0, 0 });
  bad.nodes[0] = Vector3(7, 7, 7);
  writeHexMesh(path("bad.vtu"), bad);
  const Outcome outcome = run({ "compare", path("a.vtu"), path("bad.vtu"), "--output", path("out") });
  expectErrorCode(outcome, "E_PRECONDITION");
  EXPECT_NE(outcome.error.find("bad.vtu: cell 0"), std::string::npos) << outcome.error;
}

TEST_F(CompareCommand, TheSameBytesForAnyNumberOfThreads)
{
  for (const std::string threads : { "1", "3" })
  {
    ASSERT_EQ(
      run({ "compare", path("a.vtu"), path("c.vtu"), "--threads", threads, "--output", path(threads) }).exitCode, 0);
  }
  for (const char * name : { "series.pvd", "time-000.vtu", "time-001.vtu", "regions.csv", "summary.json" })
  {
    EXPECT_EQ(contentOf(fs::path(path("1")) / name), contentOf(fs::path(path("3")) / name)) << name;
  }
}

TEST_F(CompareCommand, RefusesWithCodesAndWritesNothing)
{
  writeHexMesh(path("large.vtu"), block(6, { 10, 10, 10 }, { 0, 0, 0 }));
  const std::size_t files = fileCount();
  expectErrorCode(run({ "compare", path("a.vtu"), path("large.vtu"), "--output", path("out") }), "E_PRECONDITION");
  expectErrorCode(run({ "compare", path("a.vtu"), "--output", path("out") }), "E_USAGE");
  expectErrorCode(run({ "compare", path("a.vtu"), path("b.vtu") }), "E_USAGE");
  expectErrorCode(run({ "compare", path("a.vtu"), path("no.vtu"), "--output", path("out") }), "E_NOINPUT");
  expectErrorCode(run({ "compare", path("a.vtu"), path("b.vtu"), "--times", "5,1", "--output", path("out") }),
                  "E_USAGE");
  expectErrorCode(run({ "compare", path("a.vtu"), path("b.vtu"), "--regions", "x", "--output", path("out") }),
                  "E_USAGE");
  expectErrorCode(run({ "compare", path("a.vtu"), path("b.vtu"), "--output", path("a.vtu") }), "E_CANTCREAT");
  EXPECT_EQ(fileCount(), files);
}

TEST_F(CompareCommand, AMeshThatIsReadIsNotOverwritten)
{
  fs::create_directory(path("out"));
  fs::copy_file(path("a.vtu"), path("out/time-000.vtu"));
  expectErrorCode(run({ "compare", path("out/time-000.vtu"), path("b.vtu"), "--output", path("out") }), "E_USAGE");
}
