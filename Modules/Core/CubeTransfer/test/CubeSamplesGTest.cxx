#include "moserhex/CubeTransfer/CubeSamples.h"

#include "TestMeshes.h"
#include "moserhex/Analytic/Refusals.h"
#include "moserhex/CubeTransfer/CellMeans.h"
#include "moserhex/CubeTransfer/CubeImage.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

// Integrals and volumes to round-off: 1e-12 relative. Comparisons of numbers of threads: to the last bit.

using namespace moserhex;

namespace
{

void
smooth(const CubePoint & point, double * values)
{
  values[0] = std::sin(0.1 * point.position[0]);
  values[1] = point.position[1];
}

double
integral(const CubeMeans & means, int component)
{
  double sum = 0.0;
  for (std::size_t box = 0; box < means.volumes.size(); ++box)
  {
    sum += means.volumes[box] * means.image.at(box)[component];
  }
  return sum;
}

} // namespace

TEST(CubeSamples, TheMeshsOwnCellsHaveTheMeansOfCellMeans)
{
  const HexMesh   mesh = bentLattice(5);
  const CubeMeans means = cubeMeans(mesh, smooth, 2);
  const auto      first = cellMeans(mesh, [](const Vector3 & p) { return std::sin(0.1 * p[0]); });
  for (std::size_t cell = 0; cell < first.size(); ++cell)
  {
    EXPECT_NEAR(means.image.at(cell)[0], first[cell], 1e-13);
  }
}

TEST(CubeSamples, AnyNumberOfBoxesHasTheSameIntegralOfALinearFunction)
{
  const HexMesh mesh = bentLattice(5);
  const auto    cells = cellVolumes(mesh);
  const double  volume = std::accumulate(cells.begin(), cells.end(), 0.0);
  const double  expected = integral(cubeMeans(mesh, smooth, 2), 1);
  for (const int n : { 1, 3, 4, 7, 8 })
  {
    const CubeMeans means = cubeMeans(mesh, smooth, 2, { n, 4, 0 });
    EXPECT_NEAR(std::accumulate(means.volumes.begin(), means.volumes.end(), 0.0), volume, 1e-12 * volume) << n;
    EXPECT_NEAR(integral(means, 1), expected, 1e-12 * std::abs(expected)) << n;
  }
}

TEST(CubeSamples, BoxesStandWhereTheGridSays)
{
  const HexMesh   mesh = bentLattice(5);
  const CubeMeans means = cubeMeans(mesh,
                                    [](const CubePoint & point, double * values) {
                                      Eigen::Map<Vector3> c(values);
                                      c = point.cube;
                                    },
                                    3,
                                    { 40, 2, 0 });
  // det J is nearly constant in a small box, so its mean cube coordinates are those of its centre.
  for (const std::size_t box : { 0, 39, 40, 1600, 31999 })
  {
    const int i = static_cast<int>(box % 40);
    const int j = static_cast<int>(box / 40 % 40);
    EXPECT_LE(
      (Eigen::Map<const Vector3>(means.image.at(box)) - means.image.point(i, j, static_cast<int>(box / 1600))).norm(),
      2e-4);
  }
}

TEST(CubeSamples, VolumesAloneAreTheSame)
{
  const HexMesh mesh = bentLattice(4);
  const auto    volumes = cubeVolumes(mesh, { 5, 4, 0 });
  const auto    expected = cubeMeans(mesh, smooth, 2, { 5, 4, 0 }).volumes;
  for (std::size_t box = 0; box < volumes.size(); ++box)
  {
    EXPECT_NEAR(volumes[box], expected[box], 1e-12 * expected[box]);
  }
}

TEST(CubeSamples, NodesHaveTheirOwnValues)
{
  const HexMesh     mesh = bentLattice(4);
  const FieldVolume samples = cubeNodeSamples(mesh, smooth, 2);
  EXPECT_EQ(cubeSamplingOf(samples), CubeSampling::Nodes);
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
  {
    EXPECT_NEAR(samples.at(node)[1], mesh.nodes[node][1], 1e-12);
  }
}

TEST(CubeSamples, ThreadsDoNotMatter)
{
  const HexMesh mesh = bentLattice(5);
  EXPECT_EQ(cubeMeans(mesh, smooth, 2, { 6, 3, 1 }).image.values, cubeMeans(mesh, smooth, 2, { 6, 3, 2 }).image.values);
}

TEST(CubeSamples, OfANewGridTheKindIsKnown)
{
  for (const int n : { 2, 3, 19, 1000 })
  {
    EXPECT_EQ(cubeSamplingOf(cubeGrid(CubeSampling::Cells, n)), CubeSampling::Cells);
    EXPECT_EQ(cubeSamplingOf(cubeGrid(CubeSampling::Nodes, n)), CubeSampling::Nodes);
  }
}

TEST(CubeSamples, WhatIsNoCubeIsRefused)
{
  const auto refused = [](const VoxelGrid & grid) {
    return analytic::messageOf([&] { (void)cubeSamplingOf(grid); }) != "accepted";
  };
  VoxelGrid shifted = cubeGrid(CubeSampling::Cells, 10);
  shifted.origin[1] += 1e-3;
  EXPECT_TRUE(refused(shifted));
  VoxelGrid cut = cubeGrid(CubeSampling::Nodes, 10);
  cut.size[2] = 9;
  EXPECT_TRUE(refused(cut));
  EXPECT_TRUE(refused(VoxelGrid{}));
}

TEST(CubeSamples, OptionsOutOfRangeAreRefused)
{
  const HexMesh mesh = bentLattice(3);
  const auto    refused = [&mesh](const CubeMeanOptions & options, int components) {
    return analytic::messageOf([&] { (void)cubeMeans(mesh, smooth, components, options); }) != "accepted";
  };
  EXPECT_TRUE(refused({ -1, 4, 0 }, 2));
  EXPECT_TRUE(refused({ 1001, 4, 0 }, 2));
  EXPECT_TRUE(refused({ 0, 1, 0 }, 2));
  EXPECT_TRUE(refused({ 0, 49, 0 }, 2));
  EXPECT_TRUE(refused({ 0, 4, 0 }, 0));
  EXPECT_FALSE(refused({ 0, 4, 0 }, 2));
}
