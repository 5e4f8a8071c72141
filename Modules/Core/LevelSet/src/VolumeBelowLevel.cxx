#include "KuhnTetrahedra.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/LevelSet/MarchingTetrahedra.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace moserhex
{
namespace
{

/** t_ab of the class comment. An edge to a node of value +infinity is cut in the middle, as the surface is. */
double
cut(double level, double below, double above)
{
  return above < std::numeric_limits<double>::infinity() ? (level - below) / (above - below) : 0.5;
}

/** Fraction of a tetrahedron below the level; corners in the order of its path. */
double
fractionBelow(const std::array<double, 4> & v, double level)
{
  std::array<double, 4> corner{}; // the corners below come first
  std::size_t           below = 0;
  std::size_t           above = 4;
  for (std::size_t q = 0; q < 4; ++q)
  {
    if (v[q] < level)
    {
      corner[below++] = v[q];
    }
  }
  for (std::size_t q = 4; q-- > 0;)
  {
    if (!(v[q] < level))
    {
      corner[--above] = v[q];
    }
  }
  const auto t = [&](std::size_t a, std::size_t b) { return cut(level, corner[a], corner[b]); };
  switch (below)
  {
    case 0:
      return 0.0;
    case 1:
      return t(0, 1) * t(0, 2) * t(0, 3);
    case 2:
      return t(0, 2) * t(0, 3) * (1.0 - t(1, 3)) + t(0, 2) * t(1, 3) * (1.0 - t(1, 2)) + t(1, 2) * t(1, 3);
    case 3:
      return 1.0 - (1.0 - t(0, 3)) * (1.0 - t(1, 3)) * (1.0 - t(2, 3));
    default:
      return 1.0;
  }
}

} // namespace

VolumeBelowLevel::VolumeBelowLevel(const LevelSet & levelSet)
  : m_LevelSet(levelSet)
  , m_SmallestValue(std::numeric_limits<double>::infinity())
  , m_LargestFiniteValue(-std::numeric_limits<double>::infinity())
{
  requireValid(levelSet, "volume below a level");
  for (const double value : levelSet.values)
  {
    m_SmallestValue = std::min(m_SmallestValue, value);
    if (std::isfinite(value))
    {
      m_LargestFiniteValue = std::max(m_LargestFiniteValue, value);
    }
  }
  const RegularGrid & grid = levelSet.grid;
  m_Smallest.assign(grid.nodeCount(), std::numeric_limits<double>::infinity());
  m_Largest.assign(grid.nodeCount(), std::numeric_limits<double>::infinity());
  for (int k = 0; k + 1 < grid.size[2]; ++k)
  {
    for (int j = 0; j + 1 < grid.size[1]; ++j)
    {
      const std::size_t first = grid.nodeNumber(0, j, k);
      const double *    row00 = levelSet.values.data() + first;
      const double *    row10 = levelSet.values.data() + grid.nodeNumber(0, j + 1, k);
      const double *    row01 = levelSet.values.data() + grid.nodeNumber(0, j, k + 1);
      const double *    row11 = levelSet.values.data() + grid.nodeNumber(0, j + 1, k + 1);
      const auto        smallest = [&](std::size_t i) {
        return std::min(std::min(row00[i], row10[i]), std::min(row01[i], row11[i]));
      };
      const auto largest = [&](std::size_t i) {
        return std::max(std::max(row00[i], row10[i]), std::max(row01[i], row11[i]));
      };
      for (std::size_t i = 0; i + 1 < static_cast<std::size_t>(grid.size[0]); ++i)
      {
        m_Smallest[first + i] = std::min(smallest(i), smallest(i + 1));
        m_Largest[first + i] = std::max(largest(i), largest(i + 1));
      }
    }
  }
}

VolumeBelowLevel::Cubes
VolumeBelowLevel::cubesBetween(double lower, double upper) const
{
  Cubes cubes;
  for (std::size_t cube = 0; cube < m_Smallest.size(); ++cube)
  {
    if (isPartial(cube, lower, upper, cubes))
    {
      cubes.partial.push_back(cube);
    }
  }
  return cubes;
}

void
VolumeBelowLevel::narrow(Cubes & cubes, double lower, double upper) const
{
  const auto end = std::remove_if(cubes.partial.begin(), cubes.partial.end(), [&](std::size_t cube) {
    return !isPartial(cube, lower, upper, cubes);
  });
  cubes.partial.erase(end, cubes.partial.end());
}

double
VolumeBelowLevel::volume(double level, const Cubes & cubes) const
{
  const RegularGrid &           grid = m_LevelSet.grid;
  std::array<std::ptrdiff_t, 8> strides{};
  for (unsigned int c = 0; c < 8; ++c)
  {
    strides[c] = grid.stride(c & 1u, c >> 1 & 1u, c >> 2);
  }
  std::size_t wholeCubes = cubes.whole;
  double      tetrahedra = 0.0;
  for (const std::size_t cube : cubes.partial)
  {
    if (m_Smallest[cube] >= level)
    {
      continue;
    }
    if (m_Largest[cube] < level)
    {
      ++wholeCubes;
      continue;
    }
    const double *        base = m_LevelSet.values.data() + cube;
    std::array<double, 8> corner{};
    for (unsigned int c = 0; c < 8; ++c)
    {
      corner[c] = base[strides[c]];
    }
    for (const auto & path : detail::kuhnPaths)
    {
      tetrahedra += fractionBelow({ { corner[0], corner[path[1]], corner[path[2]], corner[7] } }, level);
    }
  }
  return grid.cellVolume() * (static_cast<double>(wholeCubes) + tetrahedra / 6.0);
}

double
VolumeBelowLevel::volume(double level) const
{
  return volume(level, cubesBetween(level, level));
}

double
levelOfVolume(const LevelSet & levelSet, double volume, const LevelOfVolumeOptions & options)
{
  return levelOfVolume(VolumeBelowLevel(levelSet), volume, options);
}

double
levelOfVolume(const VolumeBelowLevel & prepared, double volume, const LevelOfVolumeOptions & options)
{
  double       lower = std::isfinite(options.lower) ? options.lower : prepared.smallestValue();
  double       upper = std::isfinite(options.upper) ? options.upper : prepared.largestFiniteValue();
  auto         cubes = prepared.cubesBetween(lower, upper);
  double       lowerError = prepared.volume(lower, cubes) - volume;
  double       upperError = prepared.volume(upper, cubes) - volume;
  const double tolerance = options.relativeTolerance * volume;
  if (!(lowerError <= tolerance && upperError >= -tolerance))
  {
    throw InvalidInput("level of volume: " + std::to_string(volume) + " mm^3 is not between " +
                       std::to_string(lowerError + volume) + " and " + std::to_string(upperError + volume) +
                       " mm^3, the volumes at the two ends of the search");
  }
  if (std::abs(lowerError) <= tolerance)
  {
    return lower;
  }
  if (std::abs(upperError) <= tolerance)
  {
    return upper;
  }
  // Regula falsi (Illinois); a bisection whenever three steps have not halved the bracket.
  constexpr int maximumSteps = 200;
  constexpr int patience = 3;
  double        weightLower = lowerError;
  double        weightUpper = upperError;
  double        widthToHalve = upper - lower;
  int           stepsSinceHalved = 0;
  StepReport    report;
  for (; report.steps < maximumSteps; ++report.steps)
  {
    double middle = (lower * weightUpper - upper * weightLower) / (weightUpper - weightLower);
    if (stepsSinceHalved >= patience || !(middle > lower && middle < upper))
    {
      middle = lower + 0.5 * (upper - lower);
    }
    if (!(middle > lower && middle < upper))
    {
      break; // neighbouring numbers: the volume jumps here
    }
    const double error = prepared.volume(middle, cubes) - volume;
    report.residual = std::abs(error) / volume;
    if (std::abs(error) <= tolerance)
    {
      return middle;
    }
    if (error < 0.0)
    {
      lower = middle;
      weightLower = error;
      weightUpper *= 0.5;
    }
    else
    {
      upper = middle;
      weightUpper = error;
      weightLower *= 0.5;
    }
    prepared.narrow(cubes, lower, upper);
    ++stepsSinceHalved;
    if (upper - lower <= 0.5 * widthToHalve)
    {
      widthToHalve = upper - lower;
      stepsSinceHalved = 0;
    }
  }
  report.note = "the volume jumps at level " + std::to_string(lower);
  throw NotConverged("level of volume: no level encloses " + std::to_string(volume) + " mm^3; " + report.note, report);
}

} // namespace moserhex
