#include "SmoothedImage.h"

#include "moserhex/CubeTransfer/ImageFunction.h"
#include "moserhex/LevelSet/GaussianSmoothing.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace moserhex
{
namespace
{

/** Finer nodes do not show in what is left after smoothing. */
constexpr double nodesPerSigma = 2.0;
/** Of a mean over one node's box; the Gaussian has the rest of the variance [nodes^2]. */
constexpr double varianceOfBox = 1.0 / 12.0;

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

/** How finely the box around a node must be sampled along each patient's axis so that steps leave no voxel out. */
std::array<int, 3>
samplesInBox(const VoxelGrid & image, double spacing)
{
  std::array<int, 3> samples{};
  for (int axis = 0; axis < 3; ++axis)
  {
    const Vector3 step = image.direction.row(axis).transpose().cwiseAbs().cwiseQuotient(image.spacing);
    samples[static_cast<std::size_t>(axis)] = std::max(1, static_cast<int>(std::ceil(spacing * step.maxCoeff())));
  }
  return samples;
}

Vector3
nearestInImage(const VoxelGrid & grid, const Vector3 & p)
{
  const Vector3 last(grid.size[0] - 1, grid.size[1] - 1, grid.size[2] - 1);
  const Vector3 index = grid.continuousIndex(p).cwiseMax(0.0).cwiseMin(last);
  return grid.origin + grid.direction * grid.spacing.cwiseProduct(index);
}

/** Means over the boxes between the nodes: what varies within a box would otherwise show as a pattern of the grid. */
class BoxMeans
{
public:
  BoxMeans(const ScalarVolume & image, double spacing)
    : m_Image(image), m_Function(image), m_Spacing(spacing), m_Samples(samplesInBox(image, spacing))
  {}

  [[nodiscard]] double
  at(const Vector3 & node) const
  {
    double sum = 0.0;
    for (int k = 0; k < m_Samples[2]; ++k)
    {
      for (int j = 0; j < m_Samples[1]; ++j)
      {
        for (int i = 0; i < m_Samples[0]; ++i)
        {
          sum += m_Function(nearestInImage(m_Image, node + offset({ { i, j, k } })));
        }
      }
    }
    return sum / (m_Samples[0] * m_Samples[1] * m_Samples[2]);
  }

private:
  /** Of the middle of a part of the box. */
  [[nodiscard]] Vector3
  offset(const std::array<int, 3> & part) const
  {
    Vector3 from;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      from[static_cast<Eigen::Index>(axis)] = m_Spacing * ((part[axis] + 0.5) / m_Samples[axis] - 0.5);
    }
    return from;
  }

  const ScalarVolume & m_Image;
  ImageFunction        m_Function;
  double               m_Spacing;
  std::array<int, 3>   m_Samples;
};

std::unique_ptr<const LevelSet>
smoothed(const ScalarVolume & image, const Positions & points, double sigma)
{
  auto values = std::make_unique<LevelSet>();
  values->grid = gridAround(points, sigma);
  values->values.reserve(values->grid.nodeCount());
  const BoxMeans means(image, values->grid.spacing);
  for (std::size_t node = 0; node < values->grid.nodeCount(); ++node)
  {
    values->values.push_back(means.at(values->grid.point(node)));
  }
  gaussianSmoothInPlace(*values, std::sqrt(nodesPerSigma * nodesPerSigma - varianceOfBox));
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
