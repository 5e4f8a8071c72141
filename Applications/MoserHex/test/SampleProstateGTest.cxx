// Documented sizes: 51 mL within 1 mL, 54 x 43 x 47 mm within a voxel on either side. Topology and counts are exact.
#include "SampleProstate.h"

#include "moserhex/LevelSet/VoxelTopology.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace moserhex;

namespace
{

double
millilitres(const LabelVolume & label)
{
  return static_cast<double>(voxelCount(label)) * label.voxelVolume() / 1000.0;
}

/** Extent of the label's voxels along the LPS axes [mm]. */
Vector3
extent(const LabelVolume & label)
{
  Vector3 lower = Vector3::Constant(1e9);
  Vector3 upper = -lower;
  for (int k = 0; k < label.size[2]; ++k)
  {
    for (int j = 0; j < label.size[1]; ++j)
    {
      for (int i = 0; i < label.size[0]; ++i)
      {
        if (label.inside[label.voxelNumber(i, j, k)] != 0)
        {
          lower = lower.cwiseMin(label.point(i, j, k));
          upper = upper.cwiseMax(label.point(i, j, k));
        }
      }
    }
  }
  return upper - lower;
}

std::size_t
countOf(const LabelVolume & labels, int value)
{
  std::size_t count = 0;
  for (const std::uint8_t label : labels.inside)
  {
    count += label == value ? 1 : 0;
  }
  return count;
}

} // namespace

TEST(SampleProstate, HasItsDocumentedVolume)
{
  EXPECT_NEAR(millilitres(makeSampleProstate().gland), 51.0, 1.0);
}

TEST(SampleProstate, HasItsDocumentedExtent)
{
  const Vector3 size = extent(makeSampleProstate().gland);
  EXPECT_NEAR(size.x(), 54.0, 1.5);
  EXPECT_NEAR(size.y(), 43.0, 1.5);
  EXPECT_NEAR(size.z(), 47.0, 3.0);
}

TEST(SampleProstate, VoxelsAreAnisotropicAndOblique)
{
  const LabelVolume gland = makeSampleProstate().gland;
  EXPECT_EQ(gland.spacing, Vector3(0.5, 0.5, 3.0));
  EXPECT_LT(gland.direction.diagonal().minCoeff(), 0.99);
  EXPECT_NO_THROW(requireValid(gland, "sample"));
}

TEST(SampleProstate, BaseIsDentedAndPosteriorWallIsFlat)
{
  const LabelVolume gland = makeSampleProstate().gland;
  // Highest voxel in the middle and off the middle of the gland, along the third image axis.
  const auto top = [&gland](int i, int j) {
    int highest = -1;
    for (int k = 0; k < gland.size[2]; ++k)
    {
      highest = gland.inside[gland.voxelNumber(i, j, k)] != 0 ? k : highest;
    }
    return highest;
  };
  const int middle = gland.size[0] / 2;
  EXPECT_LT(top(middle, gland.size[1] / 2), top(middle + 30, gland.size[1] / 2));
}

TEST(SampleProstate, BothVisitsAreBalls)
{
  const SampleProstate sample = makeSampleProstate();
  for (const LabelVolume * label : { &sample.gland, &sample.followUp })
  {
    const VoxelTopology topology = voxelTopology(*label);
    EXPECT_TRUE(topology.isBall());
  }
}

TEST(SampleProstate, FollowUpIsFifteenPercentLarger)
{
  const SampleProstate sample = makeSampleProstate();
  EXPECT_NEAR(millilitres(sample.followUp) / millilitres(sample.gland), 1.15, 0.01);
}

TEST(SampleProstate, ZonesFillTheGland)
{
  const SampleProstate sample = makeSampleProstate();
  EXPECT_EQ(countOf(sample.zones, 1) + countOf(sample.zones, 2), voxelCount(sample.gland));
  EXPECT_GT(countOf(sample.zones, 1), voxelCount(sample.gland) / 3);
  EXPECT_GT(countOf(sample.zones, 2), voxelCount(sample.gland) / 5);
}

TEST(SampleProstate, IsTheSameEveryTime)
{
  EXPECT_EQ(makeSampleProstate().gland.inside, makeSampleProstate().gland.inside);
}
