#pragma once

#include "moserhex/Geometry/UnstructuredHexMesh.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace moserhex
{

// The named parts of a lattice, the same in every file format that has sets.

/** A quadrilateral of the cube's surface and the one cell that it belongs to. */
struct CubeFaceSide
{
  std::size_t   cell;
  Quadrilateral nodes; ///< counter-clockwise seen from outside
};

/** One of the six sides of the cube: nodes with i = 0, i = n-1, j = 0, j = n-1, k = 0, k = n-1, in the outermost layer
 * of padding where there is one. */
struct CubeFace
{
  std::string               name;  ///< FACE_I0 FACE_I1 FACE_J0 FACE_J1 FACE_K0 FACE_K1
  std::vector<std::size_t>  nodes; ///< n^2, ascending
  std::vector<CubeFaceSide> sides; ///< (n-1)^2, in order of the cells
};

/** In the order of the names above. */
[[nodiscard]] std::array<CubeFace, 6>
cubeFaces(const HexMesh & mesh);

/** Of every node, 0 in the lattice. */
[[nodiscard]] std::vector<int>
paddingLayerOfNodes(const HexMesh & mesh);

/** Cells of each shell, ascending; entry s-1 is shell s, named shellName(mesh, s). None is empty. */
[[nodiscard]] std::vector<std::vector<std::size_t>>
cellsOfShells(const std::vector<int> & shellOfCell);

/** "SHELL_1", ..., "SHELL_N", "PADDING_1", ... */
[[nodiscard]] std::string
shellName(const HexMesh & mesh, std::size_t shell);

} // namespace moserhex
