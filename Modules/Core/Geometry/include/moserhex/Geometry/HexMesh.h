#pragma once

#include "moserhex/Common/Types.h"

#include <array>
#include <cstddef>
#include <vector>

namespace moserhex
{

/** Structured hexahedral mesh of n x n x n nodes and (n-1)^3 cells, the lattice, and of L layers of padding around it.
 *
 * Node (i,j,k) has the number i + n (j + n k), cell (i,j,k) likewise with n-1. i grows towards patient Left,
 * j Posterior, k Superior (LPS). The eight nodes of a cell come in VTK_HEXAHEDRON order.
 *
 * Layer l = 1 ... L repeats the B = n^3 - (n-2)^3 nodes of the lattice's boundary further out: node b of them (counted
 * in the order of their lattice numbers) has the number n^3 + (l-1) B + b there. On each boundary quadrilateral of the
 * lattice stands one pillow cell a layer: 6 (n-1)^2 cells a layer, the layers one after the other behind the lattice's
 * cells, in each the faces i = 0, i = n-1, j = 0, j = n-1, k = 0, k = n-1, in each of these the (n-1)^2 quadrilaterals,
 * the first of the two other indices fastest. A pillow cell's own axes are those of the lattice. With L = 0 the
 * boundary of the lattice is the organ's surface, otherwise that of layer L is. */
struct HexMesh
{
  int       nodesPerSide{ 0 };  ///< n >= 2
  Positions nodes;              ///< n^3 + L B [mm]
  int       paddingLayers{ 0 }; ///< L >= 0

  /** i + n (j + n k), of a node of the lattice. */
  [[nodiscard]] std::size_t
  nodeNumber(int i, int j, int k) const
  {
    const auto n = static_cast<std::size_t>(nodesPerSide);
    return static_cast<std::size_t>(i) + n * (static_cast<std::size_t>(j) + n * static_cast<std::size_t>(k));
  }

  /** Number of the node over boundary node (i,j,k) of the lattice in a layer; layer 0 is the lattice itself. */
  [[nodiscard]] std::size_t
  paddingNodeNumber(int layer, int i, int j, int k) const;

  /** (n-1)^3 */
  [[nodiscard]] std::size_t
  latticeCellCount() const
  {
    const auto m = static_cast<std::size_t>(nodesPerSide - 1);
    return m * m * m;
  }

  /** (n-1)^3 + 6 (n-1)^2 L */
  [[nodiscard]] std::size_t
  cellCount() const
  {
    const auto m = static_cast<std::size_t>(nodesPerSide - 1);
    return m * m * (m + 6 * static_cast<std::size_t>(paddingLayers));
  }

  /** Node numbers of a cell, VTK_HEXAHEDRON order: bottom face counter-clockwise seen from above, then top face. */
  [[nodiscard]] std::array<std::size_t, 8>
  cellNodes(std::size_t cell) const;
};

/** Where a pillow cell stands. */
struct PillowCell
{
  int                layer; ///< 1 ... L, 1 innermost
  int                axis;  ///< across the layer: 0 i, 1 j, 2 k
  bool               last;  ///< on the side n-1 of the axis, not 0
  std::array<int, 3> quad;  ///< first corner of the boundary quadrilateral, entry `axis` 0 or n-1
};

/** \param cell  latticeCellCount() <= cell < cellCount() */
[[nodiscard]] PillowCell
pillowCell(const HexMesh & mesh, std::size_t cell);

/** B = n^3 - (n-2)^3: nodes on the boundary of a lattice. */
[[nodiscard]] std::size_t
boundaryNodeCount(int nodesPerSide);

/** n^3 + L B */
[[nodiscard]] std::size_t
nodeCount(int nodesPerSide, int paddingLayers);

/** \throws InvalidInput  unless n >= 2, L >= 0, there are n^3 + L B nodes, and every coordinate is finite (names the
 * node) */
void
requireValid(const HexMesh & mesh);

/** \throws InvalidInput  as requireValid(mesh), and when there is padding */
void
requireLattice(const HexMesh & mesh);

/** The lattice alone, without its padding. */
[[nodiscard]] HexMesh
latticePart(const HexMesh & mesh);

/** Eight corners of one hexahedron in VTK_HEXAHEDRON order. */
using HexCorners = std::array<Vector3, 8>;

/** Positions of the nodes of a cell [mm]. */
[[nodiscard]] HexCorners
cellCorners(const HexMesh & mesh, std::size_t cell);

/** Exact volume of the trilinear hexahedron, the integral of det J over the unit cube [mm^3].
 *
 * The integrand is at most quadratic in each variable, so the 2x2x2 Gauss rule is exact. Negative when inverted. */
[[nodiscard]] double
hexVolume(const HexCorners & corners);

/** det J at the eight corners, reference cell of side 1 [mm^3]. */
[[nodiscard]] std::array<double, 8>
cornerJacobians(const HexCorners & corners);

/** Volume of every cell [mm^3]. */
[[nodiscard]] std::vector<double>
cellVolumes(const HexMesh & mesh);

} // namespace moserhex
