#include "moserhex/LevelSet/KuhnConnectivity.h"

#include "moserhex/Common/Errors.h"

namespace moserhex
{
namespace
{

constexpr unsigned int linkSize = 14;
constexpr unsigned int fullLink = (1u << linkSize) - 1u;

/** Two nodes are neighbours when their difference is one of the 14 offsets: all coordinates 0/1 or all 0/-1. */
bool
areNeighbours(const std::array<int, 3> & a, const std::array<int, 3> & b)
{
  bool positive = false;
  bool negative = false;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const int difference = a[axis] - b[axis];
    if (difference < -1 || difference > 1)
    {
      return false;
    }
    positive = positive || difference > 0;
    negative = negative || difference < 0;
  }
  return positive != negative;
}

using Adjacency = std::array<unsigned int, linkSize>;

Adjacency
linkAdjacency()
{
  Adjacency adjacency{};
  for (unsigned int a = 0; a < linkSize; ++a)
  {
    for (unsigned int b = 0; b < linkSize; ++b)
    {
      if (areNeighbours(kuhnOffsets[a], kuhnOffsets[b]))
      {
        adjacency[a] |= 1u << b;
      }
    }
  }
  return adjacency;
}

bool
isConnectedAndNotEmpty(unsigned int set, const Adjacency & adjacency)
{
  unsigned int reached = set & (~set + 1u);
  for (unsigned int before = 0; before != reached;)
  {
    before = reached;
    for (unsigned int a = 0; a < linkSize; ++a)
    {
      if ((before >> a & 1u) != 0)
      {
        reached |= adjacency[a] & set;
      }
    }
  }
  return set != 0 && reached == set;
}

std::vector<std::uint8_t>
makeSimpleTable()
{
  const Adjacency           adjacency = linkAdjacency();
  std::vector<std::uint8_t> table(fullLink + 1u);
  for (unsigned int mask = 0; mask <= fullLink; ++mask)
  {
    table[mask] = isConnectedAndNotEmpty(mask, adjacency) && isConnectedAndNotEmpty(~mask & fullLink, adjacency);
  }
  return table;
}

const std::vector<std::uint8_t> &
simpleTable()
{
  static const std::vector<std::uint8_t> table = makeSimpleTable();
  return table;
}

} // namespace

bool
isSimpleLink(unsigned int linkMask)
{
  return simpleTable()[linkMask & fullLink] != 0;
}

KuhnConnectivity::KuhnConnectivity(const RegularGrid & grid) : m_IsSimple(simpleTable().data())
{
  for (std::size_t a = 0; a < linkSize; ++a)
  {
    m_Strides[a] = grid.stride(kuhnOffsets[a][0], kuhnOffsets[a][1], kuhnOffsets[a][2]);
  }
}

long
kuhnEulerCharacteristic(const RegularGrid & grid, const std::vector<std::uint8_t> & inside)
{
  requireValid(grid, "Euler characteristic");
  if (inside.size() != grid.nodeCount())
  {
    throw InvalidInput("Euler characteristic: " + std::to_string(inside.size()) + " entries for " +
                       std::to_string(grid.nodeCount()) + " nodes");
  }
  // A simplex is a chain of corners 0 < m1 < m2 < ... (as sets of bits) that starts at its smallest node. By the set of
  // inside corners of the cube that starts at a node: the alternating sum over the chains that start there.
  const auto contains = [](unsigned int large, unsigned int small) {
    return (large & small) == small && large != small;
  };
  std::array<int, 128> chains{}; // by the set of inside corners 1..7, bit m-1
  for (unsigned int set = 0; set < 128; ++set)
  {
    const auto has = [&](unsigned int corner) { return (set >> (corner - 1) & 1u) != 0; };
    int        sum = 1;
    for (unsigned int a = 1; a < 8; ++a)
    {
      sum -= has(a) ? 1 : 0;
      for (unsigned int b = 1; b < 8; ++b)
      {
        sum += has(a) && has(b) && contains(b, a) ? 1 : 0;
        sum -= has(a) && has(b) && has(7) && contains(b, a) && contains(7, b) ? 1 : 0;
      }
    }
    chains[set] = sum;
  }
  long euler = 0;
  for (int k = 0; k < grid.size[2]; ++k)
  {
    for (int j = 0; j < grid.size[1]; ++j)
    {
      for (int i = 0; i < grid.size[0]; ++i)
      {
        const std::size_t node = grid.nodeNumber(i, j, k);
        if (inside[node] == 0)
        {
          continue;
        }
        unsigned int set = 0;
        for (unsigned int m = 1; m < 8; ++m)
        {
          const int  a = i + static_cast<int>(m & 1u);
          const int  b = j + static_cast<int>(m >> 1 & 1u);
          const int  c = k + static_cast<int>(m >> 2);
          const bool exists = a < grid.size[0] && b < grid.size[1] && c < grid.size[2];
          set |= static_cast<unsigned int>(exists && inside[grid.nodeNumber(a, b, c)] != 0) << (m - 1);
        }
        euler += chains[set];
      }
    }
  }
  return euler;
}

} // namespace moserhex
