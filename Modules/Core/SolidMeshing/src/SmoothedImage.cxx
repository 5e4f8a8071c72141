#include "SmoothedImage.h"

#include "moserhex/CubeTransfer/ImageFunction.h"
#include "moserhex/LevelSet/GaussianSmoothing.h"

#include <algorithm>
#include <cmath>

namespace moserhex
{
namespace
{

/** Finer nodes do not show in what is left after smoothing. */
constexpr double nodesPerSigma = 2.0;

/** Along the patient's axes. */
RegularGrid
gridAround(const Positions & points, double sigma)
{
  Vector3 low = points.front();
  Vector3 high = points.front();
  for (const Vector3 & point : points)
  {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  RegularGrid grid;
  grid.spacing = sigma / nodesPerSigma;
  const double margin = 3.0 * sigma + 2.0 * grid.spacing;
  grid.origin = low - Vector3::Constant(margin);
  for (int axis = 0; axis < 3; ++axis)
  {
    const double length = high[axis] - low[axis] + 2.0 * margin;
    grid.size[static_cast<std::size_t>(axis)] = static_cast<int>(std::ceil(length / grid.spacing)) + 1;
  }
  return grid;
}

Vector3
nearestInImage(const VoxelGrid & grid, const Vector3 & p)
{
  const Vector3 last(grid.size[0] - 1, grid.size[1] - 1, grid.size[2] - 1);
  const Vector3 index = grid.continuousIndex(p).cwiseMax(0.0).cwiseMin(last);
  return grid.origin + grid.direction * grid.spacing.cwiseProduct(index);
}

std::unique_ptr<const LevelSet>
smoothed(const ScalarVolume & image, const Positions & points, double sigma)
{
  const ImageFunction function(image);
  auto                values = std::make_unique<LevelSet>();
  values->grid = gridAround(points, sigma);
  values->values.reserve(values->grid.nodeCount());
  for (std::size_t node = 0; node < values->grid.nodeCount(); ++node)
  {
    values->values.push_back(function(nearestInImage(image, values->grid.point(node))));
  }
  gaussianSmoothInPlace(*values, nodesPerSigma);
  return values;
}

} // namespace

SmoothedImage::SmoothedImage(const ScalarVolume & image, const Positions & points, double sigma)
  : m_Values(smoothed(image, points, sigma)), m_At(*m_Values)
{}

ValueAndGradient
SmoothedImage::at(const Vector3 & p) const
{
  return m_At.at(p);
}

} // namespace moserhex
