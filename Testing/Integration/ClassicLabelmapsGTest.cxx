// Shapes on which other spherical parametrisations fold or stall. Skipped where the data are not at hand.
#include "PipelineRun.h"

#include "moserhex/HexMeshIO/LabelImageReader.h"

#include <gtest/gtest.h>

#include <filesystem>

using namespace moserhex;
using namespace moserhex::integration;

namespace
{

class ClassicLabelmaps : public testing::TestWithParam<const char *>
{};

} // namespace

TEST_P(ClassicLabelmaps, GiveAMeshWithoutAFlippedTriangleOnAnyShell)
{
  const std::filesystem::path file =
    std::filesystem::path(MOSERHEX_DEVELOPMENT_DATA) / "classic" / (std::string(GetParam()) + ".nii.gz");
  if (std::string(MOSERHEX_DEVELOPMENT_DATA).empty() || !std::filesystem::exists(file))
  {
    GTEST_SKIP() << "no development data: set MoserHex_DEVELOPMENT_DATA to their folder";
  }
  const LabelImage image = readLabelImage(file.string());
  auto             pipeline = itk::MassPreservingHexahedralMeshFilter<LabelImageType>::New();
  pipeline->SetInput(image.image);
  pipeline->SetLabel(chooseLabel(image, std::nullopt).value);
  pipeline->SetLastStage(MeshingStage::Moser);
  ASSERT_NO_THROW(pipeline->Update());
  for (const AreaPreservingMapResult & map : pipeline->GetResult().sphereMaps)
  {
    EXPECT_EQ(map.quality.flippedTriangles, 0);
    EXPECT_LE(map.quality.areaRatioRms, 0.01);
    EXPECT_NEAR(map.quality.solidAngleSum, 12.566370614359172, 1e-9);
  }
  const auto & stages = pipeline->GetStages();
  EXPECT_LT(stages.back().quality->volumeVariance, 0.15);

  pipeline->SetLastStage(MeshingStage::Exact);
  ASSERT_NO_THROW(pipeline->Update());
  const HexQualitySummary & quality = *pipeline->GetStages().back().quality;
  EXPECT_LE(quality.volumeVariance, 1e-12);
  EXPECT_EQ(quality.certified.positive, quality.cells);
  EXPECT_GT(quality.scaledJacobian.minimum, 0.0);
  EXPECT_NEAR(quality.volume / pipeline->GetLabelVolume(), 1.0, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Labelmaps,
                         ClassicLabelmaps,
                         testing::Values("maxplanck_choi", "buddha_choi", "tooth_tora", "hippocampus_choi"),
                         [](const auto & parameter) { return std::string(parameter.param); });
