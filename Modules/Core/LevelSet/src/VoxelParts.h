#pragma once

#include "moserhex/LevelSet/LabelVolume.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace moserhex::detail
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

/** Parts of the inside or the outside of the label in the given adjacency. */
[[nodiscard]] Parts
connectedParts(const LabelVolume & label, bool inside, Adjacency adjacency);

/** Per part of the outside: 1 where it reaches the border of the image. */
[[nodiscard]] std::vector<std::uint8_t>
partsAtBorder(const LabelVolume & label, const Parts & parts);

} // namespace moserhex::detail
