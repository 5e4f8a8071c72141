#include "ShapeInterpolation.h"

#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Parallel.h"
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

/** Values on a box of samples, axis 0 first. */
struct Samples
{
  std::array<std::size_t, 3> size{};
  std::vector<double>        values;

  [[nodiscard]] std::size_t
  stride(std::size_t axis) const
  {
    return axis == 0 ? 1 : axis == 1 ? size[0] : size[0] * size[1];
  }
};

/** Replaces the samples along one axis by those that the stencils make of them. */
Samples
resampledAlong(std::size_t axis, const std::vector<AxisStencil> & stencils, const Samples & f, unsigned int threads)
{
  Samples result{ f.size, {} };
  result.size[axis] = stencils.size();
  result.values.resize(result.size[0] * result.size[1] * result.size[2]);
  const std::size_t row = f.stride(axis); // neighbours along the axis are this far apart
  const std::size_t slab = row * f.size[axis];
  const auto        atRow = [&](std::size_t line, std::size_t node) {
    const AxisStencil & stencil = stencils[node];
    const double *      source = f.values.data() + line * slab + static_cast<std::size_t>(stencil.first) * row;
    double *            target = result.values.data() + (line * stencils.size() + node) * row;
    for (std::size_t x = 0; x < row; ++x)
    {
      double value = 0.0;
      for (std::size_t c = 0; c < static_cast<std::size_t>(stencil.count); ++c)
      {
        value += stencil.weights[c] * source[c * row + x];
      }
      target[x] = value;
    }
  };
  constexpr std::size_t valuesPerBlock = 16384;
  const std::size_t     rows = result.values.size() / row;
  parallelForBlocks(rows, 1 + valuesPerBlock / row, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t r = begin; r < end; ++r)
    {
      atRow(r / stencils.size(), r % stencils.size());
    }
  });
  return result;
}

/** Slices beyond the label mirror its last slice and move away; then all values are saturated. */
void
completeSlicesInPlace(Samples & f, std::size_t axis, const std::array<int, 2> & occupied, double sliceThickness)
{
  const double              saturation = saturationInSlices * sliceThickness;
  const std::vector<double> inSlice = f.values;
  const std::size_t         stride = f.stride(axis);
  for (std::size_t sample = 0; sample < inSlice.size(); ++sample)
  {
    const int slice = static_cast<int>(sample / stride % f.size[axis]);
    const int source = std::min(std::max(slice, occupied[0]), occupied[1]);
    double    value =
      inSlice[sample + stride * static_cast<std::size_t>(source) - stride * static_cast<std::size_t>(slice)];
    if (source != slice)
    {
      value = std::abs(value) + (std::abs(slice - source) - 1) * sliceThickness;
    }
    f.values[sample] = saturation * std::tanh(value / saturation);
  }
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
interpolateShape(const LabelVolume & label, const RegularGrid & grid, int sliceAxis, unsigned int threads)
{
  std::array<bool, 3> inSlice{ { true, true, true } };
  if (sliceAxis >= 0)
  {
    inSlice[static_cast<std::size_t>(sliceAxis)] = false;
  }
  Samples f;
  std::copy(label.size.begin(), label.size.end(), f.size.begin());
  f.values = voxelSignedDistance(label, inSlice, threads);

  const Vector3 firstNode = label.direction.transpose() * (grid.origin - label.origin);
  const auto    resampleAlong = [&](std::size_t axis) {
    const int  a = static_cast<int>(axis);
    const auto stencils =
      axisStencils(grid.size[axis], grid.spacing, firstNode[a], label.size[axis], label.spacing[a], a == sliceAxis);
    f = resampledAlong(axis, stencils, f, threads);
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (inSlice[axis])
    {
      resampleAlong(axis);
    }
  }
  if (sliceAxis >= 0)
  {
    const auto axis = static_cast<std::size_t>(sliceAxis);
    completeSlicesInPlace(f, axis, occupiedSlices(label, axis), label.spacing[sliceAxis]);
    resampleAlong(axis);
  }
  return { grid, std::move(f.values) };
}

} // namespace moserhex::detail
