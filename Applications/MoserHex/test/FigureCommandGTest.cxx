// Exact: exit codes, streams and files of moserhex figure.
#include "CommandTest.h"

#include "moserhex/HexMeshIO/HexMeshWriter.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>

using namespace moserhex;
using namespace moserhex::app;
namespace fs = std::filesystem;

namespace
{

class FigureCommand : public CommandTest
{
protected:
  void
  SetUp() override
  {
    CommandTest::SetUp();
    ::unsetenv("DISPLAY"); // of this process and of the program that it starts
    HexMesh mesh{ 6, {} };
    for (int node = 0; node < 216; ++node)
    {
      mesh.nodes.emplace_back(node % 6 + 0.02 * (node / 36), node / 6 % 6, node / 36 * 1.1);
    }
    HexMeshFields fields;
    fields.cellArrays = { { "Stretch", 1, std::vector<double>(125, 1.0) } };
    fields.cellArrays[0].values.back() = std::nan("");
    fields.pointArrays = { { "Motion", 3, std::vector<double>(648, 0.5) } };
    writeHexMesh(path("a.vtu"), mesh, fields);
  }
};

} // namespace

TEST_F(FigureCommand, DrawsWithoutADisplay)
{
  const Outcome png = run({ "figure", path("a.vtu"), path("a.png") });
  EXPECT_EQ(png.exitCode, 0) << png.error;
  EXPECT_EQ(png.out, path("a.png") + ": 75 polygons\n");
  EXPECT_EQ(contentOf(path("a.png")).compare(0, 4, "\x89PNG"), 0);
  const Outcome svg =
    run({ "figure", path("a.vtu"), path("a.svg"), "--kind", "shells", "--colour", "shell", "--quiet" });
  EXPECT_EQ(svg.exitCode, 0) << svg.error;
  EXPECT_EQ(svg.out + svg.error, "");
  const std::string text = contentOf(path("a.svg"));
  EXPECT_NE(text.find("</svg>"), std::string::npos);
}

TEST_F(FigureCommand, TwoRunsWriteTheSameBytes)
{
  for (const std::string ending : { ".png", ".svg" })
  {
    ASSERT_EQ(run({ "figure", path("a.vtu"), path("a" + ending), "--kind", "slice" }).exitCode, 0);
    ASSERT_EQ(run({ "figure", path("a.vtu"), path("b" + ending), "--kind", "slice" }).exitCode, 0);
    EXPECT_EQ(contentOf(path("a" + ending)), contentOf(path("b" + ending)));
  }
}

TEST_F(FigureCommand, ColoursByArraysOfTheFile)
{
  for (const std::string array : { "Stretch", "Motion", "Motion:2", "Shell", "LatticeIndex:0" })
  {
    const Outcome outcome = run({ "figure", path("a.vtu"), path("a.svg"), "--colour", array });
    EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
    EXPECT_EQ(outcome.out, path("a.svg") + ": 75 polygons\n");
  }
  const Outcome refused = run({ "figure", path("a.vtu"), path("b.svg"), "--colour", "Strech" });
  expectErrorCode(refused, "E_USAGE");
  for (const char * name : { "Stretch", "Motion", "VolumeRatio", "scaled-jacobian" })
  {
    EXPECT_NE(refused.error.find(name), std::string::npos) << refused.error;
  }
  expectErrorCode(run({ "figure", path("a.vtu"), path("b.svg"), "--colour", "Motion:3" }), "E_USAGE");
  EXPECT_EQ(fileCount(), 2U);
}

TEST_F(FigureCommand, OptionsMayComeBeforeTheMesh)
{
  const Outcome outcome = run({ "figure", "--kind", "shells", "--shells", "1,2", path("a.vtu"), path("a.svg") });
  EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
}

TEST_F(FigureCommand, RefusesWithTheExitCodesOfTheOthers)
{
  expectErrorCode(run({ "figure", path("a.vtu"), path("a.png"), "--kind", "volume" }), "E_USAGE");
  expectErrorCode(run({ "figure", path("a.vtu"), path("a.png"), "--colour", "red" }), "E_USAGE");
  expectErrorCode(run({ "figure", path("a.vtu"), path("a.png"), "--width", "100" }), "E_USAGE");
  expectErrorCode(run({ "figure", path("a.vtu"), path("a.png"), "--range", "1,0" }), "E_USAGE");
  expectErrorCode(run({ "figure", path("a.vtu"), path("a.png"), "--background", "pink" }), "E_USAGE");
  expectErrorCode(run({ "figure", path("a.vtu"), path("a.vtu") }), "E_USAGE");
  expectErrorCode(run({ "figure", path("a.vtu"), path("a.jpg") }), "E_USAGE");
  expectErrorCode(run({ "figure", path("a.vtu"), path("a.png"), "--kind", "slice", "--plane", "up" }), "E_USAGE");
  expectErrorCode(run({ "figure", path("a.vtu"), path("no/a.png") }), "E_CANTCREAT");
  expectErrorCode(run({ "figure", path("missing.vtu"), path("a.png") }), "E_NOINPUT");
  expectErrorCode(run({ "figure", path("a.vtu"), path("a.png"), "--kind", "shells", "--shells", "9" }),
                  "E_PRECONDITION");
  EXPECT_EQ(fileCount(), 1U);
}

TEST_F(FigureCommand, FullDiskKeepsTheOldFile)
{
  ASSERT_EQ(run({ "figure", path("a.vtu"), path("a.svg"), "--title", "old" }).exitCode, 0);
  const std::string old = contentOf(path("a.svg"));
  expectErrorCode(run({ "figure", path("a.vtu"), path("a.svg") }, 2000), "E_IO");
  EXPECT_EQ(contentOf(path("a.svg")), old);
  EXPECT_EQ(fileCount(), 2U);
}
