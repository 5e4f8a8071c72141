// Two roads: the lower envelopes against the distance to every other voxel (1e-10 mm).
#include "TestShapes.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/LevelSet/SignedDistance.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace moserhex;

namespace
{

/** Distance to the nearest voxel of the other kind that agrees in the axes not chosen, over all pairs. */
double
bruteForce(const LabelVolume & label, const std::array<int, 3> & at, const std::array<bool, 3> & axes)
{
  const bool inside = label.inside[label.voxelNumber(at[0], at[1], at[2])] != 0;
  double     smallest = INFINITY;
  double     half = INFINITY;
  for (int axis = 0; axis < 3; ++axis)
  {
    half = axes[static_cast<std::size_t>(axis)] ? std::min(half, 0.5 * label.spacing[axis]) : half;
  }
  for (int k = 0; k < label.size[2]; ++k)
  {
    for (int j = 0; j < label.size[1]; ++j)
    {
      for (int i = 0; i < label.size[0]; ++i)
      {
        const bool reachable = (axes[0] || i == at[0]) && (axes[1] || j == at[1]) && (axes[2] || k == at[2]);
        if (reachable && (label.inside[label.voxelNumber(i, j, k)] != 0) != inside)
        {
          smallest = std::min(smallest, (label.point(i, j, k) - label.point(at[0], at[1], at[2])).norm());
        }
      }
    }
  }
  return inside ? half - smallest : smallest - half;
}

void
expectBruteForce(const LabelVolume & label, const std::array<bool, 3> & axes)
{
  const auto distance = voxelSignedDistance(label, axes);
  for (int k = 0; k < label.size[2]; ++k)
  {
    for (int j = 0; j < label.size[1]; ++j)
    {
      for (int i = 0; i < label.size[0]; ++i)
      {
        const double expected = bruteForce(label, { { i, j, k } }, axes);
        const double actual = distance[label.voxelNumber(i, j, k)];
        if (std::isinf(expected))
        {
          EXPECT_EQ(actual, expected);
        }
        else
        {
          EXPECT_NEAR(actual, expected, 1e-10);
        }
      }
    }
  }
}

LabelVolume
anisotropicLabel(double density, std::uint64_t seed)
{
  LabelVolume label = test::randomLabel({ { 11, 7, 6 } }, density, seed);
  label.spacing = Vector3(0.4, 0.7, 3.0);
  return label;
}

} // namespace

TEST(VoxelSignedDistance, ThreeAxesEqualBruteForce)
{
  expectBruteForce(anisotropicLabel(0.03, 1), { { true, true, true } });
  expectBruteForce(anisotropicLabel(0.5, 2), { { true, true, true } });
  expectBruteForce(anisotropicLabel(0.97, 3), { { true, true, true } });
}

TEST(VoxelSignedDistance, EveryChoiceOfAxesEqualsBruteForce)
{
  for (int choice = 1; choice < 8; ++choice)
  {
    expectBruteForce(anisotropicLabel(0.1, 10), { { (choice & 1) != 0, (choice & 2) != 0, (choice & 4) != 0 } });
  }
}

TEST(VoxelSignedDistance, SliceWithoutTheOtherKindIsInfinitelyFar)
{
  LabelVolume label;
  label.size = { { 3, 3, 2 } };
  label.inside.assign(18, 0);
  std::fill(label.inside.begin(), label.inside.begin() + 9, std::uint8_t{ 1 });
  const auto distance = voxelSignedDistance(label, { { true, true, false } });
  EXPECT_EQ(distance.front(), -INFINITY);
  EXPECT_EQ(distance.back(), INFINITY);
}

TEST(VoxelSignedDistance, FaceBetweenTwoVoxelsIsHalfAVoxelAway)
{
  LabelVolume label;
  label.size = { { 4, 1, 1 } };
  label.spacing = Vector3(2.0, 5.0, 5.0);
  label.inside = { 1, 1, 0, 0 };
  const auto distance = voxelSignedDistance(label, { { true, false, false } });
  EXPECT_EQ(distance, (std::vector<double>{ -3.0, -1.0, 1.0, 3.0 }));
}

TEST(VoxelSignedDistance, IsTheSameForAnyNumberOfThreads)
{
  const LabelVolume label = test::randomLabel({ { 90, 80, 20 } }, 0.02, 5);
  EXPECT_EQ(voxelSignedDistance(label, { { true, true, true } }, 1),
            voxelSignedDistance(label, { { true, true, true } }, 3));
}

TEST(VoxelSignedDistance, EmptyLabelAndNoAxisAreRefused)
{
  LabelVolume label = anisotropicLabel(0.5, 4);
  EXPECT_THROW((void)voxelSignedDistance(label, { { false, false, false } }), InvalidInput);
  std::fill(label.inside.begin(), label.inside.end(), std::uint8_t{ 0 });
  EXPECT_THROW((void)voxelSignedDistance(label, { { true, true, true } }), InvalidInput);
}
