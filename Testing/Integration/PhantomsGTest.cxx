// Whole runs on solids with known volumes. Bounds are contracts: those of the README's table, not of what was measured
// on the day the test was written.
#include "PipelineRun.h"
#include "SampleProstate.h"

#include "moserhex/Analytic/SolidShapes.h"

#include <gtest/gtest.h>

using namespace moserhex;
using namespace moserhex::integration;

namespace
{

class Phantoms : public testing::TestWithParam<analytic::Solid>
{};

std::string
testNameOf(const testing::TestParamInfo<analytic::Solid> & info)
{
  std::string name;
  for (const char c : info.param.name)
  {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0)
    {
      name += c;
    }
  }
  return name;
}

/** The contract of a whole run at N = 10. */
void
expectContract(const LabelVolume & label)
{
  const auto pipeline = runPipeline(labelImage(label));

  const WorstSphereMap maps = worstSphereMap(*pipeline);
  EXPECT_EQ(maps.flippedTriangles, 0);
  EXPECT_LE(maps.solidAngleError, 1e-9);
  EXPECT_LE(maps.areaRatioRms, 0.01);

  const ShellSurfacesSummary & shells = pipeline->GetResult().shells;
  EXPECT_LE(shells.worstVolumeError, 1e-3);
  EXPECT_EQ(shells.notNested, 0u);

  const HexQualitySummary & initial = qualityAfter(*pipeline, "initial map");
  const HexQualitySummary & final = qualityAfter(*pipeline, "moser flow");
  EXPECT_EQ(final.cells, 6859u);
  EXPECT_LE(final.volumeVariance, 0.15);
  EXPECT_LE(final.volumeVariance, initial.volumeVariance);
  EXPECT_NEAR(final.volume, pipeline->GetLabelVolume(), 0.03 * pipeline->GetLabelVolume());
  EXPECT_LE(pipeline->GetResult().boundary.maximumOfNodes, 0.1);
}

} // namespace

TEST_P(Phantoms, GiveAMeshOfNearlyEqualCellsOnTheSurface)
{
  expectContract(analytic::labelVolume(GetParam()));
}

TEST_P(Phantoms, GiveAnExactMesh)
{
  PipelineOptions options;
  options.lastStage = MeshingStage::Exact;
  const Pipeline::Pointer   pipeline = runPipeline(labelImage(analytic::labelVolume(GetParam())), options);
  const HexQualitySummary & quality = qualityAfter(*pipeline, "exact");
  EXPECT_LE(quality.volumeVariance, 1e-12);
  EXPECT_EQ(quality.certified.positive, quality.cells);
  EXPECT_GT(quality.scaledJacobian.minimum, 0.0);
  EXPECT_NEAR(quality.volume / pipeline->GetLabelVolume(), 1.0, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(All, Phantoms, testing::ValuesIn(analytic::solids()), testNameOf);

TEST(ProstateSample, GivesAMeshOfNearlyEqualCellsOnTheSurface)
{
  expectContract(makeSampleProstate().gland);
}
