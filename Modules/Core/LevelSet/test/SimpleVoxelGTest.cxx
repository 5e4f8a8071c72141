// Whole numbers: exact. What the table of neighbours says is compared with the topology of the whole mask, counted
// anew.
#include "TestShapes.h"
#include "moserhex/LevelSet/SimpleVoxel.h"
#include "moserhex/LevelSet/VoxelTopology.h"

#include <gtest/gtest.h>

using namespace moserhex;

namespace
{

/** A random mask with one empty layer, and inside it a voxel that never changes, so that it is never empty. */
LabelVolume
paddedRandomLabel(double density, std::uint64_t seed)
{
  LabelVolume label = cropAndPad(test::randomLabel({ { 5, 4, 5 } }, density, seed), { { 1, 1, 1 } });
  return label;
}

bool
sameTopology(const VoxelTopology & a, const VoxelTopology & b)
{
  return a.components == b.components && a.cavities == b.cavities && a.eulerCharacteristic == b.eulerCharacteristic;
}

/** Calls with the number of every voxel off the outermost layer. */
template <typename TFunction>
void
forInnerVoxels(const VoxelGrid & grid, const TFunction & function)
{
  for (int k = 1; k + 1 < grid.size[2]; ++k)
  {
    for (int j = 1; j + 1 < grid.size[1]; ++j)
    {
      for (int i = 1; i + 1 < grid.size[0]; ++i)
      {
        function(grid.voxelNumber(i, j, k));
      }
    }
  }
}

} // namespace

TEST(SimpleVoxel, FlippingASimpleVoxelKeepsTheTopologyOfInsideAndOutside)
{
  std::size_t simple = 0;
  for (std::uint64_t seed = 0; seed < 15; ++seed)
  {
    LabelVolume              label = paddedRandomLabel(0.2 + 0.04 * static_cast<double>(seed), seed);
    const VoxelNeighbourhood neighbourhood(label);
    const VoxelTopology      before = voxelTopology(label);
    forInnerVoxels(label, [&](std::size_t voxel) {
      if (isSimpleVoxel(neighbourhood.inside(label.inside, voxel)))
      {
        ++simple;
        label.inside[voxel] ^= 1U;
        EXPECT_TRUE(sameTopology(voxelTopology(label), before)) << "seed " << seed << ", voxel " << voxel;
        label.inside[voxel] ^= 1U;
      }
    });
  }
  EXPECT_GT(simple, 100u);
}

TEST(SimpleVoxel, AVoxelThatIsNotSimpleChangesTheTopologyUnlessItCutsAndJoinsAtOnce)
{
  std::size_t changed = 0;
  std::size_t others = 0;
  for (std::uint64_t seed = 0; seed < 15; ++seed)
  {
    LabelVolume              label = paddedRandomLabel(0.2 + 0.04 * static_cast<double>(seed), seed);
    const VoxelNeighbourhood neighbourhood(label);
    const VoxelTopology      before = voxelTopology(label);
    forInnerVoxels(label, [&](std::size_t voxel) {
      if (!isSimpleVoxel(neighbourhood.inside(label.inside, voxel)) && voxelCount(label) > 1)
      {
        label.inside[voxel] ^= 1U;
        (sameTopology(voxelTopology(label), before) ? others : changed) += 1;
        label.inside[voxel] ^= 1U;
      }
    });
  }
  EXPECT_GT(changed, 100u);
  EXPECT_LT(others, changed / 10);
}

TEST(SimpleVoxel, TheEulerCharacteristicChangesAsTheNeighboursSay)
{
  for (std::uint64_t seed = 0; seed < 15; ++seed)
  {
    LabelVolume              label = paddedRandomLabel(0.2 + 0.04 * static_cast<double>(seed), seed);
    const VoxelNeighbourhood neighbourhood(label);
    forInnerVoxels(label, [&](std::size_t voxel) {
      if (label.inside[voxel] == 0)
      {
        const long before = voxelTopology(label).eulerCharacteristic;
        label.inside[voxel] = 1;
        const long after = voxelTopology(label).eulerCharacteristic;
        label.inside[voxel] = 0;
        EXPECT_EQ(after - before, eulerChangeOfAdding(neighbourhood.inside(label.inside, voxel)));
      }
    });
  }
}

TEST(SimpleVoxel, AVoxelAloneOrDeepInsideIsNotSimple)
{
  EXPECT_FALSE(isSimpleVoxel(0));
  EXPECT_FALSE(isSimpleVoxel((1U << voxelNeighbours) - 1U));
  EXPECT_FALSE(isSimpleVoxel(~faceNeighbours() & ((1U << voxelNeighbours) - 1U))); // touched by edges and corners only
}
