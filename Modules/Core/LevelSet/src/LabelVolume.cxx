#include "moserhex/LevelSet/LabelVolume.h"

#include "moserhex/Common/Errors.h"

#include <algorithm>

namespace moserhex
{

std::size_t
voxelCount(const LabelVolume & label)
{
  return label.inside.size() -
         static_cast<std::size_t>(std::count(label.inside.begin(), label.inside.end(), std::uint8_t{ 0 }));
}

void
requireValid(const LabelVolume & label, const std::string & what)
{
  requireValid(static_cast<const VoxelGrid &>(label), what);
  if (label.inside.size() != label.gridVoxels())
  {
    throw InvalidInput(what + ": " + std::to_string(label.inside.size()) + " mask entries for " +
                       std::to_string(label.gridVoxels()) + " voxels");
  }
  if (voxelCount(label) == 0)
  {
    throw InvalidInput(what + ": no voxel has this label");
  }
}

LabelVolume
cropAndPad(const LabelVolume & label, const std::array<int, 3> & margin)
{
  requireValid(label, "crop");
  std::array<int, 3> lower = label.size;
  std::array<int, 3> upper{ { -1, -1, -1 } };
  std::size_t        voxel = 0;
  for (int k = 0; k < label.size[2]; ++k)
  {
    for (int j = 0; j < label.size[1]; ++j)
    {
      for (int i = 0; i < label.size[0]; ++i, ++voxel)
      {
        if (label.inside[voxel] != 0)
        {
          const std::array<int, 3> index{ { i, j, k } };
          for (std::size_t axis = 0; axis < 3; ++axis)
          {
            lower[axis] = std::min(lower[axis], index[axis]);
            upper[axis] = std::max(upper[axis], index[axis]);
          }
        }
      }
    }
  }
  LabelVolume result;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    result.size[axis] = upper[axis] - lower[axis] + 1 + 2 * margin[axis];
  }
  result.spacing = label.spacing;
  result.direction = label.direction;
  result.origin = label.point(lower[0] - margin[0], lower[1] - margin[1], lower[2] - margin[2]);
  result.inside.assign(result.gridVoxels(), 0);
  for (int k = lower[2]; k <= upper[2]; ++k)
  {
    for (int j = lower[1]; j <= upper[1]; ++j)
    {
      const auto source = label.inside.begin() + static_cast<std::ptrdiff_t>(label.voxelNumber(lower[0], j, k));
      const auto target =
        result.inside.begin() +
        static_cast<std::ptrdiff_t>(result.voxelNumber(margin[0], j - lower[1] + margin[1], k - lower[2] + margin[2]));
      std::transform(source, source + (upper[0] - lower[0] + 1), target, [](std::uint8_t value) {
        return static_cast<std::uint8_t>(value != 0);
      });
    }
  }
  return result;
}

} // namespace moserhex
