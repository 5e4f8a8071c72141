#include "VoxelParts.h"

#include <algorithm>

namespace moserhex::detail
{
namespace
{

std::int32_t
rootOf(std::vector<Run> & runs, std::int32_t run)
{
  auto at = [&](std::int32_t r) -> std::int32_t & { return runs[static_cast<std::size_t>(r)].part; };
  while (at(run) != run)
  {
    at(run) = at(at(run));
    run = at(run);
  }
  return run;
}

/** The smaller root becomes the root of both, so a part's root is its first run. */
void
join(std::vector<Run> & runs, std::int32_t a, std::int32_t b)
{
  a = rootOf(runs, a);
  b = rootOf(runs, b);
  runs[static_cast<std::size_t>(std::max(a, b))].part = std::min(a, b);
}

/** Runs of all rows; firstOfRow[r] .. firstOfRow[r + 1] are those of row r = j + size[1] k. */
std::vector<Run>
findRuns(const LabelVolume & label, bool inside, std::vector<std::size_t> & firstOfRow)
{
  const auto       length = static_cast<std::size_t>(label.size[0]);
  std::vector<Run> runs;
  for (std::size_t row = 0; row < label.inside.size(); row += length)
  {
    firstOfRow.push_back(runs.size());
    for (std::size_t voxel = row; voxel < row + length; ++voxel)
    {
      if ((label.inside[voxel] != 0) != inside)
      {
        continue;
      }
      if (runs.size() > firstOfRow.back() && runs.back().end == voxel)
      {
        ++runs.back().end;
      }
      else
      {
        runs.push_back({ voxel, voxel + 1, static_cast<std::int32_t>(runs.size()) });
      }
    }
  }
  firstOfRow.push_back(runs.size());
  return runs;
}

/** Joins the runs of two rows, rowA > rowB, that overlap, or touch at their ends when `reach` is 1. */
void
joinRows(std::vector<Run> &               runs,
         const std::vector<std::size_t> & firstOfRow,
         std::size_t                      rowA,
         std::size_t                      rowB,
         std::size_t                      length,
         std::size_t                      reach)
{
  std::size_t       a = firstOfRow[rowA];
  std::size_t       b = firstOfRow[rowB];
  const std::size_t offset = (rowA - rowB) * length;
  while (a < firstOfRow[rowA + 1] && b < firstOfRow[rowB + 1])
  {
    const std::size_t beginB = runs[b].begin + offset;
    const std::size_t endB = runs[b].end + offset;
    if (runs[a].begin < endB + reach && beginB < runs[a].end + reach)
    {
      join(runs, static_cast<std::int32_t>(a), static_cast<std::int32_t>(b));
    }
    (runs[a].end < endB ? a : b) += 1;
  }
}

} // namespace

Parts
connectedParts(const LabelVolume & label, bool inside, Adjacency adjacency)
{
  const auto               length = static_cast<std::size_t>(label.size[0]);
  const auto               ny = static_cast<std::size_t>(label.size[1]);
  const auto               nz = static_cast<std::size_t>(label.size[2]);
  const bool               diagonal = adjacency == Adjacency::FacesEdgesAndCorners;
  const std::size_t        reach = diagonal ? 1 : 0;
  std::vector<std::size_t> firstOfRow;
  Parts                    parts;
  parts.runs = findRuns(label, inside, firstOfRow);
  const auto joinTo = [&](std::size_t row, std::size_t other) {
    joinRows(parts.runs, firstOfRow, row, other, length, reach);
  };
  for (std::size_t k = 0; k < nz; ++k)
  {
    for (std::size_t j = 0; j < ny; ++j)
    {
      const std::size_t row = j + ny * k;
      if (j > 0)
      {
        joinTo(row, row - 1);
      }
      if (k > 0)
      {
        joinTo(row, row - ny);
        if (diagonal && j > 0)
        {
          joinTo(row, row - ny - 1);
        }
        if (diagonal && j + 1 < ny)
        {
          joinTo(row, row - ny + 1);
        }
      }
    }
  }
  std::vector<std::int32_t> partOfRoot(parts.runs.size(), -1);
  for (std::size_t run = 0; run < parts.runs.size(); ++run)
  {
    std::int32_t & part = partOfRoot[static_cast<std::size_t>(rootOf(parts.runs, static_cast<std::int32_t>(run)))];
    if (part < 0)
    {
      part = static_cast<std::int32_t>(parts.voxels.size());
      parts.voxels.push_back(0);
    }
    partOfRoot[run] = part;
  }
  for (std::size_t run = 0; run < parts.runs.size(); ++run)
  {
    Run & current = parts.runs[run];
    current.part = partOfRoot[run];
    parts.voxels[static_cast<std::size_t>(current.part)] += current.end - current.begin;
  }
  return parts;
}

std::vector<std::uint8_t>
partsAtBorder(const LabelVolume & label, const Parts & parts)
{
  const auto                length = static_cast<std::size_t>(label.size[0]);
  const auto                ny = static_cast<std::size_t>(label.size[1]);
  const auto                nz = static_cast<std::size_t>(label.size[2]);
  std::vector<std::uint8_t> open(parts.voxels.size(), 0);
  for (const Run & run : parts.runs)
  {
    const std::size_t row = run.begin / length;
    const std::size_t j = row % ny;
    const std::size_t k = row / ny;
    if (run.begin == row * length || run.end == (row + 1) * length || j == 0 || j == ny - 1 || k == 0 || k == nz - 1)
    {
      open[static_cast<std::size_t>(run.part)] = 1;
    }
  }
  return open;
}

} // namespace moserhex::detail
