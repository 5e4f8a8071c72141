// Exact: a copy there and back changes no bit.
#include "itkHexMeshConversion.h"

#include "moserhex/Analytic/Lattices.h"

#include <gtest/gtest.h>

namespace
{

moserhex::HexMesh
twistedLattice(int n)
{
  moserhex::HexMesh mesh;
  mesh.nodesPerSide = n;
  for (int k = 0; k < n; ++k)
  {
    for (int j = 0; j < n; ++j)
    {
      for (int i = 0; i < n; ++i)
      {
        mesh.nodes.push_back({ i + 0.1 * k / 3.0, j - 0.01 * i, k * 1.7 + 1e-13 });
      }
    }
  }
  return mesh;
}

using PlainMesh = itk::Mesh<float, 3, itk::DefaultStaticMeshTraits<float, 3, 3, double, double, float>>;

} // namespace

TEST(HexMeshConversion, ThereAndBackChangesNoBit)
{
  const moserhex::HexMesh source = twistedLattice(6);
  const auto              mesh = itk::LatticeHexMesh::New();
  itk::CopyHexMeshToItk(source, mesh.GetPointer());
  const moserhex::HexMesh back = itk::HexMeshFromItk(mesh.GetPointer());
  EXPECT_EQ(back.nodesPerSide, 6);
  EXPECT_EQ(back.nodes, source.nodes);
}

TEST(HexMeshConversion, PaddingGoesThereAndBackAndIsNamed)
{
  const moserhex::HexMesh source =
    moserhex::analytic::paddedLattice(4, 2, [](const moserhex::Vector3 & index) { return index; });
  const auto mesh = itk::LatticeHexMesh::New();
  itk::CopyHexMeshToItk(source, mesh.GetPointer());
  const moserhex::HexMesh back = itk::HexMeshFromItk(mesh.GetPointer());
  EXPECT_EQ(back.nodesPerSide, 4);
  EXPECT_EQ(back.paddingLayers, 2);
  EXPECT_EQ(back.nodes, source.nodes);
  const itk::LatticePointData data = mesh->GetPointData()->ElementAt(source.paddingNodeNumber(2, 0, 1, 3));
  EXPECT_EQ(data[0], 0);
  EXPECT_EQ(data[1], 1);
  EXPECT_EQ(data[2], 3);
  EXPECT_EQ(data[3], 4); // two shells, two layers
  EXPECT_EQ(mesh->GetCellData()->ElementAt(27)[0], 3);
  EXPECT_EQ(mesh->GetCellData()->ElementAt(27 + 54)[0], 4);
}

TEST(HexMeshConversion, PointDataHoldTheLatticeIndexAndShell)
{
  const auto mesh = itk::LatticeHexMesh::New();
  itk::CopyHexMeshToItk(twistedLattice(4), mesh.GetPointer());
  const itk::LatticePointData data = mesh->GetPointData()->ElementAt(2 + 4 * (1 + 4 * 1));
  EXPECT_EQ(data[0], 2);
  EXPECT_EQ(data[1], 1);
  EXPECT_EQ(data[2], 1);
  EXPECT_EQ(data[3], 1);
}

TEST(HexMeshConversion, VolumeRatiosHaveMeanOne)
{
  const auto mesh = itk::LatticeHexMesh::New();
  itk::CopyHexMeshToItk(twistedLattice(4), mesh.GetPointer());
  double sum = 0.0;
  for (itk::IdentifierType cell = 0; cell < 27; ++cell)
  {
    sum += mesh->GetCellData()->ElementAt(cell)[1];
  }
  EXPECT_NEAR(sum / 27, 1.0, 1e-12);
}

TEST(HexMeshConversion, AMeshOfPlainNumbersGetsShellAndRatio)
{
  const auto mesh = PlainMesh::New();
  itk::CopyHexMeshToItk(twistedLattice(4), mesh.GetPointer());
  EXPECT_EQ(mesh->GetPointData()->ElementAt(0), 2.0F);
  EXPECT_NEAR(mesh->GetCellData()->ElementAt(13), 1.0F, 1e-5F);
}

TEST(HexMeshConversion, OtherCellsAreRefused)
{
  const auto mesh = itk::LatticeHexMesh::New();
  itk::CopyHexMeshToItk(twistedLattice(4), mesh.GetPointer());
  itk::LatticeHexMesh::CellAutoPointer cell;
  ASSERT_TRUE(mesh->GetCell(5, cell));
  cell->SetPointId(0, 63);
  EXPECT_THROW((void)itk::HexMeshFromItk(mesh.GetPointer()), itk::ExceptionObject);
}

TEST(HexMeshConversion, AnotherNumberOfPointsIsRefused)
{
  const auto mesh = itk::LatticeHexMesh::New();
  itk::CopyHexMeshToItk(twistedLattice(4), mesh.GetPointer());
  itk::LatticeHexMesh::PointType point;
  point.Fill(0.0);
  mesh->SetPoint(64, point);
  EXPECT_THROW((void)itk::HexMeshFromItk(mesh.GetPointer()), itk::ExceptionObject);
}
