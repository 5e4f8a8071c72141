#pragma once

#include "moserhex/Common/Lanes.h"

namespace moserhex
{

/** x^(-1/3) for x > 0: a guess from the exponent's bits, then Newton's y (4 - x y^3) / 3, which gains a factor of two
 * in digits a step; four steps reach round-off. */
MOSERHEX_INLINE Lanes
inverseCubeRoot(Lanes x)
{
  const Lanes    third = allLanes(1.0 / 3.0);
  const LaneMask bits = reinterpret_cast<LaneMask>(x);
  const Lanes    scaled = __builtin_convertvector(bits, Lanes) * third;
  Lanes          y = reinterpret_cast<Lanes>(0x553EF0FF289DD796LL - __builtin_convertvector(scaled, LaneMask));
  for (int step = 0; step < 4; ++step)
  {
    y = y * (4.0 - x * y * y * y) * third;
  }
  return y;
}

/** Eight vectors. */
struct LaneVector
{
  Lanes x;
  Lanes y;
  Lanes z;
};

MOSERHEX_INLINE LaneVector
operator+(const LaneVector & a, const LaneVector & b)
{
  return { a.x + b.x, a.y + b.y, a.z + b.z };
}

MOSERHEX_INLINE LaneVector
operator-(const LaneVector & a, const LaneVector & b)
{
  return { a.x - b.x, a.y - b.y, a.z - b.z };
}

MOSERHEX_INLINE LaneVector
operator*(Lanes s, const LaneVector & a)
{
  return { s * a.x, s * a.y, s * a.z };
}

MOSERHEX_INLINE void
operator+=(LaneVector & a, const LaneVector & b)
{
  a = a + b;
}

MOSERHEX_INLINE void
operator-=(LaneVector & a, const LaneVector & b)
{
  a = a - b;
}

MOSERHEX_INLINE Lanes
dot(const LaneVector & a, const LaneVector & b)
{
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

MOSERHEX_INLINE LaneVector
cross(const LaneVector & a, const LaneVector & b)
{
  return { a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x };
}

} // namespace moserhex
