#pragma once

#include <cstddef>
#include <limits>
#include <vector>

namespace moserhex
{

/** The lowest of parabolas v + (s (q - p))^2 with their apexes p along a line of voxels of side s (Felzenszwalb and
 * Huttenlocher 2012): the squared distance transform of a line in linear time. */
class LowerEnvelope
{
public:
  /** \param most  parabolas at a time, beside two that bound them */
  LowerEnvelope(std::size_t most, double spacing)
    : m_SquaredSpacing(spacing * spacing), m_Apex(most + 2), m_From(most + 2), m_Value(most + 2)
  {}

  void
  clear()
  {
    m_Last = -1;
  }

  /** Apexes must be added in ascending order. An infinite value adds nothing. */
  void
  add(int apex, double value)
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (!(value < infinity))
    {
      return;
    }
    double from = -infinity; // the new parabola is the lowest from here on
    for (; m_Last >= 0; --m_Last)
    {
      const auto last = static_cast<std::size_t>(m_Last);
      const int  p = m_Apex[last];
      from = 0.5 * (p + apex) + (value - m_Value[last]) / (2.0 * m_SquaredSpacing * (apex - p));
      if (from > m_From[last])
      {
        break;
      }
    }
    const auto last = static_cast<std::size_t>(++m_Last);
    m_Apex[last] = apex;
    m_Value[last] = value;
    m_From[last] = m_Last == 0 ? -infinity : from;
  }

  /** body(q, apex of the lowest parabola, its value at q) for q in [begin, end), in order; nothing without parabolas.
   */
  template <typename TBody>
  void
  evaluate(int begin, int end, TBody body) const
  {
    if (m_Last < 0)
    {
      return;
    }
    const auto  last = static_cast<std::size_t>(m_Last);
    std::size_t current = 0;
    for (int q = begin; q < end; ++q)
    {
      while (current < last && m_From[current + 1] < q)
      {
        ++current;
      }
      const double steps = q - m_Apex[current];
      body(q, m_Apex[current], m_SquaredSpacing * steps * steps + m_Value[current]);
    }
  }

private:
  double              m_SquaredSpacing;
  int                 m_Last{ -1 }; ///< the envelope's last parabola
  std::vector<int>    m_Apex;
  std::vector<double> m_From;  ///< where it becomes the lowest
  std::vector<double> m_Value; ///< at its apex
};

} // namespace moserhex
