// Meshes with padding in every format. Exact: connectivity, sets; coordinates to the last bit (.inp: 1e-15 mm).
// CalculiX prints 7 digits.
#include "../src/HexMeshSets.h"
#include "TestFolder.h"
#include "TestLattice.h"
#include "moserhex/Geometry/HexMeshNumbering.h"
#include "moserhex/HexMeshIO/HexCellReader.h"
#include "moserhex/HexMeshIO/HexMeshReader.h"
#include "moserhex/HexMeshIO/HexMeshWriter.h"
#include "moserhex/HexMeshIO/HexSurfaceWriter.h"

#include <gtest/gtest.h>

#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataReader.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridReader.h>

#include <algorithm>
#include <set>

using namespace moserhex;

class PaddedMeshFiles : public testing::TestWithParam<const char *>
{};
INSTANTIATE_TEST_SUITE_P(Formats,
                         PaddedMeshFiles,
                         testing::Values("mesh.vtu", "mesh.vtk", "mesh.msh", "mesh.inp", "mesh.mesh"),
                         [](const auto & instance) { return std::string(instance.param).substr(5); });

TEST_P(PaddedMeshFiles, ComeBackAsTheyWere)
{
  for (const auto & [n, layers] : { std::pair(4, 1), std::pair(2, 3), std::pair(5, 2) })
  {
    const TestFolder folder;
    const HexMesh    mesh = bentPaddedLattice(n, layers);
    writeHexMesh(folder / GetParam(), mesh, someFields(mesh));
    const HexMesh read = readHexMesh(folder / GetParam());
    EXPECT_EQ(read.nodesPerSide, n);
    EXPECT_EQ(read.paddingLayers, layers);
    ASSERT_EQ(read.nodes.size(), mesh.nodes.size());
    for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
    {
      EXPECT_LE((read.nodes[node] - mesh.nodes[node]).cwiseAbs().maxCoeff(), 1e-15);
    }
  }
}

TEST(PaddedMeshSets, FacesAreTheBoundaryAndPointOutwards)
{
  for (const int layers : { 0, 1, 2 })
  {
    const HexMesh                    mesh = bentPaddedLattice(4, layers);
    const std::vector<std::size_t>   boundary = boundaryNodes(mesh);
    const std::vector<Quadrilateral> outside = boundaryFaces(unstructured(mesh)); // counter-clockwise from outside
    const auto                       turned = [](Quadrilateral quad) {
      std::rotate(quad.begin(), std::min_element(quad.begin(), quad.end()), quad.end());
      return quad;
    };
    std::set<Quadrilateral> expected;
    std::transform(outside.begin(), outside.end(), std::inserter(expected, expected.end()), turned);
    std::set<Quadrilateral> found;
    std::set<std::size_t>   nodes;
    for (const CubeFace & face : cubeFaces(mesh))
    {
      EXPECT_EQ(face.nodes.size(), 16u);
      EXPECT_EQ(face.sides.size(), 9u);
      nodes.insert(face.nodes.begin(), face.nodes.end());
      for (const CubeFaceSide & side : face.sides)
      {
        const auto corners = mesh.cellNodes(side.cell);
        EXPECT_TRUE(found.insert(turned(side.nodes)).second);
        for (const std::size_t node : side.nodes)
        {
          EXPECT_NE(std::find(corners.begin(), corners.end(), node), corners.end());
        }
      }
    }
    EXPECT_EQ(found, expected) << layers;
    EXPECT_TRUE(std::equal(nodes.begin(), nodes.end(), boundary.begin(), boundary.end())) << layers;
  }
}

TEST(PaddedMeshSets, LayersAreSetsBehindTheShells)
{
  const HexMesh          mesh = bentPaddedLattice(4, 2);
  const std::vector<int> shells = shellOfCells(mesh);
  EXPECT_EQ(std::count(shells.begin(), shells.end(), 1), 1);
  EXPECT_EQ(std::count(shells.begin(), shells.end(), 2), 26);
  EXPECT_EQ(std::count(shells.begin(), shells.end(), 3), 54);
  EXPECT_EQ(std::count(shells.begin(), shells.end(), 4), 54);
  EXPECT_EQ(shellName(mesh, 2), "SHELL_2");
  EXPECT_EQ(shellName(mesh, 3), "PADDING_1");
  EXPECT_EQ(shellName(mesh, 4), "PADDING_2");
  for (const char * name : { "mesh.inp", "mesh.msh", "mesh.feb", "mesh.exo" })
  {
    const TestFolder folder;
    writeHexMesh(folder / name, mesh);
    const std::string bytes = readBytes(folder / name);
    EXPECT_NE(bytes.find("PADDING_1"), std::string::npos) << name;
    EXPECT_NE(bytes.find("PADDING_2"), std::string::npos) << name;
    EXPECT_EQ(bytes.find("SHELL_3"), std::string::npos) << name;
  }
}

TEST(PaddedMeshFields, NodesSayTheirLatticeIndexAndLayer)
{
  const TestFolder folder;
  const HexMesh    mesh = bentPaddedLattice(3, 1);
  writeHexMesh(folder / "mesh.vtk", mesh);
  vtkNew<vtkUnstructuredGridReader> reader;
  reader->SetFileName((folder / "mesh.vtk").c_str());
  reader->Update();
  vtkDataArray * indices = reader->GetOutput()->GetPointData()->GetArray("LatticeIndex");
  vtkDataArray * layers = reader->GetOutput()->GetPointData()->GetArray("PaddingLayer");
  ASSERT_TRUE(indices && layers);
  for (vtkIdType node = 0; node < indices->GetNumberOfTuples(); ++node)
  {
    const double * at = indices->GetTuple3(node);
    EXPECT_EQ(mesh.paddingNodeNumber(static_cast<int>(layers->GetTuple1(node)),
                                     static_cast<int>(at[0]),
                                     static_cast<int>(at[1]),
                                     static_cast<int>(at[2])),
              static_cast<std::size_t>(node));
  }
  EXPECT_EQ(reader->GetOutput()->GetCellData()->GetArray("Shell")->GetTuple1(8), 2.0);
}

TEST(PaddedMeshFields, SurfaceIsTheOutermostLayer)
{
  const TestFolder folder;
  const HexMesh    mesh = bentPaddedLattice(4, 2);
  writeHexSurface(folder / "surface.vtk", mesh);
  vtkNew<vtkPolyDataReader> reader;
  reader->SetFileName((folder / "surface.vtk").c_str());
  reader->Update();
  const std::vector<std::size_t> boundary = boundaryNodes(mesh);
  ASSERT_EQ(reader->GetOutput()->GetNumberOfPoints(), static_cast<vtkIdType>(boundary.size()));
  EXPECT_EQ(reader->GetOutput()->GetNumberOfCells(), 54);
  for (std::size_t p = 0; p < boundary.size(); ++p)
  {
    const Vector3 place(reader->GetOutput()->GetPoint(static_cast<vtkIdType>(p)));
    EXPECT_EQ(place, mesh.nodes[boundary[p]]);
  }
}
