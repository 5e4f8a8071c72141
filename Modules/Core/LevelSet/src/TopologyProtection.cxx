#include "TopologyProtection.h"

#include "moserhex/LevelSet/GaussianSmoothing.h"
#include "moserhex/LevelSet/HomotopicGrowth.h"
#include "moserhex/LevelSet/KuhnConnectivity.h"

#include <algorithm>
#include <cmath>

namespace moserhex::detail
{
namespace
{

constexpr double changedNodeDepth = 0.3; ///< of a node that changed side, in spacings
constexpr double roundSigma = 0.7;       ///< of the smoothing after a change [nodes]
constexpr int    rounds = 3;
constexpr int    roundReach = 3; ///< only this close to a changed node [nodes]

ProtectionResult
difference(const LevelSet & f, const LevelSet & t)
{
  ProtectionResult result;
  for (std::size_t node = 0; node < f.values.size(); ++node)
  {
    const bool before = f.values[node] < 0.0;
    const bool after = t.values[node] < 0.0;
    result.cut += before && !after ? 1 : 0;
    result.filled += !before && after ? 1 : 0;
  }
  return result;
}

/** 1 for the nodes within `reach` steps (along all three axes at once) of a marked one. */
std::vector<std::uint8_t>
dilated(const RegularGrid & grid, const std::vector<std::uint8_t> & marked, int reach)
{
  std::vector<std::uint8_t> result(marked.size(), 0);
  for (std::size_t node = 0; node < marked.size(); ++node)
  {
    if (marked[node] == 0)
    {
      continue;
    }
    const RegularGrid::Index index = grid.indexOf(node);
    for (int k = std::max(index[2] - reach, 0); k <= std::min(index[2] + reach, grid.size[2] - 1); ++k)
    {
      for (int j = std::max(index[1] - reach, 0); j <= std::min(index[1] + reach, grid.size[1] - 1); ++j)
      {
        for (int i = std::max(index[0] - reach, 0); i <= std::min(index[0] + reach, grid.size[0] - 1); ++i)
        {
          result[grid.nodeNumber(i, j, k)] = 1;
        }
      }
    }
  }
  return result;
}

/** Smooths the chosen nodes; one whose side would change does so only if it is simple at that moment, and stays close
 * to its side otherwise. The topology of {f < 0} stays. */
void
smoothKeepingTopology(LevelSet & f, const std::vector<std::uint8_t> & chosen)
{
  const double              depth = changedNodeDepth * f.grid.spacing;
  const KuhnConnectivity    kuhn(f.grid);
  LevelSet                  smooth = f;
  std::vector<std::uint8_t> inside(f.values.size());
  gaussianSmoothInPlace(smooth, roundSigma);
  for (std::size_t node = 0; node < inside.size(); ++node)
  {
    inside[node] = f.values[node] < 0.0;
  }
  for (std::size_t node = 0; node < inside.size(); ++node)
  {
    if (chosen[node] == 0 || f.grid.isBorder(node))
    {
      continue;
    }
    double     value = smooth.values[node];
    const bool wasInside = inside[node] != 0;
    if ((value < 0.0) != wasInside)
    {
      if (kuhn.isSimple(inside, node))
      {
        inside[node] = wasInside ? 0 : 1;
      }
      else
      {
        value = wasInside ? -depth : depth;
      }
    }
    f.values[node] = value;
  }
}

} // namespace

std::size_t
deepestNode(const LevelSet & f)
{
  return static_cast<std::size_t>(std::min_element(f.values.begin(), f.values.end()) - f.values.begin());
}

ProtectionResult
makeBallInPlace(LevelSet & f)
{
  HomotopicGrowthOptions options;
  options.stopAbove = 0.0;
  LevelSet         ball = homotopicGrowth(f, deepestNode(f), options).levelSet;
  ProtectionResult result = difference(f, ball);
  if (result.cut == 0)
  {
    return result;
  }
  LevelSet               shrunk = homotopicShrink(f);
  const ProtectionResult byShrinking = difference(f, shrunk);
  if (byShrinking.cut + byShrinking.filled < result.cut + result.filled)
  {
    ball = std::move(shrunk);
    result = byShrinking;
  }
  std::vector<std::uint8_t> changed(f.values.size(), 0);
  for (std::size_t node = 0; node < f.values.size(); ++node)
  {
    const bool inside = ball.values[node] < 0.0;
    if ((f.values[node] < 0.0) != inside)
    {
      changed[node] = 1;
      f.values[node] = inside ? -changedNodeDepth * f.grid.spacing : changedNodeDepth * f.grid.spacing;
    }
  }
  const std::vector<std::uint8_t> chosen = dilated(f.grid, changed, roundReach);
  for (int round = 0; round < rounds; ++round)
  {
    smoothKeepingTopology(f, chosen);
  }
  return result;
}

void
makeLevelsSphericalInPlace(LevelSet & f, double band)
{
  HomotopicGrowthOptions options;
  options.stopAbove = band;
  options.valueOfOthers = band;
  const LevelSet t = homotopicGrowth(f, deepestNode(f), options).levelSet;
  for (std::size_t node = 0; node < f.values.size(); ++node)
  {
    const bool far = t.values[node] <= -band || f.values[node] >= band;
    if (!far)
    {
      f.values[node] = std::min(t.values[node], band);
    }
  }
}

} // namespace moserhex::detail
