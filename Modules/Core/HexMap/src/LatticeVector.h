#pragma once

#include "moserhex/Geometry/HexMesh.h"

#include <Eigen/Core>

#include <array>
#include <functional>
#include <vector>

namespace moserhex
{

/** Entries after each component that kernels over several cells at once may read, and add zeros to. */
constexpr std::size_t latticePadding = 8;

/** Node numbers of a cell's corners: bit 0 of the corner = i, bit 1 = j, bit 2 = k. */
using CellNodes = std::array<std::size_t, 8>;

/** Where the numbers of a mesh stand in one long vector: all x, then all y, then all z, each with spare entries at the
 * end so that kernels may read and add zeros past the last node.
 *
 * Corner a of the lattice's cell whose first node is p is the node p + corner[a]; pillow cells name their corners. A
 * number for each cell stands in the cell's slot: of the lattice's cells at their first nodes, of pillow cells behind
 * all nodes. */
struct LatticeLayout
{
  explicit LatticeLayout(int nodesPerSide, int paddingLayers = 0);

  int                    nodesPerSide;
  int                    paddingLayers;
  std::size_t            nodes;      ///< of the lattice and of all layers
  std::size_t            stride;     ///< from x to y to z of a node
  std::size_t            cellStarts; ///< nodes up to and including the last one at which a cell begins
  CellNodes              corner;
  std::vector<CellNodes> pillowCells; ///< in the order of their numbers

  /** Entries of a vector of numbers of cells. */
  [[nodiscard]] Eigen::Index
  slotCount() const
  {
    return static_cast<Eigen::Index>(stride + pillowCells.size() + latticePadding);
  }

  [[nodiscard]] std::size_t
  latticeCellCount() const
  {
    const auto m = static_cast<std::size_t>(nodesPerSide - 1);
    return m * m * m;
  }

  [[nodiscard]] std::size_t
  slot(std::size_t cell) const
  {
    return cell < latticeCellCount() ? firstNode(cell) : stride + (cell - latticeCellCount());
  }

  [[nodiscard]] CellNodes
  cellNodes(std::size_t cell) const;

  /** A mesh of this layout without places for its nodes. */
  [[nodiscard]] HexMesh
  connectivity() const;

  [[nodiscard]] Eigen::Index
  size() const
  {
    return static_cast<Eigen::Index>(3 * stride);
  }

  [[nodiscard]] std::size_t
  node(int i, int j, int k) const
  {
    const auto n = static_cast<std::size_t>(nodesPerSide);
    return static_cast<std::size_t>(i) + n * (static_cast<std::size_t>(j) + n * static_cast<std::size_t>(k));
  }

  /** First node of a cell of the lattice, cells numbered i + (n-1) (j + (n-1) k). */
  [[nodiscard]] std::size_t
  firstNode(std::size_t cell) const;

  [[nodiscard]] Vector3
  at(const Eigen::VectorXd & x, std::size_t node) const
  {
    const double * p = x.data() + node;
    return { p[0], p[stride], p[2 * stride] };
  }

  void
  add(Eigen::VectorXd & x, std::size_t node, const Vector3 & value) const
  {
    double * p = x.data() + node;
    p[0] += value[0];
    p[stride] += value[1];
    p[2 * stride] += value[2];
  }

  /** Sets the padding to zero, where kernels may have left sums of masked lanes. */
  void
  clearPadding(Eigen::VectorXd & x) const;
};

/** (nodes - origin) / unit as one vector. */
[[nodiscard]] Eigen::VectorXd
latticeVector(const LatticeLayout & layout, const Positions & nodes, const Vector3 & origin, double unit);

/** The inverse. */
[[nodiscard]] Positions
latticePositions(const LatticeLayout & layout, const Eigen::VectorXd & x, const Vector3 & origin, double unit);

/** x, y and z of the nodes as the three columns of a matrix. */
[[nodiscard]] inline Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>>
componentsOf(const LatticeLayout & layout, Eigen::VectorXd & x)
{
  return {
    x.data(), static_cast<Eigen::Index>(layout.nodes), 3, Eigen::OuterStride<>(static_cast<Eigen::Index>(layout.stride))
  };
}

/** Number of slabs of cell layers of the lattice that slabwise work is cut into; depends on n alone. */
[[nodiscard]] std::size_t
slabCount(const LatticeLayout & layout);

/** Runs body(slab, begin, end) for the ranges [begin, end) of cell starts of every slab of the lattice, the even slabs
 * first, in parallel, then the odd ones. A body may add to the nodes of its cells: two slabs of one colour share none,
 * so every node receives its terms in the same order whatever the number of threads. */
void
forEachSlab(const LatticeLayout &                                              layout,
            unsigned int                                                       threads,
            const std::function<void(std::size_t, std::size_t, std::size_t)> & body);

} // namespace moserhex
