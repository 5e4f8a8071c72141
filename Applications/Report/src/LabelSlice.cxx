#include "LabelSlice.h"

#include <algorithm>
#include <cmath>

namespace moserhex::app
{
namespace
{

constexpr int mostSquares = 320;

VoxelGrid
gridOf(const LabelImageType & image)
{
  VoxelGrid  grid;
  const auto region = image.GetLargestPossibleRegion();
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    const auto row = static_cast<int>(axis);
    grid.size[axis] = static_cast<int>(region.GetSize()[axis]);
    grid.spacing[row] = image.GetSpacing()[axis];
    for (unsigned int column = 0; column < 3; ++column)
    {
      grid.direction(row, static_cast<int>(column)) = image.GetDirection()(axis, column);
    }
  }
  LabelImageType::PointType first;
  image.TransformIndexToPhysicalPoint(region.GetIndex(), first);
  grid.origin = Vector3(first[0], first[1], first[2]);
  return grid;
}

bool
isAmong(LabelValue value, const std::vector<LabelValue> & labels)
{
  return std::find(labels.begin(), labels.end(), value) != labels.end();
}

} // namespace

std::optional<Box>
boxOfLabels(const LabelImageType & image, const std::vector<LabelValue> & labels)
{
  const VoxelGrid    grid = gridOf(image);
  const LabelValue * voxel = image.GetBufferPointer();
  std::array<int, 3> low = grid.size;
  std::array<int, 3> high{ { -1, -1, -1 } };
  for (int k = 0; k < grid.size[2]; ++k)
  {
    for (int j = 0; j < grid.size[1]; ++j)
    {
      for (int i = 0; i < grid.size[0]; ++i, ++voxel)
      {
        if (*voxel != 0 && isAmong(*voxel, labels))
        {
          low = { std::min(low[0], i), std::min(low[1], j), std::min(low[2], k) };
          high = { std::max(high[0], i), std::max(high[1], j), std::max(high[2], k) };
        }
      }
    }
  }
  if (high[0] < 0)
  {
    return std::nullopt;
  }
  const Vector3 infinite = Vector3::Constant(std::numeric_limits<double>::infinity());
  Box           box{ infinite, -infinite };
  for (int corner = 0; corner < 8; ++corner)
  {
    Vector3 index;
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto at = static_cast<std::size_t>(axis);
      index[axis] = corner >> axis & 1 ? high[at] + 0.5 : low[at] - 0.5;
    }
    const Vector3 point = grid.origin + grid.direction * grid.spacing.cwiseProduct(index);
    box.low = box.low.cwiseMin(point);
    box.high = box.high.cwiseMax(point);
  }
  return box;
}

LabelSlice
sliceLabels(const LabelImageType &          image,
            const std::vector<LabelValue> & labels,
            const Box &                     box,
            const CutPlane &                plane)
{
  const VoxelGrid grid = gridOf(image);
  const int       first = plane.axis == 0 ? 1 : 0;
  const int       second = plane.axis == 2 ? 1 : 2;
  const Vector3   extent = box.high - box.low;
  LabelSlice      slice;
  slice.step = std::max(grid.spacing.minCoeff() / 2.0, std::max(extent[first], extent[second]) / mostSquares);
  slice.corner = { box.low[first], box.low[second] };
  slice.size = { static_cast<int>(std::ceil(extent[first] / slice.step)),
                 static_cast<int>(std::ceil(extent[second] / slice.step)) };
  Vector3 point = Vector3::Constant(plane.place);
  for (int b = 0; b < slice.size[1]; ++b)
  {
    for (int a = 0; a < slice.size[0]; ++a)
    {
      point[first] = slice.corner[0] + (a + 0.5) * slice.step;
      point[second] = slice.corner[1] + (b + 0.5) * slice.step;
      const Vector3              place = grid.continuousIndex(point);
      std::array<std::size_t, 3> index{};
      bool                       isInside = true;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const double nearest = std::floor(place[static_cast<int>(axis)] + 0.5);
        isInside = isInside && nearest >= 0.0 && nearest < grid.size[axis];
        index[axis] = isInside ? static_cast<std::size_t>(nearest) : 0;
      }
      const LabelValue value =
        isInside ? image.GetBufferPointer()[grid.voxelNumber(
                     static_cast<int>(index[0]), static_cast<int>(index[1]), static_cast<int>(index[2]))]
                 : 0;
      slice.values.push_back(isAmong(value, labels) ? value : 0);
    }
  }
  return slice;
}

} // namespace moserhex::app
