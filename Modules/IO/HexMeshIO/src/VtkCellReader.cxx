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
#include <vtkCellType.h>
#include <vtkFieldData.h>
#include <vtkGenericCell.h>
#include <vtkIdList.h>
#include <vtkNew.h>
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

} // namespace

HexCellFile
readVtkCells(const std::string & fileName)
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

} // namespace moserhex
