#include "moserhex/Deformation/CubeRegions.h"

#include "moserhex/Common/Errors.h"

#include <algorithm>
#include <array>

namespace moserhex
{
namespace
{

void
requireNodes(int nodesPerSide)
{
  if (nodesPerSide < 2)
  {
    throw InvalidInput("regions of a lattice of " + std::to_string(nodesPerSide) + " nodes a side, need >= 2");
  }
}

bool
isBoxWithin(const CubeBox & inner, const CubeBox & outer)
{
  return (inner.lower.array() >= outer.lower.array()).all() && (inner.lower.array() < inner.upper.array()).all() &&
         (inner.upper.array() <= outer.upper.array()).all();
}

/** A part in [0,1] that rounding of a box's bounds has made is none, and what it has taken from a whole is all there.
 */
double
withoutRounding(double part)
{
  constexpr double rounding = 1e-9;
  if (part < rounding)
  {
    return 0.0;
  }
  return part > 1.0 - rounding ? 1.0 : part;
}

/** How much of each of the n-1 intervals of an axis lies in the box. */
std::vector<double>
overlaps(const CubeBox & box, Eigen::Index axis, int nodesPerSide)
{
  const int           m = nodesPerSide - 1;
  std::vector<double> result(static_cast<std::size_t>(m));
  for (int i = 0; i < m; ++i)
  {
    const double from = std::max(box.lower[axis] * m, static_cast<double>(i));
    const double to = std::min(box.upper[axis] * m, static_cast<double>(i + 1));
    result[static_cast<std::size_t>(i)] = withoutRounding(to - from);
  }
  return result;
}

/** Adds sign times the box's part of every cell. */
void
addCells(const CubeBox & box, double sign, int nodesPerSide, std::vector<double> & fractions)
{
  const std::array<std::vector<double>, 3> along{ overlaps(box, 0, nodesPerSide),
                                                  overlaps(box, 1, nodesPerSide),
                                                  overlaps(box, 2, nodesPerSide) };
  std::size_t                              cell = 0;
  for (const double k : along[2])
  {
    for (const double j : along[1])
    {
      for (const double i : along[0])
      {
        fractions[cell++] += sign * i * j * k;
      }
    }
  }
}

/** Adds sign times the box's part of every boundary quadrilateral, in the order of boundaryQuads. */
void
addQuads(const CubeBox & box, double sign, int nodesPerSide, std::vector<double> & fractions)
{
  std::size_t quad = 0;
  for (Eigen::Index axis = 0; axis < 3; ++axis)
  {
    const std::vector<double> first = overlaps(box, (axis + 1) % 3, nodesPerSide);
    const std::vector<double> second = overlaps(box, (axis + 2) % 3, nodesPerSide);
    for (const bool reaches : { box.lower[axis] <= 0.0, box.upper[axis] >= 1.0 })
    {
      for (const double b : second)
      {
        for (const double a : first)
        {
          fractions[quad++] += reaches ? sign * a * b : 0.0;
        }
      }
    }
  }
}

/** What is left by rounding is nothing. */
void
clampToUnitInterval(std::vector<double> & fractions)
{
  for (double & fraction : fractions)
  {
    fraction = std::clamp(fraction, 0.0, 1.0);
  }
}

CubeBox
half(Eigen::Index axis, bool last)
{
  CubeBox box;
  (last ? box.lower : box.upper)[axis] = 0.5;
  return box;
}

constexpr const char * sideNames[3][2] = { { "right", "left" },
                                           { "anterior", "posterior" },
                                           { "inferior", "superior" } };

} // namespace

void
requireValid(const CubeRegion & region)
{
  if (!isBoxWithin(region.box, CubeBox{}) || (region.without && !isBoxWithin(*region.without, region.box)))
  {
    throw InvalidInput("region " + region.name + ": need 0 <= lower < upper <= 1 along every axis");
  }
}

CubeRegion
wholeRegion()
{
  return { "organ", {}, {} };
}

std::vector<CubeRegion>
octantRegions()
{
  std::vector<CubeRegion> regions;
  for (int octant = 0; octant < 8; ++octant)
  {
    CubeRegion region;
    for (int axis = 0; axis < 3; ++axis)
    {
      const int side = octant >> axis & 1;
      region.name += (axis == 0 ? "" : "-") + std::string(sideNames[axis][side]);
      (side == 1 ? region.box.lower : region.box.upper)[axis] = 0.5;
    }
    regions.push_back(region);
  }
  return regions;
}

std::vector<CubeRegion>
halfRegions()
{
  std::vector<CubeRegion> regions;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const bool last : { false, true })
    {
      regions.push_back({ sideNames[axis][last ? 1 : 0], half(axis, last), {} });
    }
  }
  return regions;
}

std::vector<CubeRegion>
shellRegions(int nodesPerSide)
{
  requireNodes(nodesPerSide);
  const int  shells = nodesPerSide / 2;
  const auto boxAt = [nodesPerSide](int depth) {
    const double margin = static_cast<double>(depth) / (nodesPerSide - 1);
    return CubeBox{ Vector3::Constant(margin), Vector3::Constant(1.0 - margin) };
  };
  std::vector<CubeRegion> regions;
  for (int shell = 1; shell <= shells; ++shell)
  {
    CubeRegion region{ "shell-" + std::to_string(shell), boxAt(shells - shell), {} };
    if (shell > 1)
    {
      region.without = boxAt(shells - shell + 1);
    }
    regions.push_back(region);
  }
  return regions;
}

std::vector<double>
cellFractions(const CubeRegion & region, int nodesPerSide)
{
  requireNodes(nodesPerSide);
  requireValid(region);
  const auto          m = static_cast<std::size_t>(nodesPerSide - 1);
  std::vector<double> fractions(m * m * m, 0.0);
  addCells(region.box, 1.0, nodesPerSide, fractions);
  if (region.without)
  {
    addCells(*region.without, -1.0, nodesPerSide, fractions);
  }
  clampToUnitInterval(fractions);
  return fractions;
}

std::vector<double>
quadFractions(const CubeRegion & region, int nodesPerSide)
{
  requireNodes(nodesPerSide);
  requireValid(region);
  const auto          m = static_cast<std::size_t>(nodesPerSide - 1);
  std::vector<double> fractions(6 * m * m, 0.0);
  addQuads(region.box, 1.0, nodesPerSide, fractions);
  if (region.without)
  {
    addQuads(*region.without, -1.0, nodesPerSide, fractions);
  }
  clampToUnitInterval(fractions);
  return fractions;
}

std::vector<int>
regionOfCells(const std::vector<CubeRegion> & regions, int nodesPerSide)
{
  requireNodes(nodesPerSide);
  const auto       m = static_cast<std::size_t>(nodesPerSide - 1);
  std::vector<int> numbers(m * m * m, 0);
  for (std::size_t region = 0; region < regions.size(); ++region)
  {
    const std::vector<double> fractions = cellFractions(regions[region], nodesPerSide);
    for (std::size_t cell = 0; cell < numbers.size(); ++cell)
    {
      if (numbers[cell] == 0 && fractions[cell] > 0.5)
      {
        numbers[cell] = static_cast<int>(region) + 1;
      }
    }
  }
  return numbers;
}

} // namespace moserhex
