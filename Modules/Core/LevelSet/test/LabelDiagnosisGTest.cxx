// Counts are exact; the depth of a cube is that of its middle voxel.
#include "TestShapes.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/LevelSet/LabelDiagnosis.h"

#include <gtest/gtest.h>

using namespace moserhex;

namespace
{

LabelVolume
emptyLabel(const std::array<int, 3> & size)
{
  LabelVolume label;
  label.size = size;
  label.inside.assign(label.gridVoxels(), 0);
  return label;
}

void
fill(LabelVolume & label, const std::array<int, 3> & first, const std::array<int, 3> & last, std::uint8_t value = 1)
{
  for (int k = first[2]; k <= last[2]; ++k)
  {
    for (int j = first[1]; j <= last[1]; ++j)
    {
      for (int i = first[0]; i <= last[0]; ++i)
      {
        label.inside[label.voxelNumber(i, j, k)] = value;
      }
    }
  }
}

} // namespace

TEST(LabelDiagnosis, CubeIsABallWithItsDepthAndBox)
{
  LabelVolume label = emptyLabel({ { 12, 12, 12 } });
  label.spacing = Vector3(0.5, 0.5, 0.5);
  fill(label, { { 2, 3, 4 } }, { { 8, 9, 10 } });
  const LabelDiagnosis diagnosis = diagnoseLabel(label);
  EXPECT_TRUE(diagnosis.isBall());
  EXPECT_EQ(diagnosis.voxels, 343u);
  EXPECT_DOUBLE_EQ(diagnosis.volume, 343 * 0.125);
  EXPECT_EQ(diagnosis.componentVoxels, (std::vector<std::size_t>{ 343 }));
  EXPECT_EQ(diagnosis.firstIndex, (std::array<int, 3>{ { 2, 3, 4 } }));
  EXPECT_EQ(diagnosis.lastIndex, (std::array<int, 3>{ { 8, 9, 10 } }));
  EXPECT_DOUBLE_EQ(diagnosis.depth, 3.5 * 0.5);
  EXPECT_FALSE(diagnosis.borders.any());
  EXPECT_EQ(diagnosis.nonManifoldEdges + diagnosis.nonManifoldVertices, 0u);
}

TEST(LabelDiagnosis, ComponentsCavitiesAndHandlesAreCountedForTheWholeAndForTheLargest)
{
  LabelVolume label = emptyLabel({ { 30, 12, 12 } });
  fill(label, { { 1, 1, 1 } }, { { 9, 9, 9 } });
  fill(label, { { 5, 5, 1 } }, { { 5, 5, 9 } }, 0);   // a tunnel
  fill(label, { { 2, 2, 2 } }, { { 3, 2, 2 } }, 0);   // a cavity of two voxels
  fill(label, { { 12, 1, 1 } }, { { 16, 5, 3 } });    // a smaller part
  fill(label, { { 14, 3, 1 } }, { { 14, 3, 3 } }, 0); // with a tunnel of its own
  fill(label, { { 20, 1, 1 } }, { { 21, 1, 1 } });
  const LabelDiagnosis diagnosis = diagnoseLabel(label);
  EXPECT_FALSE(diagnosis.isBall());
  EXPECT_EQ(diagnosis.componentVoxels, (std::vector<std::size_t>{ 729 - 9 - 2, 75 - 3, 2 }));
  EXPECT_EQ(diagnosis.topology.components, 3u);
  EXPECT_EQ(diagnosis.topology.cavities, 1u);
  EXPECT_EQ(diagnosis.cavityVoxels, 2u);
  EXPECT_EQ(diagnosis.topology.handles(), 2);
  EXPECT_EQ(diagnosis.largestComponent.components, 1u);
  EXPECT_EQ(diagnosis.largestComponent.handles(), 1);
  EXPECT_EQ(diagnosis.largestComponent.cavities, 0u);
}

TEST(LabelDiagnosis, EdgesAndVerticesWhereVoxelsMeetWithoutAFaceAreCounted)
{
  LabelVolume label = emptyLabel({ { 6, 6, 6 } });
  fill(label, { { 1, 1, 1 } }, { { 1, 1, 2 } });
  fill(label, { { 2, 2, 1 } }, { { 2, 2, 2 } }); // two edges along the third axis
  EXPECT_EQ(diagnoseLabel(label).nonManifoldEdges, 2u);
  EXPECT_EQ(diagnoseLabel(label).nonManifoldVertices, 0u);

  for (const std::uint8_t inside : { 1, 0 })
  {
    LabelVolume corners = emptyLabel({ { 6, 6, 6 } });
    fill(corners, { { 1, 1, 1 } }, { { 4, 4, 4 } }, inside == 1 ? 0 : 1);
    corners.inside[corners.voxelNumber(2, 3, 2)] = inside;
    corners.inside[corners.voxelNumber(3, 2, 3)] = inside;
    EXPECT_EQ(diagnoseLabel(corners).nonManifoldEdges, 0u);
    EXPECT_EQ(diagnoseLabel(corners).nonManifoldVertices, 1u);
  }
}

TEST(LabelDiagnosis, BordersAreNamedByImageAxisWhateverTheDirection)
{
  LabelVolume label = emptyLabel({ { 5, 6, 7 } });
  fill(label, { { 0, 2, 2 } }, { { 2, 5, 3 } });
  label.direction << 0, 0, 1, 1, 0, 0, 0, -1, 0;
  label.origin = Vector3(3, -40, 12);
  label.spacing = Vector3(0.3, 0.4, 3.0);
  EXPECT_EQ(imageBordersTouched(label).names(), "first i, last j");
  EXPECT_TRUE(imageBordersTouched(label).any());
  EXPECT_EQ(diagnoseLabel(label).borders.touched, imageBordersTouched(label).touched);
}

TEST(LabelDiagnosis, EmptyLabelIsRefused)
{
  EXPECT_THROW((void)diagnoseLabel(emptyLabel({ { 3, 3, 3 } })), InvalidInput);
  EXPECT_THROW((void)imageBordersTouched(emptyLabel({ { 3, 3, 3 } })), InvalidInput);
}
