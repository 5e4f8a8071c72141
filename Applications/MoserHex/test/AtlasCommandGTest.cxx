// Files exact; scores of projected meshes 1e-9 of a standard deviation, reconstructed nodes 1e-9 mm.
#include "CommandTest.h"
#include "PageName.h"
#include "TextTable.h"
#include "moserhex/Common/Random.h"
#include "moserhex/HexMeshIO/AtomicFile.h"
#include "moserhex/HexMeshIO/HexMeshReader.h"
#include "moserhex/HexMeshIO/HexMeshWriter.h"
#include "moserhex/HexMeshIO/LabelImageReader.h"
#include "moserhex/Quality/HexQuality.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

using namespace moserhex;
using namespace moserhex::app;
namespace fs = std::filesystem;

namespace
{

/** A box of 5^3 nodes, some 40 mm, whose sides depend on the subject; every second one has a bulge of 4 mm at the end
 * of the first axis. */
HexMesh
boxOf(int subject, int n = 5)
{
  Random        random(static_cast<std::uint64_t>(subject) + 1);
  const Vector3 sides(40.0 + random.uniform(-3, 3), 30.0 + random.uniform(-2, 2), 35.0 + random.uniform(-2, 2));
  HexMesh       mesh{ n, {} };
  for (int node = 0; node < n * n * n; ++node)
  {
    const Vector3 c = Vector3(node % n, node / n % n, node / (n * n)) / (n - 1);
    const Vector3 noise(random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2));
    const double  bulge = subject % 2 == 1 ? 4.0 * std::pow(c[0], 4) * c[1] * (1 - c[1]) * 4 : 0.0;
    mesh.nodes.push_back(sides.cwiseProduct(c) + noise + bulge * Vector3::UnitX() +
                         Vector3(100.0, -20.0 * subject, 7.0));
  }
  return mesh;
}

class AtlasCommand : public CommandTest
{
protected:
  /** m/0.vtu ... and table.csv, with groups odd and even and three sites. */
  void
  writeSubjects(int count) const
  {
    fs::create_directories(path("m"));
    std::string table = "subject,mesh,group,age,site\n";
    for (int i = 0; i < count; ++i)
    {
      const std::string number = std::to_string(i);
      writeHexMesh(path("m/" + number + ".vtu"), boxOf(i));
      table += "S" + number + ",m/" + number + ".vtu," + (i % 2 == 1 ? "odd" : "even") + "," +
               std::to_string(50 + i * 7 % 11) + "," + std::array{ "north", "south", "west" }[i / 2 % 3] + "\n";
    }
    writeTextFile(path("table.csv"), table);
  }

  [[nodiscard]] Outcome
  atlas(const std::string & input, const std::string & output, const std::vector<std::string> & more = {}) const
  {
    std::vector<std::string> arguments{ "atlas", path(input), "--output", path(output), "--no-sandbox" };
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }

  [[nodiscard]] nlohmann::json
  summary(const std::string & output) const
  {
    return nlohmann::json::parse(contentOf(path(output + "/atlas.json")));
  }
};

} // namespace

TEST_F(AtlasCommand, WritesTheMeanTheModesAndTheTests)
{
  writeSubjects(16);
  const Outcome outcome =
    atlas("table.csv", "out", { "--group", "group", "--covariates", "age", "--regress", "age", "--permutations=499" });
  ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_EQ(outcome.error, "");
  for (const char * file : { "mean.vtu",
                             "mode-01-plus3.vtu",
                             "mode-01-minus3.vtu",
                             "template.nrrd",
                             "scores.csv",
                             "model.json",
                             "model.f64",
                             "model_quality.csv",
                             "group.vtu",
                             "group.csv",
                             "regression.vtu",
                             "regression.csv",
                             "atlas.json" })
  {
    EXPECT_TRUE(fs::exists(path(std::string("out/") + file))) << file;
  }
  EXPECT_EQ(fs::exists(path("out/atlas.html")), pagesAreBuilt());
  const HexMesh           mean = readHexMesh(path("out/mean.vtu"));
  const HexQualitySummary quality = summarizeQuality(mean);
  EXPECT_LT(quality.volumeVariance, 1e-18);
  EXPECT_EQ(quality.certified.positive, mean.cellCount());
  const auto json = summary("out");
  EXPECT_EQ(json["subjects"], 16);
  EXPECT_EQ(json["tests"]["group"]["groups"], (std::vector<std::string>{ "even", "odd" }));
  EXPECT_EQ(json["tests"]["group"]["covariates"], std::vector<std::string>{ "age" });
  EXPECT_EQ(json["tests"]["regression"]["covariates"], std::vector<std::string>{});
  EXPECT_LE(json["tests"]["group"]["smallest_p_family_wise"], 0.05);
  EXPECT_EQ(readTextTable(path("out/group.csv")).rows.size(), 125u);
  EXPECT_EQ(readTextTable(path("out/scores.csv")).rows.size(), 16u);
}

TEST_F(AtlasCommand, ThreeGroupsAreComparedAtOnce)
{
  writeSubjects(18);
  const Outcome outcome = atlas("table.csv", "out", { "--group=site", "--covariates=age", "--permutations=99" });
  ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_NE(outcome.out.find("site, north (6), south (6), west (6)"), std::string::npos) << outcome.out;
  const auto test = summary("out")["tests"]["group"];
  EXPECT_EQ(test["groups"], (std::vector<std::string>{ "north", "south", "west" }));
  EXPECT_EQ(test["group_sizes"], (std::vector<int>{ 6, 6, 6 }));
  EXPECT_EQ(test["statistic"], "Pillai's trace");
  EXPECT_EQ(test["degrees_of_freedom"], 14); // 18 less constant, age and two
  const TextTable table = readTextTable(path("out/group.csv"));
  EXPECT_EQ(std::vector<std::string>(table.columns.begin() + 7, table.columns.end()),
            (std::vector<std::string>{ "difference_north_x",
                                       "difference_north_y",
                                       "difference_north_z",
                                       "difference_south_x",
                                       "difference_south_y",
                                       "difference_south_z",
                                       "difference_west_x",
                                       "difference_west_y",
                                       "difference_west_z",
                                       "pillai_trace",
                                       "p",
                                       "p_family_wise",
                                       "q_false_discovery",
                                       "effect_size" }));
  for (const TextTable::Row & row : table.rows)
  {
    const auto number = [&row](std::size_t column) { return std::strtod(row.cells[column].c_str(), nullptr); };
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      EXPECT_NEAR(number(7 + axis) + number(10 + axis) + number(13 + axis), 0.0, 1e-9); // groups of equal sizes
    }
    EXPECT_NEAR(number(16) / 2.0, number(20), 1e-12); // partial eta squared: V / s
  }
  EXPECT_NE(contentOf(path("out/group.vtu")).find("Name=\"Difference_south\""), std::string::npos);
}

TEST_F(AtlasCommand, MeshesOfModesAreExactAndSayHowManyDeviationsTheyShow)
{
  writeSubjects(8);
  const Outcome outcome = atlas("m", "out", { "--mode-meshes=2" });
  ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
  const auto meshes = summary("out")["model"]["meshes"];
  ASSERT_EQ(meshes.size(), 4u);
  for (const auto & entry : meshes)
  {
    const HexMesh           mesh = readHexMesh(path("out/" + entry["file"].get<std::string>()));
    const HexQualitySummary quality = summarizeQuality(mesh);
    EXPECT_LT(quality.volumeVariance, 1e-18);
    EXPECT_EQ(quality.certified.positive, mesh.cellCount());
    EXPECT_EQ(std::abs(entry["standard_deviations"].get<double>()), 3.0);
  }
  EXPECT_NE(contentOf(path("out/mode-01-minus3.vtu")).find("Name=\"StandardDeviations\""), std::string::npos);
}

TEST_F(AtlasCommand, AModeThatIsNoShapeAtThreeDeviationsIsShownByLessWithAWarning)
{
  // Boxes alike in all but their first side, which a few have nearly lost: at minus three deviations it is negative.
  fs::create_directories(path("m"));
  for (int i = 0; i < 6; ++i)
  {
    HexMesh box = boxOf(0);
    for (Vector3 & node : box.nodes)
    {
      node[0] *= i < 3 ? 0.2 + 0.02 * i : 1.0 + 0.02 * i;
    }
    writeHexMesh(path("m/" + std::to_string(i) + ".vtu"), box);
  }
  const Outcome outcome = atlas("m", "out", { "--mode-meshes=1", "--align=none" });
  ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
  const auto json = summary("out");
  const auto meshes = json["model"]["meshes"];
  ASSERT_EQ(meshes.size(), 2u);
  const bool isPlusReduced = std::abs(meshes[0]["standard_deviations"].get<double>()) < 3.0;
  const auto reduced = meshes[isPlusReduced ? 0 : 1];
  const auto whole = meshes[isPlusReduced ? 1 : 0];
  const auto file = reduced["file"].get<std::string>();
  EXPECT_EQ(std::abs(whole["standard_deviations"].get<double>()), 3.0);
  EXPECT_EQ(std::abs(reduced["standard_deviations"].get<double>()), 1.0);
  EXPECT_EQ(reduced["attempts"].size(), 4u);
  EXPECT_TRUE(fs::exists(path("out/" + file)));
  EXPECT_NE(outcome.error.find(file + ": shows "), std::string::npos) << outcome.error;
  ASSERT_EQ(json["warnings"].size(), 1u);
  EXPECT_NE(outcome.error.find(json["warnings"][0].get<std::string>().substr(0, 60)), std::string::npos);
}

TEST_F(AtlasCommand, TheTemplateHasTheMeansVolume)
{
  writeSubjects(4);
  ASSERT_EQ(atlas("m", "out").exitCode, 0);
  const auto        image = readLabelImage(path("out/template.nrrd"));
  const std::size_t voxels = voxelCount(labelVolumeOf(*image.image, 1));
  const double      volume = summary("out")["mean"]["volume_ml"];
  EXPECT_NEAR(static_cast<double>(voxels) / 1000.0, volume, 0.03 * volume);
}

TEST_F(AtlasCommand, TheSameFilesForAnyNumberOfThreads)
{
  writeSubjects(8);
  ASSERT_EQ(atlas("table.csv", "one", { "--group=group", "--permutations=99", "--threads=1" }).exitCode, 0);
  ASSERT_EQ(atlas("table.csv", "three", { "--group=group", "--permutations=99", "--threads=3" }).exitCode, 0);
  for (const auto & entry : fs::directory_iterator(path("one")))
  {
    const std::string name = entry.path().filename().string();
    EXPECT_EQ(contentOf(path("one/" + name)), contentOf(path("three/" + name))) << name;
  }
}

TEST_F(AtlasCommand, ASubjectIsProjectedToItsOwnScoresAndMadeOfThem)
{
  writeSubjects(6);
  ASSERT_EQ(atlas("m", "out", { "--modes=100%", "--align=none" }).exitCode, 0);
  ASSERT_EQ(atlas("m", "projected", { "--project", path("out/model.json") }).exitCode, 0);
  const TextTable first = readTextTable(path("out/scores.csv"));
  const TextTable again = readTextTable(path("projected/scores.csv"));
  ASSERT_EQ(again.rows.size(), 6u);
  ASSERT_EQ(first.columns.back(), "mode_5");
  for (std::size_t row = 0; row < 6; ++row)
  {
    EXPECT_LT(std::strtod(again.rows[row].cells[4].c_str(), nullptr), 1e-9);
    for (std::size_t column = 5; column < 10; ++column)
    {
      EXPECT_NEAR(std::strtod(first.rows[row].cells[column].c_str(), nullptr),
                  std::strtod(again.rows[row].cells[column].c_str(), nullptr),
                  1e-9);
    }
  }
  ASSERT_EQ(atlas("out/scores.csv", "made", { "--reconstruct", path("out/model.json") }).exitCode, 0);
  const HexMesh made = readHexMesh(path("made/3.vtu"));
  for (std::size_t node = 0; node < made.nodes.size(); ++node)
  {
    EXPECT_LT((made.nodes[node] - boxOf(3).nodes[node]).norm(), 1e-9);
  }
}

TEST_F(AtlasCommand, ProjectionAndReconstructionReplaceNoInput)
{
  writeSubjects(6);
  ASSERT_EQ(atlas("m", "out", { "--modes=100%", "--align=none" }).exitCode, 0);
  const std::string scores = contentOf(path("out/scores.csv"));
  const std::string mesh = contentOf(path("m/3.vtu"));
  const std::string model = path("out/model.json");
  expectErrorCode(atlas("out/scores.csv", "m", { "--reconstruct", model }), "E_USAGE"); // among the subjects
  expectErrorCode(atlas("out/scores.csv", "out", { "--reconstruct", model }), "E_USAGE");
  expectErrorCode(atlas("m", "out", { "--project", model }), "E_USAGE");
  EXPECT_EQ(contentOf(path("out/scores.csv")), scores);
  EXPECT_EQ(contentOf(path("m/3.vtu")), mesh);
  ASSERT_EQ(atlas("out/scores.csv", "made", { "--reconstruct", model }).exitCode, 0);
  EXPECT_EQ(atlas("out/scores.csv", "made", { "--reconstruct", model, "--modes=2" }).exitCode, 0); // its own
}

TEST_F(AtlasCommand, NamesOfGroupsMayHoldAnything)
{
  writeSubjects(9);
  std::string table = "mesh,age\n";
  for (int i = 0; i < 9; ++i)
  {
    const char * const groups[] = { "<50", ">65", "R&D \"x\"" };
    table += "m/" + std::to_string(i) + ".vtu,\"" + (i % 3 == 2 ? "R&D \"\"x\"\"" : groups[i % 3]) + "\"\n";
  }
  writeTextFile(path("ages.csv"), table);
  const Outcome outcome = atlas("ages.csv", "out", { "--group=age", "--permutations=99" });
  ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
  const std::string mesh = contentOf(path("out/group.vtu"));
  for (const char * name : { "Difference__50_1", "Difference__65_2", "Difference_R_D _x__3" })
  {
    EXPECT_NE(mesh.find(name), std::string::npos) << name;
  }
  EXPECT_NE(contentOf(path("out/group.csv")).find("difference_<50_x"), std::string::npos);
}

TEST_F(AtlasCommand, AnAtlasThatWasNotFinishedIsNoSubjectAndGoes)
{
  writeSubjects(6);
  ASSERT_EQ(atlas("m", "m/atlas", {}).exitCode, 0);
  fs::remove(path("m/atlas/model.json"));
  writeTextFile(path("m/atlas/atlas.json"), "{ \"status\": \"unfinished\" }\n");
  const Outcome outcome = atlas("m", "out", {});
  EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_NE(outcome.out.find("subjects    6"), std::string::npos) << outcome.out;
}

TEST_F(AtlasCommand, ALatticeThatWasTurnedIsWarnedOf)
{
  writeSubjects(4);
  writeTextFile(path("m/2.json"), R"json({"warnings": ["the lattice is turned by 45 degrees about (0, 0, 1)"]})json");
  const Outcome outcome = atlas("m", "out", { "--quiet" });
  EXPECT_EQ(outcome.exitCode, 0);
  EXPECT_NE(outcome.error.find("lattice is turned by 45 degrees"), std::string::npos) << outcome.error;
}

TEST_F(AtlasCommand, OptionsMayComeBeforeTheTable)
{
  writeSubjects(8);
  const Outcome outcome = run({ "atlas",
                                "--output",
                                path("out"),
                                "--no-sandbox",
                                "--permutations=99",
                                "--group",
                                "group",
                                "--covariates",
                                "age",
                                path("table.csv") });
  ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_EQ(summary("out")["tests"]["group"]["covariates"], std::vector<std::string>{ "age" });
}

TEST_F(AtlasCommand, ACovariateThatFollowsFromOthersIsLeftOutWithAWarning)
{
  writeSubjects(16);
  std::string table = "mesh,group,age,born,scanner,site\n";
  for (int i = 0; i < 16; ++i)
  {
    const double age = 50.3 + i * 7 % 11;
    table += "m/" + std::to_string(i) + ".vtu," + (i % 2 == 1 ? "odd," : "even,") + std::to_string(age) + "," +
             std::to_string(2024.1 - age) + ",3.6," + std::array{ "north", "south", "west" }[i / 2 % 3] + "\n";
  }
  writeTextFile(path("table.csv"), table);
  const Outcome few = atlas("table.csv", "few", { "--group=group", "--covariates=age,site", "--permutations=99" });
  const Outcome all =
    atlas("table.csv", "all", { "--group=group", "--covariates=age,born,scanner,site", "--permutations=99" });
  ASSERT_EQ(few.exitCode, 0) << few.error;
  ASSERT_EQ(all.exitCode, 0) << all.error;
  EXPECT_EQ(few.error, "");
  EXPECT_NE(all.error.find("the covariate born is left out"), std::string::npos) << all.error;
  EXPECT_NE(all.error.find("the covariate scanner is left out"), std::string::npos) << all.error;
  EXPECT_EQ(contentOf(path("few/group.csv")), contentOf(path("all/group.csv")));
  const auto test = summary("all")["tests"]["group"];
  EXPECT_EQ(test["covariates_left_out"], (std::vector<std::string>{ "born", "scanner" }));
  EXPECT_EQ(test["degrees_of_freedom"], 11); // 16 less constant, age, two of the sites and the groups
}

TEST_F(AtlasCommand, TheSmallestPossiblePIsSaid)
{
  writeSubjects(8);
  const Outcome outcome = atlas("table.csv", "out", { "--group=group" });
  ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
  const auto test = summary("out")["tests"]["group"];
  EXPECT_EQ(test["permutations"], 70);
  EXPECT_EQ(test["exact"], true);
  EXPECT_NEAR(test["smallest_possible_p"].get<double>(), 2.0 / 70.0, 1e-12);
  EXPECT_GE(test["smallest_p_family_wise"], test["smallest_possible_p"]);
  EXPECT_NE(outcome.out.find("of at least 0.02857"), std::string::npos) << outcome.out;
}

TEST_F(AtlasCommand, AnEarlierAtlasIsNoSubjectAndIsReplaced)
{
  writeSubjects(5);
  ASSERT_EQ(atlas("table.csv", "m/old", { "--group=group", "--permutations=9" }).exitCode, 0);
  const Outcome other = atlas("m", "out");
  ASSERT_EQ(other.exitCode, 0) << other.error;
  EXPECT_EQ(summary("out")["subjects"], 5);
  EXPECT_NE(other.error.find("old: an atlas"), std::string::npos) << other.error;
  writeTextFile(path("m/old/notes.txt"), "mine");
  ASSERT_EQ(atlas("m", "m/old", { "--mode-meshes=1" }).exitCode, 0);
  EXPECT_TRUE(fs::exists(path("m/old/mode-01-plus3.vtu")));
  EXPECT_TRUE(fs::exists(path("m/old/notes.txt")));
  for (const char * stale : { "group.vtu", "group.csv", "mode-02-plus3.vtu" })
  {
    EXPECT_FALSE(fs::exists(path(std::string("m/old/") + stale))) << stale;
  }
  expectErrorCode(atlas("m", "m"), "E_USAGE");
  expectErrorCode(atlas("m/old/mean.vtu", "m/old", { path("m/1.vtu") }), "E_USAGE");
  expectErrorCode(atlas("m/old", "out"), "E_NOINPUT");
}

TEST_F(AtlasCommand, ATemplateThatWouldBeTooLargeCostsTheTemplateOnly)
{
  writeSubjects(4);
  const Outcome outcome = atlas("m", "out", { "--label-spacing=0.01", "--mode-meshes=0" });
  ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_NE(outcome.error.find("template.nrrd is not written"), std::string::npos) << outcome.error;
  EXPECT_FALSE(fs::exists(path("out/template.nrrd")));
  EXPECT_TRUE(fs::exists(path("out/model.json")));
  EXPECT_EQ(summary("out")["warnings"].size(), 1u);
}

TEST_F(AtlasCommand, ADesignThatCannotBeTestedIsRefusedBeforeTheMeshesAreRead)
{
  writeTextFile(path("table.csv"),
                "mesh,group,age,arm\nno/1.vtu,a,1,x\nno/2.vtu,b,2,x\nno/3.vtu,a,4,y\nno/4.vtu,b,3,y\n");
  expectErrorCode(atlas("table.csv", "out", { "--group=group", "--covariates=age" }), "E_PRECONDITION");
  expectErrorCode(atlas("table.csv", "out", { "--group=arm" }), "E_PRECONDITION");
}

TEST_F(AtlasCommand, AMeanThatIsNoSolidIsRefusedWithAReason)
{
  // One box in three scanners, each half a turn from the others: the mean of the turns is a reflection.
  fs::create_directories(path("m"));
  for (int axis = 0; axis < 3; ++axis)
  {
    HexMesh box = boxOf(0);
    for (Vector3 & node : box.nodes)
    {
      const double kept = node[axis];
      node = -node;
      node[axis] = kept;
    }
    writeHexMesh(path("m/" + std::to_string(axis) + ".vtu"), box);
  }
  const Outcome outcome = atlas("m", "out", { "--align=none" });
  expectErrorCode(outcome, "E_PRECONDITION");
  EXPECT_NE(outcome.error.find("the subjects' mean is no solid"), std::string::npos) << outcome.error;
}

TEST_F(AtlasCommand, MeshesAreMadeOfAnyOfTheModes)
{
  writeSubjects(6);
  ASSERT_EQ(atlas("m", "out", { "--modes=3", "--align=none" }).exitCode, 0);
  const auto make = [&](const std::string & table, const std::string & folder, const std::vector<std::string> & more) {
    writeTextFile(path("scores.csv"), table);
    std::vector<std::string> arguments{ "--reconstruct", path("out/model.json") };
    arguments.insert(arguments.end(), more.begin(), more.end());
    return atlas("scores.csv", folder, arguments);
  };
  const auto nodes = [&](const std::string & file) { return readHexMesh(path(file)).nodes; };
  ASSERT_EQ(make("subject,mode_2\n,+3\nB,-3\nNA,\n", "made", {}).exitCode, 0);
  EXPECT_TRUE(fs::exists(path("made/row-1.vtu")));
  EXPECT_TRUE(fs::exists(path("made/row-3.vtu")));
  const Positions up = nodes("made/row-1.vtu");
  const Positions down = nodes("made/B.vtu");
  const Positions mean = nodes("made/row-3.vtu");
  double          largest = 0.0;
  for (std::size_t node = 0; node < mean.size(); ++node)
  {
    EXPECT_LT((0.5 * (up[node] + down[node]) - mean[node]).norm(), 1e-9);
    largest = std::max(largest, (up[node] - mean[node]).norm());
  }
  EXPECT_GT(largest, 1.0);

  ASSERT_EQ(make("mode_1,mode_2\n1,2\n", "one", { "--modes=1" }).exitCode, 0);
  ASSERT_EQ(make("mode_1\n1\n", "first", {}).exitCode, 0);
  EXPECT_EQ(contentOf(path("one/row-1.vtu")), contentOf(path("first/row-1.vtu")));

  expectErrorCode(make("mode_1,mode_7\n1,2\n", "no", {}), "E_FORMAT");
  expectErrorCode(make("mode_1,mode_0\n1,2\n", "no", {}), "E_FORMAT");
  expectErrorCode(make("mode_1\nlarge\n", "no", {}), "E_FORMAT");
  expectErrorCode(make("mode_1\n\"3,2\"\n\"4,1\"\n", "no", {}), "E_FORMAT");
  expectErrorCode(make("subject,mode_x\nA,2\n", "no", {}), "E_FORMAT");
}

TEST_F(AtlasCommand, WhatAModelDoesNotUseIsRefusedWithIt)
{
  for (const char * option :
       { "--align=none", "--mode-meshes=1", "--permutations=9", "--label-spacing=2", "--samples=9", "--seed=2" })
  {
    expectErrorCode(atlas("m", "out", { "--project", path("model.json"), option }), "E_USAGE");
    expectErrorCode(atlas("scores.csv", "out", { "--reconstruct", path("model.json"), option }), "E_USAGE");
  }
  expectErrorCode(atlas("m", "out", { "--project", path("model.json"), "--modes=2" }), "E_USAGE");
}

TEST_F(AtlasCommand, Refusals)
{
  writeSubjects(4);
  expectErrorCode(atlas("table.csv", "out", { "--group", "sex" }), "E_FORMAT");
  expectErrorCode(atlas("table.csv", "out", { "--group", "age" }), "E_FORMAT");
  expectErrorCode(atlas("table.csv", "out", { "--covariates", "age" }), "E_USAGE");
  expectErrorCode(atlas("table.csv", "out", { "--modes", "0" }), "E_USAGE");
  expectErrorCode(atlas("table.csv", "out", { "--modes", "120%" }), "E_USAGE");
  expectErrorCode(atlas("m/1.vtu", "out"), "E_PRECONDITION");
  expectErrorCode(atlas("m/1.vtu", "out", { path("m/9.vtu") }), "E_NOINPUT");
  expectErrorCode(atlas("m", "out", { "--project", path("table.csv") }), "E_FORMAT");
  ASSERT_EQ(atlas("m", "model").exitCode, 0);
  writeTextFile(path("empty.csv"), "subject,mesh\n");
  expectErrorCode(atlas("empty.csv", "out", { "--project", path("model/model.json") }), "E_EMPTY");
  expectErrorCode(atlas("table.csv", "out", { "--group", "group", "--project", path("model.json") }), "E_USAGE");
  writeHexMesh(path("m/other.vtu"), boxOf(1, 6));
  expectErrorCode(atlas("m", "out"), "E_NOT_HEXAHEDRA");
}
