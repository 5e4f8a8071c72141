#pragma once

#include "moserhex/LevelSet/VoxelGrid.h"

#include <cmath>
#include <locale>
#include <sstream>
#include <string>

namespace moserhex
{

[[nodiscard]] inline bool
isDensity(double value)
{
  return value > 0.0 && std::isfinite(value);
}

/** Six digits, as few as it takes. */
[[nodiscard]] inline std::string
describeNumber(double value)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << value;
  return text.str();
}

/** "voxel (3, 0, 12) holds -0.5", the index counted from 0. */
[[nodiscard]] inline std::string
describeVoxel(const VoxelGrid & grid, std::size_t voxel, double value)
{
  const auto nx = static_cast<std::size_t>(grid.size[0]);
  const auto ny = static_cast<std::size_t>(grid.size[1]);
  return "voxel (" + std::to_string(voxel % nx) + ", " + std::to_string(voxel / nx % ny) + ", " +
         std::to_string(voxel / (nx * ny)) + ") holds " + describeNumber(value);
}

} // namespace moserhex
