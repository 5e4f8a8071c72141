#include "moserhex/LevelSet/VoxelTopology.h"

#include <algorithm>

namespace moserhex
{
namespace
{

enum class Adjacency
{
  Faces,               ///< 6 neighbours
  FacesEdgesAndCorners ///< 26 neighbours
};

/** Voxels [begin, end) of one kind along axis 0, numbered through the whole volume. */
struct Run
{
  std::size_t  begin;
  std::size_t  end;
  std::int32_t part; ///< parent run while parts are joined, number of the part afterwards
};

/** Connected parts of the voxels of one kind, as runs; parts are numbered in voxel order. */
struct Parts
{
  std::vector<Run>         runs;
  std::vector<std::size_t> voxels; ///< per part
};

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

/** vertices - edges + squares - cubes of the complex of voxels joined by faces; the label has an empty margin of one
 * voxel. Each cell is counted at its voxel of smallest index. */
long
faceConnectedEulerCharacteristic(const LabelVolume & padded)
{
  const auto        along = [&](int di, int dj, int dk) { return padded.voxelNumber(di, dj, dk); };
  const std::size_t x = along(1, 0, 0);
  const std::size_t y = along(0, 1, 0);
  const std::size_t z = along(0, 0, 1);
  const auto &      in = padded.inside;
  long              euler = 0;
  for (std::size_t v = 0; v + x + y + z < in.size(); ++v)
  {
    if (in[v] == 0)
    {
      continue;
    }
    const bool hasX = in[v + x] != 0;
    const bool hasY = in[v + y] != 0;
    const bool hasZ = in[v + z] != 0;
    const bool squareXY = hasX && hasY && in[v + x + y] != 0;
    const bool squareYZ = hasY && hasZ && in[v + y + z] != 0;
    const bool squareXZ = hasX && hasZ && in[v + x + z] != 0;
    const bool cube = squareXY && squareYZ && squareXZ && in[v + x + y + z] != 0;
    euler += 1 - (hasX + hasY + hasZ) + (squareXY + squareYZ + squareXZ) - (cube ? 1 : 0);
  }
  return euler;
}

} // namespace

VoxelTopology
voxelTopology(const LabelVolume & label)
{
  requireValid(label, "voxel topology");
  const LabelVolume padded = cropAndPad(label, { { 1, 1, 1 } });
  VoxelTopology     topology;
  topology.components = connectedParts(padded, true, Adjacency::Faces).voxels.size();
  topology.cavities = connectedParts(padded, false, Adjacency::FacesEdgesAndCorners).voxels.size() - 1;
  topology.eulerCharacteristic = faceConnectedEulerCharacteristic(padded);
  return topology;
}

VoxelChange
keepLargestComponentInPlace(LabelVolume & label)
{
  requireValid(label, "largest component");
  const Parts parts = connectedParts(label, true, Adjacency::Faces);
  const auto  largest =
    static_cast<std::int32_t>(std::max_element(parts.voxels.begin(), parts.voxels.end()) - parts.voxels.begin());
  VoxelChange change{ parts.voxels.size() - 1, 0 };
  for (const Run & run : parts.runs)
  {
    if (run.part != largest)
    {
      change.voxels += run.end - run.begin;
      std::fill(label.inside.begin() + static_cast<std::ptrdiff_t>(run.begin),
                label.inside.begin() + static_cast<std::ptrdiff_t>(run.end),
                std::uint8_t{ 0 });
    }
  }
  return change;
}

VoxelChange
fillCavitiesInPlace(LabelVolume & label)
{
  requireValid(label, "cavities");
  const Parts               parts = connectedParts(label, false, Adjacency::FacesEdgesAndCorners);
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
  VoxelChange change;
  change.parts = static_cast<std::size_t>(std::count(open.begin(), open.end(), std::uint8_t{ 0 }));
  for (const Run & run : parts.runs)
  {
    if (open[static_cast<std::size_t>(run.part)] == 0)
    {
      change.voxels += run.end - run.begin;
      std::fill(label.inside.begin() + static_cast<std::ptrdiff_t>(run.begin),
                label.inside.begin() + static_cast<std::ptrdiff_t>(run.end),
                std::uint8_t{ 1 });
    }
  }
  return change;
}

} // namespace moserhex
