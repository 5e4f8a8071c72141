#include "CellShares.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace moserhex
{
namespace
{

/** A cell grows or shrinks by this factor at most against the organ [1]. */
constexpr double mostGrowth = 8.0;

void
scaleToMeanOne(std::vector<double> & values)
{
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  for (double & value : values)
  {
    value /= mean;
  }
}

} // namespace

std::vector<double>
cellShares(const HexMesh & mesh)
{
  std::vector<double> shares = cellVolumes(mesh);
  scaleToMeanOne(shares);
  return shares;
}

GrownShares
grownShares(const HexMesh & loosened, const std::vector<double> & before)
{
  GrownShares grown{ cellShares(loosened) };
  for (std::size_t cell = 0; cell < before.size(); ++cell)
  {
    const double ratio = grown.shares[cell] / before[cell];
    const double allowed = std::clamp(ratio, 1.0 / mostGrowth, mostGrowth);
    grown.limited += allowed != ratio ? 1 : 0;
    grown.shares[cell] = before[cell] * allowed;
  }
  scaleToMeanOne(grown.shares);
  return grown;
}

LocalGrowth
growthBetween(const std::vector<double> & before, const std::vector<double> & after)
{
  LocalGrowth growth{ after.front() / before.front(), after.front() / before.front(), 0 };
  for (std::size_t cell = 1; cell < before.size(); ++cell)
  {
    const double ratio = after[cell] / before[cell];
    growth.smallest = std::min(growth.smallest, ratio);
    growth.largest = std::max(growth.largest, ratio);
  }
  return growth;
}

std::vector<double>
partlyGrown(const std::vector<double> & before, const std::vector<double> & after, double part)
{
  std::vector<double> shares(before.size());
  for (std::size_t cell = 0; cell < shares.size(); ++cell)
  {
    shares[cell] = before[cell] * std::pow(after[cell] / before[cell], part);
  }
  scaleToMeanOne(shares);
  return shares;
}

} // namespace moserhex
