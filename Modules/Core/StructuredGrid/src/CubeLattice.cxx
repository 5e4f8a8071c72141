#include "moserhex/StructuredGrid/CubeLattice.h"

#include "moserhex/Common/Errors.h"

#include <algorithm>
#include <cstdlib>
#include <string>

namespace moserhex
{
namespace
{
constexpr int maximumShells = 500;

/** Number of an index triple in a box of `side` entries a side, first index fastest. */
std::size_t
boxNumber(int side, int i, int j, int k)
{
  const auto n = static_cast<std::size_t>(side);
  return static_cast<std::size_t>(i) + n * (static_cast<std::size_t>(j) + n * static_cast<std::size_t>(k));
}

std::array<int, 3>
boxIndex(int side, std::size_t number)
{
  const auto n = static_cast<std::size_t>(side);
  return { static_cast<int>(number % n), static_cast<int>(number / n % n), static_cast<int>(number / n / n) };
}
} // namespace

CubeLattice::CubeLattice(int shells) : m_Shells(shells)
{
  if (shells < 1 || shells > maximumShells)
  {
    throw InvalidInput("number of shells " + std::to_string(shells) + ", must be 1 to " +
                       std::to_string(maximumShells));
  }
}

std::size_t
CubeLattice::nodeCount() const
{
  const auto n = static_cast<std::size_t>(nodesPerSide());
  return n * n * n;
}

std::size_t
CubeLattice::cellCount() const
{
  const auto m = static_cast<std::size_t>(nodesPerSide() - 1);
  return m * m * m;
}

std::size_t
CubeLattice::nodeNumber(int i, int j, int k) const
{
  return boxNumber(nodesPerSide(), i, j, k);
}

std::array<int, 3>
CubeLattice::nodeIndex(std::size_t node) const
{
  return boxIndex(nodesPerSide(), node);
}

int
CubeLattice::shellOfNode(std::size_t node) const
{
  int largest = 0;
  for (const int index : nodeIndex(node))
  {
    largest = std::max(largest, std::abs(2 * index - (nodesPerSide() - 1)));
  }
  return (largest + 1) / 2;
}

int
CubeLattice::shellOfCell(std::size_t cell) const
{
  int largest = 0;
  for (const int index : boxIndex(nodesPerSide() - 1, cell))
  {
    largest = std::max(largest, std::abs(index - (m_Shells - 1)));
  }
  return largest + 1;
}

std::vector<std::size_t>
CubeLattice::nodesOfShell(int shell) const
{
  requireShell(shell);
  const int                low = m_Shells - shell;
  const int                high = m_Shells + shell - 1;
  std::vector<std::size_t> nodes;
  nodes.reserve(static_cast<std::size_t>(6 * (2 * shell - 1) * (2 * shell - 1) + 2));
  for (int k = low; k <= high; ++k)
  {
    for (int j = low; j <= high; ++j)
    {
      const bool wholeRow = k == low || k == high || j == low || j == high;
      for (int i = low; i <= high; i += wholeRow ? 1 : high - low)
      {
        nodes.push_back(nodeNumber(i, j, k));
      }
    }
  }
  return nodes;
}

std::vector<Quad>
CubeLattice::quadsOfShell(int shell) const
{
  requireShell(shell);
  const int         low = m_Shells - shell;
  const int         high = m_Shells + shell - 1;
  std::vector<Quad> quads;
  quads.reserve(static_cast<std::size_t>(6 * (high - low) * (high - low)));
  for (int axis = 0; axis < 3; ++axis)
  {
    const int first = (axis + 1) % 3;
    const int second = (axis + 2) % 3;
    for (const bool upper : { false, true })
    {
      const auto node = [&](int a, int b) {
        std::array<int, 3> index{};
        index[static_cast<std::size_t>(axis)] = upper ? high : low;
        index[static_cast<std::size_t>(first)] = a;
        index[static_cast<std::size_t>(second)] = b;
        return nodeNumber(index[0], index[1], index[2]);
      };
      for (int b = low; b < high; ++b)
      {
        for (int a = low; a < high; ++a)
        {
          Quad quad{ node(a, b), node(a + 1, b), node(a + 1, b + 1), node(a, b + 1) };
          if (!upper)
          {
            std::swap(quad[1], quad[3]);
          }
          quads.push_back(quad);
        }
      }
    }
  }
  return quads;
}

Vector3
CubeLattice::position(std::size_t node) const
{
  const auto   index = nodeIndex(node);
  const double last = nodesPerSide() - 1;
  return { (2 * index[0] - last) / last, (2 * index[1] - last) / last, (2 * index[2] - last) / last };
}

Vector3
CubeLattice::positionOnShell(std::size_t node) const
{
  const auto   index = nodeIndex(node);
  const double last = nodesPerSide() - 1;
  const double size = 2 * shellOfNode(node) - 1;
  return { (2 * index[0] - last) / size, (2 * index[1] - last) / size, (2 * index[2] - last) / size };
}

double
CubeLattice::relativeSize(int shell) const
{
  requireShell(shell);
  return (2.0 * shell - 1.0) / (2.0 * m_Shells - 1.0);
}

void
CubeLattice::requireShell(int shell) const
{
  if (shell < 1 || shell > m_Shells)
  {
    throw InvalidInput("shell number " + std::to_string(shell) + ", must be 1 to " + std::to_string(m_Shells));
  }
}

} // namespace moserhex
