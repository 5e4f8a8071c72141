// Exact: what is said of files and reports as moserhex mesh writes them. Rotations to 1e-12.
#include "MeshRecord.h"

#include "TestFolder.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>

using namespace moserhex;
using namespace moserhex::app;

namespace
{

std::string
descriptionOf(const std::optional<LatticeTurn> & turn)
{
  return turn ? turn->description : "";
}

} // namespace

TEST(MeshRecord, ARotationIsItsAxisTimesItsAngle)
{
  const double angle = pi / 6.0;
  EXPECT_LT((rotationVector(Eigen::AngleAxisd(angle, Vector3::UnitY()).toRotationMatrix()) - Vector3(0, 30, 0)).norm(),
            1e-12);
  EXPECT_EQ(rotationVector(Matrix3::Identity()), Vector3(0, 0, 0));
}

TEST(MeshRecord, TheTurnOfTheFileNeedsNoReport)
{
  const TestFolder folder;
  const auto       turn = turnOfLattice(folder / "a.vtu", latticeTurnArrays({ 0, 0, 45 }));
  EXPECT_EQ(descriptionOf(turn), "the lattice is turned by 45 degrees about (0 0 1)");
  EXPECT_EQ(turn->rotation, Vector3(0, 0, 45));
  EXPECT_TRUE(latticeTurnArrays({ 0, 0, 0 }).empty());
}

TEST(MeshRecord, ATurnOfTheReportHasItsAxis)
{
  const TestFolder folder;
  writeBytes(folder / "a.json", R"({"warnings": [], "lattice_turn_degrees": [0, -30, 0]})");
  const auto turn = turnOfLattice(folder / "a.msh", {});
  EXPECT_EQ(descriptionOf(turn), "the lattice is turned by 30 degrees about (0 -1 0)");
  EXPECT_EQ(turn->rotation, Vector3(0, -30, 0));
}

TEST(MeshRecord, AWarningOfAnOlderReportIsTold)
{
  const TestFolder folder;
  writeBytes(
    folder / "a.json",
    R"({"warnings": ["a hole was filled", "stage J: the lattice is turned by 45 degrees about (0 0 1): its own )"
    R"(frame did not lead to an exact mesh"]})");
  EXPECT_EQ(descriptionOf(turnOfLattice(folder / "a.vtu", {})), "the lattice is turned by 45 degrees about (0 0 1)");
}

TEST(MeshRecord, ATemplateThatWasTurnedIsTold)
{
  const TestFolder folder;
  writeBytes(
    folder / "a.json",
    R"({"warnings": ["b.vtu: the lattice is turned by 45 degrees about (0 0 1); this mesh is turned alike"]})");
  EXPECT_EQ(descriptionOf(turnOfLattice(folder / "a.vtu", {})), "the lattice is turned by 45 degrees about (0 0 1)");
}

TEST(MeshRecord, ARidgeFrameOfAnOlderReportIsTold)
{
  const TestFolder folder;
  writeBytes(folder / "a.json", R"({"warnings": [], "frame": {"turned_degrees": 7.6}})");
  EXPECT_EQ(descriptionOf(turnOfLattice(folder / "a.vtu", {})), "the lattice is turned by 8 degrees (--frame ridge)");
}

TEST(MeshRecord, NothingIsToldWithoutATurnOrAReport)
{
  const TestFolder folder;
  for (const char * report :
       { R"({"warnings": ["a hole was filled"]})",
         R"({"warnings": 3, "frame": 2, "lattice_turn_degrees": "x", "exact": [], "parameters": 1})",
         "[1, 2]",
         "not JSON",
         "" })
  {
    writeBytes(folder / "a.json", report);
    EXPECT_FALSE(turnOfLattice(folder / "a.vtu", {})) << report;
    EXPECT_FALSE(cellRecordOf(folder / "a.vtu", {}).isInexact) << report;
  }
  EXPECT_FALSE(turnOfLattice(folder / "missing.vtu", {}));
  EXPECT_FALSE(cellRecordOf(folder / "missing.vtu", {}).isInexact);
}

TEST(MeshRecord, OnlyTurnsThatDifferAreWarnedOf)
{
  const TestFolder folder;
  const TurnOfFile plain{ "plain.vtu", {} };
  const TurnOfFile turned{ "turned.vtu", turnOfLattice(folder / "a.vtu", latticeTurnArrays({ 0, 0, 45 })) };
  const TurnOfFile other{ "other.vtu", turnOfLattice(folder / "a.vtu", latticeTurnArrays({ 0, 45, 0 })) };
  const TurnOfFile inWords{ "words.vtu", LatticeTurn{ "the lattice is turned by 45 degrees about (0 0 1)", {} } };
  EXPECT_TRUE(turnWarnings({ plain, plain }, "so").empty());
  EXPECT_TRUE(turnWarnings({ turned, turned }, "so").empty());
  const std::vector<std::string> warning{ "turned.vtu: the lattice is turned by 45 degrees about (0 0 1); so" };
  EXPECT_EQ(turnWarnings({ plain, turned }, "so"), warning);
  EXPECT_EQ(turnWarnings({ turned, plain }, "so"), warning);
  EXPECT_EQ(turnWarnings({ turned, other }, "so").size(), 2u);
  EXPECT_EQ(turnWarnings({ inWords, inWords }, "so").size(), 2u);
}

TEST(MeshRecord, LocalGrowthIsTold)
{
  const TestFolder folder;
  EXPECT_TRUE(cellRecordOf(folder / "a.vtu", localGrowthArrays(0.8, 2.1)).hasLocalGrowth);
  EXPECT_FALSE(cellRecordOf(folder / "a.vtu", {}).hasLocalGrowth);
  writeBytes(folder / "a.json", R"({"template": {"local_growth": {"smallest": 0.8}}})");
  EXPECT_TRUE(cellRecordOf(folder / "a.vtu", {}).hasLocalGrowth);
  writeBytes(folder / "a.json", R"({"template": 3})");
  EXPECT_FALSE(cellRecordOf(folder / "a.vtu", {}).hasLocalGrowth);
}

TEST(MeshRecord, IsKeptForAnotherFileOfTheMesh)
{
  const TestFolder        folder;
  std::vector<NamedArray> inFile = localGrowthArrays(0.8, 2.1);
  inFile.push_back({ "Other", 1, { 1.0 } });
  inFile.push_back(latticeTurnArrays({ 0, 0, 45 }).front());
  const std::vector<NamedArray> kept = recordOf(folder / "a.vtu", inFile);
  ASSERT_EQ(kept.size(), 3u);
  EXPECT_EQ(kept[0].name, "LatticeTurn");
  EXPECT_EQ(kept[1].values, inFile[0].values);
  EXPECT_EQ(kept[2].values, inFile[1].values);
}

TEST(MeshRecord, WhatOnlyTheReportHasIsKeptToo)
{
  const TestFolder folder;
  writeBytes(folder / "a.json",
             R"({"density": {"mean": 3.5}, "exact": {"reached": false},)"
             R"( "template": {"local_growth": {"smallest": 0.8, "largest": 2.0}}})");
  const std::vector<NamedArray> kept = recordOf(folder / "a.vtu", {});
  ASSERT_EQ(kept.size(), 4u);
  EXPECT_EQ(kept[0].values, std::vector<double>{ 0.8 });
  EXPECT_EQ(kept[1].values, std::vector<double>{ 2.0 });
  EXPECT_EQ(kept[2].values, std::vector<double>{ 3.5 });
  EXPECT_EQ(kept[3].name, "NotExact");
  EXPECT_TRUE(recordOf("", {}).empty());
}

TEST(MeshRecord, OfARunIsWhatMakesItsCellsDiffer)
{
  RunReport report;
  report.exact.emplace().reached = true;
  EXPECT_TRUE(recordOf(report).empty());
  report.density.emplace().mean = 3.5;
  ASSERT_EQ(recordOf(report).size(), 1u);
  EXPECT_EQ(recordOf(report)[0].values, std::vector<double>{ 3.5 });
  EXPECT_TRUE(cellRecordOf("", recordOf(report)).hasDensity);
  EXPECT_FALSE(cellRecordOf("", recordOf(report)).isInexact);
  report.exact->reached = false;
  EXPECT_TRUE(cellRecordOf("", recordOf(report)).isInexact);
  report.exact.reset(); // another last stage
  EXPECT_TRUE(cellRecordOf("", recordOf(report)).isInexact);
  EXPECT_EQ(recordOf("", recordOf(report)).size(), 2u);
  const TestFolder folder;
  writeBytes(folder / "a.json", R"({"density": {"mean": 3.5}})");
  EXPECT_TRUE(cellRecordOf(folder / "a.vtu", {}).hasDensity);
}

TEST(MeshRecord, AMeshThatIsNotExactIsTold)
{
  const TestFolder folder;
  const auto       isInexact = [&folder](const std::string & report) {
    writeBytes(folder / "a.json", report);
    return cellRecordOf(folder / "a.vtu", {}).isInexact;
  };
  EXPECT_TRUE(isInexact(R"({"parameters": {"stage": "moser"}})"));
  EXPECT_TRUE(isInexact(R"({"parameters": {"stage": "exact"}, "exact": {"reached": false}})"));
  EXPECT_FALSE(isInexact(R"({"parameters": {"stage": "exact"}, "exact": {"reached": true}})"));
}
