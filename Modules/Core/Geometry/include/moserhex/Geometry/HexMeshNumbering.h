#pragma once

#include "moserhex/Geometry/UnstructuredHexMesh.h"

#include <array>
#include <vector>

namespace moserhex
{

/** Where a node stands in the mesh. */
struct NodeIndex
{
  std::array<int, 3> lattice; ///< i, j, k; of a node of the padding: of the boundary node that it stands over
  int                layer;   ///< of the padding, 0 in the lattice
};

/** Of every node. */
[[nodiscard]] std::vector<NodeIndex>
nodeIndices(const HexMesh & mesh);

/** Of every node in the cube [0,1]^3: (i, j, k) / (n-1). Layer l of the padding lies outside, l / (n-1) further out
 * along every axis at whose end the node is [1]. */
[[nodiscard]] Positions
cubeCoordinates(const HexMesh & mesh);

/** Shell of every cell: N - (layers of cells between it and the lattice's boundary), 1 in the middle and N = n/2
 * outermost; N + l in layer l of the padding. */
[[nodiscard]] std::vector<int>
shellOfCells(const HexMesh & mesh);

/** Nodes on the boundary of the mesh: of its outermost layer of padding, or of the lattice where there is none.
 * Ascending, B = n^3 - (n-2)^3 of them. */
[[nodiscard]] std::vector<std::size_t>
boundaryNodes(const HexMesh & mesh);

/** Where they are, in the same order [mm]. */
[[nodiscard]] Positions
boundaryPoints(const HexMesh & mesh);

/** The node numbers around every quadrilateral of the boundary, 6 (n-1)^2 of them; orientation differs from face to
 * face. */
[[nodiscard]] std::vector<Quadrilateral>
boundaryQuads(const HexMesh & mesh);

} // namespace moserhex
