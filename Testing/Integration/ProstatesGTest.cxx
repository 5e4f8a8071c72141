// Fifteen real prostates (PI-CAI, 15 to 263 mL, oblique, 0.3 x 0.3 x 3.6 mm): the contract of the main job. Bounds are
// promises to users; measured values are in Documentation/Results.md. Skipped where the data are not at hand.
#include "PipelineRun.h"

#include "moserhex/HexMeshIO/LabelImageReader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iostream>

using namespace moserhex;
using namespace moserhex::integration;

namespace
{

/** Image files of a folder of the development data, in order of name; empty when it is not at hand. */
std::vector<std::string>
developmentImages(const std::string & folder)
{
  const std::filesystem::path path = std::filesystem::path(MOSERHEX_DEVELOPMENT_DATA) / folder;
  std::vector<std::string>    files;
  if (std::string(MOSERHEX_DEVELOPMENT_DATA).empty() || !std::filesystem::is_directory(path))
  {
    return files;
  }
  for (const auto & entry : std::filesystem::directory_iterator(path))
  {
    files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

double
medianOf(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

} // namespace

TEST(Prostates, AllGiveMeshesWithinTheContract)
{
  const std::vector<std::string> files = developmentImages("dev/Bosma22b");
  if (files.empty())
  {
    GTEST_SKIP() << "no development data: set MoserHex_DEVELOPMENT_DATA to their folder";
  }
  std::vector<double> variances;
  std::vector<double> concave;
  for (const std::string & file : files)
  {
    SCOPED_TRACE(file);
    const LabelImage image = readLabelImage(file);
    using RealPipeline = itk::MassPreservingHexahedralMeshFilter<LabelImageType>;
    auto pipeline = RealPipeline::New();
    pipeline->SetInput(image.image);
    pipeline->SetLabel(chooseLabel(image, std::nullopt).value);
    pipeline->SetLastStage(MeshingStage::Moser);
    ASSERT_NO_THROW(pipeline->Update());

    const SolidMeshingResult & result = pipeline->GetResult();
    for (const AreaPreservingMapResult & map : result.sphereMaps)
    {
      EXPECT_EQ(map.quality.flippedTriangles, 0);
      EXPECT_LE(map.quality.areaRatioRms, 0.01);
      EXPECT_NEAR(map.quality.solidAngleSum, 12.566370614359172, 1e-9);
    }
    EXPECT_LE(result.shells.worstVolumeError, 1e-3);
    EXPECT_GE(result.shells.smallestRelativeGap(), 0.2);
    EXPECT_EQ(result.shells.notNested, 0u);
    double initialVariance = -1.0;
    for (const MeshingStageReport & stage : result.stages)
    {
      initialVariance = stage.name == "initial map" ? stage.quality->volumeVariance : initialVariance;
    }
    EXPECT_LE(initialVariance, 0.3);
    const HexQualitySummary & quality = *result.stages.back().quality;
    EXPECT_LE(quality.volumeVariance, 0.15);
    variances.push_back(quality.volumeVariance);
    concave.push_back(quality.concavePercent);
    EXPECT_NEAR(quality.volume / pipeline->GetLabelVolume(), 1.0, 0.03);
  }
  EXPECT_LE(medianOf(variances), 0.05);
  EXPECT_LE(medianOf(concave), 0.5);
}

TEST(Prostates, TransitionZonesAreRepairedAndMeshedExactly)
{
  constexpr int                  transitionZone = 2;
  const std::vector<std::string> files = developmentImages("dev/zonal_Yuan23");
  if (files.empty())
  {
    GTEST_SKIP() << "no development data: set MoserHex_DEVELOPMENT_DATA to their folder";
  }
  std::size_t meshed = 0;
  for (const std::string & file : files)
  {
    SCOPED_TRACE(file);
    const LabelImage image = readLabelImage(file);
    auto             pipeline = itk::MassPreservingHexahedralMeshFilter<LabelImageType>::New();
    pipeline->SetInput(image.image);
    pipeline->SetLabel(transitionZone);
    try
    {
      pipeline->Update();
    }
    catch (const itk::CoreError & refusal)
    {
      std::cout << file << ": " << refusal.GetDescription() << std::endl;
      continue;
    }
    ++meshed;
    const HexQualitySummary & quality = *pipeline->GetStages().back().quality;
    EXPECT_EQ(quality.certified.positive, quality.cells);
    EXPECT_LE(quality.volumeVariance, 1e-12);
    EXPECT_GE(pipeline->GetConditioningReport().dice, 0.95);
    if (pipeline->GetConditioningReport().rounding > 0.0)
    {
      EXPECT_EQ(pipeline->GetResult().attempts.back(), "rounder solid: exact");
    }
  }
  EXPECT_GE(static_cast<double>(meshed), 0.95 * static_cast<double>(files.size()));
}

TEST(Prostates, AllGiveExactMeshes)
{
  const std::vector<std::string> files = developmentImages("dev/Bosma22b");
  if (files.empty())
  {
    GTEST_SKIP() << "no development data: set MoserHex_DEVELOPMENT_DATA to their folder";
  }
  std::vector<double> smallest;
  std::vector<double> medians;
  for (const std::string & file : files)
  {
    SCOPED_TRACE(file);
    const LabelImage image = readLabelImage(file);
    auto             pipeline = itk::MassPreservingHexahedralMeshFilter<LabelImageType>::New();
    pipeline->SetInput(image.image);
    pipeline->SetLabel(chooseLabel(image, std::nullopt).value);
    ASSERT_NO_THROW(pipeline->Update());
    const HexQualitySummary & quality = *pipeline->GetStages().back().quality;
    EXPECT_LE(quality.volumeVariance, 1e-12);
    EXPECT_EQ(quality.concaveCells, 0u);
    EXPECT_EQ(quality.certified.positive, quality.cells);
    EXPECT_NEAR(quality.volume / pipeline->GetLabelVolume(), 1.0, 1e-9);
    EXPECT_LE(pipeline->GetResult().equalisation->largestDistance, 0.5);
    EXPECT_GE(quality.scaledJacobian.minimum, 0.03);
    smallest.push_back(quality.scaledJacobian.minimum);
    medians.push_back(quality.scaledJacobian.median);
  }
  EXPECT_GE(medianOf(smallest), 0.12);
  EXPECT_GE(medianOf(medians), 0.80);
}
