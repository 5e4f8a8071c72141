#pragma once

#include "moserhex/Geometry/HexMesh.h"

#include <array>
#include <cstddef>
#include <vector>

namespace moserhex
{

/** Axis-aligned boxes of the blocks of a lattice's cells, halved along their longest side of the lattice. */
class CellBoxTree
{
public:
  /** \param slack  every box is that much larger on all sides [mm] */
  CellBoxTree(const HexMesh & mesh, double slack);

  /** The numbers of the cells in those smallest blocks whose boxes hold the point, ascending. */
  void
  cellsNear(const Vector3 & p, std::vector<std::size_t> & cells) const;

private:
  struct Block
  {
    std::array<int, 3> begin;
    std::array<int, 3> end;
  };
  struct Node
  {
    Block   block;
    Vector3 lower{ Vector3::Zero() };
    Vector3 upper{ Vector3::Zero() };
    int     left{ 0 }; ///< number of the first child, the second one follows; 0: a smallest block
  };

  void
  build(std::size_t node, const HexMesh & mesh, double slack);

  int               m_CellsPerSide;
  std::vector<Node> m_Nodes;
};

} // namespace moserhex
