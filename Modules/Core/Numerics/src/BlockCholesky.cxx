#include "moserhex/Numerics/BlockCholesky.h"

#include "moserhex/Common/Errors.h"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace moserhex
{
namespace
{

/** Minimum-degree order of the vertices: entry k is the vertex eliminated k-th. */
std::vector<int>
eliminationOrder(std::size_t vertexCount, const std::vector<BlockCholesky::GraphEdge> & edges)
{
  const auto                          n = static_cast<Eigen::Index>(vertexCount);
  std::vector<Eigen::Triplet<double>> triplets;
  triplets.reserve(2 * edges.size() + vertexCount);
  for (int v = 0; v < static_cast<int>(n); ++v)
  {
    triplets.emplace_back(v, v, 1.0);
  }
  for (const BlockCholesky::GraphEdge & edge : edges)
  {
    triplets.emplace_back(edge[0], edge[1], 1.0);
    triplets.emplace_back(edge[1], edge[0], 1.0);
  }
  Eigen::SparseMatrix<double> graph(n, n);
  graph.setFromTriplets(triplets.begin(), triplets.end());
  Eigen::AMDOrdering<int>::PermutationType permutation;
  Eigen::AMDOrdering<int>()(graph, permutation);
  return { permutation.indices().data(), permutation.indices().data() + n };
}

/** Inverse of the lower triangular L with L L^T = A; false unless A is positive definite. */
bool
invertCholesky(const BlockCholesky::Block & A, BlockCholesky::Block & inverse)
{
  const double a = A(0, 0);
  if (!(a > 0.0) || !std::isfinite(a))
  {
    return false;
  }
  const double l00 = std::sqrt(a);
  const double l10 = A(1, 0) / l00;
  const double d = A(1, 1) - l10 * l10;
  if (!(d > 0.0) || !std::isfinite(d))
  {
    return false;
  }
  const double l11 = std::sqrt(d);
  inverse << 1.0 / l00, 0.0, -l10 / (l00 * l11), 1.0 / l11;
  return true;
}

} // namespace

void
BlockCholesky::analyzePattern(std::size_t vertexCount, const std::vector<GraphEdge> & edges)
{
  m_Factorized = false;
  if (vertexCount == 0)
  {
    throw InvalidInput("block Cholesky: no vertex");
  }
  for (std::size_t e = 0; e < edges.size(); ++e)
  {
    const bool inRange = edges[e][0] >= 0 && edges[e][1] >= 0 &&
                         static_cast<std::size_t>(std::max(edges[e][0], edges[e][1])) < vertexCount;
    if (!inRange || edges[e][0] == edges[e][1])
    {
      std::ostringstream message;
      message << "block Cholesky: edge " << e << " joins vertices " << edges[e][0] << " and " << edges[e][1]
              << ", need two different ones from 0 to " << vertexCount - 1;
      throw InvalidInput(message.str());
    }
  }
  m_EdgeCount = edges.size();
  m_NewToOld = eliminationOrder(vertexCount, edges);
  m_OldToNew.resize(vertexCount);
  for (std::size_t k = 0; k < vertexCount; ++k)
  {
    m_OldToNew[m_NewToOld[k]] = static_cast<int>(k);
  }
  permuteGraph(edges);
  findRowPatterns();
  findColumnPatterns();
  m_Values.resize(m_Rows.size());
  m_DiagonalInverse.resize(vertexCount);
  m_Work.assign(vertexCount, Block::Zero());
}

void
BlockCholesky::permuteGraph(const std::vector<GraphEdge> & edges)
{
  m_EntryBegin.assign(m_NewToOld.size() + 1, 0);
  for (const GraphEdge & edge : edges)
  {
    ++m_EntryBegin[std::max(m_OldToNew[edge[0]], m_OldToNew[edge[1]]) + 1];
  }
  for (std::size_t k = 0; k < m_NewToOld.size(); ++k)
  {
    m_EntryBegin[k + 1] += m_EntryBegin[k];
  }
  m_Entries.resize(edges.size());
  std::vector<std::size_t> next(m_EntryBegin.begin(), m_EntryBegin.end() - 1);
  for (std::size_t e = 0; e < edges.size(); ++e)
  {
    const int first = m_OldToNew[edges[e][0]];
    const int second = m_OldToNew[edges[e][1]];
    m_Entries[next[std::max(first, second)]++] = { std::min(first, second), static_cast<int>(e), first > second };
  }
}

/** Row k of L has an entry in every column met on the way from an entry of A's row k up the elimination tree to k. */
void
BlockCholesky::findRowPatterns()
{
  const int        n = static_cast<int>(m_NewToOld.size());
  std::vector<int> parent(n, -1);
  std::vector<int> visited(n, -1);
  std::vector<int> path;
  std::vector<int> pattern;
  m_RowBegin.assign(1, 0);
  m_RowColumns.clear();
  for (int k = 0; k < n; ++k)
  {
    visited[k] = k;
    pattern.clear();
    for (std::size_t q = m_EntryBegin[k]; q < m_EntryBegin[k + 1]; ++q)
    {
      for (int i = m_Entries[q].row; visited[i] != k; i = parent[i])
      {
        visited[i] = k;
        pattern.push_back(i);
        if (parent[i] < 0)
        {
          parent[i] = k;
        }
      }
    }
    std::sort(pattern.begin(), pattern.end());
    m_RowColumns.insert(m_RowColumns.end(), pattern.begin(), pattern.end());
    m_RowBegin.push_back(m_RowColumns.size());
  }
}

void
BlockCholesky::findColumnPatterns()
{
  const std::size_t n = m_NewToOld.size();
  m_ColumnBegin.assign(n + 1, 0);
  for (const int column : m_RowColumns)
  {
    ++m_ColumnBegin[column + 1];
  }
  for (std::size_t i = 0; i < n; ++i)
  {
    m_ColumnBegin[i + 1] += m_ColumnBegin[i];
  }
  m_Rows.resize(m_RowColumns.size());
  std::vector<std::size_t> next(m_ColumnBegin.begin(), m_ColumnBegin.end() - 1);
  for (std::size_t k = 0; k < n; ++k)
  {
    for (std::size_t q = m_RowBegin[k]; q < m_RowBegin[k + 1]; ++q)
    {
      m_Rows[next[m_RowColumns[q]]++] = static_cast<int>(k);
    }
  }
}

/** Row k of L from rows 0 to k-1. With Y_i = L(k,i)^T the columns i are solved in ascending order:
 *   Y_i = L(i,i)^-1 (A(i,k) - sum_{j<i} L(i,j) Y_j),   L(k,k) L(k,k)^T = A(k,k) - sum_i Y_i^T Y_i. */
bool
BlockCholesky::eliminateRow(int k, const BlockVector & diagonal, const BlockVector & coupling)
{
  for (std::size_t q = m_EntryBegin[k]; q < m_EntryBegin[k + 1]; ++q)
  {
    const Entry & entry = m_Entries[q];
    m_Work[entry.row] = entry.transposed ? Block(coupling[entry.edge].transpose()) : coupling[entry.edge];
  }
  Block pivot = diagonal[m_NewToOld[k]];
  for (std::size_t q = m_RowBegin[k]; q < m_RowBegin[k + 1]; ++q)
  {
    const int   i = m_RowColumns[q];
    const Block Y = m_DiagonalInverse[i] * m_Work[i];
    m_Work[i].setZero();
    const std::size_t end = m_ColumnEnd[i]++;
    for (std::size_t p = m_ColumnBegin[i]; p < end; ++p)
    {
      m_Work[m_Rows[p]].noalias() -= m_Values[p] * Y;
    }
    pivot.noalias() -= Y.transpose() * Y;
    m_Values[end] = Y.transpose();
  }
  return invertCholesky(pivot, m_DiagonalInverse[k]);
}

void
BlockCholesky::factorize(const BlockVector & diagonal, const BlockVector & coupling)
{
  if (m_NewToOld.empty() || diagonal.size() != m_NewToOld.size() || coupling.size() != m_EdgeCount)
  {
    std::ostringstream message;
    message << "block Cholesky: " << diagonal.size() << " diagonal and " << coupling.size()
            << " coupling blocks, the pattern has " << m_NewToOld.size() << " and " << m_EdgeCount;
    throw InvalidInput(message.str());
  }
  m_Factorized = false;
  m_ColumnEnd.assign(m_ColumnBegin.begin(), m_ColumnBegin.end() - 1);
  for (int k = 0; k < static_cast<int>(m_NewToOld.size()); ++k)
  {
    if (!eliminateRow(k, diagonal, coupling))
    {
      // What an interrupted row leaves behind must not enter the next factorisation.
      std::fill(m_Work.begin(), m_Work.end(), Block::Zero());
      StepReport report;
      report.steps = k;
      report.note = "not positive definite";
      throw NotConverged("block Cholesky: the matrix is not positive definite", report);
    }
  }
  m_Factorized = true;
}

Eigen::VectorXd
BlockCholesky::solve(const Eigen::VectorXd & b) const
{
  const auto n = static_cast<Eigen::Index>(m_NewToOld.size());
  if (!m_Factorized || b.size() != 2 * n)
  {
    std::ostringstream message;
    message << "block Cholesky: right-hand side of " << b.size() << " entries, need " << (m_Factorized ? 2 * n : 0)
            << " (0: nothing was factorised)";
    throw InvalidInput(message.str());
  }
  Eigen::VectorXd y(2 * n);
  for (Eigen::Index k = 0; k < n; ++k)
  {
    y.segment<2>(2 * k) = b.segment<2>(2 * m_NewToOld[k]);
  }
  for (Eigen::Index i = 0; i < n; ++i)
  {
    const Eigen::Vector2d yi = m_DiagonalInverse[i] * y.segment<2>(2 * i);
    y.segment<2>(2 * i) = yi;
    for (std::size_t p = m_ColumnBegin[i]; p < m_ColumnBegin[i + 1]; ++p)
    {
      y.segment<2>(2 * m_Rows[p]).noalias() -= m_Values[p] * yi;
    }
  }
  for (Eigen::Index i = n; i-- > 0;)
  {
    Eigen::Vector2d sum = y.segment<2>(2 * i);
    for (std::size_t p = m_ColumnBegin[i]; p < m_ColumnBegin[i + 1]; ++p)
    {
      sum.noalias() -= m_Values[p].transpose() * y.segment<2>(2 * m_Rows[p]);
    }
    y.segment<2>(2 * i) = m_DiagonalInverse[i].transpose() * sum;
  }
  Eigen::VectorXd x(2 * n);
  for (Eigen::Index k = 0; k < n; ++k)
  {
    x.segment<2>(2 * m_NewToOld[k]) = y.segment<2>(2 * k);
  }
  if (!x.allFinite())
  {
    throw NotConverged("block Cholesky: the solution is not finite", StepReport{});
  }
  return x;
}

} // namespace moserhex
