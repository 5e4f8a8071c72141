// Exact: what is read and what is refused.
#include "TimeSeries.h"

#include "CommandErrors.h"
#include "MeshRecord.h"
#include "TestFolder.h"
#include "moserhex/Analytic/Lattices.h"
#include "moserhex/Analytic/Refusals.h"
#include "moserhex/HexMeshIO/HexMeshWriter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

using namespace moserhex;
using namespace moserhex::app;

namespace
{

/** All cells convex, their volumes different. */
HexMesh
unevenLattice()
{
  return analytic::lattice(
    4, [](const Vector3 & index) { return Vector3(index[0] + 0.05 * index[0] * index[0], index[1], index[2]); });
}

class TimeSeriesFiles : public testing::Test
{
protected:
  void
  SetUp() override
  {
    writeHexMesh(m_Folder / "a.vtu", analytic::cubeLattice(4));
    writeHexMesh(m_Folder / "b.msh", analytic::cubeLattice(4, 2.0));
    writeHexMesh(m_Folder / "large.vtu", analytic::cubeLattice(6));
    writeHexMesh(m_Folder / "padded.vtu", analytic::paddedLattice(4, 2, [](const Vector3 & index) { return index; }));
  }

  [[nodiscard]] CompareCommandOptions
  of(const std::vector<std::string> & names) const
  {
    CompareCommandOptions options;
    for (const std::string & name : names)
    {
      options.meshes.push_back(m_Folder / name);
    }
    return options;
  }

  TestFolder m_Folder;
};

} // namespace

TEST_F(TimeSeriesFiles, MeshesWithTheirNamesAndTimes)
{
  CompareCommandOptions options = of({ "a.vtu", "b.msh" });
  options.times = { 0.0, 6.5 };
  const TimeSeries series = readTimeSeries(options);
  ASSERT_EQ(series.points.size(), 2u);
  EXPECT_EQ(series.points[0].name, "a");
  EXPECT_EQ(series.points[1].months, 6.5);
  EXPECT_EQ(series.points[1].lattice.nodes, analytic::cubeLattice(4, 2.0).nodes);
  EXPECT_TRUE(series.warnings.empty());
  options.names = { "first", "second" };
  EXPECT_EQ(readTimeSeries(options).points[1].name, "second");
}

TEST_F(TimeSeriesFiles, EqualPaddingIsLeftOutWithAWarning)
{
  const TimeSeries series = readTimeSeries(of({ "padded.vtu", "padded.vtu" }));
  EXPECT_EQ(series.points[1].lattice.paddingLayers, 0);
  EXPECT_EQ(series.points[1].lattice.nodes.size(), 64u);
  ASSERT_EQ(series.warnings.size(), 1u);
  EXPECT_NE(series.warnings[0].find("padding is left out"), std::string::npos);
  EXPECT_NE(series.warnings[0].find("the volumes of regions"), std::string::npos);
  EXPECT_NEAR(series.points[1].volume, 7.0 * 7.0 * 7.0, 1e-9); // 3 cells and 2 layers at both ends
}

TEST_F(TimeSeriesFiles, ATurnedLatticeIsAWarning)
{
  writeBytes(m_Folder / "b.json", R"({"warnings": ["the lattice is turned by 30 degrees about (1 0 0): because"]})");
  const TimeSeries series = readTimeSeries(of({ "a.vtu", "b.msh" }));
  ASSERT_EQ(series.warnings.size(), 1u);
  EXPECT_NE(series.warnings[0].find("b.msh: the lattice is turned by 30 degrees"), std::string::npos);
}

TEST_F(TimeSeriesFiles, LatticesThatWereTurnedAlikeAreNoWarning)
{
  HexMeshFields turned;
  turned.meshArrays = latticeTurnArrays({ 0, 0, 45 });
  writeHexMesh(m_Folder / "turned.vtu", analytic::cubeLattice(4), turned);
  writeHexMesh(m_Folder / "tied.vtk", analytic::cubeLattice(4, 2.0), turned);
  EXPECT_TRUE(readTimeSeries(of({ "turned.vtu", "tied.vtk" })).warnings.empty());
  const TimeSeries series = readTimeSeries(of({ "a.vtu", "tied.vtk" }));
  ASSERT_EQ(series.warnings.size(), 1u);
  EXPECT_NE(series.warnings[0].find("tied.vtk: the lattice is turned by 45 degrees about (0 0 1)"), std::string::npos);
}

TEST_F(TimeSeriesFiles, CellsThatAreEvenAtOneTimeOnlyAreAWarning)
{
  writeHexMesh(m_Folder / "uneven.vtu", unevenLattice());
  EXPECT_NEAR(readTimeSeries(of({ "a.vtu", "uneven.vtu" })).points[1].quality.volumeVariance,
              volumeQuality(unevenLattice()).volumeVariance,
              1e-15);
  const auto warnings = readTimeSeries(of({ "a.vtu", "uneven.vtu" })).warnings;
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("uneven.vtu: its cells are uneven"), std::string::npos) << warnings[0];
  EXPECT_NE(warnings[0].find("unless it was made with --local-growth"), std::string::npos) << warnings[0];
  const auto ofBaseline = readTimeSeries(of({ "uneven.vtu", "a.vtu" })).warnings;
  ASSERT_EQ(ofBaseline.size(), 1u);
  EXPECT_NE(ofBaseline[0].find("uneven.vtu: its cells are uneven"), std::string::npos) << ofBaseline[0];
  EXPECT_NE(ofBaseline[0].find("Volumetric is no local growth"), std::string::npos) << ofBaseline[0];
  const auto ofBoth = readTimeSeries(of({ "uneven.vtu", "uneven.vtu" })).warnings;
  ASSERT_EQ(ofBoth.size(), 1u);
  EXPECT_NE(ofBoth[0].find("/uneven, too"), std::string::npos) << ofBoth[0];
  HexMeshFields grown;
  grown.meshArrays = localGrowthArrays(0.5, 2.0);
  writeHexMesh(m_Folder / "grown.vtu", unevenLattice(), grown);
  EXPECT_TRUE(readTimeSeries(of({ "a.vtu", "grown.vtu" })).warnings.empty());
}

TEST_F(TimeSeriesFiles, ConcaveCellsAreAWarningOfEachMesh)
{
  HexMesh folded = analytic::cubeLattice(4);
  folded.nodes[folded.nodeNumber(1, 1, 1)] += Vector3(0.9, 0.9, 0.9); // beyond the diagonal planes of its cells
  writeHexMesh(m_Folder / "folded.vtu", folded);
  const TimeSeries series = readTimeSeries(of({ "folded.vtu", "folded.vtu" }));
  EXPECT_EQ(series.points[1].quality.concaveCells, volumeQuality(folded).concaveCells);
  ASSERT_EQ(series.warnings.size(), 2u);
  EXPECT_NE(series.warnings[0].find("folded.vtu: " + std::to_string(volumeQuality(folded).concaveCells) +
                                    " of 27 cells are concave"),
            std::string::npos)
    << series.warnings[0];
}

TEST_F(TimeSeriesFiles, AMeshThatItsReportCallsInexactIsAWarning)
{
  writeBytes(m_Folder / "b.json", R"({"parameters": {"stage": "moser"}})");
  const TimeSeries series = readTimeSeries(of({ "a.vtu", "b.msh" }));
  ASSERT_EQ(series.warnings.size(), 1u);
  EXPECT_NE(series.warnings[0].find("b.msh: it was not made exact"), std::string::npos);
}

TEST_F(TimeSeriesFiles, WhatTheFilesRecordOfTheirCellsIsTold)
{
  const auto write = [this](const std::string & name, const std::string & array) {
    HexMeshFields fields;
    fields.meshArrays = { { array, 1, { 1.0 } } };
    writeHexMesh(m_Folder / name, unevenLattice(), fields);
  };
  write("density.vtu", "MeanDensity");
  write("moser.vtu", "NotExact");
  const TimeSeries series = readTimeSeries(of({ "density.vtu", "moser.vtu" }));
  ASSERT_EQ(series.warnings.size(), 2u); // nothing of unevenness, which these explain
  EXPECT_NE(series.warnings[0].find("density.vtu: its cells hold equal masses of a density"), std::string::npos);
  EXPECT_NE(series.warnings[1].find("moser.vtu: it was not made exact"), std::string::npos);
  EXPECT_TRUE(series.points[0].cells.hasDensity);
  EXPECT_EQ(series.points[1].record.size(), 1u);
}

TEST_F(TimeSeriesFiles, CoordinatesOf32BitsAreEven)
{
  HexMesh far = analytic::cubeLattice(4, 2.13);
  for (Vector3 & node : far.nodes)
  {
    node = (node + Vector3(-100.3, 57.7, -900.1)).cast<float>().cast<double>();
  }
  writeHexMesh(m_Folder / "far.vtu", far);
  EXPECT_TRUE(readTimeSeries(of({ "a.vtu", "far.vtu" })).warnings.empty());
}

TEST_F(TimeSeriesFiles, EqualNamesGetTheirFolders)
{
  const TestFolder other;
  writeHexMesh(other / "a.vtu", analytic::cubeLattice(4));
  CompareCommandOptions options = of({ "a.vtu", "b.msh" });
  options.meshes.push_back(other / "a.vtu");
  const TimeSeries series = readTimeSeries(options);
  EXPECT_EQ(series.points[0].name, std::filesystem::path(m_Folder / "").parent_path().filename().string() + "/a");
  EXPECT_EQ(series.points[1].name, "b");
  EXPECT_EQ(series.points[2].name, std::filesystem::path(other / "").parent_path().filename().string() + "/a");
}

TEST_F(TimeSeriesFiles, ATransformAndAWayToAlignAreOneTooMany)
{
  CompareCommandOptions options = of({ "a.vtu", "b.msh" });
  options.transforms = { "t.tfm" };
  options.align = "similarity";
  EXPECT_NE(
    analytic::messageOf<UsageError>([&] { (void)readTimeSeries(options); }).find("both --transforms and --align"),
    std::string::npos);
}

TEST_F(TimeSeriesFiles, ChecksumsAreOfWhatWasRead)
{
  const TimeSeries series = readTimeSeries(of({ "a.vtu", "b.msh" }));
  EXPECT_EQ(series.points[1].file.name, m_Folder / "b.msh");
  EXPECT_EQ(series.points[1].file.sha256, sha256OfInput(m_Folder / "b.msh"));
  EXPECT_TRUE(series.points[1].transform.name.empty());
}

TEST_F(TimeSeriesFiles, AnotherLatticeIsRefused)
{
  const auto refusal = [this](const std::vector<std::string> & names) {
    return analytic::messageOf<BadInput>([&] { (void)readTimeSeries(of(names)); });
  };
  EXPECT_NE(refusal({ "a.vtu", "large.vtu" }).find("6 nodes a side, the baseline has 4"), std::string::npos);
  EXPECT_NE(refusal({ "a.vtu", "padded.vtu" }).find("2 layers of padding, the baseline has 0"), std::string::npos);
  EXPECT_NE(refusal({ "a.vtu", "missing.vtu" }), "accepted");
}

TEST_F(TimeSeriesFiles, ContradictionsAreWrongUsage)
{
  EXPECT_THROW((void)readTimeSeries(of({ "a.vtu" })), UsageError);
  CompareCommandOptions options = of({ "a.vtu", "b.msh" });
  options.times = { 0.0 };
  EXPECT_THROW((void)readTimeSeries(options), UsageError);
  options.times = { 12.0, 12.0 };
  EXPECT_THROW((void)readTimeSeries(options), UsageError);
  options.times.clear();
  options.names = { "a", "b", "c" };
  EXPECT_THROW((void)readTimeSeries(options), UsageError);
}
