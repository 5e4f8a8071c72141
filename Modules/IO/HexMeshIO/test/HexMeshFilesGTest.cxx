// Exact: coordinates to the last bit, connectivity, bytes.
#include "moserhex/HexMeshIO/HexMeshReader.h"
#include "moserhex/HexMeshIO/HexMeshWriter.h"

#include "FullDisk.h"
#include "TestFolder.h"
#include "TestLattice.h"

#include <gtest/gtest.h>

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <cmath>
#include <limits>

using namespace moserhex;

namespace
{

template <typename TReader>
vtkSmartPointer<vtkUnstructuredGrid>
readByVtk(const std::string & fileName)
{
  vtkNew<TReader> reader;
  reader->SetFileName(fileName.c_str());
  reader->Update();
  return reader->GetOutput();
}

void
expectFields(vtkUnstructuredGrid & grid, int n)
{
  auto * lattice = grid.GetPointData()->GetArray("LatticeIndex");
  ASSERT_TRUE(lattice);
  ASSERT_EQ(lattice->GetNumberOfComponents(), 3);
  const vtkIdType node = 1 + n * (2 + n * 3);
  EXPECT_EQ(lattice->GetComponent(node, 0), 1);
  EXPECT_EQ(lattice->GetComponent(node, 1), 2);
  EXPECT_EQ(lattice->GetComponent(node, 2), 3);

  auto * shell = grid.GetCellData()->GetArray("Shell");
  ASSERT_TRUE(shell);
  double range[2];
  shell->GetRange(range);
  EXPECT_EQ(range[0], 1);
  EXPECT_EQ(range[1], n / 2);
  EXPECT_EQ(shell->GetTuple1(0), n / 2);
  const vtkIdType middle = (n - 1) / 2;
  EXPECT_EQ(shell->GetTuple1(middle + (n - 1) * (middle + (n - 1) * middle)), 1);

  auto * ratio = grid.GetCellData()->GetArray("VolumeRatio");
  ASSERT_TRUE(ratio);
  double sum = 0.0;
  for (vtkIdType cell = 0; cell < grid.GetNumberOfCells(); ++cell)
  {
    sum += ratio->GetTuple1(cell);
  }
  EXPECT_NEAR(sum / static_cast<double>(grid.GetNumberOfCells()), 1.0, 1e-12);
  EXPECT_TRUE(grid.GetCellData()->GetArray("ScaledJacobian"));
  EXPECT_TRUE(grid.GetPointData()->GetArray("CubeCoordinate"));
  ASSERT_TRUE(grid.GetCellData()->GetArray("Label"));
  EXPECT_EQ(grid.GetCellData()->GetArray("Label")->GetTuple1(3), 3.0);
}

} // namespace

class HexMeshFiles : public testing::TestWithParam<const char *>
{};
INSTANTIATE_TEST_SUITE_P(Formats, HexMeshFiles, testing::Values("mesh.vtu", "mesh.vtk"), [](const auto & instance) {
  return std::string(instance.param).substr(5);
});

TEST_P(HexMeshFiles, RoundTripKeepsEveryBit)
{
  const TestFolder folder;
  const HexMesh    mesh = bentLattice(6);
  writeHexMesh(folder / GetParam(), mesh, someFields(mesh));
  const HexMesh read = readHexMesh(folder / GetParam());
  EXPECT_EQ(read.nodesPerSide, 6);
  EXPECT_EQ(read.nodes, mesh.nodes);
  EXPECT_EQ(folder.fileCount(), 1u);
}

TEST_P(HexMeshFiles, SameMeshGivesTheSameBytes)
{
  const TestFolder folder;
  const HexMesh    mesh = bentLattice(6);
  writeHexMesh(folder / GetParam(), mesh, someFields(mesh));
  const std::string first = readBytes(folder / GetParam());
  writeHexMesh(folder / "other.vtu", mesh);
  writeHexMesh(folder / "other.vtk", mesh);
  writeHexMesh(folder / GetParam(), mesh, someFields(mesh));
  EXPECT_EQ(readBytes(folder / GetParam()), first);
}

TEST_P(HexMeshFiles, TruncatedFileIsRefused)
{
  const TestFolder folder;
  const HexMesh    mesh = bentLattice(6);
  writeHexMesh(folder / GetParam(), mesh);
  const std::string bytes = readBytes(folder / GetParam());
  writeBytes(folder / GetParam(), bytes.substr(0, bytes.size() / 3));
  EXPECT_THROW((void)readHexMesh(folder / GetParam()), BadInput);
}

TEST_P(HexMeshFiles, FullDiskIsReportedAndLeavesNothing)
{
  const TestFolder folder;
  EXPECT_TRUE(reportsFullDisk([&] { writeHexMesh(folder / GetParam(), bentLattice(12)); }));
  EXPECT_EQ(folder.fileCount(), 0u);
}

TEST_P(HexMeshFiles, MissingFolderIsReported)
{
  const TestFolder folder;
  EXPECT_THROW(writeHexMesh(folder / "no/" + GetParam(), bentLattice(4)), IOError);
}

TEST_P(HexMeshFiles, MissingFileIsRefused)
{
  const TestFolder folder;
  EXPECT_THROW((void)readHexMesh(folder / GetParam()), BadInput);
}

TEST(HexMeshWriter, VtuCarriesItsFieldsAndSpace)
{
  const TestFolder folder;
  const HexMesh    mesh = bentLattice(6);
  writeHexMesh(folder / "mesh.vtu", mesh, someFields(mesh));
  const auto grid = readByVtk<vtkXMLUnstructuredGridReader>(folder / "mesh.vtu");
  expectFields(*grid, 6);
  auto * space = vtkStringArray::SafeDownCast(grid->GetFieldData()->GetAbstractArray("SPACE"));
  ASSERT_TRUE(space);
  EXPECT_EQ(space->GetValue(0), "LPS");
}

TEST(HexMeshWriter, VtuWithoutSpaceTagHasNoFieldData)
{
  const TestFolder folder;
  writeHexMesh(folder / "mesh.vtu", bentLattice(4), {}, { false });
  const auto grid = readByVtk<vtkXMLUnstructuredGridReader>(folder / "mesh.vtu");
  EXPECT_EQ(grid->GetFieldData()->GetNumberOfArrays(), 0);
}

TEST(HexMeshWriter, LegacyFileCarriesItsFields)
{
  const TestFolder folder;
  const HexMesh    mesh = bentLattice(6);
  writeHexMesh(folder / "mesh.vtk", mesh, someFields(mesh));
  expectFields(*readByVtk<vtkUnstructuredGridReader>(folder / "mesh.vtk"), 6);
}

TEST(HexMeshWriter, LegacyFileIsVersion42WithSpaceAndWithoutMetadataOrStrings)
{
  const TestFolder folder;
  const HexMesh    mesh = bentLattice(6);
  writeHexMesh(folder / "mesh.vtk", mesh, someFields(mesh));
  std::ifstream file(folder / "mesh.vtk", std::ios::binary);
  std::string   version;
  std::string   header;
  std::getline(file, version);
  std::getline(file, header);
  EXPECT_EQ(version, "# vtk DataFile Version 4.2");
  EXPECT_NE(header.find("SPACE=LPS"), std::string::npos);
  const std::string bytes = readBytes(folder / "mesh.vtk");
  EXPECT_EQ(bytes.find("METADATA"), std::string::npos);
  EXPECT_EQ(bytes.find(" string\n"), std::string::npos);
  EXPECT_NE(bytes.find("\nBINARY\n"), std::string::npos);
}

TEST(HexMeshWriter, OtherExtensionIsRefused)
{
  const TestFolder folder;
  EXPECT_THROW(writeHexMesh(folder / "mesh.stl", bentLattice(4)), BadInput);
}

TEST(HexMeshWriter, NodeThatIsNotFiniteIsRefused)
{
  const TestFolder folder;
  HexMesh          mesh = bentLattice(4);
  mesh.nodes[5].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(writeHexMesh(folder / "mesh.vtu", mesh), InvalidInput);
  EXPECT_EQ(folder.fileCount(), 0u);
}

TEST(HexMeshWriter, WrongSizesAreRefused)
{
  const TestFolder folder;
  HexMesh          mesh = bentLattice(4);
  HexMeshFields    fields;
  fields.scaledJacobian.assign(3, 1.0);
  EXPECT_THROW(writeHexMesh(folder / "mesh.vtu", mesh, fields), InvalidInput);
  fields = {};
  fields.label.assign(3, 1);
  EXPECT_THROW(writeHexMesh(folder / "mesh.vtu", mesh, fields), InvalidInput);
  mesh.nodes.pop_back();
  EXPECT_THROW(writeHexMesh(folder / "mesh.vtu", mesh), InvalidInput);
}

TEST(HexMeshReader, OtherLatticeOrderIsRefused)
{
  const TestFolder folder;
  writeHexMesh(folder / "mesh.vtk", bentLattice(4));
  std::string bytes = readBytes(folder / "mesh.vtk");
  // The first cell is "8, 0 1 5 4 ..." in big-endian 32-bit numbers behind the line "CELLS 27 243".
  const auto cells = bytes.find("CELLS 27 243\n");
  ASSERT_NE(cells, std::string::npos);
  bytes[cells + 13 + 4 + 3] = 7;
  writeBytes(folder / "mesh.vtk", bytes);
  EXPECT_THROW((void)readHexMesh(folder / "mesh.vtk"), BadInput);
}
