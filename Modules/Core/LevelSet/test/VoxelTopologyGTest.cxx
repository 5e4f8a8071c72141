// Whole numbers: exact. Shapes with known topology, and for random masks the two roads of duality: the inside joined by
// faces and the outside joined by faces, edges and corners have the same boundary.
#include "TestShapes.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/LevelSet/VoxelTopology.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

using namespace moserhex;

namespace
{

LabelVolume
emptyLabel(int n)
{
  LabelVolume label;
  label.size = { { n, n, n } };
  label.inside.assign(static_cast<std::size_t>(n * n * n), 0);
  return label;
}

void
set(LabelVolume & label, int i, int j, int k)
{
  label.inside[label.voxelNumber(i, j, k)] = 1;
}

LabelVolume
torus()
{
  return test::labelOf({ { 20, 20, 9 } }, Vector3::Ones(), [](const Vector3 & p) {
    return std::hypot(std::hypot(p.x(), p.y()) - 6.0, p.z()) - 2.5;
  });
}

/** V - E + F - C of the union of the closed voxels that are outside, counted cell by cell. */
long
eulerCharacteristicOfClosedOutside(const LabelVolume & label)
{
  std::set<std::array<int, 3>> cells; // doubled coordinates: odd along the axes the cell extends in
  for (int k = 0; k < label.size[2]; ++k)
  {
    for (int j = 0; j < label.size[1]; ++j)
    {
      for (int i = 0; i < label.size[0]; ++i)
      {
        if (label.inside[label.voxelNumber(i, j, k)] != 0)
        {
          continue;
        }
        for (int part = 0; part < 27; ++part)
        {
          cells.insert({ { 2 * i + part % 3, 2 * j + part / 3 % 3, 2 * k + part / 9 } });
        }
      }
    }
  }
  long euler = 0;
  for (const auto & cell : cells)
  {
    euler += (cell[0] + cell[1] + cell[2]) % 2 == 0 ? 1 : -1;
  }
  return euler;
}

} // namespace

TEST(VoxelTopology, OneVoxelIsABall)
{
  LabelVolume label = emptyLabel(1);
  set(label, 0, 0, 0);
  EXPECT_TRUE(voxelTopology(label).isBall());
}

TEST(VoxelTopology, TorusHasOneHandle)
{
  const VoxelTopology topology = voxelTopology(torus());
  EXPECT_EQ(topology.components, 1u);
  EXPECT_EQ(topology.cavities, 0u);
  EXPECT_EQ(topology.handles(), 1);
  EXPECT_EQ(topology.surfaceEulerCharacteristic(), 0);
  EXPECT_FALSE(topology.isBall());
}

TEST(VoxelTopology, HollowBallHasOneCavity)
{
  const auto label = test::labelOf(
    { { 15, 15, 15 } }, Vector3::Ones(), [](const Vector3 & p) { return std::abs(p.norm() - 4.5) - 1.5; });
  const VoxelTopology topology = voxelTopology(label);
  EXPECT_EQ(topology.cavities, 1u);
  EXPECT_EQ(topology.handles(), 0);
  EXPECT_EQ(topology.surfaceEulerCharacteristic(), 4);
}

TEST(VoxelTopology, RingThatClosesInAnEdgeOnlyIsNoHandle)
{
  LabelVolume label = emptyLabel(3); // the eight voxels around the middle of a slice, one corner moved out of the way
  for (int j = 0; j < 3; ++j)
  {
    for (int i = 0; i < 3; ++i)
    {
      if (!(i == 1 && j == 1) && !(i == 2 && j == 2))
      {
        set(label, i, j, 1);
      }
    }
  }
  EXPECT_TRUE(voxelTopology(label).isBall()); // (2,1) and (1,2) meet in an edge
  set(label, 2, 2, 1);
  EXPECT_EQ(voxelTopology(label).handles(), 1);
}

TEST(VoxelTopology, VoxelsThatMeetInAnEdgeOrACornerAreTwoComponents)
{
  LabelVolume label = emptyLabel(3);
  set(label, 0, 0, 0);
  set(label, 1, 1, 0);
  set(label, 2, 2, 1);
  EXPECT_EQ(voxelTopology(label).components, 3u);
}

TEST(VoxelTopology, PocketOpenThroughACornerIsNoCavity)
{
  LabelVolume label = emptyLabel(3);
  label.inside.assign(27, 1);
  label.inside[label.voxelNumber(1, 1, 1)] = 0;
  EXPECT_EQ(voxelTopology(label).cavities, 1u);
  label.inside[label.voxelNumber(2, 2, 2)] = 0;
  EXPECT_EQ(voxelTopology(label).cavities, 0u);
}

TEST(VoxelTopology, InsideAndOutsideGiveTheSameNumber)
{
  for (std::uint64_t seed = 0; seed < 20; ++seed)
  {
    const LabelVolume label = test::randomLabel({ { 6, 5, 7 } }, 0.2 + 0.03 * static_cast<double>(seed), seed);
    const LabelVolume padded = cropAndPad(label, { { 1, 1, 1 } });
    // The rest of space, glued to the box along its surface, takes away 1.
    EXPECT_EQ(voxelTopology(label).eulerCharacteristic, eulerCharacteristicOfClosedOutside(padded) - 1)
      << "seed " << seed;
  }
}

TEST(VoxelTopology, LabelThatFillsTheImageIsABall)
{
  LabelVolume label = emptyLabel(4);
  label.inside.assign(64, 1);
  EXPECT_TRUE(voxelTopology(label).isBall());
}

TEST(KeepLargestComponent, DropsTheOthersAndCountsThem)
{
  LabelVolume label = emptyLabel(5);
  set(label, 0, 0, 0);
  set(label, 2, 2, 2);
  set(label, 3, 2, 2);
  set(label, 3, 3, 3); // meets (3,2,2) in an edge
  const VoxelChange change = keepLargestComponentInPlace(label);
  EXPECT_EQ(change.parts, 2u);
  EXPECT_EQ(change.voxels, 2u);
  EXPECT_EQ(voxelCount(label), 2u);
  EXPECT_EQ(label.inside[label.voxelNumber(2, 2, 2)], 1);
}

TEST(KeepLargestComponent, SpiralIsOneComponent)
{
  LabelVolume label = emptyLabel(7); // joins of runs happen late and in both directions
  for (int q = 0; q < 7; ++q)
  {
    set(label, q, 0, 3);
    set(label, 6, q, 3);
    set(label, q, 6, 3);
    set(label, 0, std::max(q, 2), 3);
    set(label, std::min(q, 4), 2, 3);
    set(label, 4, std::min(std::max(q, 2), 4), 3);
  }
  EXPECT_EQ(keepLargestComponentInPlace(label).parts, 0u);
}

TEST(FillCavities, FillsWhatIsClosedInAndCountsIt)
{
  LabelVolume label = emptyLabel(7);
  label.inside.assign(343, 1);
  label.inside[label.voxelNumber(2, 2, 2)] = 0;
  label.inside[label.voxelNumber(3, 3, 3)] = 0; // 26-connected to the first: one cavity
  label.inside[label.voxelNumber(0, 4, 4)] = 0; // open
  const VoxelChange change = fillCavitiesInPlace(label);
  EXPECT_EQ(change.parts, 1u);
  EXPECT_EQ(change.voxels, 2u);
  EXPECT_EQ(voxelCount(label), 342u);
}

TEST(VoxelTopology, EmptyAndInvalidLabelsAreRefused)
{
  LabelVolume label = emptyLabel(3);
  EXPECT_THROW((void)voxelTopology(label), InvalidInput);
  EXPECT_THROW((void)keepLargestComponentInPlace(label), InvalidInput);
  EXPECT_THROW((void)fillCavitiesInPlace(label), InvalidInput);
  set(label, 1, 1, 1);
  label.spacing[1] = 0.0;
  EXPECT_THROW((void)voxelTopology(label), InvalidInput);
}

TEST(LabelVolume, CropAndPadKeepsPlacesInSpace)
{
  LabelVolume label = emptyLabel(6);
  label.spacing = Vector3(0.5, 2.0, 3.0);
  label.origin = Vector3(7, 8, 9);
  set(label, 1, 2, 3);
  set(label, 4, 2, 5);
  const LabelVolume cropped = cropAndPad(label, { { 2, 0, 3 } });
  EXPECT_EQ(cropped.size, (std::array<int, 3>{ { 8, 1, 9 } }));
  EXPECT_EQ(voxelCount(cropped), 2u);
  EXPECT_EQ(cropped.inside[cropped.voxelNumber(2, 0, 3)], 1);
  EXPECT_LT((cropped.point(2, 0, 3) - label.point(1, 2, 3)).norm(), 1e-12);
}

TEST(LabelVolume, BadVolumesAreRefused)
{
  const auto refuse = [](const auto & change) {
    LabelVolume label = emptyLabel(3);
    set(label, 1, 1, 1);
    change(label);
    EXPECT_THROW(requireValid(label, "test"), InvalidInput);
  };
  refuse([](LabelVolume & label) { label.size[0] = 0; });
  refuse([](LabelVolume & label) { label.inside.pop_back(); });
  refuse([](LabelVolume & label) { label.direction(0, 1) = 0.1; });
  refuse([](LabelVolume & label) { label.origin[2] = NAN; });
  refuse([](LabelVolume & label) { label.inside.assign(27, 0); });
}
