#pragma once

#include "moserhex/Common/Types.h"

#include <array>
#include <cstddef>
#include <vector>

namespace moserhex
{

/** Structured hexahedral mesh of n x n x n nodes and (n-1)^3 cells.
 *
 * Node (i,j,k) has the number i + n (j + n k), cell (i,j,k) likewise with n-1. i grows towards patient Left,
 * j Posterior, k Superior (LPS). The eight nodes of a cell come in VTK_HEXAHEDRON order. */
struct HexMesh
{
  int       nodesPerSide{ 0 }; ///< n >= 2
  Positions nodes;             ///< n^3 x 3 [mm]

  [[nodiscard]] std::size_t
  nodeNumber(int i, int j, int k) const
  {
    const auto n = static_cast<std::size_t>(nodesPerSide);
    return static_cast<std::size_t>(i) + n * (static_cast<std::size_t>(j) + n * static_cast<std::size_t>(k));
  }

  [[nodiscard]] std::size_t
  cellCount() const
  {
    const auto m = static_cast<std::size_t>(nodesPerSide - 1);
    return m * m * m;
  }

  /** Node numbers of a cell, VTK_HEXAHEDRON order: bottom face counter-clockwise seen from above, then top face. */
  [[nodiscard]] std::array<std::size_t, 8>
  cellNodes(std::size_t cell) const;
};

/** \throws InvalidInput  unless there are n^3 nodes, n >= 2, and every coordinate is finite (names the node) */
void
requireValid(const HexMesh & mesh);

/** Eight corners of one hexahedron in VTK_HEXAHEDRON order. */
using HexCorners = std::array<Vector3, 8>;

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

/** Volume of every cell, (n-1)^3 [mm^3]. */
[[nodiscard]] std::vector<double>
cellVolumes(const HexMesh & mesh);

} // namespace moserhex
