// Against trying every voxel, to round-off (1e-12 relative).
#include "NearestVoxel.h"

#include "TestDensities.h"
#include "moserhex/Common/Random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>

using namespace moserhex;
using namespace moserhex::test;

namespace
{

std::vector<Vector3>
centresOf(const VoxelGrid & grid)
{
  std::vector<Vector3> centres;
  (void)imageOf(grid, [&centres](const Vector3 & p) {
    centres.push_back(p);
    return 1.0;
  });
  return centres;
}

/** A few voxels of obliqueVoxels(), whose sides differ. */
std::vector<std::uint8_t>
fewMarks(std::uint64_t seed)
{
  Random                    random(seed);
  std::vector<std::uint8_t> marks(obliqueVoxels().gridVoxels(), 0);
  std::generate(
    marks.begin(), marks.end(), [&random]() -> std::uint8_t { return random.uniform(0, 1) < 0.03 ? 1 : 0; });
  marks[100] = 1;
  return marks;
}

} // namespace

TEST(NearestVoxel, IsMarkedAndNoMarkedOneIsNearer)
{
  const std::vector<Vector3> centres = centresOf(obliqueVoxels());
  for (const std::uint64_t seed : { 1u, 2u, 3u })
  {
    const std::vector<std::uint8_t> marks = fewMarks(seed);
    const std::vector<std::size_t>  nearest = nearestMarkedVoxel(obliqueVoxels(), marks);
    ASSERT_EQ(nearest.size(), marks.size());
    for (std::size_t voxel = 0; voxel < marks.size(); ++voxel)
    {
      double smallest = std::numeric_limits<double>::infinity();
      for (std::size_t other = 0; other < marks.size(); ++other)
      {
        smallest = std::min(smallest, marks[other] != 0 ? (centres[voxel] - centres[other]).norm() : smallest);
      }
      EXPECT_EQ(marks[nearest[voxel]], 1) << seed << " " << voxel;
      EXPECT_NEAR((centres[voxel] - centres[nearest[voxel]]).norm(), smallest, 1e-12 * smallest)
        << seed << " " << voxel;
    }
  }
}

TEST(NearestVoxel, OfAMarkedVoxelIsItself)
{
  std::vector<std::size_t> itself(obliqueVoxels().gridVoxels());
  std::iota(itself.begin(), itself.end(), std::size_t{ 0 });
  EXPECT_EQ(nearestMarkedVoxel(obliqueVoxels(), std::vector<std::uint8_t>(itself.size(), 1)), itself);
  EXPECT_EQ(nearestMarkedVoxel(obliqueVoxels(), std::vector<std::uint8_t>(itself.size(), 0)), itself); // none
}

TEST(NearestVoxel, IsTheSameForAnyNumberOfThreads)
{
  const std::vector<std::uint8_t> marks = fewMarks(4);
  EXPECT_EQ(nearestMarkedVoxel(obliqueVoxels(), marks, 1), nearestMarkedVoxel(obliqueVoxels(), marks, 3));
}
