#pragma once

#include <cmath>
#include <cstddef>
#include <cstring>

#if !defined(__GNUC__)
#  error "moserhex needs the vector extensions of GCC or Clang"
#endif

/** Compiles a kernel for several instruction sets and picks one when the program starts. All give the same bits: the
 * lanes are independent, their number is fixed, and multiply-add contraction is off for these files. Not with the
 * sanitizers, whose runtime is not up when the choice is made. */
#if defined(__x86_64__) && defined(__gnu_linux__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#  define MOSERHEX_KERNEL __attribute__((target_clones("default", "avx2", "avx512f")))
#else
#  define MOSERHEX_KERNEL
#endif

#define MOSERHEX_INLINE inline __attribute__((always_inline))

namespace moserhex
{

/** Eight numbers worked on together: the same quantity of eight neighbours. */
constexpr std::size_t laneCount = 8;
using Lanes = double __attribute__((vector_size(8 * laneCount)));
using LaneMask = long long __attribute__((vector_size(8 * laneCount))); ///< all bits set: yes

MOSERHEX_INLINE Lanes
allLanes(double value)
{
  return Lanes{} + value;
}

MOSERHEX_INLINE Lanes
loadLanes(const double * from)
{
  Lanes lanes;
  std::memcpy(&lanes, from, sizeof lanes);
  return lanes;
}

MOSERHEX_INLINE void
storeLanes(double * to, Lanes lanes)
{
  std::memcpy(to, &lanes, sizeof lanes);
}

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
