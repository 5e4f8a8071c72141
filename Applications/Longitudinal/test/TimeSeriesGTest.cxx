// Exact: what is read and what is refused.
#include "TimeSeries.h"

#include "CommandErrors.h"
#include "TestFolder.h"
#include "moserhex/Analytic/Lattices.h"
#include "moserhex/Analytic/Refusals.h"
#include "moserhex/HexMeshIO/HexMeshWriter.h"

#include <gtest/gtest.h>

using namespace moserhex;
using namespace moserhex::app;

namespace
{

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
}

TEST_F(TimeSeriesFiles, ATurnedLatticeIsAWarning)
{
  writeBytes(m_Folder / "b.json", R"({"warnings": ["the lattice is turned by 30 degrees about (1 0 0): because"]})");
  const TimeSeries series = readTimeSeries(of({ "a.vtu", "b.msh" }));
  ASSERT_EQ(series.warnings.size(), 1u);
  EXPECT_NE(series.warnings[0].find("b.msh: the lattice is turned by 30 degrees"), std::string::npos);
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
