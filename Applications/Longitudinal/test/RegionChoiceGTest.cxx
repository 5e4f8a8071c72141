// Exact: sets by name, boxes as in the table.
#include "RegionChoice.h"

#include "CommandErrors.h"
#include "TestFolder.h"
#include "moserhex/Analytic/Refusals.h"

#include <gtest/gtest.h>

using namespace moserhex;
using namespace moserhex::app;

TEST(RegionChoice, SetsInTheOrderTheyAreAskedFor)
{
  const auto sets = chosenRegions({ "shells", "octants", "halves" }, 20);
  ASSERT_EQ(sets.size(), 3u);
  EXPECT_EQ(sets[0].name, "shells");
  EXPECT_EQ(sets[0].regions.size(), 10u);
  EXPECT_EQ(sets[1].regions.size(), 8u);
  EXPECT_EQ(sets[2].regions.size(), 6u);
}

TEST(RegionChoice, BoxesOfATableWithColumnsInAnyOrder)
{
  const TestFolder folder;
  writeBytes(folder / "boxes.csv",
             "name,note,imin,imax,jmin,jmax,kmin,kmax\napex,low,0,1,0,1,0,0.25\n\"left, back\",,0.5,1,0.5,1,0,1\n");
  const auto sets = chosenRegions({ folder / "boxes.csv" }, 20);
  ASSERT_EQ(sets.size(), 1u);
  EXPECT_EQ(sets[0].name, "boxes");
  ASSERT_EQ(sets[0].regions.size(), 2u);
  EXPECT_EQ(sets[0].regions[0].box.upper, Vector3(1, 1, 0.25));
  EXPECT_EQ(sets[0].regions[1].name, "left, back");
  EXPECT_EQ(sets[0].regions[1].box.lower, Vector3(0.5, 0.5, 0));
  EXPECT_EQ(sets[0].table.name, folder / "boxes.csv");
  EXPECT_EQ(sets[0].table.sha256, sha256OfInput(folder / "boxes.csv"));
}

TEST(RegionChoice, BoxesThatTheArrayCannotShowAreWarnedOf)
{
  const TestFolder folder;
  const auto       warningsOf = [&folder](const std::string & lines) {
    writeBytes(folder / "boxes.csv", "name,imin,imax,jmin,jmax,kmin,kmax\n" + lines);
    return regionWarnings(chosenRegions({ folder / "boxes.csv", "halves" }, 20), 20);
  };
  EXPECT_TRUE(warningsOf("a,0,0.5,0,1,0,1\nb,0.5,1,0,1,0,1\n").empty()); // they touch
  const auto overlap = warningsOf("a,0,0.6,0,1,0,1\nb,0.5,1,0,1,0,1\n");
  ASSERT_EQ(overlap.size(), 1u);
  EXPECT_NE(overlap[0].find("boxes.csv: a and b overlap;"), std::string::npos) << overlap[0];
  const auto thin = warningsOf("a,0,0.02,0,1,0,1\n"); // a cell is 1/19 wide
  ASSERT_EQ(thin.size(), 1u);
  EXPECT_NE(thin[0].find("boxes.csv: a has more than half of no cell"), std::string::npos) << thin[0];
}

TEST(RegionChoice, TablesThatSayTooLittleAreRefusedWithTheLine)
{
  const TestFolder folder;
  const auto       refusal = [&folder](const std::string & text) {
    writeBytes(folder / "boxes.csv", text);
    return analytic::messageOf<BadInput>([&] { (void)chosenRegions({ folder / "boxes.csv" }, 20); });
  };
  const std::string head = "name,imin,imax,jmin,jmax,kmin,kmax\n";
  EXPECT_EQ(refusal(head + "a,0,1,0,1,0,1\n"), "accepted");
  EXPECT_NE(refusal("name,imin,imax,jmin,jmax,kmin\na,0,1,0,1,0\n").find("line 1: no column kmax"), std::string::npos);
  EXPECT_NE(refusal(head + "a,0,1,0,1,0,x\n").find("line 2: \"x\" is no number"), std::string::npos);
  EXPECT_NE(refusal(head + "a,0,1,0,1,0,1.5\n").find("line 2: region a"), std::string::npos);
  EXPECT_NE(refusal(head + "a,0,1,0,1,0,nan\n").find("line 2"), std::string::npos);
  EXPECT_NE(refusal(head + "a,0,1,0,1,0,1\na,0,1,0,1,0,1\n").find("line 3: the name a again"), std::string::npos);
  EXPECT_NE(refusal(head + ",0,1,0,1,0,1\n").find("line 2: no name"), std::string::npos);
  EXPECT_NE(refusal(head).find("line 1: no region"), std::string::npos);
}

TEST(RegionChoice, UnknownAndRepeatedSetsAreWrongUsage)
{
  EXPECT_THROW((void)chosenRegions({ "quadrants" }, 20), UsageError);
  EXPECT_THROW((void)chosenRegions({ "octants", "octants" }, 20), UsageError);
  EXPECT_THROW((void)chosenRegions({ "missing.csv" }, 20), BadInput);
}
