#include "moserhex/LevelSet/AgreementDensity.h"

#include "moserhex/Common/Errors.h"
#include "moserhex/LevelSet/GaussianSmoothing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace moserhex
{
namespace
{

/** In the grid's voxels, both ends included. */
struct IndexBox
{
  Vector3 low{ Vector3::Constant(std::numeric_limits<double>::infinity()) };
  Vector3 high{ Vector3::Constant(-std::numeric_limits<double>::infinity()) };
};

/** Calls body(i, j, k) for every voxel of a grid, in the order of their numbers. */
template <typename TBody>
void
forEachVoxel(const VoxelGrid & grid, TBody body)
{
  for (int k = 0; k < grid.size[2]; ++k)
  {
    for (int j = 0; j < grid.size[1]; ++j)
    {
      for (int i = 0; i < grid.size[0]; ++i)
      {
        body(i, j, k);
      }
    }
  }
}

/** Around the corners of the label's voxels. */
void
extend(const LabelVolume & label, const VoxelGrid & grid, IndexBox & box)
{
  forEachVoxel(label, [&](int i, int j, int k) {
    if (label.inside[label.voxelNumber(i, j, k)] == 0)
    {
      return;
    }
    for (int corner = 0; corner < 8; ++corner)
    {
      const Vector3 at(i + ((corner & 1) != 0 ? 0.5 : -0.5),
                       j + ((corner & 2) != 0 ? 0.5 : -0.5),
                       k + ((corner & 4) != 0 ? 0.5 : -0.5));
      const Vector3 index = grid.continuousIndex(label.origin + label.direction * label.spacing.cwiseProduct(at));
      box.low = box.low.cwiseMin(index);
      box.high = box.high.cwiseMax(index);
    }
  });
}

[[noreturn]] void
refuseLabelsApart()
{
  throw InvalidInput("agreement: the labels have no voxel in common");
}

/** The grid of the first label, around all of them. \throws InvalidInput  their boxes have nothing in common: what is
 * around them could be of any size */
VoxelGrid
gridAround(const std::vector<LabelVolume> & labels)
{
  VoxelGrid grid = labels.front();
  IndexBox  box;
  IndexBox  common{ box.high, box.low };
  for (const LabelVolume & label : labels)
  {
    IndexBox own;
    extend(label, grid, own);
    common = { common.low.cwiseMax(own.low), common.high.cwiseMin(own.high) };
    box = { box.low.cwiseMin(own.low), box.high.cwiseMax(own.high) };
  }
  if ((common.high - common.low).minCoeff() <= 0.0)
  {
    refuseLabelsApart();
  }
  const Eigen::Vector3i low = box.low.array().floor().cast<int>() - 1;
  const Eigen::Vector3i high = box.high.array().ceil().cast<int>() + 1;
  grid.origin = grid.point(low[0], low[1], low[2]);
  grid.size = { { high[0] - low[0] + 1, high[1] - low[1] + 1, high[2] - low[2] + 1 } };
  return grid;
}

bool
holds(const LabelVolume & label, const Vector3 & p)
{
  const Vector3 index = label.continuousIndex(p).array().round();
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!(index[axis] >= 0.0 && index[axis] < label.size[static_cast<std::size_t>(axis)]))
    {
      return false;
    }
  }
  return label.inside[label.voxelNumber(
           static_cast<int>(index[0]), static_cast<int>(index[1]), static_cast<int>(index[2]))] != 0;
}

void
requireUsable(const std::vector<LabelVolume> & labels, const AgreementOptions & options)
{
  const auto require = [](bool isRight, const std::string & text) {
    if (!isRight)
    {
      throw InvalidInput("agreement: " + text);
    }
  };
  require(labels.size() >= 2, "at least two labels are needed");
  require(options.disputed > 0.0 && options.disputed <= 1.0, "the density of disputed voxels must be in (0, 1]");
  require(options.smoothing >= 0.0 && std::isfinite(options.smoothing), "the smoothing must be finite, not negative");
  for (std::size_t l = 0; l < labels.size(); ++l)
  {
    requireValid(labels[l], "agreement: label " + std::to_string(l + 1));
  }
}

} // namespace

AgreementDensity
agreementDensity(const std::vector<LabelVolume> & labels, const AgreementOptions & options)
{
  requireUsable(labels, options);
  AgreementDensity result;
  ScalarVolume &   density = result.density;
  static_cast<VoxelGrid &>(density) = gridAround(labels);
  ScalarVolume inUnion = density;
  std::size_t  agreed = 0;
  std::size_t  disputed = 0;
  forEachVoxel(density, [&](int i, int j, int k) {
    const Vector3 p = density.point(i, j, k);
    const auto    holders = static_cast<std::size_t>(
      std::count_if(labels.begin(), labels.end(), [&p](const LabelVolume & label) { return holds(label, p); }));
    const bool isHeld = holders > 0;
    const bool isAgreed = holders == labels.size();
    agreed += isAgreed ? 1 : 0;
    disputed += isHeld && !isAgreed ? 1 : 0;
    inUnion.values.push_back(isHeld ? 1.0 : 0.0);
    density.values.push_back(isAgreed ? 1.0 : isHeld ? options.disputed : 0.0);
  });
  if (agreed == 0)
  {
    refuseLabelsApart();
  }
  result.agreedVolume = static_cast<double>(agreed) * density.voxelVolume();
  result.disputedVolume = static_cast<double>(disputed) * density.voxelVolume();
  const std::vector<double> isInUnion = inUnion.values;
  gaussianSmoothInPlace(density, options.smoothing);
  gaussianSmoothInPlace(inUnion, options.smoothing);
  for (std::size_t voxel = 0; voxel < isInUnion.size(); ++voxel)
  {
    density.values[voxel] = isInUnion[voxel] > 0.0 ? density.values[voxel] / inUnion.values[voxel] : 1.0;
  }
  return result;
}

} // namespace moserhex
