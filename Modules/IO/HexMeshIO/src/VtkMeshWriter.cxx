#include "FileNames.h"
#include "HexMeshFormats.h"
#include "HexMeshSets.h"
#include "VtkMessages.h"
#include "moserhex/Geometry/HexMeshNumbering.h"
#include "moserhex/HexMeshIO/FileErrors.h"

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

vtkSmartPointer<vtkIntArray>
latticeIndices(const HexMesh & mesh)
{
  auto array = vtkSmartPointer<vtkIntArray>::New();
  array->SetName("LatticeIndex");
  array->SetNumberOfComponents(3);
  for (const NodeIndex & index : nodeIndices(mesh))
  {
    array->InsertNextTypedTuple(index.lattice.data());
  }
  return array;
}

vtkSmartPointer<vtkIntArray>
integerArray(const char * name, const std::vector<int> & values)
{
  auto array = vtkSmartPointer<vtkIntArray>::New();
  array->SetName(name);
  for (const int value : values)
  {
    array->InsertNextValue(value);
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

/** \throws InvalidInput  the name is taken */
void
addArray(vtkFieldData & data, const NamedArray & named)
{
  if (data.HasArray(named.name.c_str()) == 1)
  {
    throw InvalidInput("writeHexMesh: there is an array " + named.name + " already");
  }
  vtkNew<vtkDoubleArray> array;
  array->SetName(named.name.c_str());
  array->SetNumberOfComponents(named.components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(named.values.size()) / named.components);
  // No negative zeros: whether VTK calls the least value 0 or -0 in the file depends on how its threads share the work.
  std::transform(
    named.values.begin(), named.values.end(), array->GetPointer(0), [](double value) { return value + 0.0; });
  data.AddArray(array);
}

/** A fresh grid for each file: what an earlier writer cached in the arrays would change the bytes. */
vtkSmartPointer<vtkUnstructuredGrid>
makeGrid(const HexMeshContent & content)
{
  const HexMesh &       mesh = content.mesh;
  const HexMeshFields & fields = content.fields;
  auto                  grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints>     points;
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
  grid->GetPointData()->AddArray(latticeIndices(mesh));
  if (mesh.paddingLayers > 0)
  {
    grid->GetPointData()->AddArray(integerArray("PaddingLayer", paddingLayerOfNodes(mesh)));
  }
  grid->GetPointData()->AddArray(vectorArray("CubeCoordinate", cubeCoordinates(mesh)));
  grid->GetCellData()->AddArray(integerArray("Shell", content.shell));
  grid->GetCellData()->AddArray(scalarArray("VolumeRatio", content.volumeRatio));
  if (!fields.scaledJacobian.empty())
  {
    grid->GetCellData()->AddArray(scalarArray("ScaledJacobian", fields.scaledJacobian));
  }
  if (!fields.label.empty())
  {
    grid->GetCellData()->AddArray(integerArray("Label", fields.label));
  }
  for (const NamedArray & array : fields.pointArrays)
  {
    addArray(*grid->GetPointData(), array);
  }
  for (const NamedArray & array : fields.cellArrays)
  {
    addArray(*grid->GetCellData(), array);
  }
  for (const NamedArray & array : fields.meshArrays)
  {
    addArray(*grid->GetFieldData(), array);
  }
  return grid;
}

/** Cached ranges make the legacy writer add METADATA blocks, which Gmsh refuses. */
void
clearArrayInformation(vtkUnstructuredGrid & grid)
{
  grid.GetPoints()->GetData()->GetInformation()->Clear();
  for (vtkFieldData * data : { static_cast<vtkFieldData *>(grid.GetPointData()),
                               static_cast<vtkFieldData *>(grid.GetCellData()),
                               grid.GetFieldData() })
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

} // namespace

void
writeVtkMesh(const AtomicFile & file, const HexMeshContent & content, const HexMeshWriterOptions & options)
{
  const auto grid = makeGrid(content);
  if (endsWith(file.finalName(), ".vtu"))
  {
    writeXml(file, *grid, options);
  }
  else
  {
    writeLegacy(file, *grid);
  }
}

} // namespace moserhex
