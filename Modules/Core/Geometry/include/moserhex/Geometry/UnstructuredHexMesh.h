#pragma once

#include "moserhex/Geometry/HexMesh.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace moserhex
{

/** Hexahedral mesh of any connectivity, as other tools make them. */
struct UnstructuredHexMesh
{
  Positions                               nodes; ///< [mm]
  std::vector<std::array<std::size_t, 8>> cells; ///< node numbers from 0, VTK_HEXAHEDRON order

  /** Number of cells. */
  [[nodiscard]] std::size_t
  cellCount() const
  {
    return cells.size();
  }

  /** Node numbers of a cell, VTK_HEXAHEDRON order. */
  [[nodiscard]] const std::array<std::size_t, 8> &
  cellNodes(std::size_t cell) const
  {
    return cells[cell];
  }
};

/** \throws InvalidInput  no cell, a cell names a node that does not exist or one node twice (names the cell), or a
 *                        coordinate is not finite (names the node) */
void
requireValid(const UnstructuredHexMesh & mesh);

/** The same mesh with its connectivity written out. */
[[nodiscard]] UnstructuredHexMesh
unstructured(const HexMesh & mesh);

/** The lattice, with its padding, when the mesh is one: nodes and cells numbered and connected as in HexMesh. */
[[nodiscard]] std::optional<HexMesh>
asLattice(const UnstructuredHexMesh & mesh);

/** Positions of the nodes of a cell [mm]. */
[[nodiscard]] HexCorners
cellCorners(const UnstructuredHexMesh & mesh, std::size_t cell);

/** Volume of every cell [mm^3]. */
[[nodiscard]] std::vector<double>
cellVolumes(const UnstructuredHexMesh & mesh);

/** A face of exactly one cell: node numbers counter-clockwise seen from outside. */
using Quadrilateral = std::array<std::size_t, 4>;

/** Faces that belong to one cell only, in order of cell and face. O(cells log cells). */
[[nodiscard]] std::vector<Quadrilateral>
boundaryFaces(const UnstructuredHexMesh & mesh);

/** One of boundaryFaces and the cell that it belongs to. */
struct BoundaryFace
{
  std::size_t   cell;  ///< the cell it belongs to
  Quadrilateral nodes; ///< around the face
};

/** The same faces of a part of the mesh: those that belong to one of the given cells only.
 * \param cells  different cell numbers; the order of the result is theirs */
[[nodiscard]] std::vector<BoundaryFace>
boundaryFacesOf(const UnstructuredHexMesh & mesh, const std::vector<std::size_t> & cells);

} // namespace moserhex
