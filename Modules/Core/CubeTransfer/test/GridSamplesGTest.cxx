#include "moserhex/CubeTransfer/GridSamples.h"

#include "TestMeshes.h"
#include "moserhex/CubeTransfer/CubeImage.h"
#include "moserhex/CubeTransfer/FieldFunction.h"

#include <gtest/gtest.h>

// Round-off: 1e-10 mm. Comparisons of numbers of threads: to the last bit.

using namespace moserhex;

namespace
{

/** Holds the bent bar. */
VoxelGrid
barGrid()
{
  return { { { 45, 40, 12 } }, { 1.2, 1.3, 2.0 }, { -24.0, -2.0, 97.0 } };
}

void
positionOf(const CubePoint & point, double * values)
{
  Eigen::Map<Vector3> p(values);
  p = point.position;
}

} // namespace

TEST(GridSamples, EveryVoxelInTheMeshGetsItsOwnPlace)
{
  const HexMesh     mesh = bentLattice(6);
  const CubeMap     map(mesh);
  const VoxelGrid   grid = barGrid();
  const GridSamples samples = gridSamples(map, mesh, positionOf, 3, grid, { -1e6, 0 });
  std::size_t       inside = 0;
  for (int k = 0; k < grid.size[2]; ++k)
  {
    for (int j = 0; j < grid.size[1]; ++j)
    {
      for (int i = 0; i < grid.size[0]; ++i)
      {
        const Vector3                   p = grid.point(i, j, k);
        const Eigen::Map<const Vector3> value(samples.image.at(grid.voxelNumber(i, j, k)));
        const bool                      isInside = map.find(p).has_value();
        inside += isInside ? 1 : 0;
        EXPECT_LE((value - (isInside ? p : Vector3(Vector3::Constant(-1e6)))).norm(), 1e-10);
      }
    }
  }
  EXPECT_EQ(samples.inside, inside);
  EXPECT_GT(inside, 1000u);
}

TEST(GridSamples, TheFacesOfTheCubeAreInAnImageOfIt)
{
  const FieldVolume   image{ cubeGrid(CubeSampling::Cells, 7), 1, std::vector<double>(343, 5.0) };
  const FieldFunction f(image, ImageInterpolation::Linear);
  for (const Vector3 & corner : { Vector3(0.0, 0.0, 0.0), Vector3(1.0, 1.0, 1.0), Vector3(1.0, 0.0, 0.5) })
  {
    double value = 0.0;
    EXPECT_TRUE(f.evaluate(corner, &value));
    EXPECT_DOUBLE_EQ(value, 5.0);
  }
  double unchanged = 3.0;
  EXPECT_FALSE(f.evaluate(Vector3(1.0 + 1e-6, 0.5, 0.5), &unchanged));
  EXPECT_EQ(unchanged, 3.0);
}

TEST(GridSamples, ThreadsDoNotMatter)
{
  const HexMesh mesh = bentLattice(4);
  const CubeMap map(mesh);
  EXPECT_EQ(gridSamples(map, mesh, positionOf, 3, barGrid(), { 0.0, 1 }).image.values,
            gridSamples(map, mesh, positionOf, 3, barGrid(), { 0.0, 2 }).image.values);
}
