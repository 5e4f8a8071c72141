#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace moserhex
{

/** Cholesky factorisation of sparse symmetric positive definite matrices of 2 x 2 blocks on an undirected graph: one
 * diagonal block for each vertex, one coupling block for each edge.
 *
 * Two unknowns a vertex is what motion on a surface has. With blocks the graph is half the size of the scalar one and
 * each index is read once for sixteen floating-point operations: about three times as fast as the scalar factorisation
 * of SparseCholesky, to the same result. Minimum-degree order of elimination, up-looking (row by row). Values go in by
 * vertex and edge number, so that assembly writes to known places. Deterministic, single-threaded. */
class BlockCholesky
{
public:
  using Block = Eigen::Matrix2d;                 ///< of the two unknowns of a vertex, or of two vertices
  using BlockVector = std::vector<Block>;        ///< one block for each vertex, or for each edge
  using GraphEdge = std::array<std::int32_t, 2>; ///< numbers of its two vertices

  /** Order of elimination and pattern of L: once for a graph. O(blocks of L).
   * \throws InvalidInput  no vertex, or an edge with a vertex out of range or with one vertex twice */
  void
  analyzePattern(std::size_t vertexCount, const std::vector<GraphEdge> & edges);

  /** The values of L.
   * \param diagonal  symmetric, one for each vertex; the lower triangle is read
   * \param coupling  one for each edge: rows belong to its first vertex, columns to its second
   * \throws InvalidInput  sizes are not those of the pattern
   * \throws NotConverged  the matrix is not positive definite, or holds a number that is not finite */
  void
  factorize(const BlockVector & diagonal, const BlockVector & coupling);

  /** x with A x = b; entries 2v and 2v+1 belong to vertex v.
   * \throws InvalidInput  nothing was factorised, or b has another size
   * \throws NotConverged  the solution is not finite */
  [[nodiscard]] Eigen::VectorXd
  solve(const Eigen::VectorXd & b) const;

private:
  /** A block of A above the diagonal of the permuted matrix. */
  struct Entry
  {
    int  row;        ///< permuted
    int  edge;       ///< number of the coupling block
    bool transposed; ///< the block is stored the other way round
  };

  void
  permuteGraph(const std::vector<GraphEdge> & edges);
  void
  findRowPatterns();
  void
  findColumnPatterns();
  [[nodiscard]] bool
  eliminateRow(int k, const BlockVector & diagonal, const BlockVector & coupling);

  std::vector<int> m_NewToOld;
  std::vector<int> m_OldToNew;

  std::vector<std::size_t> m_EntryBegin; ///< entries of column k of the permuted A: [begin[k], begin[k+1])
  std::vector<Entry>       m_Entries;

  std::vector<std::size_t> m_RowBegin; ///< columns of L in row k, in the order of their elimination
  std::vector<int>         m_RowColumns;
  std::vector<std::size_t> m_ColumnBegin; ///< rows of L in column i below the diagonal, ascending
  std::vector<int>         m_Rows;

  BlockVector              m_Values;          ///< parallel to m_Rows
  BlockVector              m_DiagonalInverse; ///< inverses of the lower triangular diagonal blocks of L
  BlockVector              m_Work;
  std::vector<std::size_t> m_ColumnEnd; ///< end of the rows of a column that are known so far
  std::size_t              m_EdgeCount{ 0 };
  bool                     m_Factorized{ false };
};

} // namespace moserhex
