#pragma once

#include "moserhex/Common/InstructionSets.h"

#include <cmath>
#include <cstddef>
#include <cstring>

namespace moserhex
{

/** Eight numbers worked on together: the same quantity of eight neighbours. */
constexpr std::size_t laneCount = 8;
/** Elementwise arithmetic with + - * / and comparisons, which give a mask. */
using Lanes = double __attribute__((vector_size(8 * laneCount)));
using LaneMask = long long __attribute__((vector_size(8 * laneCount))); ///< all bits set: yes

/** The same value in every lane. */
MOSERHEX_INLINE Lanes
allLanes(double value)
{
  return Lanes{} + value;
}

/** From laneCount neighbouring numbers, at any alignment. */
MOSERHEX_INLINE Lanes
loadLanes(const double * from)
{
  Lanes lanes;
  std::memcpy(&lanes, from, sizeof lanes);
  return lanes;
}

/** To laneCount neighbouring numbers, at any alignment. */
MOSERHEX_INLINE void
storeLanes(double * to, Lanes lanes)
{
  std::memcpy(to, &lanes, sizeof lanes);
}

/** Adds the lanes to laneCount neighbouring numbers. */
MOSERHEX_INLINE void
addLanes(double * to, Lanes lanes)
{
  storeLanes(to, loadLanes(to) + lanes);
}

/** Lane by lane: yes ? a : b. What is not taken may be NaN. */
MOSERHEX_INLINE Lanes
select(LaneMask yes, Lanes a, Lanes b)
{
  return reinterpret_cast<Lanes>((reinterpret_cast<LaneMask>(a) & yes) | (reinterpret_cast<LaneMask>(b) & ~yes));
}

/** Lane by lane, correctly rounded. */
MOSERHEX_INLINE Lanes
squareRoot(Lanes x)
{
  Lanes root;
  for (std::size_t lane = 0; lane < laneCount; ++lane)
  {
    root[lane] = std::sqrt(x[lane]);
  }
  return root;
}

/** Sum over the lanes, in order. */
MOSERHEX_INLINE double
sumOfLanes(Lanes x)
{
  double sum = 0.0;
  for (std::size_t lane = 0; lane < laneCount; ++lane)
  {
    sum += x[lane];
  }
  return sum;
}

} // namespace moserhex
