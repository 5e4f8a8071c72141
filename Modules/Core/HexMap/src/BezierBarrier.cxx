#include "BezierBarrier.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace moserhex
{
namespace
{

constexpr std::size_t sampleCount = 27;

/** First corner of edge e = 0..3 along a direction, corners numbered by bits (i,j,k). */
constexpr std::size_t edgeStart[3][4] = { { 0, 2, 4, 6 }, { 0, 1, 4, 5 }, { 0, 1, 2, 3 } };
/** The two directions across each direction, the slower one last. */
constexpr std::size_t across[3][2] = { { 1, 2 }, { 0, 2 }, { 0, 1 } };

/** Bilinear weights of the four edges along a direction at sample q of {0,1/2,1}^3. */
std::array<double, 4>
edgeWeights(std::size_t sample, std::size_t direction)
{
  const std::array<double, 3> at{ 0.5 * static_cast<double>(sample % 3),
                                  0.5 * static_cast<double>(sample / 3 % 3),
                                  0.5 * static_cast<double>(sample / 9) };
  const double                s = at[across[direction][0]];
  const double                t = at[across[direction][1]];
  return { (1 - s) * (1 - t), s * (1 - t), (1 - s) * t, s * t };
}

/** Samples at {0,1/2,1}^3 <-> coefficients: b_1 = 2 f(1/2) - (f_0 + f_1)/2 in each direction. */
void
samplesToCoefficientsInPlace(std::array<double, sampleCount> & values)
{
  for (const std::size_t step : { 1, 3, 9 })
  {
    for (std::size_t q = 0; q < sampleCount; ++q)
    {
      if (q / step % 3 == 1)
      {
        values[q] = 2.0 * values[q] - 0.5 * (values[q - step] + values[q + step]);
      }
    }
  }
}

/** The transpose, for gradients. */
void
transposeInPlace(std::array<double, sampleCount> & values)
{
  for (const std::size_t step : { 9, 3, 1 })
  {
    for (std::size_t q = 0; q < sampleCount; ++q)
    {
      if (q / step % 3 == 1)
      {
        values[q - step] -= 0.5 * values[q];
        values[q + step] -= 0.5 * values[q];
        values[q] *= 2.0;
      }
    }
  }
}

} // namespace

double
addBezierBarrier(const LatticeLayout &            layout,
                 const Eigen::VectorXd &          x,
                 const std::vector<std::size_t> & cells,
                 double                           margin,
                 double                           weight,
                 Eigen::VectorXd &                gradient)
{
  double energy = 0.0;
  for (const std::size_t cell : cells)
  {
    const CellNodes        nodes = layout.cellNodes(cell);
    std::array<Vector3, 8> corners;
    for (std::size_t a = 0; a < 8; ++a)
    {
      corners[a] = layout.at(x, nodes[a]);
    }
    std::array<double, sampleCount>                 values;
    std::array<std::array<Vector3, 3>, sampleCount> tangents;
    for (std::size_t q = 0; q < sampleCount; ++q)
    {
      for (std::size_t d = 0; d < 3; ++d)
      {
        const std::array<double, 4> weights = edgeWeights(q, d);
        tangents[q][d].setZero();
        for (std::size_t e = 0; e < 4; ++e)
        {
          const std::size_t start = edgeStart[d][e];
          tangents[q][d] += weights[e] * (corners[start + (std::size_t{ 1 } << d)] - corners[start]);
        }
      }
      values[q] = tangents[q][0].dot(tangents[q][1].cross(tangents[q][2]));
    }
    samplesToCoefficientsInPlace(values);

    bool active = false;
    for (double & value : values)
    {
      const double shortfall = std::max(0.0, margin - value);
      energy += 0.5 * weight * shortfall * shortfall;
      value = -weight * shortfall; // dE/db
      active = active || shortfall > 0.0;
    }
    if (!active)
    {
      continue;
    }
    transposeInPlace(values);
    for (std::size_t q = 0; q < sampleCount; ++q)
    {
      for (std::size_t d = 0; d < 3; ++d)
      {
        const Vector3               cofactor = values[q] * tangents[q][(d + 1) % 3].cross(tangents[q][(d + 2) % 3]);
        const std::array<double, 4> weights = edgeWeights(q, d);
        for (std::size_t e = 0; e < 4; ++e)
        {
          const std::size_t start = edgeStart[d][e];
          layout.add(gradient, nodes[start + (std::size_t{ 1 } << d)], weights[e] * cofactor);
          layout.add(gradient, nodes[start], -weights[e] * cofactor);
        }
      }
    }
  }
  return energy;
}

} // namespace moserhex
