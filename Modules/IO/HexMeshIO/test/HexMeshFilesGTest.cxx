// Exact: coordinates to the last bit, connectivity, bytes.
#include "moserhex/HexMeshIO/HexMeshReader.h"
#include "moserhex/HexMeshIO/HexMeshWriter.h"

#include "FullDisk.h"
#include "TestFolder.h"
#include "TestLattice.h"
#include "moserhex/Analytic/Refusals.h"

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

/** 1/3, 2/3, 3/3 ... */
NamedArray
numberedArray(const std::string & name, int components, std::size_t places)
{
  NamedArray array{ name, components, {} };
  for (std::size_t value = 1; value <= places * static_cast<std::size_t>(components); ++value)
  {
    array.values.push_back(static_cast<double>(value) / 3.0);
  }
  return array;
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

TEST(HexMeshWriter, NamedArraysOfEveryShapeAreReadByVtk)
{
  const TestFolder folder;
  const HexMesh    mesh = bentLattice(4);
  HexMeshFields    fields;
  for (const int components : { 1, 3, 6, 9 })
  {
    fields.pointArrays.push_back(numberedArray("Node" + std::to_string(components), components, mesh.nodes.size()));
    fields.cellArrays.push_back(numberedArray("Cell" + std::to_string(components), components, mesh.cellCount()));
  }
  fields.pointArrays.front().values[5] = std::nan("");
  fields.meshArrays = { { "Mesh1", 1, { 2.5 } } };
  writeHexMesh(folder / "mesh.vtu", mesh, fields);
  writeHexMesh(folder / "mesh.vtk", mesh, fields);
  for (const auto & grid : { readByVtk<vtkXMLUnstructuredGridReader>(folder / "mesh.vtu"),
                             readByVtk<vtkUnstructuredGridReader>(folder / "mesh.vtk") })
  {
    EXPECT_TRUE(std::isnan(grid->GetPointData()->GetArray("Node1")->GetTuple1(5)));
    ASSERT_NE(grid->GetFieldData()->GetArray("Mesh1"), nullptr);
    EXPECT_EQ(grid->GetFieldData()->GetArray("Mesh1")->GetTuple1(0), 2.5);
    for (const int components : { 1, 3, 6, 9 })
    {
      auto * ofNodes = grid->GetPointData()->GetArray(("Node" + std::to_string(components)).c_str());
      auto * ofCells = grid->GetCellData()->GetArray(("Cell" + std::to_string(components)).c_str());
      ASSERT_TRUE(ofNodes && ofCells) << components;
      EXPECT_EQ(ofNodes->GetNumberOfComponents(), components);
      EXPECT_EQ(ofNodes->GetNumberOfTuples(), 64);
      EXPECT_EQ(ofCells->GetNumberOfTuples(), 27);
      EXPECT_EQ(ofNodes->GetComponent(63, components - 1), 64.0 * components / 3.0);
      EXPECT_EQ(ofCells->GetComponent(2, 0), (2.0 * components + 1.0) / 3.0);
    }
  }
}

TEST(HexMeshWriter, NamedArraysThatCannotBeWrittenAreRefused)
{
  const TestFolder folder;
  const HexMesh    mesh = bentLattice(4);
  const auto       refusal = [&](const NamedArray & array, const char * file = "mesh.vtu") {
    HexMeshFields fields;
    fields.cellArrays.push_back(array);
    return analytic::messageOf([&] { writeHexMesh(folder / file, mesh, fields); });
  };
  const std::vector<double> values(27, 1.0);
  EXPECT_EQ(refusal({ "Mine", 1, values }), "accepted");
  EXPECT_NE(refusal({ "", 1, values }).find("no name"), std::string::npos);
  EXPECT_NE(refusal({ "Shell", 1, values }).find("an array Shell already"), std::string::npos);
  EXPECT_NE(refusal({ "Mine", 2, std::vector<double>(54, 1.0) }).find("2 components"), std::string::npos);
  EXPECT_NE(refusal({ "Mine", 3, values }).find("27 values of Mine, need 81"), std::string::npos);
  EXPECT_NE(refusal({ "Mine", 1, values }, "mesh.msh").find(".vtu and .vtk only"), std::string::npos);
  EXPECT_EQ(folder.fileCount(), 1u);
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
