#pragma once

#include <Eigen/SparseCore>

#include <array>
#include <cstddef>

namespace moserhex
{

/** Discrete exterior calculus on the regular lattice of n x n x n nodes with spacing h.
 *
 * Numbering. Nodes (i,j,k): i + n (j + n k). Edges: all x-edges, then y, then z; edges of one direction by the index of
 * their first node in a box of (n-1) x n x n (x-edges; likewise y, z), first index fastest. Faces: all with normal x,
 * then y, then z; box n x (n-1) x (n-1) for normal x. Cells: box (n-1)^3.
 * Orientation. Edges point along their axis; faces have the axis as normal, their boundary runs counter-clockwise about
 * it; cells are right-handed, outward faces positive. */
class CubeLatticeOperators
{
public:
  using SparseMatrix = Eigen::SparseMatrix<double>; ///< as all operators are given

  /** \throws InvalidInput  nodesPerSide < 2, or spacing not positive and finite */
  explicit CubeLatticeOperators(int nodesPerSide, double spacing = 1.0);

  /** n^3. */
  [[nodiscard]] std::size_t
  nodeCount() const;
  /** 3 n^2 (n-1). */
  [[nodiscard]] std::size_t
  edgeCount() const;
  /** 3 n (n-1)^2. */
  [[nodiscard]] std::size_t
  faceCount() const;
  /** (n-1)^3. */
  [[nodiscard]] std::size_t
  cellCount() const;

  /** i + n (j + n k). */
  [[nodiscard]] std::size_t
  nodeNumber(int i, int j, int k) const;
  /** Edge along `axis` that starts at node (i,j,k). */
  [[nodiscard]] std::size_t
  edgeNumber(int axis, int i, int j, int k) const;
  /** Face with normal `axis` whose smallest node is (i,j,k). */
  [[nodiscard]] std::size_t
  faceNumber(int axis, int i, int j, int k) const;
  /** Cell whose smallest node is (i,j,k): i + (n-1) (j + (n-1) k). */
  [[nodiscard]] std::size_t
  cellNumber(int i, int j, int k) const;

  [[nodiscard]] SparseMatrix
  d0() const; ///< gradient, edges x nodes, entries +-1
  [[nodiscard]] SparseMatrix
  d1() const; ///< curl, faces x edges, entries +-1
  [[nodiscard]] SparseMatrix
  d2() const; ///< divergence, cells x faces, entries +-1

  /** Diagonal Hodge stars: measure of the dual element over measure of the primal one. Dual elements are cut off at the
   * boundary, so boundary nodes, edges and faces have 1/2, 1/4 or 1/8 of an interior one's. */
  [[nodiscard]] Eigen::VectorXd
  star0() const; ///< dual volume [h^3]
  [[nodiscard]] Eigen::VectorXd
  star1() const; ///< dual area / edge length [h]
  [[nodiscard]] Eigen::VectorXd
  star2() const; ///< dual length / face area [1/h]
  [[nodiscard]] Eigen::VectorXd
  star3() const; ///< 1 / cell volume [1/h^3]

  /** 1 for faces inside the cube, 0 for those on its surface: multiplies a 2-form to make its boundary flux zero. */
  [[nodiscard]] Eigen::VectorXd
  interiorFaces() const;

  /** The flux v = *2^-1 d2^T theta of a 3-form's potential, zero on the boundary: faces x cells. */
  [[nodiscard]] SparseMatrix
  fluxFromPotential() const;

private:
  int    m_N;
  double m_Spacing;
};

} // namespace moserhex
