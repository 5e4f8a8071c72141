#include "moserhex/LevelSet/CubicInterpolation.h"

#include "moserhex/Common/Errors.h"

#include <algorithm>

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
  const auto          dx = catmullRomDerivatives(stencil.fraction[0]);
  const auto          dy = catmullRomDerivatives(stencil.fraction[1]);
  const auto          dz = catmullRomDerivatives(stencil.fraction[2]);

  double  value = 0.0;
  Vector3 gradient = Vector3::Zero(); // with respect to the index
  for (std::size_t c = 0; c < 4; ++c)
  {
    double planeValue = 0.0;
    double planeX = 0.0;
    double planeY = 0.0;
    for (std::size_t b = 0; b < 4; ++b)
    {
      const double * row = m_LevelSet.values.data() + grid.nodeNumber(stencil.first[0],
                                                                      stencil.first[1] + static_cast<int>(b),
                                                                      stencil.first[2] + static_cast<int>(c));
      const double   rowValue = wx[0] * row[0] + wx[1] * row[1] + wx[2] * row[2] + wx[3] * row[3];
      const double   rowX = dx[0] * row[0] + dx[1] * row[1] + dx[2] * row[2] + dx[3] * row[3];
      planeValue += wy[b] * rowValue;
      planeX += wy[b] * rowX;
      planeY += dy[b] * rowValue;
    }
    value += wz[c] * planeValue;
    gradient += Vector3(wz[c] * planeX, wz[c] * planeY, dz[c] * planeValue);
  }
  return { value, m_ToIndex.transpose() * gradient };
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
