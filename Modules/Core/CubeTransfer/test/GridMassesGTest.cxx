#include "moserhex/CubeTransfer/GridMasses.h"

#include "TestMeshes.h"
#include "moserhex/Analytic/Refusals.h"
#include "moserhex/Analytic/SolidShapes.h"
#include "moserhex/CubeTransfer/CubeImage.h"
#include "moserhex/CubeTransfer/CubeSamples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

// Masses to round-off: 1e-12 relative. Noise in full voxels: 1 %, as documented. Threads: to the last bit.

using namespace moserhex;

namespace
{

VoxelGrid
barGrid(int columns)
{
  return { { { columns, 40, 12 } }, { 1.2, 1.3, 2.0 }, { -24.0, -2.0, 97.0 } };
}

/** Masses of a density 1 + (y/50)^2 and of a constant one, 2. */
FieldVolume
massesOf(const HexMesh & mesh, int samplesPerAxis)
{
  const CubeMeans means = cubeMeans(mesh,
                                    [](const CubePoint & point, double * values) {
                                      values[0] = 1.0 + std::pow(point.position[1] / 50.0, 2);
                                      values[1] = 2.0;
                                    },
                                    2,
                                    { samplesPerAxis, 4, 0 });
  FieldVolume     masses = means.image;
  for (std::size_t box = 0; box < means.volumes.size(); ++box)
  {
    masses.at(box)[0] *= means.volumes[box];
    masses.at(box)[1] *= means.volumes[box];
  }
  return masses;
}

double
total(const FieldVolume & image, int component)
{
  double sum = 0.0;
  for (std::size_t voxel = 0; voxel < image.gridVoxels(); ++voxel)
  {
    sum += image.at(voxel)[component];
  }
  return sum;
}

} // namespace

TEST(GridMasses, NoMassIsLost)
{
  const HexMesh mesh = bentLattice(6);
  const CubeMap map(mesh);
  for (const int samples : { 5, 8 })
  {
    for (const double points : { 1.0, 4.0 })
    {
      const FieldVolume masses = massesOf(mesh, samples);
      const GridMasses  result = gridMasses(map, mesh, masses, barGrid(45), { points, 0.0, 0 });
      for (int component = 0; component < 2; ++component)
      {
        const double expected = total(masses, component);
        const double found = total(result.image, component) * result.image.voxelVolume();
        EXPECT_NEAR(found, expected, 1e-12 * expected);
        EXPECT_NEAR(result.outside[static_cast<std::size_t>(component)], 0.0, 1e-12 * expected);
      }
    }
  }
}

TEST(GridMasses, WhatLiesBeyondTheGridIsCounted)
{
  const HexMesh     mesh = bentLattice(6);
  const CubeMap     map(mesh);
  const FieldVolume masses = massesOf(mesh, 5);
  const GridMasses  result = gridMasses(map, mesh, masses, barGrid(20));
  const double      expected = total(masses, 0);
  EXPECT_GT(result.outside[0], 0.1 * expected);
  EXPECT_NEAR(total(result.image, 0) * result.image.voxelVolume() + result.outside[0], expected, 1e-12 * expected);
}

TEST(GridMasses, AConstantDensityStaysConstantInFullVoxels)
{
  const HexMesh    mesh = bentLattice(6);
  const CubeMap    map(mesh);
  const VoxelGrid  grid = barGrid(45);
  const GridMasses result = gridMasses(map, mesh, massesOf(mesh, 5), grid);
  std::size_t      full = 0;
  for (int k = 0; k < grid.size[2]; ++k)
  {
    for (int j = 0; j < grid.size[1]; ++j)
    {
      for (int i = 0; i < grid.size[0]; ++i)
      {
        bool isInside = true;
        for (int corner = 0; corner < 8; ++corner)
        {
          const Vector3 step(corner & 1 ? 0.6 : -0.6, corner & 2 ? 0.65 : -0.65, corner & 4 ? 1.0 : -1.0);
          isInside = isInside && map.find(grid.point(i, j, k) + step).has_value();
        }
        if (isInside)
        {
          ++full;
          EXPECT_NEAR(result.image.at(grid.voxelNumber(i, j, k))[1], 2.0, 0.02);
        }
      }
    }
  }
  EXPECT_GT(full, 500u);
}

TEST(GridMasses, NoVoxelHoldsMoreThanTheDensityThatFillsIt)
{
  const HexMesh mesh = bentLattice(6);
  const CubeMap map(mesh);
  for (const double spacing : { 1.0, 2.0, 3.5 })
  {
    VoxelGrid grid = barGrid(45);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const auto at = static_cast<Eigen::Index>(axis);
      grid.size[axis] = static_cast<int>(std::ceil(grid.size[axis] * grid.spacing[at] / spacing));
    }
    grid.spacing = Vector3::Constant(spacing);
    const GridMasses result = gridMasses(map, mesh, massesOf(mesh, 5), grid);
    double           most = 0.0;
    for (std::size_t voxel = 0; voxel < grid.gridVoxels(); ++voxel)
    {
      most = std::max(most, result.image.at(voxel)[1]);
    }
    EXPECT_LE(most, 2.0 * 1.005) << spacing;
    EXPECT_GT(most, 2.0 * 0.995) << spacing;
  }
}

TEST(GridMasses, ObliqueAndLeftHandedGridsHoldTheSameMass)
{
  const HexMesh     mesh = bentLattice(5);
  const CubeMap     map(mesh);
  const FieldVolume masses = massesOf(mesh, 4);
  VoxelGrid         oblique{ { { 80, 80, 80 } }, { 1.5, 1.5, 1.5 }, Vector3::Zero(), analytic::obliqueDirection() };
  oblique.direction.col(2) *= -1.0;
  oblique.origin = Vector3(2.0, 20.0, 107.0) - oblique.direction * Vector3::Constant(60.0);
  const GridMasses result = gridMasses(map, mesh, masses, oblique);
  EXPECT_NEAR(total(result.image, 0) * oblique.voxelVolume(), total(masses, 0), 1e-12 * total(masses, 0));
}

TEST(GridMasses, ThreadsDoNotMatter)
{
  const HexMesh     mesh = bentLattice(5);
  const CubeMap     map(mesh);
  const FieldVolume masses = massesOf(mesh, 4);
  EXPECT_EQ(gridMasses(map, mesh, masses, barGrid(45), { 4.0, 0.0, 1 }).image.values,
            gridMasses(map, mesh, masses, barGrid(45), { 4.0, 0.0, 2 }).image.values);
}

TEST(GridMasses, UntouchedVoxelsAreBackground)
{
  const HexMesh    mesh = bentLattice(4);
  const CubeMap    map(mesh);
  const GridMasses result = gridMasses(map, mesh, massesOf(mesh, 3), barGrid(45), { 4.0, -7.0, 0 });
  EXPECT_EQ(result.image.values.front(), -7.0);
  const auto background = std::count(result.image.values.begin(), result.image.values.end(), -7.0);
  EXPECT_EQ(static_cast<std::size_t>(background), 2 * (result.image.gridVoxels() - result.reached));
}

TEST(GridMasses, SamplesAtNodesAndOptionsOutOfRangeAreRefused)
{
  const HexMesh mesh = bentLattice(3);
  const CubeMap map(mesh);
  const auto    refused = [&](const FieldVolume & masses, double points) {
    return analytic::messageOf([&] {
             (void)gridMasses(map, mesh, masses, barGrid(45), { points, 0.0, 0 });
           }) != "accepted";
  };
  const FieldVolume nodes{ cubeGrid(CubeSampling::Nodes, 3), 1, std::vector<double>(27, 1.0) };
  EXPECT_TRUE(refused(nodes, 4.0));
  EXPECT_TRUE(refused(massesOf(mesh, 2), 0.5));
  EXPECT_TRUE(refused(massesOf(mesh, 2), 17.0));
  EXPECT_FALSE(refused(massesOf(mesh, 2), 1.0));
}
