#include "moserhex/LevelSet/LabelVolume.h"

#include "moserhex/Common/Errors.h"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace moserhex
{
namespace
{

/** Any of these voxels is inside. All are looked at: a loop without a way out takes many at a time. */
bool
anyInside(const std::uint8_t * begin, const std::uint8_t * end)
{
  return std::accumulate(begin, end, std::uint8_t{ 0 }, [](std::uint8_t a, std::uint8_t b) {
           return static_cast<std::uint8_t>(a | b);
         }) != 0;
}

} // namespace

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
  if (!anyInside(label.inside.data(), label.inside.data() + label.inside.size()))
  {
    throw InvalidInput(ErrorCode::EmptyLabel, what + ": no voxel has this label");
  }
}

LabelVolume
cropAndPad(const LabelVolume & label, const std::array<int, 3> & margin)
{
  requireValid(label, "crop");
  std::array<int, 3> lower = label.size;
  std::array<int, 3> upper{ { -1, -1, -1 } };
  const auto         length = static_cast<std::ptrdiff_t>(label.size[0]);
  const auto *       row = label.inside.data();
  for (int k = 0; k < label.size[2]; ++k)
  {
    for (int j = 0; j < label.size[1]; ++j, row += length)
    {
      if (!anyInside(row, row + length)) // as most rows of an image
      {
        continue;
      }
      const auto isInside = [](std::uint8_t value) { return value != 0; };
      const auto first = std::find_if(row, row + length, isInside);
      const auto last =
        std::find_if(std::make_reverse_iterator(row + length), std::make_reverse_iterator(first), isInside);
      const std::array<int, 3> from{ static_cast<int>(first - row), j, k };
      const std::array<int, 3> to{ static_cast<int>(last.base() - row) - 1, j, k };
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        lower[axis] = std::min(lower[axis], from[axis]);
        upper[axis] = std::max(upper[axis], to[axis]);
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
