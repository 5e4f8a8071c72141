#include "moserhex/LevelSet/GaussianSmoothing.h"

#include "moserhex/Common/Errors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

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

/** \param size    of the lattice, its first index the fastest \param sigmas  along its axes [nodes] */
void
smoothLattice(const std::array<int, 3> & size, const Vector3 & sigmas, std::vector<double> & values)
{
  const int            nx = size[0];
  const int            ny = size[1];
  const int            nz = size[2];
  const std::ptrdiff_t plane = static_cast<std::ptrdiff_t>(nx) * ny;
  double *             first = values.data();
  std::vector<double>  padded;
  std::vector<double>  weights = halfKernel(sigmas[0]);
  for (int row = 0; row < ny * nz; ++row)
  {
    convolveAlongRow(first + static_cast<std::ptrdiff_t>(nx) * row, nx, weights, padded);
  }
  weights = halfKernel(sigmas[1]);
  for (int k = 0; k < nz; ++k)
  {
    convolveRows(first + plane * k, ny, nx, nx, weights, padded);
  }
  weights = halfKernel(sigmas[2]);
  for (int j = 0; j < ny; ++j)
  {
    convolveRows(first + static_cast<std::ptrdiff_t>(nx) * j, nz, plane, nx, weights, padded);
  }
}

void
requireSmoothable(const std::vector<double> & values, double sigma, const std::string & unit)
{
  if (!(sigma >= 0.0) || !std::isfinite(sigma))
  {
    throw InvalidInput("Gaussian smoothing: sigma " + std::to_string(sigma) + " " + unit + ", need >= 0");
  }
  if (!std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); }))
  {
    throw InvalidInput("Gaussian smoothing: a value is not finite");
  }
}

} // namespace

void
gaussianSmoothInPlace(LevelSet & levelSet, double sigmaInNodes)
{
  requireValid(levelSet, "Gaussian smoothing");
  requireSmoothable(levelSet.values, sigmaInNodes, "nodes");
  if (sigmaInNodes > 0.0)
  {
    smoothLattice(levelSet.grid.size, Vector3::Constant(sigmaInNodes), levelSet.values);
  }
}

void
gaussianSmoothInPlace(ScalarVolume & image, double sigma)
{
  requireValid(image, "Gaussian smoothing");
  requireSmoothable(image.values, sigma, "mm");
  if (sigma > 0.0)
  {
    smoothLattice(image.size, sigma * image.spacing.cwiseInverse(), image.values);
  }
}

} // namespace moserhex
