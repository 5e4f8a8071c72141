#pragma once

#include "moserhex/Common/Types.h"

#include <array>
#include <cstddef>
#include <vector>

namespace moserhex
{

/** Four node numbers, counter-clockwise seen from outside the cube. */
using Quad = std::array<std::size_t, 4>;

/** The cube lattice of N shells: n = 2N nodes a side, n^3 nodes, (n-1)^3 cells.
 *
 * Node (i,j,k) has the number i + n (j + n k), cell (i,j,k) likewise with n-1. Cube shell k is the boundary of the cube
 * that is left after N-k layers have been eroded: k = N is the cube's surface, k = 1 the eight nodes of the middle
 * cell. Shell k has 6 (2k-1)^2 + 2 nodes and 6 (2k-1)^2 quadrilaterals. */
class CubeLattice
{
public:
  /** \throws InvalidInput  shells < 1 or shells > 500 */
  explicit CubeLattice(int shells);

  /** N. */
  [[nodiscard]] int
  shells() const
  {
    return m_Shells;
  }

  /** n = 2N. */
  [[nodiscard]] int
  nodesPerSide() const
  {
    return 2 * m_Shells;
  }

  /** n^3. */
  [[nodiscard]] std::size_t
  nodeCount() const;

  /** (n-1)^3. */
  [[nodiscard]] std::size_t
  cellCount() const;

  /** i + n (j + n k). */
  [[nodiscard]] std::size_t
  nodeNumber(int i, int j, int k) const;

  /** Inverse of nodeNumber. */
  [[nodiscard]] std::array<int, 3>
  nodeIndex(std::size_t node) const;

  /** Shell number 1..N of a node: (1 + max |2 i - (n-1)|) / 2 over the three indices. */
  [[nodiscard]] int
  shellOfNode(std::size_t node) const;

  /** Shell number 1..N of a cell, that of the outermost of its nodes; the middle cell has 1. */
  [[nodiscard]] int
  shellOfCell(std::size_t cell) const;

  /** Nodes of a shell in increasing order. \throws InvalidInput  shell outside 1..N */
  [[nodiscard]] std::vector<std::size_t>
  nodesOfShell(int shell) const;

  /** Quadrilaterals of a shell, outward, face by face: -x +x -y +y -z +z. \throws InvalidInput  shell outside 1..N */
  [[nodiscard]] std::vector<Quad>
  quadsOfShell(int shell) const;

  /** Position of a node in the cube [-1,1]^3. */
  [[nodiscard]] Vector3
  position(std::size_t node) const;

  /** Position of a node with its own shell blown up to the surface of [-1,1]^3: the largest coordinate is exactly 1. */
  [[nodiscard]] Vector3
  positionOnShell(std::size_t node) const;

  /** Side of shell k over the side of the cube, (2k-1)/(2N-1) [1]. */
  [[nodiscard]] double
  relativeSize(int shell) const;

private:
  void
  requireShell(int shell) const;

  int m_Shells;
};

} // namespace moserhex
