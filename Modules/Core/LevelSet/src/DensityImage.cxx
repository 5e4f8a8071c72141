#include "moserhex/LevelSet/DensityImage.h"

#include "DensityText.h"
#include "moserhex/Common/Errors.h"

#include <algorithm>
#include <cmath>

namespace moserhex
{
namespace
{

/** B(t+1), B(t), B(t-1): weights of the voxels before, at and after the middle one. */
std::array<double, 3>
splineWeights(double t)
{
  return { { 0.5 * (0.5 - t) * (0.5 - t), 0.75 - t * t, 0.5 * (0.5 + t) * (0.5 + t) } };
}

std::array<double, 3>
splineDerivatives(double t)
{
  return { { t - 0.5, -2.0 * t, t + 0.5 } };
}

double
blend(const std::array<double, 3> & weights, const double * row)
{
  return weights[0] * row[0] + weights[1] * row[1] + weights[2] * row[2];
}

int
clampIndex(int index, int size)
{
  return std::min(std::max(index, 0), size - 1);
}

/** Sum of the second differences along the three axes, the border voxels repeated outside. */
double
secondDifferences(const ScalarVolume & image, int i, int j, int k)
{
  const double middle = image.values[image.voxelNumber(i, j, k)];
  const auto   value = [&](int a, int b, int c) {
    return image.values[image.voxelNumber(
      clampIndex(a, image.size[0]), clampIndex(b, image.size[1]), clampIndex(c, image.size[2]))];
  };
  return (value(i - 1, j, k) - middle) + (value(i + 1, j, k) - middle) + (value(i, j - 1, k) - middle) +
         (value(i, j + 1, k) - middle) + (value(i, j, k - 1) - middle) + (value(i, j, k + 1) - middle);
}

/** c of every voxel, in the order of the voxel numbers. */
std::vector<double>
splineCoefficients(const ScalarVolume & image)
{
  std::vector<double> coefficients;
  coefficients.reserve(image.values.size());
  for (int k = 0; k < image.size[2]; ++k)
  {
    for (int j = 0; j < image.size[1]; ++j)
    {
      for (int i = 0; i < image.size[0]; ++i)
      {
        const double value = image.values[coefficients.size()];
        coefficients.push_back(std::max(value - secondDifferences(image, i, j, k) / 8.0, 0.5 * value));
      }
    }
  }
  return coefficients;
}

} // namespace

void
requireValid(const ScalarVolume & image, const std::string & what)
{
  requireValid(static_cast<const VoxelGrid &>(image), what);
  if (image.values.size() != image.gridVoxels())
  {
    throw InvalidInput(ErrorCode::Density,
                       what + ": " + std::to_string(image.values.size()) + " values for " +
                         std::to_string(image.gridVoxels()) + " voxels");
  }
}

DensityImage::DensityImage(const ScalarVolume & image)
  : m_ToIndex(image.spacing.cwiseInverse().asDiagonal() * image.direction.transpose())
  , m_Origin(image.origin)
  , m_Size(image.size)
  , m_RowStride(static_cast<std::size_t>(image.size[0]) + 2)
  , m_SliceStride(m_RowStride * (static_cast<std::size_t>(image.size[1]) + 2))
{
  requireValid(image, "density image");
  for (std::size_t voxel = 0; voxel < image.values.size(); ++voxel)
  {
    if (!isDensity(image.values[voxel]))
    {
      throw InvalidInput(ErrorCode::Density,
                         "density image: " + describeVoxel(image, voxel, image.values[voxel]) +
                           ", need positive and finite");
    }
  }
  const std::vector<double> coefficients = splineCoefficients(image);
  m_Coefficients.resize(m_SliceStride * (static_cast<std::size_t>(m_Size[2]) + 2));
  double * padded = m_Coefficients.data();
  for (int k = -1; k <= m_Size[2]; ++k)
  {
    for (int j = -1; j <= m_Size[1]; ++j)
    {
      const double * row =
        coefficients.data() + image.voxelNumber(0, clampIndex(j, m_Size[1]), clampIndex(k, m_Size[2]));
      *padded++ = row[0];
      padded = std::copy(row, row + m_Size[0], padded);
      *padded++ = row[m_Size[0] - 1];
    }
  }
}

DensityImage::Stencil
DensityImage::stencilAt(const Vector3 & p) const
{
  const Vector3 index = m_ToIndex * (p - m_Origin);
  Stencil       stencil;
  std::size_t   middle[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const int    size = m_Size[static_cast<std::size_t>(axis)];
    const double s = index[axis] > -0.5 ? std::min(index[axis], size - 0.5) : -0.5;
    const int    nearest = std::min(static_cast<int>(s + 0.5), size - 1);
    middle[axis] = static_cast<std::size_t>(nearest);
    stencil.fraction[axis] = s - nearest;
  }
  stencil.first = m_Coefficients.data() + middle[0] + m_RowStride * middle[1] + m_SliceStride * middle[2];
  return stencil;
}

ValueAndGradient
DensityImage::at(const Vector3 & p) const
{
  using Pair = Eigen::Array2d; // value and derivative along the row, in one packet
  const Stencil stencil = stencilAt(p);
  const auto    wx = splineWeights(stencil.fraction[0]);
  const auto    wy = splineWeights(stencil.fraction[1]);
  const auto    wz = splineWeights(stencil.fraction[2]);
  const auto    dx = splineDerivatives(stencil.fraction[0]);
  const auto    dy = splineDerivatives(stencil.fraction[1]);
  const auto    dz = splineDerivatives(stencil.fraction[2]);
  const Pair    alongX[3] = { { wx[0], dx[0] }, { wx[1], dx[1] }, { wx[2], dx[2] } };

  double  value = 0.0;
  Vector3 gradient = Vector3::Zero(); // with respect to the index
  for (std::size_t c = 0; c < 3; ++c)
  {
    Pair   plane = Pair::Zero();
    double planeY = 0.0;
    for (std::size_t b = 0; b < 3; ++b)
    {
      const double * coefficients = stencil.first + b * m_RowStride + c * m_SliceStride;
      const Pair     row = alongX[0] * coefficients[0] + alongX[1] * coefficients[1] + alongX[2] * coefficients[2];
      plane += wy[b] * row;
      planeY += dy[b] * row[0];
    }
    value += wz[c] * plane[0];
    gradient += Vector3(wz[c] * plane[1], wz[c] * planeY, dz[c] * plane[0]);
  }
  return { value, m_ToIndex.transpose() * gradient };
}

double
DensityImage::value(const Vector3 & p) const
{
  const Stencil stencil = stencilAt(p);
  const auto    wx = splineWeights(stencil.fraction[0]);
  const auto    wy = splineWeights(stencil.fraction[1]);
  const auto    wz = splineWeights(stencil.fraction[2]);
  double        value = 0.0;
  for (std::size_t c = 0; c < 3; ++c)
  {
    const double * row = stencil.first + c * m_SliceStride;
    value += wz[c] *
             (wy[0] * blend(wx, row) + wy[1] * blend(wx, row + m_RowStride) + wy[2] * blend(wx, row + 2 * m_RowStride));
  }
  return value;
}

} // namespace moserhex
