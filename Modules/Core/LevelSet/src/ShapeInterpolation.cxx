#include "ShapeInterpolation.h"

#include "moserhex/Common/Errors.h"
#include "moserhex/LevelSet/CubicInterpolation.h"
#include "moserhex/LevelSet/SignedDistance.h"

#include <algorithm>
#include <cmath>

namespace moserhex::detail
{
namespace
{

constexpr double saturationInSlices = 3.0;

/** Which samples along one axis make the value at one node, and how much of each. */
struct AxisStencil
{
  int                   first{ 0 };
  int                   count{ 0 };
  std::array<double, 4> weights{};
};

/** One stencil per node along an axis; samples beyond the voxels repeat the ends. */
std::vector<AxisStencil>
axisStencils(int nodes, double nodeSpacing, double firstNode, int voxels, double voxelSpacing, bool cubic)
{
  std::vector<AxisStencil> stencils(static_cast<std::size_t>(nodes));
  const double             lowest = cubic ? 1.0 : 0.0;
  const double             highest = cubic ? voxels - 2.0 : voxels - 1.0;
  for (int node = 0; node < nodes; ++node)
  {
    const double  position = (firstNode + node * nodeSpacing) / voxelSpacing;
    const double  s = std::min(std::max(position, lowest), highest);
    const int     base = std::min(static_cast<int>(s), voxels - (cubic ? 3 : 2));
    AxisStencil & stencil = stencils[static_cast<std::size_t>(node)];
    if (cubic)
    {
      stencil.first = base - 1;
      stencil.count = 4;
      stencil.weights = catmullRomWeights(s - base);
    }
    else
    {
      stencil.first = base;
      stencil.count = 2;
      stencil.weights = { { 1.0 - (s - base), s - base, 0.0, 0.0 } };
    }
  }
  return stencils;
}

/** First and last slice that holds an inside voxel. */
std::array<int, 2>
occupiedSlices(const LabelVolume & label, std::size_t axis)
{
  std::array<int, 2> range{ { label.size[axis], -1 } };
  std::size_t        voxel = 0;
  for (int k = 0; k < label.size[2]; ++k)
  {
    for (int j = 0; j < label.size[1]; ++j)
    {
      for (int i = 0; i < label.size[0]; ++i, ++voxel)
      {
        if (label.inside[voxel] != 0)
        {
          const int slice = std::array<int, 3>{ { i, j, k } }[axis];
          range[0] = std::min(range[0], slice);
          range[1] = std::max(range[1], slice);
        }
      }
    }
  }
  return range;
}

/** Distance within each slice; slices beyond the label mirror its last slice and move away; then saturated. */
std::vector<double>
saturatedSliceDistance(const LabelVolume & label, int sliceAxis)
{
  const auto          axis = static_cast<std::size_t>(sliceAxis);
  std::array<bool, 3> inSlice{ { true, true, true } };
  inSlice[axis] = false;
  std::vector<double>              distance = voxelSignedDistance(label, inSlice);
  const double                     sliceThickness = label.spacing[sliceAxis];
  const double                     saturation = saturationInSlices * sliceThickness;
  const auto                       occupied = occupiedSlices(label, axis);
  const std::array<std::size_t, 3> strides{ { 1, label.voxelNumber(0, 1, 0), label.voxelNumber(0, 0, 1) } };

  std::vector<double> result(distance.size());
  std::size_t         voxel = 0;
  for (int k = 0; k < label.size[2]; ++k)
  {
    for (int j = 0; j < label.size[1]; ++j)
    {
      for (int i = 0; i < label.size[0]; ++i, ++voxel)
      {
        const int slice = std::array<int, 3>{ { i, j, k } }[axis];
        const int source = std::min(std::max(slice, occupied[0]), occupied[1]);
        double    value = 0.0;
        if (source == slice)
        {
          value = distance[voxel];
        }
        else
        {
          const std::size_t mirrored = source > slice
                                         ? voxel + strides[axis] * static_cast<std::size_t>(source - slice)
                                         : voxel - strides[axis] * static_cast<std::size_t>(slice - source);
          value = std::abs(distance[mirrored]) + (std::abs(slice - source) - 1) * sliceThickness;
        }
        result[voxel] = saturation * std::tanh(value / saturation);
      }
    }
  }
  return result;
}

} // namespace

int
findSliceAxis(const Vector3 & spacing, double anisotropy)
{
  int sliceAxis = 0;
  spacing.maxCoeff(&sliceAxis);
  return spacing[sliceAxis] > anisotropy * spacing.minCoeff() ? sliceAxis : -1;
}

RegularGrid
gridAround(const LabelVolume & label, double spacing, double margin)
{
  const LabelVolume tight = cropAndPad(label, { { 0, 0, 0 } });
  RegularGrid       grid;
  grid.spacing = spacing;
  grid.direction = label.direction;
  Vector3 toFirstNode; // from the centre of the tight volume's first voxel, along the image axes
  for (int axis = 0; axis < 3; ++axis)
  {
    const double extent = tight.size[static_cast<std::size_t>(axis)] * label.spacing[axis];
    const double intervals = std::ceil((extent + 2.0 * margin) / spacing);
    if (!(intervals < 1e6))
    {
      throw InvalidInput("grid spacing " + std::to_string(spacing) + " mm is too small for a label of " +
                         std::to_string(extent) + " mm");
    }
    grid.size[static_cast<std::size_t>(axis)] = static_cast<int>(intervals) + 1;
    toFirstNode[axis] = 0.5 * (extent - intervals * spacing) - 0.5 * label.spacing[axis];
  }
  grid.origin = tight.origin + grid.direction * toFirstNode;
  return grid;
}

LevelSet
interpolateShape(const LabelVolume & label, const RegularGrid & grid, int sliceAxis)
{
  const std::vector<double> distance =
    sliceAxis < 0 ? voxelSignedDistance(label, { { true, true, true } }) : saturatedSliceDistance(label, sliceAxis);

  const Vector3                           firstNode = label.direction.transpose() * (grid.origin - label.origin);
  std::array<std::vector<AxisStencil>, 3> stencils;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const int a = static_cast<int>(axis);
    stencils[axis] =
      axisStencils(grid.size[axis], grid.spacing, firstNode[a], label.size[axis], label.spacing[a], a == sliceAxis);
  }

  LevelSet    f{ grid, std::vector<double>(grid.nodeCount()) };
  std::size_t node = 0;
  for (const AxisStencil & z : stencils[2])
  {
    for (const AxisStencil & y : stencils[1])
    {
      for (const AxisStencil & x : stencils[0])
      {
        double value = 0.0;
        for (int c = 0; c < z.count; ++c)
        {
          for (int b = 0; b < y.count; ++b)
          {
            const double * row = distance.data() + label.voxelNumber(x.first, y.first + b, z.first + c);
            double         rowValue = 0.0;
            for (int a = 0; a < x.count; ++a)
            {
              rowValue += x.weights[static_cast<std::size_t>(a)] * row[a];
            }
            value += z.weights[static_cast<std::size_t>(c)] * y.weights[static_cast<std::size_t>(b)] * rowValue;
          }
        }
        f.values[node++] = value;
      }
    }
  }
  return f;
}

} // namespace moserhex::detail
