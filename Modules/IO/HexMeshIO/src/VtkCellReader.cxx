#include "FileNames.h"
#include "HexCellCollector.h"
#include "HexCellFormats.h"
#include "LegacyVtkCheck.h"
#include "VtkCompatibility.h"
#include "VtkMessages.h"
#include "VtkSpace.h"
#include "XmlVtkCheck.h"

#include <vtkCell.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkGenericCell.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <map>
#include <new>

namespace moserhex
{
namespace
{

constexpr const char * writeAgain = "write the mesh again";

struct FileGrid
{
  vtkSmartPointer<vtkUnstructuredGrid> grid;
  bool                                 isRas{ false };
};

template <typename TReader>
FileGrid
readGridWith(const std::string & fileName)
{
  const VtkMessages messages;
  vtkNew<TReader>   reader;
  reader->SetFileName(fileName.c_str());
  try
  {
    reader->Update();
  }
  catch (const std::bad_alloc &)
  {
    throw BadInput(ErrorCode::Truncated, fileName, "promises more than fits the memory", writeAgain);
  }
  if (reader->GetErrorCode() != 0 || !messages.firstError().empty() || !reader->GetOutput())
  {
    throw BadInput(
      ErrorCode::NotHexahedra, fileName, "not a readable VTK mesh (" + messages.firstError() + ")", writeAgain);
  }
  FileGrid file{ reader->GetOutput() };
  file.isRas = saysRas(file.grid->GetFieldData());
  if constexpr (std::is_same_v<TReader, vtkUnstructuredGridReader>)
  {
    file.isRas = file.isRas || saysRas(reader->GetHeader());
  }
  return file;
}

/** The arrays fit together, so that the grid's own functions may be used. */
void
requireConsistent(const std::string & fileName, vtkUnstructuredGrid & grid)
{
  const vtkIdType cells = grid.GetNumberOfCells();
  if (!grid.GetPoints() || cells == 0)
  {
    throw BadInput(ErrorCode::NotHexahedra, fileName, "has no points or no cells", writeAgain);
  }
  if (!grid.GetCells()->IsValid() || cellTypesOf(grid)->GetNumberOfValues() != cells)
  {
    throw BadInput(
      ErrorCode::NotHexahedra, fileName, "the lists of cells and of their types do not fit together", writeAgain);
  }
}

/** nullptr: a type that VTK does not know. */
vtkSmartPointer<vtkCell>
cellOf(int type)
{
  const VtkMessages messages; // about those
  return vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(type));
}

/** "Tetra" of vtkTetra. */
std::string
nameOf(int type)
{
  const vtkSmartPointer<vtkCell> cell = cellOf(type);
  return cell ? std::string(cell->GetClassName()).substr(3) : "cell type " + std::to_string(type);
}

int
dimensionOf(int type)
{
  const vtkSmartPointer<vtkCell> cell = cellOf(type);
  return cell ? cell->GetCellDimension() : 3;
}

FileGrid
readGrid(const std::string & fileName)
{
  FileGrid file;
  if (endsWith(fileName, ".vtu"))
  {
    requireHonestXml(fileName, "UnstructuredGrid", writeAgain);
    file = readGridWith<vtkXMLUnstructuredGridReader>(fileName);
  }
  else
  {
    requireHonestCounts(fileName);
    file = readGridWith<vtkUnstructuredGridReader>(fileName);
  }
  requireConsistent(fileName, *file.grid);
  return file;
}

HexCellFile
meshOf(const FileGrid & file, const std::string & fileName)
{
  HexCellCollector collector(fileName);
  for (vtkIdType node = 0; node < file.grid->GetNumberOfPoints(); ++node)
  {
    Vector3 position;
    file.grid->GetPoint(node, position.data());
    collector.addNode(node, position);
  }
  std::map<int, std::size_t> others;
  vtkNew<vtkIdList>          points;
  for (vtkIdType cell = 0; cell < file.grid->GetNumberOfCells(); ++cell)
  {
    file.grid->GetCells()->GetCellAtId(cell, points);
    const int type = file.grid->GetCellType(cell);
    if (type != VTK_HEXAHEDRON)
    {
      ++others[type];
    }
    else if (points->GetNumberOfIds() == 8)
    {
      std::array<HexCellCollector::NodeTag, 8> tags{};
      std::copy_n(points->GetPointer(0), 8, tags.begin());
      collector.addHexahedron(tags);
    }
    else
    {
      throw BadInput(ErrorCode::NotHexahedra,
                     fileName,
                     "a hexahedron of " + std::to_string(points->GetNumberOfIds()) + " points",
                     writeAgain);
    }
  }
  for (const auto & [type, count] : others)
  {
    collector.addOther(nameOf(type), dimensionOf(type), count);
  }
  HexCellFile result = collector.finish();
  if (file.isRas)
  {
    turnRasIntoLps(result.mesh.nodes);
  }
  return result;
}

/** Numbers of the grid's hexahedra, and of the points that they use, ascending: the nodes of meshOf. */
struct KeptNumbers
{
  std::vector<vtkIdType> cells;
  std::vector<vtkIdType> nodes;
};

KeptNumbers
keptNumbers(vtkUnstructuredGrid & grid)
{
  KeptNumbers       kept;
  std::vector<char> isUsed(static_cast<std::size_t>(grid.GetNumberOfPoints()), 0);
  vtkNew<vtkIdList> points;
  for (vtkIdType cell = 0; cell < grid.GetNumberOfCells(); ++cell)
  {
    if (grid.GetCellType(cell) == VTK_HEXAHEDRON)
    {
      kept.cells.push_back(cell);
      grid.GetCells()->GetCellAtId(cell, points);
      for (vtkIdType corner = 0; corner < points->GetNumberOfIds(); ++corner)
      {
        isUsed[static_cast<std::size_t>(points->GetId(corner))] = 1;
      }
    }
  }
  for (std::size_t node = 0; node < isUsed.size(); ++node)
  {
    if (isUsed[node] != 0)
    {
      kept.nodes.push_back(static_cast<vtkIdType>(node));
    }
  }
  return kept;
}

/** \param count  of the grid's cells or points \param kept  which of them */
std::vector<NamedArray>
arraysOf(vtkFieldData & data, vtkIdType count, const std::vector<vtkIdType> & kept, const std::string & fileName)
{
  std::vector<NamedArray> arrays;
  for (int number = 0; number < data.GetNumberOfArrays(); ++number)
  {
    vtkDataArray * const array = data.GetArray(number); // nullptr: of words
    if (!array || !array->GetName() || array->GetName()[0] == '\0')
    {
      continue;
    }
    if (array->GetNumberOfTuples() != count)
    {
      throw BadInput(ErrorCode::NotHexahedra,
                     fileName,
                     "array " + oneLine(array->GetName(), 40) + " is " + std::to_string(array->GetNumberOfTuples()) +
                       " long and not " + std::to_string(count),
                     writeAgain);
    }
    NamedArray named{ array->GetName(), array->GetNumberOfComponents(), {} };
    named.values.reserve(kept.size() * static_cast<std::size_t>(named.components));
    for (const vtkIdType one : kept)
    {
      for (int component = 0; component < named.components; ++component)
      {
        named.values.push_back(array->GetComponent(one, component));
      }
    }
    arrays.push_back(std::move(named));
  }
  return arrays;
}

/** Numbers that stand in a file once for the mesh. */
std::vector<NamedArray>
meshArraysOf(vtkFieldData & data)
{
  std::vector<NamedArray> arrays;
  for (int number = 0; number < data.GetNumberOfArrays(); ++number)
  {
    vtkDataArray * const array = data.GetArray(number); // nullptr: of words
    if (array && array->GetName() && array->GetNumberOfTuples() == 1)
    {
      NamedArray named{ array->GetName(), array->GetNumberOfComponents(), {} };
      for (int component = 0; component < named.components; ++component)
      {
        named.values.push_back(array->GetComponent(0, component));
      }
      arrays.push_back(std::move(named));
    }
  }
  return arrays;
}

HexCellFile
fileOf(const FileGrid & file, const std::string & fileName)
{
  HexCellFile result = meshOf(file, fileName);
  result.meshArrays = meshArraysOf(*file.grid->GetFieldData());
  return result;
}

} // namespace

HexCellFile
readVtkCells(const std::string & fileName)
{
  return fileOf(readGrid(fileName), fileName);
}

HexCellFile
readVtkCellsWithArrays(const std::string & fileName)
{
  const FileGrid        file = readGrid(fileName);
  HexCellFile           result = fileOf(file, fileName);
  vtkUnstructuredGrid & grid = *file.grid;
  const KeptNumbers     kept = keptNumbers(grid);
  result.arrays.ofCells = arraysOf(*grid.GetCellData(), grid.GetNumberOfCells(), kept.cells, fileName);
  result.arrays.ofNodes = arraysOf(*grid.GetPointData(), grid.GetNumberOfPoints(), kept.nodes, fileName);
  return result;
}

} // namespace moserhex
