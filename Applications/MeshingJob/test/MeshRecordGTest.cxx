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
  const double angle = std::acos(-1.0) / 6.0;
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
    EXPECT_FALSE(isReportedInexact(folder / "a.vtu")) << report;
  }
  EXPECT_FALSE(turnOfLattice(folder / "missing.vtu", {}));
  EXPECT_FALSE(isReportedInexact(folder / "missing.vtu"));
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
  EXPECT_TRUE(hasLocalGrowth(folder / "a.vtu", localGrowthArrays(0.8, 2.1)));
  EXPECT_FALSE(hasLocalGrowth(folder / "a.vtu", {}));
  writeBytes(folder / "a.json", R"({"template": {"local_growth": {"smallest": 0.8}}})");
  EXPECT_TRUE(hasLocalGrowth(folder / "a.vtu", {}));
  writeBytes(folder / "a.json", R"({"template": 3})");
  EXPECT_FALSE(hasLocalGrowth(folder / "a.vtu", {}));
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

TEST(MeshRecord, AMeshThatIsNotExactIsTold)
{
  const TestFolder folder;
  const auto       isInexact = [&folder](const std::string & report) {
    writeBytes(folder / "a.json", report);
    return isReportedInexact(folder / "a.vtu");
  };
  EXPECT_TRUE(isInexact(R"({"parameters": {"stage": "moser"}})"));
  EXPECT_TRUE(isInexact(R"({"parameters": {"stage": "exact"}, "exact": {"reached": false}})"));
  EXPECT_FALSE(isInexact(R"({"parameters": {"stage": "exact"}, "exact": {"reached": true}})"));
}
