// Exact: what the command says and writes. That nodes stay: the sample, and as a reader who leaves its upper end out
// would draw it, meshed with the density and without.
#include "CommandTest.h"

#include "SampleProstate.h"
#include "moserhex/HexMeshIO/HexMeshReader.h"
#include "moserhex/HexMeshIO/LabelImageWriter.h"

#include <algorithm>
#include <filesystem>

using namespace moserhex;
using namespace moserhex::app;
namespace fs = std::filesystem;

namespace
{

class AgreementCommand : public CommandTest
{
protected:
  void
  SetUp() override
  {
    CommandTest::SetUp();
    LabelVolume gland = makeSampleProstate().gland;
    writeLabelImage(path("a.nrrd"), gland);
    const auto last = std::find(gland.inside.rbegin(), gland.inside.rend(), 1);
    const auto leftOut = gland.inside.rend() - last - 3 * static_cast<std::ptrdiff_t>(gland.voxelNumber(0, 0, 1));
    std::fill(gland.inside.begin() + leftOut, gland.inside.end(), std::uint8_t{ 0 }); // some 9 mm
    writeLabelImage(path("b.nrrd"), gland);
  }

  /** Of the nodes of equal index of meshes of a and b, b tied to a [mm]. */
  double
  medianDistance(const std::vector<std::string> & density)
  {
    const auto meshed = [&](std::vector<std::string> arguments) {
      arguments.insert(arguments.begin(), "mesh");
      arguments.insert(arguments.end(), { "--shells", "4", "--quiet" });
      arguments.insert(arguments.end(), density.begin(), density.end());
      const Outcome outcome = run(arguments);
      EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
    };
    meshed({ path("a.nrrd"), path("a.vtu") });
    meshed({ path("b.nrrd"), path("b.vtu"), "--template", path("a.vtu"), "--align", "none" });
    const HexMesh       a = readHexMesh(path("a.vtu"));
    const HexMesh       b = readHexMesh(path("b.vtu"));
    std::vector<double> distances;
    for (std::size_t node = 0; node < a.nodes.size(); ++node)
    {
      distances.push_back((a.nodes[node] - b.nodes.at(node)).norm());
    }
    std::nth_element(distances.begin(), distances.begin() + distances.size() / 2, distances.end());
    return distances[distances.size() / 2];
  }
};

} // namespace

TEST_F(AgreementCommand, NodesStayWhereOnlyOneReaderHasAnEnd)
{
  const Outcome outcome = run({ "agreement", path("a.nrrd"), path("b.nrrd"), "--output", path("agreed.nrrd") });
  ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_NE(outcome.out.find("a.nrrd, label 1: 51.272 mL\n"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find(" (overlap 0.9"), std::string::npos) << outcome.out;
  const double byVolume = medianDistance({});
  const double byAgreement = medianDistance({ "--density", path("agreed.nrrd") });
  EXPECT_LT(byAgreement, 0.7 * byVolume) << byVolume;
}

TEST_F(AgreementCommand, OrgansThatHardlyOverlapAreWarnedOf)
{
  LabelVolume moved = makeSampleProstate().gland;
  moved.origin += Vector3(25.0, 0.0, 0.0);
  writeLabelImage(path("c.nrrd"), moved);
  const Outcome outcome =
    run({ "agreement", path("a.nrrd"), path("b.nrrd"), path("c.nrrd"), "--output", path("agreed.nii.gz"), "--quiet" });
  EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_NE(outcome.error.find("are they of one organ, in one space?"), std::string::npos) << outcome.error;
  EXPECT_EQ(outcome.out, "");
  EXPECT_TRUE(fs::exists(path("agreed.nii.gz")));
}

TEST_F(AgreementCommand, WhatCannotBeDoneIsSaid)
{
  EXPECT_EQ(run({ "agreement", path("a.nrrd"), "--output", path("agreed.nrrd") }).exitCode, 2);
  const Outcome kept = run({ "agreement", path("a.nrrd"), path("b.nrrd"), "--output", path("b.nrrd") });
  EXPECT_EQ(kept.exitCode, 2);
  EXPECT_NE(kept.error.find("would be overwritten"), std::string::npos) << kept.error;
  const Outcome missing = run({ "agreement", path("a.nrrd"), path("c.nrrd"), "--output", path("agreed.nrrd") });
  EXPECT_EQ(missing.exitCode, 3);
  EXPECT_FALSE(fs::exists(path("agreed.nrrd")));
}
