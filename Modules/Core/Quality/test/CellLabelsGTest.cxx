// Exact: the cells of a box lattice lie in known voxels.
#include "moserhex/Quality/CellLabels.h"

#include "moserhex/Common/Errors.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

using namespace moserhex;

namespace
{

/** 6 x 6 x 6 voxels of 1 mm, centres at 0..5: label 1 where i < 3, else label 2, and nothing where k = 5. */
LabelValues
twoHalves()
{
  LabelValues labels;
  labels.size = { { 6, 6, 6 } };
  for (int k = 0; k < 6; ++k)
  {
    for (int j = 0; j < 6; ++j)
    {
      for (int i = 0; i < 6; ++i)
      {
        labels.values.push_back(k == 5 ? 0 : (i < 3 ? 1 : 2));
      }
    }
  }
  return labels;
}

/** n^3 nodes over the box [low, high]. */
HexMesh
boxLattice(int n, const Vector3 & low, const Vector3 & high)
{
  HexMesh mesh{ n, {} };
  for (int node = 0; node < n * n * n; ++node)
  {
    const Vector3 index(node % n, node / n % n, node / (n * n));
    mesh.nodes.emplace_back(low + (high - low).cwiseProduct(index) / (n - 1));
  }
  return mesh;
}

} // namespace

TEST(CellLabels, CellsGetTheLabelOfTheVoxelsTheyLieIn)
{
  const HexMesh mesh = boxLattice(3, Vector3::Constant(-0.5), Vector3(5.5, 5.5, 4.5));
  EXPECT_EQ(labelsOfCells(mesh, twoHalves()), (std::vector<std::int32_t>{ 1, 2, 1, 2, 1, 2, 1, 2 }));
}

TEST(CellLabels, TheCommonestLabelOfACellWinsWhateverLiesBeside)
{
  // One cell from i = -0.5 to 3.4: its samples along i lie in voxels 0, 1 and 3.
  EXPECT_EQ(labelsOfCells(boxLattice(2, Vector3::Constant(-0.5), Vector3(3.4, 4.5, 5.5)), twoHalves()).front(), 1);
  EXPECT_EQ(labelsOfCells(boxLattice(2, Vector3(1.6, 0.0, 0.0), Vector3(5.5, 4.5, 8.5)), twoHalves()).front(), 2);
}

TEST(CellLabels, OfEquallyCommonLabelsTheSmallestWins)
{
  // Samples along i in voxels 2, 3 and beyond the image.
  const HexMesh mesh = boxLattice(2, Vector3(1.5, 0.0, 0.0), Vector3(7.5, 4.0, 4.0));
  LabelValues   labels = twoHalves();
  for (std::size_t voxel = 0; voxel < labels.values.size(); ++voxel)
  {
    labels.values[voxel] = voxel % 6 == 2 ? 7 : (voxel % 6 == 4 ? 5 : 0);
  }
  EXPECT_EQ(labelsOfCells(mesh, labels).front(), 5);
}

TEST(CellLabels, CellsBesideEveryLabelGet0)
{
  EXPECT_EQ(labelsOfCells(boxLattice(2, Vector3::Constant(50.0), Vector3::Constant(51.0)), twoHalves()).front(), 0);
}

TEST(CellLabels, AnObliqueImageGivesTheLabelsOfTheMovedMesh)
{
  const Matrix3 turn = Eigen::AngleAxisd(0.7, Vector3(1.0, 2.0, 3.0).normalized()).toRotationMatrix();
  const Vector3 shift(10.0, -20.0, 30.0);
  LabelValues   labels = twoHalves();
  labels.spacing = Vector3(0.5, 1.0, 3.0);
  labels.origin = shift;
  labels.direction = turn;
  HexMesh    mesh = boxLattice(4, Vector3::Constant(-0.4), Vector3(5.3, 5.2, 4.6)); // no sample between two voxels
  const auto expected = labelsOfCells(mesh, twoHalves());
  for (Vector3 & node : mesh.nodes)
  {
    node = shift + turn * labels.spacing.cwiseProduct(node);
  }
  EXPECT_EQ(labelsOfCells(mesh, labels, 2), expected);
}

TEST(CellLabels, AWrongNumberOfValuesIsRefused)
{
  LabelValues labels = twoHalves();
  labels.values.pop_back();
  EXPECT_THROW((void)labelsOfCells(boxLattice(2, Vector3::Zero(), Vector3::Ones()), labels), InvalidInput);
}
