#include "moserhex/HexMeshIO/HexMeshWriter.h"

#include "FileNames.h"
#include "VtkMessages.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/HexMeshIO/AtomicFile.h"
#include "moserhex/HexMeshIO/HexMeshReader.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <algorithm>
#include <cstring>

namespace moserhex
{
namespace
{

void
requireSize(const char * what, std::size_t actual, std::size_t expected)
{
  if (actual != expected)
  {
    throw InvalidInput(std::string("writeHexMesh: ") + std::to_string(actual) + " " + what + ", need " +
                       std::to_string(expected));
  }
}

/** Volume of each cell over their mean. */
std::vector<double>
checkedVolumeRatios(const HexMesh & mesh, const HexMeshFields & fields)
{
  if (mesh.nodesPerSide < 2)
  {
    throw InvalidInput("writeHexMesh: nodesPerSide = " + std::to_string(mesh.nodesPerSide) + ", need >= 2");
  }
  const auto n = static_cast<std::size_t>(mesh.nodesPerSide);
  requireSize("nodes", mesh.nodes.size(), n * n * n);
  if (!fields.scaledJacobian.empty())
  {
    requireSize("scaled Jacobians", fields.scaledJacobian.size(), mesh.cellCount());
  }
  if (!fields.label.empty())
  {
    requireSize("labels", fields.label.size(), mesh.cellCount());
  }
  if (!fields.cubeCoordinates.empty())
  {
    requireSize("cube coordinates", fields.cubeCoordinates.size(), mesh.nodes.size());
  }
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
  {
    if (!mesh.nodes[node].allFinite())
    {
      throw InvalidInput("writeHexMesh: node " + std::to_string(node) + " is not finite");
    }
  }
  std::vector<double> ratios = cellVolumes(mesh);
  double              sum = 0.0;
  for (const double volume : ratios)
  {
    sum += volume;
  }
  const double mean = sum / static_cast<double>(ratios.size());
  if (!(mean > 0.0))
  {
    throw InvalidInput("writeHexMesh: mean cell volume " + std::to_string(mean) + " mm^3, need > 0");
  }
  for (double & ratio : ratios)
  {
    ratio /= mean;
  }
  return ratios;
}

/** Shell of every cell: N - (layers of cells between it and the surface). */
vtkSmartPointer<vtkIntArray>
shellOfCells(int nodesPerSide)
{
  const int  m = nodesPerSide - 1;
  const int  shells = nodesPerSide / 2;
  const auto layers = [m](int index) { return std::min(index, m - 1 - index); };
  auto       array = vtkSmartPointer<vtkIntArray>::New();
  array->SetName("Shell");
  for (int k = 0; k < m; ++k)
  {
    for (int j = 0; j < m; ++j)
    {
      for (int i = 0; i < m; ++i)
      {
        array->InsertNextValue(shells - std::min({ layers(i), layers(j), layers(k) }));
      }
    }
  }
  return array;
}

vtkSmartPointer<vtkIntArray>
latticeIndices(int nodesPerSide)
{
  auto array = vtkSmartPointer<vtkIntArray>::New();
  array->SetName("LatticeIndex");
  array->SetNumberOfComponents(3);
  for (int k = 0; k < nodesPerSide; ++k)
  {
    for (int j = 0; j < nodesPerSide; ++j)
    {
      for (int i = 0; i < nodesPerSide; ++i)
      {
        array->InsertNextTuple3(i, j, k);
      }
    }
  }
  return array;
}

vtkSmartPointer<vtkIntArray>
labelArray(const std::vector<std::int32_t> & labels)
{
  auto array = vtkSmartPointer<vtkIntArray>::New();
  array->SetName("Label");
  for (const std::int32_t label : labels)
  {
    array->InsertNextValue(label);
  }
  return array;
}

vtkSmartPointer<vtkDoubleArray>
scalarArray(const char * name, const std::vector<double> & values)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  for (const double value : values)
  {
    array->InsertNextValue(value);
  }
  return array;
}

vtkSmartPointer<vtkDoubleArray>
vectorArray(const char * name, const Positions & values)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(3);
  for (const Vector3 & value : values)
  {
    array->InsertNextTuple(value.data());
  }
  return array;
}

/** A fresh grid for each file: what an earlier writer cached in the arrays would change the bytes. */
vtkSmartPointer<vtkUnstructuredGrid>
makeGrid(const HexMesh & mesh, const HexMeshFields & fields, const std::vector<double> & volumeRatios)
{
  auto              grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetData(vectorArray("Points", mesh.nodes));
  grid->SetPoints(points);
  grid->Allocate(static_cast<vtkIdType>(mesh.cellCount()));
  for (std::size_t cell = 0; cell < mesh.cellCount(); ++cell)
  {
    std::array<vtkIdType, 8> ids{};
    const auto               nodes = mesh.cellNodes(cell);
    std::transform(nodes.begin(), nodes.end(), ids.begin(), [](std::size_t id) { return static_cast<vtkIdType>(id); });
    grid->InsertNextCell(VTK_HEXAHEDRON, 8, ids.data());
  }
  grid->GetPointData()->AddArray(latticeIndices(mesh.nodesPerSide));
  if (!fields.cubeCoordinates.empty())
  {
    grid->GetPointData()->AddArray(vectorArray("CubeCoordinate", fields.cubeCoordinates));
  }
  grid->GetCellData()->AddArray(shellOfCells(mesh.nodesPerSide));
  grid->GetCellData()->AddArray(scalarArray("VolumeRatio", volumeRatios));
  if (!fields.scaledJacobian.empty())
  {
    grid->GetCellData()->AddArray(scalarArray("ScaledJacobian", fields.scaledJacobian));
  }
  if (!fields.label.empty())
  {
    grid->GetCellData()->AddArray(labelArray(fields.label));
  }
  return grid;
}

/** Cached ranges make the legacy writer add METADATA blocks, which Gmsh refuses. */
void
clearArrayInformation(vtkUnstructuredGrid & grid)
{
  grid.GetPoints()->GetData()->GetInformation()->Clear();
  for (vtkFieldData * data :
       { static_cast<vtkFieldData *>(grid.GetPointData()), static_cast<vtkFieldData *>(grid.GetCellData()) })
  {
    for (int array = 0; array < data->GetNumberOfArrays(); ++array)
    {
      data->GetAbstractArray(array)->GetInformation()->Clear();
    }
  }
}

template <typename TWriter>
void
runWriter(TWriter & writer, const std::string & finalName)
{
  const VtkMessages messages;
  const int         succeeded = writer.Write();
  const auto        code = writer.GetErrorCode();
  if (succeeded == 0 || code != 0 || !messages.firstError().empty())
  {
    // Codes below VTK's own are those of errno, and say more than VTK's messages.
    const bool        isErrno = code != 0 && code < vtkErrorCode::FirstVTKErrorCode;
    const std::string words =
      messages.firstError().empty() ? "VTK error " + std::to_string(code) : messages.firstError();
    const std::string detail = isErrno ? std::strerror(static_cast<int>(code)) : words;
    throw IOError(ErrorCode::InputOutput,
                  finalName,
                  "cannot write the mesh (" + detail + ")",
                  "free some space or choose another folder");
  }
}

void
writeXml(const AtomicFile & file, vtkUnstructuredGrid & grid, const HexMeshWriterOptions & options)
{
  if (options.spaceTag)
  {
    vtkNew<vtkStringArray> space;
    space->SetName("SPACE");
    space->InsertNextValue("LPS");
    grid.GetFieldData()->AddArray(space);
  }
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetFileName(file.partName().c_str());
  writer->SetInputData(&grid);
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToZLib();
  writer->SetCompressionLevel(1); // coordinates hardly get smaller with more work
  runWriter(*writer, file.finalName());
}

void
writeLegacy(const AtomicFile & file, vtkUnstructuredGrid & grid)
{
  vtkNew<vtkUnstructuredGridWriter> writer;
  writer->SetFileName(file.partName().c_str());
  writer->SetInputData(&grid);
  writer->SetFileVersion(42);
  writer->SetFileTypeToBinary();
  writer->SetHeader("MoserHex hexahedral mesh; SPACE=LPS");
  clearArrayInformation(grid);
  runWriter(*writer, file.finalName());
}

void
requireSame(const AtomicFile & file, const HexMesh & mesh)
{
  const auto sameBits = [](const Vector3 & a, const Vector3 & b) {
    return std::memcmp(a.data(), b.data(), 3 * sizeof(double)) == 0;
  };
  try
  {
    ReadOptions options;
    options.sandbox = false; // a file of our own, in a program that may be busy with threads
    const HexMesh read = readHexMesh(file.partName(), options);
    if (read.nodesPerSide == mesh.nodesPerSide &&
        std::equal(mesh.nodes.begin(), mesh.nodes.end(), read.nodes.begin(), read.nodes.end(), sameBits))
    {
      return;
    }
  }
  catch (const BadInput &)
  {
    // Reported below, under the file's own name.
  }
  throw IOError(ErrorCode::InputOutput,
                file.finalName(),
                "the mesh reads back differently",
                "free some space or choose another folder");
}

} // namespace

bool
isHexMeshName(const std::string & fileName)
{
  return endsWithAny(fileName, { ".vtu", ".vtk" });
}

void
writeHexMesh(const std::string &          fileName,
             const HexMesh &              mesh,
             const HexMeshFields &        fields,
             const HexMeshWriterOptions & options)
{
  if (!isHexMeshName(fileName))
  {
    throw BadInput(
      ErrorCode::Usage, fileName, "meshes are written as VTK files", "give a name that ends with .vtu or .vtk");
  }
  const auto grid = makeGrid(mesh, fields, checkedVolumeRatios(mesh, fields));
  AtomicFile file(fileName);
  if (endsWith(fileName, ".vtu"))
  {
    writeXml(file, *grid, options);
  }
  else
  {
    writeLegacy(file, *grid);
  }
  requireSame(file, mesh);
  file.commit();
}

} // namespace moserhex
