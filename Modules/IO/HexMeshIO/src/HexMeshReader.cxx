#include "moserhex/HexMeshIO/HexMeshReader.h"

#include "FileNames.h"
#include "ImageFileCheck.h"
#include "VtkMessages.h"

#include <vtkCell.h>
#include <vtkCellType.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <cmath>

namespace moserhex
{
namespace
{

template <typename TReader>
vtkSmartPointer<vtkUnstructuredGrid>
readGridWith(const std::string & fileName)
{
  const VtkMessages messages;
  vtkNew<TReader>   reader;
  reader->SetFileName(fileName.c_str());
  reader->Update();
  if (reader->GetErrorCode() != 0 || !messages.firstError().empty() || !reader->GetOutput())
  {
    throw BadInput(fileName, "not a readable VTK mesh (" + messages.firstError() + ")", "write the mesh again");
  }
  return reader->GetOutput();
}

/** n of n^3, or 0. */
int
cubeRoot(vtkIdType count)
{
  const auto root = static_cast<int>(std::lround(std::cbrt(static_cast<double>(count))));
  return static_cast<vtkIdType>(root) * root * root == count ? root : 0;
}

bool
hasLatticeConnectivity(vtkUnstructuredGrid & grid, const HexMesh & mesh)
{
  vtkNew<vtkIdList> points;
  for (std::size_t cell = 0; cell < mesh.cellCount(); ++cell)
  {
    const auto id = static_cast<vtkIdType>(cell);
    if (grid.GetCellType(id) != VTK_HEXAHEDRON)
    {
      return false;
    }
    grid.GetCellPoints(id, points);
    const auto nodes = mesh.cellNodes(cell);
    for (std::size_t corner = 0; corner < 8; ++corner)
    {
      if (points->GetId(static_cast<vtkIdType>(corner)) != static_cast<vtkIdType>(nodes[corner]))
      {
        return false;
      }
    }
  }
  return true;
}

} // namespace

HexMesh
readHexMesh(const std::string & fileName)
{
  requireReadableFile(fileName);
  vtkSmartPointer<vtkUnstructuredGrid> grid;
  if (endsWith(fileName, ".vtu"))
  {
    grid = readGridWith<vtkXMLUnstructuredGridReader>(fileName);
  }
  else if (endsWith(fileName, ".vtk"))
  {
    grid = readGridWith<vtkUnstructuredGridReader>(fileName);
  }
  else
  {
    throw BadInput(fileName, "not a mesh file's name", "give a .vtu or .vtk file");
  }

  HexMesh mesh;
  mesh.nodesPerSide = cubeRoot(grid->GetNumberOfPoints());
  if (mesh.nodesPerSide < 2 || static_cast<std::size_t>(grid->GetNumberOfCells()) != mesh.cellCount())
  {
    throw BadInput(fileName,
                   std::to_string(grid->GetNumberOfPoints()) + " nodes and " +
                     std::to_string(grid->GetNumberOfCells()) + " cells are not a lattice of n^3 and (n-1)^3",
                   "give a mesh written by moserhex");
  }
  if (!hasLatticeConnectivity(*grid, mesh))
  {
    throw BadInput(fileName, "the cells do not connect as the lattice does", "give a mesh written by moserhex");
  }
  mesh.nodes.resize(static_cast<std::size_t>(grid->GetNumberOfPoints()));
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
  {
    grid->GetPoint(static_cast<vtkIdType>(node), mesh.nodes[node].data());
    if (!mesh.nodes[node].allFinite())
    {
      throw BadInput(fileName, "node " + std::to_string(node) + " is not finite", "write the mesh again");
    }
  }
  return mesh;
}

} // namespace moserhex
