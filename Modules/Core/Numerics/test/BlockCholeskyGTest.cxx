// Round-off class: a direct solver compared with another one; 1e-11 leaves room for condition numbers up to 1e4.
#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Random.h"
#include "moserhex/Numerics/BlockCholesky.h"
#include "moserhex/Numerics/SparseCholesky.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

using namespace moserhex;

namespace
{

struct BlockProblem
{
  std::size_t                           vertexCount{ 0 };
  std::vector<BlockCholesky::GraphEdge> edges;
  BlockCholesky::BlockVector            diagonal;
  BlockCholesky::BlockVector            coupling;
};

/** A random graph with random blocks, made positive definite by diagonal dominance. Edges run in both directions. */
BlockProblem
randomProblem(std::size_t vertexCount, std::size_t edgeCount, std::uint64_t seed)
{
  Random                        random(seed);
  BlockProblem                  problem;
  std::set<std::pair<int, int>> used;
  problem.vertexCount = vertexCount;
  problem.diagonal.assign(vertexCount, BlockCholesky::Block::Zero());
  while (problem.edges.size() < edgeCount)
  {
    const int i = static_cast<int>(random.next() % vertexCount);
    const int j = static_cast<int>(random.next() % vertexCount);
    if (i == j || !used.insert(std::minmax(i, j)).second)
    {
      continue;
    }
    BlockCholesky::Block block;
    for (Eigen::Index q = 0; q < 4; ++q)
    {
      block(q) = random.uniform(-1.0, 1.0);
    }
    problem.edges.push_back({ i, j });
    problem.coupling.push_back(block);
    for (const int v : { i, j })
    {
      problem.diagonal[v] += 2.0 * BlockCholesky::Block::Identity();
    }
  }
  for (BlockCholesky::Block & block : problem.diagonal)
  {
    block(0, 0) += 0.1;
    block(1, 1) += 0.2;
    block(0, 1) = block(1, 0) = 0.05;
  }
  return problem;
}

SparseCholesky::Matrix
asScalarMatrix(const BlockProblem & problem)
{
  std::vector<Eigen::Triplet<double>> triplets;
  const auto                          add = [&](int row, int column, const BlockCholesky::Block & block) {
    for (int r = 0; r < 2; ++r)
    {
      for (int c = 0; c < 2; ++c)
      {
        triplets.emplace_back(2 * row + r, 2 * column + c, block(r, c));
      }
    }
  };
  for (std::size_t v = 0; v < problem.vertexCount; ++v)
  {
    add(static_cast<int>(v), static_cast<int>(v), problem.diagonal[v]);
  }
  for (std::size_t e = 0; e < problem.edges.size(); ++e)
  {
    add(problem.edges[e][0], problem.edges[e][1], problem.coupling[e]);
    add(problem.edges[e][1], problem.edges[e][0], problem.coupling[e].transpose());
  }
  const auto             size = static_cast<Eigen::Index>(2 * problem.vertexCount);
  SparseCholesky::Matrix A(size, size);
  A.setFromTriplets(triplets.begin(), triplets.end());
  return A;
}

Eigen::VectorXd
rightHandSide(std::size_t vertexCount)
{
  Eigen::VectorXd b(static_cast<Eigen::Index>(2 * vertexCount));
  for (Eigen::Index i = 0; i < b.size(); ++i)
  {
    b[i] = std::cos(0.7 * static_cast<double>(i));
  }
  return b;
}

} // namespace

TEST(BlockCholesky, SolutionEqualsTheScalarSolver)
{
  for (const std::uint64_t seed : { 1u, 2u, 3u })
  {
    const BlockProblem           problem = randomProblem(200, 500, seed);
    const SparseCholesky::Matrix A = asScalarMatrix(problem);
    const Eigen::VectorXd        b = rightHandSide(problem.vertexCount);
    BlockCholesky                block;
    block.analyzePattern(problem.vertexCount, problem.edges);
    block.factorize(problem.diagonal, problem.coupling);
    SparseCholesky scalar;
    scalar.compute(A);
    const Eigen::VectorXd expected = scalar.solve(b);
    EXPECT_LT((block.solve(b) - expected).norm(), 1e-11 * expected.norm()) << "seed " << seed;
    EXPECT_LT(relativeResidual(A, block.solve(b), b), 1e-14) << "seed " << seed;
  }
}

TEST(BlockCholesky, VerticesWithoutEdgesAreSolvedOnTheirOwn)
{
  BlockCholesky cholesky;
  cholesky.analyzePattern(2, {});
  BlockCholesky::Block block;
  block << 4.0, 2.0, 2.0, 3.0;
  cholesky.factorize({ block, BlockCholesky::Block::Identity() }, {});
  const Eigen::VectorXd x = cholesky.solve(Eigen::Vector4d(8.0, 7.0, 5.0, 6.0));
  EXPECT_LT((x - Eigen::Vector4d(1.25, 1.5, 5.0, 6.0)).norm(), 1e-14);
}

TEST(BlockCholesky, FailedFactorisationLeavesNothingBehind)
{
  const BlockProblem    problem = randomProblem(100, 250, 7);
  const Eigen::VectorXd b = rightHandSide(problem.vertexCount);
  BlockCholesky         cholesky;
  cholesky.analyzePattern(problem.vertexCount, problem.edges);
  cholesky.factorize(problem.diagonal, problem.coupling);
  const Eigen::VectorXd before = cholesky.solve(b);

  BlockCholesky::BlockVector indefinite = problem.diagonal;
  indefinite[50] = -BlockCholesky::Block::Identity();
  EXPECT_THROW(cholesky.factorize(indefinite, problem.coupling), NotConverged);
  EXPECT_THROW((void)cholesky.solve(b), InvalidInput) << "nothing is factorised now";
  cholesky.factorize(problem.diagonal, problem.coupling);
  EXPECT_EQ(cholesky.solve(b), before) << "bit for bit";
}

TEST(BlockCholesky, NumberThatIsNotFiniteIsNotConverged)
{
  BlockProblem  problem = randomProblem(30, 60, 4);
  BlockCholesky cholesky;
  cholesky.analyzePattern(problem.vertexCount, problem.edges);
  problem.coupling[10](1, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(cholesky.factorize(problem.diagonal, problem.coupling), NotConverged);
}

TEST(BlockCholesky, SolutionThatIsNotFiniteIsNotConverged)
{
  BlockCholesky cholesky;
  cholesky.analyzePattern(1, {});
  cholesky.factorize({ BlockCholesky::Block::Identity() }, {});
  EXPECT_THROW((void)cholesky.solve(Eigen::Vector2d(std::numeric_limits<double>::infinity(), 0.0)), NotConverged);
}

TEST(BlockCholesky, WrongSizesAreRefused)
{
  BlockCholesky cholesky;
  EXPECT_THROW(cholesky.analyzePattern(0, {}), InvalidInput);
  EXPECT_THROW(cholesky.analyzePattern(2, { { 0, 2 } }), InvalidInput);
  EXPECT_THROW(cholesky.analyzePattern(2, { { 1, 1 } }), InvalidInput);
  EXPECT_THROW(cholesky.analyzePattern(2, { { -1, 1 } }), InvalidInput);
  cholesky.analyzePattern(2, { { 0, 1 } });
  EXPECT_THROW(cholesky.factorize({ BlockCholesky::Block::Identity() }, {}), InvalidInput);
  const BlockCholesky::BlockVector diagonal(2, BlockCholesky::Block::Identity());
  EXPECT_THROW(cholesky.factorize(diagonal, {}), InvalidInput);
  cholesky.factorize(diagonal, { BlockCholesky::Block::Zero() });
  EXPECT_THROW((void)cholesky.solve(Eigen::VectorXd::Ones(3)), InvalidInput);
}
