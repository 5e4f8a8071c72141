#ifndef itkHexMeshConversion_h
#define itkHexMeshConversion_h

#include "itkTriangleMeshConversion.h"

#include "moserhex/Geometry/HexMeshNumbering.h"
#include "moserhex/StructuredGrid/CubeLattice.h"

#include <itkFixedArray.h>
#include <itkHexahedronCell.h>
#include <itkMesh.h>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace itk
{

/** Point data of a lattice mesh: lattice index i, j, k and shell number; in layer l of the padding the index of the
 * lattice's boundary node that the point stands over, and N + l. */
using LatticePointData = FixedArray<double, 4>;

/** Cell data of a lattice mesh: shell number (N + l in layer l of the padding) and volume ratio (cell volume / mean
 * cell volume). */
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

  const moserhex::CubeLattice            lattice(source.nodesPerSide / 2);
  const std::vector<moserhex::NodeIndex> indices = moserhex::nodeIndices(source);
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
    const auto [index, layer] = indices[node];
    const int shell = layer == 0 ? lattice.shellOfNode(node) : lattice.shells() + layer;
    if constexpr (std::is_arithmetic<PointPixel>::value)
    {
      target->SetPointData(id, static_cast<PointPixel>(shell));
    }
    else
    {
      PointPixel data;
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
      data[0] = cellNumber < source.latticeCellCount()
                  ? lattice.shellOfCell(cellNumber)
                  : lattice.shells() + moserhex::pillowCell(source, cellNumber).layer;
      data[1] = ratio;
      target->SetCellData(id, data);
    }
  }
}

/** The lattice, with its padding, whose points are those of an itk::Mesh, in order.
 * \throws ExceptionObject  when the numbers of points and cells are of no lattice, or a cell is not the lattice's */
template <typename TMesh>
moserhex::HexMesh
HexMeshFromItk(const TMesh * source)
{
  moserhex::UnstructuredHexMesh mesh;
  mesh.nodes = PositionsFromItk(source);
  for (IdentifierType id = 0; id < source->GetNumberOfCells(); ++id)
  {
    typename TMesh::CellType::CellAutoPointer cell;
    std::array<std::size_t, 8>                nodes{};
    if (source->GetCell(id, cell) && cell->GetNumberOfPoints() == nodes.size())
    {
      std::copy(cell->PointIdsBegin(), cell->PointIdsEnd(), nodes.begin());
    }
    mesh.cells.push_back(nodes);
  }
  std::optional<moserhex::HexMesh> lattice = moserhex::asLattice(mesh);
  if (!lattice)
  {
    itkGenericExceptionMacro(<< mesh.nodes.size() << " points and " << mesh.cells.size()
                             << " cells are not a lattice of n^3 points and (n-1)^3 cells in its order");
  }
  return std::move(*lattice);
}

} // namespace itk

#endif
