#include "moserhex/LevelSet/GaussianSmoothing.h"

#include "moserhex/Common/Errors.h"

#include <algorithm>
#include <cmath>

namespace moserhex
{
namespace
{

/** Weights of -radius .. radius; the symmetric half is stored: w[0] of the centre, w[e] of both sides. */
std::vector<double>
halfKernel(double sigma)
{
  const int           radius = std::max(1, static_cast<int>(std::ceil(3.0 * sigma)));
  std::vector<double> weights(static_cast<std::size_t>(radius) + 1);
  double              sum = 0.0;
  for (int e = 0; e <= radius; ++e)
  {
    const double weight = std::exp(-0.5 * e * e / (sigma * sigma));
    weights[static_cast<std::size_t>(e)] = weight;
    sum += e == 0 ? weight : 2.0 * weight;
  }
  for (double & weight : weights)
  {
    weight /= sum;
  }
  return weights;
}

/** Convolves `count` rows of `length` contiguous values, `stride` apart, across the rows. Rows outside repeat the ends.
 * `padded` is work space. */
void
convolveRows(double *                    first,
             int                         count,
             std::ptrdiff_t              stride,
             std::ptrdiff_t              length,
             const std::vector<double> & weights,
             std::vector<double> &       padded)
{
  const int radius = static_cast<int>(weights.size()) - 1;
  padded.resize(static_cast<std::size_t>((count + 2 * radius) * length));
  for (int q = -radius; q < count + radius; ++q)
  {
    const double * row = first + stride * std::min(std::max(q, 0), count - 1);
    std::copy(row, row + length, padded.data() + (q + radius) * length);
  }
  for (int q = 0; q < count; ++q)
  {
    double *       target = first + stride * q;
    const double * centre = padded.data() + (q + radius) * length;
    for (std::ptrdiff_t x = 0; x < length; ++x)
    {
      target[x] = weights[0] * centre[x];
    }
    for (int e = 1; e <= radius; ++e)
    {
      const double   weight = weights[static_cast<std::size_t>(e)];
      const double * before = centre - e * length;
      const double * after = centre + e * length;
      for (std::ptrdiff_t x = 0; x < length; ++x)
      {
        target[x] += weight * (before[x] + after[x]);
      }
    }
  }
}

/** Convolves one contiguous row along itself. */
void
convolveAlongRow(double * row, int length, const std::vector<double> & weights, std::vector<double> & padded)
{
  const int radius = static_cast<int>(weights.size()) - 1;
  padded.resize(static_cast<std::size_t>(length + 2 * radius));
  std::fill_n(padded.begin(), radius, row[0]);
  std::copy(row, row + length, padded.begin() + radius);
  std::fill_n(padded.begin() + radius + length, radius, row[length - 1]);
  for (int x = 0; x < length; ++x)
  {
    row[x] = weights[0] * padded[static_cast<std::size_t>(x + radius)];
  }
  for (int e = 1; e <= radius; ++e)
  {
    const double   weight = weights[static_cast<std::size_t>(e)];
    const double * before = padded.data() + radius - e;
    const double * after = padded.data() + radius + e;
    for (int x = 0; x < length; ++x)
    {
      row[x] += weight * (before[x] + after[x]);
    }
  }
}

} // namespace

void
gaussianSmoothInPlace(LevelSet & levelSet, double sigmaInNodes)
{
  requireValid(levelSet, "Gaussian smoothing");
  if (!(sigmaInNodes >= 0.0) || !std::isfinite(sigmaInNodes))
  {
    throw InvalidInput("Gaussian smoothing: sigma " + std::to_string(sigmaInNodes) + " nodes, need >= 0");
  }
  for (const double value : levelSet.values)
  {
    if (!std::isfinite(value))
    {
      throw InvalidInput("Gaussian smoothing: a value is not finite");
    }
  }
  if (sigmaInNodes == 0.0)
  {
    return;
  }
  const std::vector<double> weights = halfKernel(sigmaInNodes);
  const int                 nx = levelSet.grid.size[0];
  const int                 ny = levelSet.grid.size[1];
  const int                 nz = levelSet.grid.size[2];
  double *                  values = levelSet.values.data();
  std::vector<double>       padded;
  for (int row = 0; row < ny * nz; ++row)
  {
    convolveAlongRow(values + static_cast<std::ptrdiff_t>(nx) * row, nx, weights, padded);
  }
  const std::ptrdiff_t plane = static_cast<std::ptrdiff_t>(nx) * ny;
  for (int k = 0; k < nz; ++k)
  {
    convolveRows(values + plane * k, ny, nx, nx, weights, padded);
  }
  for (int j = 0; j < ny; ++j)
  {
    convolveRows(values + static_cast<std::ptrdiff_t>(nx) * j, nz, plane, nx, weights, padded);
  }
}

} // namespace moserhex
