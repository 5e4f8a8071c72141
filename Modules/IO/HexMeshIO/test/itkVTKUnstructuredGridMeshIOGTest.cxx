// Exact: what ITK writes through this class VTK reads, to the last bit, and ITK itself.
#include "TestFolder.h"
#include "moserhex/HexMeshIO/itkVTKUnstructuredGridMeshIO.h"

#include <itkDefaultStaticMeshTraits.h>
#include <itkHexahedronCell.h>
#include <itkMesh.h>
#include <itkMeshFileReader.h>
#include <itkMeshFileWriter.h>
#include <itkTetrahedronCell.h>

#include <gtest/gtest.h>

#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridReader.h>

#include <filesystem>

using namespace moserhex;

namespace
{

using MeshType = itk::Mesh<double, 3, itk::DefaultStaticMeshTraits<double, 3, 3, double, double, double>>;

/** Two hexahedra side by side, with a number at each point and in each cell. */
MeshType::Pointer
twoCells()
{
  const auto mesh = MeshType::New();
  for (unsigned int p = 0; p < 12; ++p)
  {
    const unsigned int i = p % 3;
    const unsigned int j = p / 3 % 2;
    const unsigned int k = p / 6;
    const double       point[] = { i / 3.0, j - 100.0 / 7.0, 1e-5 * k };
    mesh->SetPoint(p, MeshType::PointType(point));
    mesh->SetPointData(p, 0.1 * p);
  }
  for (unsigned int c = 0; c < 2; ++c)
  {
    MeshType::CellAutoPointer cell;
    cell.TakeOwnership(new itk::HexahedronCell<MeshType::CellType>);
    const unsigned int corners[] = { 0, 1, 4, 3, 6, 7, 10, 9 };
    for (unsigned int a = 0; a < 8; ++a)
    {
      cell->SetPointId(static_cast<int>(a), corners[a] + c);
    }
    mesh->SetCell(c, cell);
    mesh->SetCellData(c, 1.0 / (3.0 + c));
  }
  return mesh;
}

void
write(const MeshType & mesh, const std::string & fileName, bool isBinary)
{
  itk::VTKUnstructuredGridMeshIOFactory::RegisterOneFactory();
  const auto writer = itk::MeshFileWriter<MeshType>::New();
  writer->SetInput(&mesh);
  writer->SetFileName(fileName);
  if (isBinary)
  {
    writer->SetFileTypeAsBINARY();
  }
  writer->Update();
}

} // namespace

class VTKUnstructuredGridMeshIO : public testing::TestWithParam<bool>
{};

TEST_P(VTKUnstructuredGridMeshIO, VtkReadsWhatItkWrote)
{
  const TestFolder folder;
  const auto       mesh = twoCells();
  write(*mesh, folder / "m.vtk", GetParam());
  vtkNew<vtkUnstructuredGridReader> reader;
  reader->SetFileName((folder / "m.vtk").c_str());
  reader->Update();
  vtkUnstructuredGrid & grid = *reader->GetOutput();
  ASSERT_EQ(grid.GetNumberOfPoints(), 12);
  ASSERT_EQ(grid.GetNumberOfCells(), 2);
  EXPECT_NE(std::string(reader->GetHeader()).find("SPACE=LPS"), std::string::npos);
  for (vtkIdType p = 0; p < 12; ++p)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_EQ(grid.GetPoint(p)[axis], mesh->GetPoint(static_cast<unsigned int>(p))[static_cast<unsigned int>(axis)]);
    }
    EXPECT_EQ(grid.GetPointData()->GetArray("PointData")->GetTuple1(p), 0.1 * static_cast<double>(p));
  }
  EXPECT_EQ(grid.GetCellType(1), 12);
  EXPECT_EQ(grid.GetCell(1)->GetPointId(2), 5);
  EXPECT_EQ(grid.GetCellData()->GetArray("CellData")->GetTuple1(1), 0.25);
}

TEST_P(VTKUnstructuredGridMeshIO, ItkReadsWhatItWrote)
{
  const TestFolder folder;
  const auto       mesh = twoCells();
  write(*mesh, folder / "m.vtk", GetParam());
  const auto reader = itk::MeshFileReader<MeshType>::New();
  reader->SetFileName(folder / "m.vtk");
  reader->Update();
  const MeshType & read = *reader->GetOutput();
  ASSERT_EQ(read.GetNumberOfPoints(), 12u);
  ASSERT_EQ(read.GetNumberOfCells(), 2u);
  EXPECT_EQ(read.GetPoint(7), mesh->GetPoint(7));
  MeshType::CellAutoPointer cell;
  ASSERT_TRUE(read.GetCell(1, cell));
  EXPECT_EQ(cell->GetType(), itk::CellGeometryEnum::HEXAHEDRON_CELL);
  EXPECT_EQ(cell->GetPointIds()[6], 11u);
}

INSTANTIATE_TEST_SUITE_P(Forms, VTKUnstructuredGridMeshIO, testing::Bool());

TEST(VTKUnstructuredGridMeshIO, OtherVolumeCellsAreWrittenAndNotRead)
{
  const TestFolder          folder;
  const auto                mesh = twoCells();
  MeshType::CellAutoPointer cell;
  cell.TakeOwnership(new itk::TetrahedronCell<MeshType::CellType>);
  for (int a = 0; a < 4; ++a)
  {
    cell->SetPointId(a, static_cast<unsigned int>(a));
  }
  mesh->SetCell(2, cell);
  mesh->SetCellData(2, 0.0);
  write(*mesh, folder / "m.vtk", false);
  vtkNew<vtkUnstructuredGridReader> reader;
  reader->SetFileName((folder / "m.vtk").c_str());
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetCellType(2), 10);
  const auto again = itk::MeshFileReader<MeshType>::New();
  again->SetFileName(folder / "m.vtk");
  EXPECT_THROW(again->Update(), itk::ExceptionObject);
}

TEST(VTKUnstructuredGridMeshIO, FailureIsAnExceptionAndLeavesNoFile)
{
  const TestFolder folder;
  EXPECT_THROW(write(*twoCells(), folder / "none/m.vtk", false), itk::ExceptionObject);
  EXPECT_FALSE(std::filesystem::exists(folder / "none"));
}

TEST(VTKUnstructuredGridMeshIO, FilesOfOtherKindsAreLeftToOthers)
{
  const auto io = itk::VTKUnstructuredGridMeshIO::New();
  EXPECT_TRUE(io->CanWriteFile("a.VTK"));
  EXPECT_FALSE(io->CanWriteFile("a.vtu"));
  EXPECT_FALSE(io->CanReadFile("none.vtk"));
}
