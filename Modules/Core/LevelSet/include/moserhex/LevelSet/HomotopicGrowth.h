#pragma once

#include "moserhex/LevelSet/LevelSet.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace moserhex
{

/** Options of homotopicGrowth. */
struct HomotopicGrowthOptions
{
  /** Nodes that may be added, one entry per node; empty: all. */
  std::vector<std::uint8_t> allowed;

  /** Nodes with a larger value are not added: growth of a band is faster than growth of the box. */
  double stopAbove{ std::numeric_limits<double>::infinity() };

  /** Value given to nodes that were never added: the border, nodes not allowed, and nodes that never became simple. */
  double valueOfOthers{ std::numeric_limits<double>::infinity() };
};

/** What homotopicGrowth made. */
struct HomotopicGrowthResult
{
  LevelSet    levelSet;       ///< t
  std::size_t added{ 0 };     ///< nodes that became part of the ball
  std::size_t postponed{ 0 }; ///< times a node was met that was not simple; 0: f itself has no other critical node
};

/** Grows a ball node by node in the order of f (ties by node number); a node that is not simple waits until it is.
 *
 *   t(v) = max(f(v), next number above the t of the node added before v)
 *
 * so t >= f, every set {t < c} is a ball in the Kuhn complex, and every level set of the piecewise linear t is one
 * sphere (see KuhnConnectivity.h). Levels c must lie below stopAbove, valueOfOthers and the largest added value.
 *
 * \param f     values of any unit; +infinity is never added
 * \param seed  node number, not on the border and allowed
 * \throws InvalidInput  invalid level set, seed out of range, on the border or not allowed, or `allowed` of wrong size
 * \note O(n log n), deterministic. Growth cuts tunnels and leaves islands out: {t < c} is a subset of {f < c}. */
[[nodiscard]] HomotopicGrowthResult
homotopicGrowth(const LevelSet & f, std::size_t seed, const HomotopicGrowthOptions & options = {});

/** The mirror: the outside grows from the border of the box inwards, in the order of -f.
 *
 * t <= f, every {t < c} is a ball and a superset of {f < c}: tunnels are filled, islands joined, cavities filled.
 * The nodes that remain at the end (at least one) all get the smallest value.
 * \throws InvalidInput  invalid level set, or a value that is not finite */
[[nodiscard]] LevelSet
homotopicShrink(const LevelSet & f);

} // namespace moserhex
