// Exact: what is said of reports as moserhex mesh writes them.
#include "LatticeTurn.h"

#include "TestFolder.h"

#include <gtest/gtest.h>

using namespace moserhex;
using namespace moserhex::app;

TEST(LatticeTurn, AWarningOfTheReportIsTold)
{
  const TestFolder folder;
  writeBytes(
    folder / "a.json",
    R"({"warnings": ["a hole was filled", "stage J: the lattice is turned by 45 degrees about (0 0 1): its own )"
    R"(frame did not lead to an exact mesh"]})");
  EXPECT_EQ(turnOfLattice(folder / "a.vtu").value_or(""), "the lattice is turned by 45 degrees about (0 0 1)");
}

TEST(LatticeTurn, ARidgeFrameIsTold)
{
  const TestFolder folder;
  writeBytes(folder / "a.json", R"({"warnings": [], "frame": {"turned_degrees": 7.6}})");
  EXPECT_EQ(turnOfLattice(folder / "a.vtu").value_or(""), "the lattice is turned by 8 degrees (--frame ridge)");
}

TEST(LatticeTurn, NothingIsToldWithoutATurnOrAReport)
{
  const TestFolder folder;
  for (const char * report :
       { R"({"warnings": ["a hole was filled"]})", R"({"warnings": 3, "frame": 2})", "[1, 2]", "not JSON", "" })
  {
    writeBytes(folder / "a.json", report);
    EXPECT_FALSE(turnOfLattice(folder / "a.vtu")) << report;
  }
  EXPECT_FALSE(turnOfLattice(folder / "missing.vtu"));
}
