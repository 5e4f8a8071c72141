#include "moserhex/LevelSet/ShellOrdering.h"

#include "moserhex/Common/Errors.h"
#include "moserhex/LevelSet/GaussianSmoothing.h"
#include "moserhex/LevelSet/HomotopicGrowth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

namespace moserhex
{
namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<std::size_t>
nodesInside(const LevelSet & phi)
{
  std::vector<std::size_t> nodes;
  for (std::size_t node = 0; node < phi.values.size(); ++node)
  {
    if (phi.values[node] < 0.0)
    {
      nodes.push_back(node);
    }
  }
  return nodes;
}

/** Radius of the ball that holds as many grid cells as there are nodes inside [mm]. */
double
equivalentRadius(std::size_t count, double spacing)
{
  return spacing * std::cbrt(3.0 * static_cast<double>(count) / (4.0 * pi));
}

void
requireArrival(const LevelSet & phi, const LevelSet & arrival)
{
  requireValid(phi, "shell ordering, phi");
  if (arrival.grid.size != phi.grid.size || arrival.values.size() != phi.values.size())
  {
    throw InvalidInput("shell ordering: arrival times and phi have different grids");
  }
  bool reached = false;
  for (std::size_t node = 0; node < phi.values.size(); ++node)
  {
    if (phi.values[node] < 0.0)
    {
      if (std::isnan(arrival.values[node]))
      {
        throw InvalidInput("shell ordering: the arrival time of node " + std::to_string(node) + " is not a number");
      }
      reached = reached || std::isfinite(arrival.values[node]);
    }
  }
  if (!reached)
  {
    throw InvalidInput("shell ordering: 0 nodes inside the organ have an arrival time, need at least 1");
  }
}

/** R |grad rho| by the larger of the two one-sided differences along each axis, so that a ridge of u is not flat. */
double
relativeSlope(const LevelSet & torsion, double largest, double radius, std::size_t node)
{
  const auto rho = [&](std::ptrdiff_t stride) {
    const double u = torsion.values[node + static_cast<std::size_t>(stride)];
    return std::sqrt(std::max(0.0, 1.0 - u / largest));
  };
  const RegularGrid & grid = torsion.grid;
  const double        here = rho(0);
  double              squaredSlope = 0.0;
  for (const std::ptrdiff_t stride : { grid.stride(1, 0, 0), grid.stride(0, 1, 0), grid.stride(0, 0, 1) })
  {
    const double difference = std::max(std::abs(rho(stride) - here), std::abs(here - rho(-stride)));
    squaredSlope += difference * difference;
  }
  return radius * std::sqrt(squaredSlope) / grid.spacing;
}

/** Times of all nodes inside: those not reached follow the last one, the deeper the earlier. Outside +infinity. */
LevelSet
completedArrival(const LevelSet &                 phi,
                 const LevelSet &                 arrival,
                 const std::vector<std::size_t> & inside,
                 std::size_t &                    unreached)
{
  LevelSet complete{ phi.grid, std::vector<double>(phi.values.size(), infinity) };
  double   last = -infinity;
  double   deepest = 0.0;
  for (const std::size_t node : inside)
  {
    complete.values[node] = arrival.values[node];
    deepest = std::min(deepest, phi.values[node]);
    if (std::isfinite(arrival.values[node]))
    {
      last = std::max(last, arrival.values[node]);
    }
  }
  unreached = 0;
  for (const std::size_t node : inside)
  {
    if (!std::isfinite(complete.values[node]))
    {
      ++unreached;
      complete.values[node] = last + (1.0 + std::abs(last)) * (2.0 - phi.values[node] / deepest);
    }
  }
  return complete;
}

/** Growth from the seed over the nodes inside, in order of time; nodes that never became simple come last. */
LevelSet
grownInside(const LevelSet & arrival, const std::vector<std::size_t> & inside, std::size_t seed)
{
  HomotopicGrowthOptions options;
  options.allowed.assign(arrival.values.size(), 0);
  double last = -infinity;
  for (const std::size_t node : inside)
  {
    options.allowed[node] = 1;
    last = std::max(last, arrival.values[node]);
  }
  options.valueOfOthers = last + 1.0 + std::abs(last);
  return homotopicGrowth(arrival, seed, options).levelSet;
}

/** s = (rank / count)^(2/3) at the nodes inside; nodes of equal grown and original time share their mean rank. */
void
writeRanks(const LevelSet & grown, const LevelSet & arrival, std::vector<std::size_t> inside, LevelSet & s)
{
  std::sort(inside.begin(), inside.end(), [&](std::size_t a, std::size_t b) {
    return grown.values[a] != grown.values[b] ? grown.values[a] < grown.values[b] : a < b;
  });
  // Growth tells equal times apart by the smallest step of a number; such a step is still "equal".
  const auto equal = [&](std::size_t a, std::size_t b) {
    return arrival.values[a] == arrival.values[b] &&
           grown.values[b] - grown.values[a] <= 1e-12 * std::abs(grown.values[a]);
  };
  const auto count = static_cast<double>(inside.size());
  for (std::size_t first = 0; first < inside.size();)
  {
    std::size_t last = first;
    while (last + 1 < inside.size() && equal(inside[last], inside[last + 1]))
    {
      ++last;
    }
    const double rank = 0.5 * static_cast<double>(first + last + 1);
    for (std::size_t i = first; i <= last; ++i)
    {
      s.values[inside[i]] = std::pow(rank / count, 2.0 / 3.0);
    }
    first = last + 1;
  }
}

/** Growth over the whole box from the smallest value: every level set becomes a sphere. Values stay finite. */
LevelSet
grownEverywhere(const LevelSet & s)
{
  const auto smallest = std::min_element(s.values.begin(), s.values.end());
  const auto largest = std::max_element(s.values.begin(), s.values.end());

  HomotopicGrowthOptions options;
  options.valueOfOthers = *largest;
  return homotopicGrowth(s, static_cast<std::size_t>(smallest - s.values.begin()), options).levelSet;
}

} // namespace

std::vector<double>
cubeVolumeFractions(int shells)
{
  if (shells < 1)
  {
    throw InvalidInput("shells = " + std::to_string(shells) + ", need at least 1");
  }
  std::vector<double> fractions(static_cast<std::size_t>(shells));
  for (int k = 1; k <= shells; ++k)
  {
    const double side = (2.0 * k - 1.0) / (2.0 * shells - 1.0);
    fractions[static_cast<std::size_t>(k - 1)] = side * side * side;
  }
  return fractions;
}

FrontWeight
frontWeight(const LevelSet & phi, const FrontWeightOptions & options)
{
  if (!(options.depthPower >= 0.0) || !(options.smallestSlope > 0.0) || !(options.smallestWeight > 0.0))
  {
    throw InvalidInput("front weight: depthPower = " + std::to_string(options.depthPower) +
                       " (need >= 0), smallestSlope = " + std::to_string(options.smallestSlope) +
                       " (need > 0), smallestWeight = " + std::to_string(options.smallestWeight) + " (need > 0)");
  }
  const TorsionFunctionResult    torsion = torsionFunction(phi, options.torsion);
  const std::vector<double> &    u = torsion.levelSet.values;
  const std::vector<std::size_t> inside = nodesInside(phi);
  const double                   radius = equivalentRadius(inside.size(), phi.grid.spacing);

  FrontWeight front;
  front.torsion = torsion.report;
  front.seed = static_cast<std::size_t>(std::max_element(u.begin(), u.end()) - u.begin());
  front.weight = { phi.grid, std::vector<double>(phi.values.size(), options.smallestWeight) };
  const double deepest = *std::min_element(phi.values.begin(), phi.values.end());
  for (const std::size_t node : inside)
  {
    const double depth = std::pow(phi.values[node] / deepest, options.depthPower);
    const double slope = relativeSlope(torsion.levelSet, u[front.seed], radius, node);
    front.weight.values[node] = std::max(options.smallestWeight, depth / std::max(options.smallestSlope, slope));
  }
  return front;
}

ShellOrdering
shellOrdering(const LevelSet & phi, const LevelSet & arrival, std::size_t seed, const ShellOrderingOptions & options)
{
  requireArrival(phi, arrival);
  if (seed >= phi.values.size() || !(phi.values[seed] < 0.0))
  {
    throw InvalidInput("shell ordering: seed " + std::to_string(seed) + " is not a node inside the organ");
  }
  const std::vector<std::size_t> inside = nodesInside(phi);
  const double                   radius = equivalentRadius(inside.size(), phi.grid.spacing);

  ShellOrdering  ordering;
  const LevelSet times = completedArrival(phi, arrival, inside, ordering.unreached);
  LevelSet       s{ phi.grid, std::vector<double>(phi.values.size()) };
  for (std::size_t node = 0; node < s.values.size(); ++node)
  {
    s.values[node] = 1.0 + 2.0 * std::max(0.0, phi.values[node]) / radius;
  }
  writeRanks(grownInside(times, inside, seed), times, inside, s);
  gaussianSmoothInPlace(s, options.smoothing);
  ordering.levelSet = grownEverywhere(s);
  for (const std::size_t node : inside)
  {
    ordering.raised += ordering.levelSet.values[node] > s.values[node] + 1e-9 ? 1 : 0;
  }
  return ordering;
}

Snapshots
separatedSnapshots(const LevelSet & phi, const LevelSet & arrival, int shells, const SnapshotOptions & options)
{
  requireArrival(phi, arrival);
  if (shells < 1 || !(options.reached > 0.0 && options.reached <= 1.0) || !(options.gap > 0.0))
  {
    throw InvalidInput("snapshots: shells = " + std::to_string(shells) +
                       " (need >= 1), reached = " + std::to_string(options.reached) +
                       " (need (0,1]), gap = " + std::to_string(options.gap) + " (need > 0)");
  }
  const std::vector<std::size_t> inside = nodesInside(phi);
  std::vector<double>            times;
  double                         deepest = 0.0;
  for (const std::size_t node : inside)
  {
    deepest = std::min(deepest, phi.values[node]);
    if (std::isfinite(arrival.values[node]))
    {
      times.push_back(arrival.values[node]);
    }
  }
  std::sort(times.begin(), times.end());
  const auto   last = static_cast<std::size_t>(std::ceil(options.reached * static_cast<double>(times.size()))) - 1;
  const double start = times.front();
  const double span = times[last] - start;
  const double width = std::min(options.gap * phi.grid.spacing * shells, -0.5 * deepest);

  Snapshots snapshots;
  snapshots.arrival = { phi.grid, std::vector<double>(phi.values.size(), infinity) };
  times.clear();
  for (const std::size_t node : inside)
  {
    const double time = std::max(arrival.values[node], start + span * (1.0 + phi.values[node] / width));
    snapshots.arrival.values[node] = time;
    times.push_back(time);
  }
  std::sort(times.begin(), times.end());
  const auto count = static_cast<double>(inside.size());
  double     before = 0.0;
  for (int k = 1; k < shells; ++k)
  {
    const auto passed = std::upper_bound(times.begin(), times.end(), start + span * k / shells) - times.begin();
    before = std::max(before + 1.0 / count, static_cast<double>(passed) / count);
    snapshots.volumeFractions.push_back(before);
  }
  snapshots.volumeFractions.push_back(1.0);
  return snapshots;
}

} // namespace moserhex
