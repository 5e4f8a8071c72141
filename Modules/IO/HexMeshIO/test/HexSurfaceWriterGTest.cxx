// Exact: nodes to the last bit, faces, bytes. The enclosed volume to round-off.
#include "TestFolder.h"
#include "moserhex/Geometry/TriangleTopology.h"
#include "moserhex/HexMeshIO/HexSurfaceWriter.h"
#include "moserhex/HexMeshIO/SurfaceReader.h"

#include <gtest/gtest.h>

#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataReader.h>

#include <fstream>
#include <iterator>

using namespace moserhex;

namespace
{

/** n^3 nodes of a box of cells of 1/3 x 1 x 2 mm. */
HexMesh
boxLattice(int n)
{
  HexMesh mesh;
  mesh.nodesPerSide = n;
  for (int k = 0; k < n; ++k)
  {
    for (int j = 0; j < n; ++j)
    {
      for (int i = 0; i < n; ++i)
      {
        mesh.nodes.emplace_back(i / 3.0 - 10.0, j, 2.0 * k);
      }
    }
  }
  return mesh;
}

std::string
bytesOf(const std::string & fileName)
{
  std::ifstream file(fileName, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
}

} // namespace

TEST(HexSurfaceWriter, VtkReadsNodesFacesAndLatticeIndices)
{
  const TestFolder folder;
  const HexMesh    mesh = boxLattice(4);
  writeHexSurface(folder / "s.vtk", mesh);
  vtkNew<vtkPolyDataReader> reader;
  reader->SetFileName((folder / "s.vtk").c_str());
  reader->Update();
  vtkPolyData & surface = *reader->GetOutput();
  ASSERT_EQ(surface.GetNumberOfPoints(), 56); // 4^3 - 2^3
  ASSERT_EQ(surface.GetNumberOfCells(), 54);
  EXPECT_NE(std::string(reader->GetHeader()).find("SPACE=LPS"), std::string::npos);
  vtkDataArray * index = surface.GetPointData()->GetArray("LatticeIndex");
  vtkDataArray * face = surface.GetCellData()->GetArray("CubeFace");
  ASSERT_TRUE(index != nullptr && face != nullptr);
  for (vtkIdType p = 0; p < surface.GetNumberOfPoints(); ++p)
  {
    const double *    at = index->GetTuple3(p);
    const std::size_t node = static_cast<std::size_t>(at[0] + 4 * (at[1] + 4 * at[2]));
    EXPECT_EQ(Vector3(surface.GetPoint(p)), mesh.nodes[node]) << "node " << node;
  }
  for (vtkIdType c = 0; c < surface.GetNumberOfCells(); ++c)
  {
    const int side = static_cast<int>(face->GetTuple1(c));
    for (vtkIdType p = 0; p < 4; ++p)
    {
      EXPECT_EQ(index->GetComponent(surface.GetCell(c)->GetPointId(static_cast<int>(p)), side / 2),
                side % 2 == 0 ? 0 : 3);
    }
  }
}

TEST(HexSurfaceWriter, SurfaceIsClosedAndOrientedOutwards)
{
  const TestFolder folder;
  writeHexSurface(folder / "s.vtk", boxLattice(4));
  const SurfaceFile surface = readSurface(folder / "s.vtk");
  EXPECT_NEAR(enclosedVolume(surface.mesh), 1.0 * 3.0 * 6.0, 1e-12);
}

TEST(HexSurfaceWriter, SameMeshSameBytes)
{
  const TestFolder folder;
  writeHexSurface(folder / "a.vtk", boxLattice(3));
  writeHexSurface(folder / "b.vtk", boxLattice(3));
  EXPECT_EQ(bytesOf(folder / "a.vtk"), bytesOf(folder / "b.vtk"));
}

TEST(HexSurfaceWriter, OtherNamesAndBrokenMeshesAreRefused)
{
  const TestFolder folder;
  EXPECT_EQ(codeThrownBy([&] { writeHexSurface(folder / "s.stl", boxLattice(3)); }), ErrorCode::Usage);
  HexMesh mesh = boxLattice(3);
  mesh.nodes.pop_back();
  EXPECT_THROW(writeHexSurface(folder / "s.vtk", mesh), InvalidInput);
  EXPECT_EQ(codeThrownBy([&] { writeHexSurface(folder / "none/s.vtk", boxLattice(3)); }), ErrorCode::CannotCreate);
}
