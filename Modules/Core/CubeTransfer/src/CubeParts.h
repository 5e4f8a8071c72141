#pragma once

#include "moserhex/Common/Types.h"

#include <cstddef>
#include <vector>

namespace moserhex
{

/** What one cell has of an interval, along one axis: local coordinates begin to end in [0,1]. */
struct CellPart
{
  int    cell;
  double begin;
  double end;
};

/** The parts in cells of each of `intervals` equal intervals of [0,1], which has `cells` equal cells. */
[[nodiscard]] inline std::vector<std::vector<CellPart>>
partsInCells(int intervals, int cells)
{
  // In units of 1 / (intervals * cells) all ends are whole numbers.
  std::vector<std::vector<CellPart>> parts(static_cast<std::size_t>(intervals));
  for (int i = 0; i < intervals; ++i)
  {
    const int begin = i * cells;
    const int end = begin + cells;
    for (int cell = begin / intervals; cell * intervals < end; ++cell)
    {
      const int    first = cell * intervals;
      const double from = begin > first ? static_cast<double>(begin - first) / intervals : 0.0;
      const double to = end < first + intervals ? static_cast<double>(end - first) / intervals : 1.0;
      parts[static_cast<std::size_t>(i)].push_back({ cell, from, to });
    }
  }
  return parts;
}

/** Calls visit(cell, lower, sides) for every part of box number `box` of N^3: the cell's number, the local coordinates
 * of the part's lower corner and its sides. */
template <typename TVisit>
void
forPartsOfBox(const std::vector<std::vector<CellPart>> & parts, std::size_t box, int cells, const TVisit & visit)
{
  const std::size_t n = parts.size();
  const auto        m = static_cast<std::size_t>(cells);
  for (const CellPart & c : parts[box / (n * n)])
  {
    for (const CellPart & b : parts[box / n % n])
    {
      for (const CellPart & a : parts[box % n])
      {
        const std::size_t cell = static_cast<std::size_t>(a.cell) +
                                 m * (static_cast<std::size_t>(b.cell) + m * static_cast<std::size_t>(c.cell));
        visit(cell, Vector3(a.begin, b.begin, c.begin), Vector3(a.end - a.begin, b.end - b.begin, c.end - c.begin));
      }
    }
  }
}

} // namespace moserhex
