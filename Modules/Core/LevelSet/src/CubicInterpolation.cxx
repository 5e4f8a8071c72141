#include "moserhex/LevelSet/CubicInterpolation.h"

#include "moserhex/Common/Errors.h"
#include "moserhex/Common/InstructionSets.h"

#include <algorithm>
#include <cstring>

namespace moserhex
{
namespace
{

/** First of the four samples along an axis, and the fraction between the middle two. */
struct Stencil
{
  std::array<int, 3>    first{ { 0, 0, 0 } };
  std::array<double, 3> fraction{ { 0.0, 0.0, 0.0 } };
};

Stencil
stencilAt(const RegularGrid & grid, const Vector3 & index)
{
  Stencil stencil;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double s = std::min(std::max(index[static_cast<int>(axis)], 1.0), static_cast<double>(grid.size[axis] - 2));
    const int    base = std::min(static_cast<int>(s), grid.size[axis] - 3);
    stencil.first[axis] = base - 1;
    stencil.fraction[axis] = s - base;
  }
  return stencil;
}

/** Four neighbours along the first axis. */
constexpr std::size_t taps = 4;
using Row = double __attribute__((vector_size(8 * taps)));
using Weights = std::array<double, taps>;

/** Sums over the 16 rows of a stencil, which leave the four numbers along the first axis. */
struct RowSums
{
  std::array<double, taps> values;
  std::array<double, taps> alongSecond; // derivative with respect to the second index
  std::array<double, taps> alongThird;
};

MOSERHEX_KERNEL void
sumRows(const double *  first,
        std::size_t     rowStride,
        std::size_t     planeStride,
        const Weights & second,
        const Weights & secondDerivatives,
        const Weights & third,
        const Weights & thirdDerivatives,
        RowSums &       sums)
{
  Row values{};
  Row alongSecond{};
  Row alongThird{};
  for (std::size_t c = 0; c < taps; ++c)
  {
    Row plane{};
    Row planeAlongSecond{};
    for (std::size_t b = 0; b < taps; ++b)
    {
      Row row;
      std::memcpy(&row, first + c * planeStride + b * rowStride, sizeof row);
      plane += second[b] * row;
      planeAlongSecond += secondDerivatives[b] * row;
    }
    values += third[c] * plane;
    alongSecond += third[c] * planeAlongSecond;
    alongThird += thirdDerivatives[c] * plane;
  }
  std::memcpy(sums.values.data(), &values, sizeof values);
  std::memcpy(sums.alongSecond.data(), &alongSecond, sizeof alongSecond);
  std::memcpy(sums.alongThird.data(), &alongThird, sizeof alongThird);
}

double
weightedSum(const Weights & weights, const std::array<double, taps> & values)
{
  return weights[0] * values[0] + weights[1] * values[1] + weights[2] * values[2] + weights[3] * values[3];
}

} // namespace

CubicInterpolator::CubicInterpolator(const LevelSet & levelSet) : m_LevelSet(levelSet)
{
  requireValid(levelSet.grid, "cubic interpolation");
  if (levelSet.values.size() != levelSet.grid.nodeCount())
  {
    throw InvalidInput("cubic interpolation: " + std::to_string(levelSet.values.size()) + " values for " +
                       std::to_string(levelSet.grid.nodeCount()) + " nodes");
  }
  m_ToIndex = levelSet.grid.direction.transpose() / levelSet.grid.spacing;
}

ValueAndGradient
CubicInterpolator::at(const Vector3 & p) const
{
  const RegularGrid & grid = m_LevelSet.grid;
  const Stencil       stencil = stencilAt(grid, m_ToIndex * (p - grid.origin));
  const auto          wx = catmullRomWeights(stencil.fraction[0]);
  const auto          wy = catmullRomWeights(stencil.fraction[1]);
  const auto          wz = catmullRomWeights(stencil.fraction[2]);
  RowSums             sums;
  sumRows(m_LevelSet.values.data() + grid.nodeNumber(stencil.first[0], stencil.first[1], stencil.first[2]),
          static_cast<std::size_t>(grid.size[0]),
          static_cast<std::size_t>(grid.size[0]) * static_cast<std::size_t>(grid.size[1]),
          wy,
          catmullRomDerivatives(stencil.fraction[1]),
          wz,
          catmullRomDerivatives(stencil.fraction[2]),
          sums);
  const Vector3 gradient(weightedSum(catmullRomDerivatives(stencil.fraction[0]), sums.values),
                         weightedSum(wx, sums.alongSecond),
                         weightedSum(wx, sums.alongThird)); // with respect to the index
  return { weightedSum(wx, sums.values), m_ToIndex.transpose() * gradient };
}

double
CubicInterpolator::value(const Vector3 & p) const
{
  const RegularGrid & grid = m_LevelSet.grid;
  const Stencil       stencil = stencilAt(grid, m_ToIndex * (p - grid.origin));
  const auto          wx = catmullRomWeights(stencil.fraction[0]);
  const auto          wy = catmullRomWeights(stencil.fraction[1]);
  const auto          wz = catmullRomWeights(stencil.fraction[2]);

  double value = 0.0;
  for (std::size_t c = 0; c < 4; ++c)
  {
    double plane = 0.0;
    for (std::size_t b = 0; b < 4; ++b)
    {
      const double * row = m_LevelSet.values.data() + grid.nodeNumber(stencil.first[0],
                                                                      stencil.first[1] + static_cast<int>(b),
                                                                      stencil.first[2] + static_cast<int>(c));
      plane += wy[b] * (wx[0] * row[0] + wx[1] * row[1] + wx[2] * row[2] + wx[3] * row[3]);
    }
    value += wz[c] * plane;
  }
  return value;
}

Vector3
projectToLevel(const CubicInterpolator & f, Vector3 p, double level, double maximumStep, int iterations)
{
  constexpr double closeEnough = 1e-10;
  for (int iteration = 0; iteration < iterations; ++iteration)
  {
    const ValueAndGradient at = f.at(p);
    const double           slope = at.gradient.norm();
    const double           difference = level - at.value;
    if (!(slope > 0.0) || std::abs(difference) < closeEnough * slope)
    {
      break;
    }
    const double step = std::min(std::max(difference / slope, -maximumStep), maximumStep);
    p += (step / slope) * at.gradient;
  }
  return p;
}

} // namespace moserhex
