#include "SurfacePoints.h"

#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace moserhex
{
namespace
{

/** A plane that cuts a cubic grid of spacing h is crossed by (|n_x| + |n_y| + |n_z|) / h^2 edges per area, by 3/2 in
 * the mean over all directions of its unit normal n. */
constexpr double crossingsPerArea = 1.5;

/** The box grows by this part of its length, and at most so often: to forty times its length. */
constexpr double growthOfBox = 0.25;
constexpr int    largestNumberOfGrowths = 16;
/** A surface this much larger than its volume lets one expect is not a solid's. */
constexpr std::size_t largestNumberOfSamples = std::size_t{ 1 } << 28;

constexpr int bisections = 12;

using Counts = std::array<std::size_t, 3>;

/** phi on a cubic grid. */
class SampledBox
{
public:
  SampledBox(const Positions & around, double spacing) : m_Lower(around.front()), m_Spacing(spacing)
  {
    Vector3 upper = around.front();
    for (const Vector3 & p : around)
    {
      m_Lower = m_Lower.cwiseMin(p);
      upper = upper.cwiseMax(p);
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      m_Counts[axis] = 3 + static_cast<std::size_t>(std::ceil((upper[axis] - m_Lower[axis]) / spacing));
      m_Lower[axis] -= spacing;
    }
  }

  void
  sample(const SignedDistance & phi, unsigned int threads)
  {
    if (static_cast<double>(m_Counts[0]) * static_cast<double>(m_Counts[1]) * static_cast<double>(m_Counts[2]) >
        static_cast<double>(largestNumberOfSamples))
    {
      throw InvalidInput("equalisation: the lattice is far larger than the volume");
    }
    m_IsInside.assign(m_Counts[0] * m_Counts[1] * m_Counts[2], 0);
    parallelFor(m_Counts[2], threads, [&](std::size_t k) {
      Vector3 unused;
      for (std::size_t j = 0; j < m_Counts[1]; ++j)
      {
        for (std::size_t i = 0; i < m_Counts[0]; ++i)
        {
          m_IsInside[number({ i, j, k })] = phi(place({ i, j, k }), unused) <= 0.0 ? 1 : 0;
        }
      }
    });
  }

  /** Moves the faces that the solid reaches outwards; false when there is none. */
  [[nodiscard]] bool
  grow()
  {
    const Counts        counts = m_Counts;
    std::array<bool, 3> below{};
    std::array<bool, 3> above{};
    const auto          isInside = [this](std::size_t i, std::size_t j, std::size_t k) {
      return m_IsInside[number({ i, j, k })] != 0;
    };
    for (std::size_t k = 0; k < counts[2]; ++k)
    {
      for (std::size_t j = 0; j < counts[1]; ++j)
      {
        below[0] = below[0] || isInside(0, j, k);
        above[0] = above[0] || isInside(counts[0] - 1, j, k);
      }
      for (std::size_t i = 0; i < counts[0]; ++i)
      {
        below[1] = below[1] || isInside(i, 0, k);
        above[1] = above[1] || isInside(i, counts[1] - 1, k);
      }
    }
    for (std::size_t j = 0; j < counts[1]; ++j)
    {
      for (std::size_t i = 0; i < counts[0]; ++i)
      {
        below[2] = below[2] || isInside(i, j, 0);
        above[2] = above[2] || isInside(i, j, counts[2] - 1);
      }
    }
    bool grows = false;
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto more = 2 + static_cast<std::size_t>(growthOfBox * static_cast<double>(counts[axis]));
      m_Lower[axis] -= below[axis] ? static_cast<double>(more) * m_Spacing : 0.0;
      m_Counts[axis] += (below[axis] ? more : 0) + (above[axis] ? more : 0);
      grows = grows || below[axis] || above[axis];
    }
    return grows;
  }

  /** Where the grid's edges cross the surface. */
  [[nodiscard]] Positions
  crossings(const SignedDistance & phi) const
  {
    Positions points;
    for (std::size_t k = 0; k < m_Counts[2]; ++k)
    {
      for (std::size_t j = 0; j < m_Counts[1]; ++j)
      {
        for (std::size_t i = 0; i < m_Counts[0]; ++i)
        {
          const Counts at{ i, j, k };
          for (std::size_t axis = 0; axis < 3; ++axis)
          {
            Counts next = at;
            ++next[axis];
            if (next[axis] < m_Counts[axis] && m_IsInside[number(at)] != m_IsInside[number(next)])
            {
              points.push_back(m_IsInside[number(at)] != 0 ? crossing(phi, place(at), place(next))
                                                           : crossing(phi, place(next), place(at)));
            }
          }
        }
      }
    }
    return points;
  }

private:
  [[nodiscard]] std::size_t
  number(const Counts & at) const
  {
    return at[0] + m_Counts[0] * (at[1] + m_Counts[1] * at[2]);
  }

  [[nodiscard]] Vector3
  place(const Counts & at) const
  {
    return m_Lower +
           m_Spacing * Vector3(static_cast<double>(at[0]), static_cast<double>(at[1]), static_cast<double>(at[2]));
  }

  static Vector3
  crossing(const SignedDistance & phi, Vector3 inside, Vector3 outside)
  {
    Vector3 unused;
    for (int step = 0; step < bisections; ++step)
    {
      const Vector3 middle = 0.5 * (inside + outside);
      (phi(middle, unused) <= 0.0 ? inside : outside) = middle;
    }
    return 0.5 * (inside + outside);
  }

  Vector3           m_Lower;
  double            m_Spacing;
  Counts            m_Counts{};
  std::vector<char> m_IsInside;
};

} // namespace

Positions
surfacePoints(const Positions &      around,
              const SignedDistance & phi,
              double                 volume,
              std::size_t            count,
              unsigned int           threads)
{
  const double areaOfBall = std::cbrt(36.0 * pi * volume * volume);
  SampledBox   box(around, std::sqrt(crossingsPerArea * areaOfBall / static_cast<double>(count)));
  box.sample(phi, threads);
  for (int growth = 0; box.grow(); ++growth)
  {
    if (growth == largestNumberOfGrowths)
    {
      throw InvalidInput(
        ErrorCode::Shape,
        "equalisation: the surface is not closed around the start: the solid goes on far outside the lattice");
    }
    box.sample(phi, threads);
  }
  Positions points = box.crossings(phi);
  if (points.empty())
  {
    throw InvalidInput("equalisation: there is no surface where the lattice is");
  }
  return points;
}

} // namespace moserhex
