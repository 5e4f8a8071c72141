#ifndef itkHexMeshConversion_h
#define itkHexMeshConversion_h

#include "itkTriangleMeshConversion.h"

#include "moserhex/Geometry/HexMesh.h"
#include "moserhex/StructuredGrid/CubeLattice.h"

#include <itkFixedArray.h>
#include <itkHexahedronCell.h>
#include <itkMesh.h>

#include <cmath>

namespace itk
{

/** Point data of a lattice mesh: lattice index i, j, k and shell number. */
using LatticePointData = FixedArray<double, 4>;

/** Cell data of a lattice mesh: shell number and volume ratio (cell volume / mean cell volume). */
using LatticeCellData = FixedArray<double, 2>;

/** Hexahedral mesh with double points, lattice index and shell number per point, shell number and volume ratio per
 * cell. A mesh whose pixel types are plain numbers gets the shell number per point and the volume ratio per cell. */
using LatticeHexMesh =
  Mesh<LatticePointData, 3, DefaultStaticMeshTraits<LatticePointData, 3, 3, double, double, LatticeCellData>>;

/** Copies a structured hexahedral mesh into an itk::Mesh: points and HexahedronCell's in lattice order, and their data.
 * Any earlier content is replaced. The number of nodes per side must be even (n = 2N). */
template <typename TMesh>
void
CopyHexMeshToItk(const moserhex::HexMesh & source, TMesh * target)
{
  static_assert(std::is_same<typename TMesh::CoordRepType, double>::value, "points must be stored as double");
  using CellType = typename TMesh::CellType;
  using PointPixel = typename TMesh::PixelType;
  using CellPixel = typename TMesh::CellPixelType;

  const moserhex::CubeLattice lattice(source.nodesPerSide / 2);
  target->Initialize();
  target->GetPoints()->Reserve(source.nodes.size());
  for (std::size_t node = 0; node < source.nodes.size(); ++node)
  {
    const auto                id = static_cast<IdentifierType>(node);
    typename TMesh::PointType point;
    for (unsigned int a = 0; a < 3; ++a)
    {
      point[a] = source.nodes[node][a];
    }
    target->SetPoint(id, point);
    const int shell = lattice.shellOfNode(node);
    if constexpr (std::is_arithmetic<PointPixel>::value)
    {
      target->SetPointData(id, static_cast<PointPixel>(shell));
    }
    else
    {
      const std::array<int, 3> index = lattice.nodeIndex(node);
      PointPixel               data;
      data[0] = index[0];
      data[1] = index[1];
      data[2] = index[2];
      data[3] = shell;
      target->SetPointData(id, data);
    }
  }

  const std::vector<double> volumes = moserhex::cellVolumes(source);
  double                    total = 0.0;
  for (const double volume : volumes)
  {
    total += volume;
  }
  const double mean = total / static_cast<double>(volumes.size());
  for (std::size_t cellNumber = 0; cellNumber < volumes.size(); ++cellNumber)
  {
    const auto                         id = static_cast<IdentifierType>(cellNumber);
    typename CellType::CellAutoPointer cell;
    cell.TakeOwnership(new HexahedronCell<CellType>);
    const std::array<std::size_t, 8> nodes = source.cellNodes(cellNumber);
    for (int c = 0; c < 8; ++c)
    {
      cell->SetPointId(c, static_cast<IdentifierType>(nodes[c]));
    }
    target->SetCell(id, cell);
    const double ratio = volumes[cellNumber] / mean;
    if constexpr (std::is_arithmetic<CellPixel>::value)
    {
      target->SetCellData(id, static_cast<CellPixel>(ratio));
    }
    else
    {
      CellPixel data;
      data[0] = lattice.shellOfCell(cellNumber);
      data[1] = ratio;
      target->SetCellData(id, data);
    }
  }
}

/** The lattice mesh whose points are those of an itk::Mesh, in order.
 * \throws ExceptionObject  when the number of points is not n^3, or a cell is not the lattice's */
template <typename TMesh>
moserhex::HexMesh
HexMeshFromItk(const TMesh * source)
{
  moserhex::HexMesh mesh;
  mesh.nodes = PositionsFromItk(source);
  const auto count = mesh.nodes.size();
  mesh.nodesPerSide = static_cast<int>(std::lround(std::cbrt(static_cast<double>(count))));
  const auto n = static_cast<std::size_t>(mesh.nodesPerSide);
  if (n < 2 || n * n * n != count || source->GetNumberOfCells() != mesh.cellCount())
  {
    itkGenericExceptionMacro(<< count << " points and " << source->GetNumberOfCells()
                             << " cells are not a lattice of n^3 points and (n-1)^3 cells");
  }
  for (std::size_t cellNumber = 0; cellNumber < mesh.cellCount(); ++cellNumber)
  {
    typename TMesh::CellType::CellAutoPointer cell;
    const std::array<std::size_t, 8>          nodes = mesh.cellNodes(cellNumber);
    bool same = source->GetCell(static_cast<IdentifierType>(cellNumber), cell) && cell->GetNumberOfPoints() == 8;
    for (int c = 0; same && c < 8; ++c)
    {
      same = cell->GetPointIds()[c] == nodes[c];
    }
    if (!same)
    {
      itkGenericExceptionMacro("cell " << cellNumber << " is not the lattice's");
    }
  }
  return mesh;
}

} // namespace itk

#endif
