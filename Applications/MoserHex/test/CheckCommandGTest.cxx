// Exact: what moserhex check says of small labels whose topology is known.
#include "CommandTest.h"

#include "SampleProstate.h"
#include "moserhex/HexMeshIO/LabelImageWriter.h"

#include <nlohmann/json.hpp>

using namespace moserhex;
using namespace moserhex::app;

namespace
{

class CheckCommand : public CommandTest
{
protected:
  /** A cube with a tunnel, and a voxel by itself in the first corner of the image. */
  void
  writeCubeWithTunnel() const
  {
    LabelVolume label = cubeWithTunnel();
    label.inside.front() = 1;
    writeLabelImage(path("tunnel.nrrd"), label);
  }
};

} // namespace

TEST_F(CheckCommand, ASolidOfGenus0IsSaidToBeOne)
{
  writeSample();
  const Outcome outcome = run({ "check", path("prostate.nrrd") });
  EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_EQ(outcome.error, "");
  EXPECT_NE(outcome.out.find("verdict    one solid of genus 0"), std::string::npos) << outcome.out;
  EXPECT_EQ(fileCount(), 1u);
}

TEST_F(CheckCommand, PartsHandlesBordersAndTheRepairAreListed)
{
  writeCubeWithTunnel();
  const Outcome outcome = run({ "check", path("tunnel.nrrd") });
  EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_NE(outcome.out.find("2 components"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("1 handle"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("first i"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("\nrepair     "), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("verdict    to be repaired"), std::string::npos) << outcome.out;
}

TEST_F(CheckCommand, ARepairBeyondTheLimitIsSaidToBeRefused)
{
  writeCubeWithTunnel();
  const Outcome outcome = run({ "check", path("tunnel.nrrd"), "--max-repair", "0.01" });
  EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_NE(outcome.out.find("verdict    refused"), std::string::npos) << outcome.out;
}

TEST_F(CheckCommand, AllLabelsMakeATableOfOneLineEach)
{
  writeLabelImage(path("zones.nrrd"), makeSampleProstate().zones);
  const Outcome outcome = run({ "check", path("zones.nrrd"), "--all-labels" });
  EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 3) << outcome.out;
}

TEST_F(CheckCommand, JsonHoldsTheNumbers)
{
  writeCubeWithTunnel();
  ASSERT_EQ(run({ "check", path("tunnel.nrrd"), "--json", path("c.json"), "--quiet" }).exitCode, 0);
  const auto label = nlohmann::json::parse(contentOf(path("c.json")))["labels"][0];
  EXPECT_EQ(label["voxels"], 16 * 16 * 16 - 16 + 1);
  EXPECT_EQ(label["topology"]["components"], 2);
  EXPECT_EQ(label["topology"]["handles"], 1);
  EXPECT_EQ(label["component_voxels"], (std::vector<int>{ 16 * 16 * 16 - 16, 1 }));
  EXPECT_FALSE(label["ball"].get<bool>());
  EXPECT_TRUE(label["repair"]["possible"].get<bool>());
  EXPECT_EQ(label["repair"]["voxels_removed"], 1);
  EXPECT_GE(label["repair"]["voxels_added"].get<int>(), 1);
}

TEST_F(CheckCommand, ContradictingOptionsAreWrongUsage)
{
  expectErrorCode(run({ "check", path("a.nrrd"), "--all-labels", "--label=1" }), "E_USAGE");
  expectErrorCode(run({ "check", path("a.nrrd"), "--json", path("a.nrrd") }), "E_USAGE");
}
