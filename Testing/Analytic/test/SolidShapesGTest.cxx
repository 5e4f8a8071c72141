// Tolerances: the voxel count of a smooth solid approaches its closed-form volume much faster than the voxel size; at
// half a millimetre the measured differences are below 2e-3, so 5e-3 separates a wrong formula from the grid. Frame
// identities: the same voxel count up to the grid, 1e-2.
#include "moserhex/Analytic/SolidShapes.h"

#include "moserhex/Analytic/ObservedOrder.h"
#include "moserhex/Common/Errors.h"

#include <gtest/gtest.h>

using namespace moserhex;
using namespace moserhex::analytic;

namespace moserhex::analytic
{
void
PrintTo(const Solid & solid, std::ostream * stream)
{
  *stream << solid.name;
}
} // namespace moserhex::analytic

class EverySolid : public testing::TestWithParam<Solid>
{};

INSTANTIATE_TEST_SUITE_P(SolidShapes, EverySolid, testing::ValuesIn(solids()), [](const auto & instance) {
  return instance.param.name;
});

TEST_P(EverySolid, VoxelVolumeApproachesTheClosedForm)
{
  // The faces of the cube lie half-way between voxels.
  const LabelVolume label = labelVolume(GetParam(), { Vector3::Constant(32.0 / 65.0) });
  EXPECT_LT(relativeError(volumeOfVoxels(label), GetParam().volume), 5e-3);
}

TEST_P(EverySolid, ObliqueAnisotropicGridHoldsTheSameVolume)
{
  const LabelVolume label = labelVolume(GetParam(), { Vector3(0.5, 0.5, 1.0), obliqueDirection() });
  EXPECT_LT(relativeError(volumeOfVoxels(label), GetParam().volume), 1e-2);
}

TEST_P(EverySolid, MarginOfTheGridIsOutside)
{
  const LabelVolume label = labelVolume(GetParam(), { Vector3::Constant(1.0), Matrix3::Identity(), 2.0 });
  std::size_t       voxel = 0;
  for (int k = 0; k < label.size[2]; ++k)
  {
    for (int j = 0; j < label.size[1]; ++j)
    {
      for (int i = 0; i < label.size[0]; ++i, ++voxel)
      {
        const bool nearBorder =
          i < 2 || j < 2 || k < 2 || i >= label.size[0] - 2 || j >= label.size[1] - 2 || k >= label.size[2] - 2;
        EXPECT_FALSE(nearBorder && label.inside[voxel]) << i << ' ' << j << ' ' << k;
      }
    }
  }
}

TEST(SolidShapes, BadSizesAreRefused)
{
  EXPECT_THROW((void)ball(0.0), InvalidInput);
  EXPECT_THROW((void)ellipsoid(Vector3(1, 1, -1)), InvalidInput);
  EXPECT_THROW((void)bumpyBall(1.0, 0.6), InvalidInput);
  EXPECT_THROW((void)banana(5.0, 9.0), InvalidInput);
  EXPECT_THROW((void)cube(-1.0), InvalidInput);
  EXPECT_THROW((void)labelVolume(ball(), { Vector3(1, 0, 1) }), InvalidInput);
}
